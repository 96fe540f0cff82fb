"""A concrete scenario as a moving picture: animated GIF, video, or one picture of it."""

import tempfile
from importlib.util import find_spec
from pathlib import Path

from scegen.motion import build_paths
from scegen.report.cinema import Watch, gif_of, write_mp4
from scegen.report.film import Cut, make_film
from scegen.report.raster import png_of
from scegen.report.theme import LIGHT, Theme
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario

GIF, MP4, PNG = "gif", "mp4", "png"
RATES = {GIF: 10.0, MP4: 25.0, PNG: 10.0}
"""Pictures a second where nothing else is asked for."""


def has_video() -> bool:
    """Whether videos can be made here."""
    return find_spec("imageio_ffmpeg") is not None


def rendered(
    concrete: ConcreteScenario,
    ending: str,
    cut: Cut | None = None,
    theme: Theme = LIGHT,
    watch: Watch = iter,
) -> bytes:
    """The file's content.

    ``ending`` is ``gif``, ``mp4`` or ``png``, which is the picture of the closest approach. ``cut``
    is what is shown, the seconds around the closest approach if None; ``watch`` is told of every
    picture's number.

    Raises:
        MissingToolError: a video is asked for without imageio-ffmpeg.
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    cut = cut or Cut(fps=RATES[ending])
    network = build_network(concrete.road)
    film = make_film(concrete, network, build_paths(concrete, network), cut, theme)
    if ending == PNG:
        return png_of(film.picture(film.critical))
    if ending == GIF:
        return gif_of(film, watch)
    with tempfile.TemporaryDirectory(prefix="scegen-") as place:
        file = Path(place, "film.mp4")
        write_mp4(film, file, cut.fps, watch)
        return file.read_bytes()
