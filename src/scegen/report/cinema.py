"""Films as files: animated GIF with Pillow, video with ffmpeg."""

from collections.abc import Callable, Iterable, Iterator
from importlib import import_module
from io import BytesIO
from pathlib import Path

from PIL import Image

from scegen.errors import of_extra
from scegen.report.film import Film
from scegen.report.raster import png_of
from scegen.report.theme import Theme

Watch = Callable[[Iterable[int]], Iterable[int]]
_COLOURS, _SAMPLED = 128, 6
_SWATCH, _SHARES = (24, 24), (1.0, 0.6, 0.35)
"""Size in pixels, and how strongly ways and rings are drawn over what lies beneath."""
_LEAST_CS = 2
"""Hundredths of a second; players slow down what is faster."""
_QUIETLY = ["-loglevel", "error", "-threads", "1", "-fflags", "+bitexact",
             "-flags:v", "+bitexact", "-map_metadata", "-1"]  # fmt: skip


def gif_of(film: Film, watch: Watch = iter) -> bytes:
    """A film as an animated GIF that plays for ever; the same film gives the same bytes.

    ``watch`` is told of every picture's number, to show how far it is.
    """
    pictures = [_image(film, number) for number in watch(range(len(film)))]
    stage = film.stage
    palette = _palette(pictures, stage.theme, stage.colour.values())
    frames = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in pictures]
    durations = [max(round(lasts * 100), _LEAST_CS) * 10 for lasts in film.lasts_s.tolist()]
    buffer = BytesIO()
    frames[0].save(buffer, "GIF", save_all=True, append_images=frames[1:], duration=durations,
                   loop=0, disposal=1, optimize=False)  # fmt: skip
    return buffer.getvalue()


VIDEO_HINT = "pip install 'ml-scegen[video]'"


def write_mp4(film: Film, path: Path, fps: float, watch: Watch = iter) -> None:
    """A film as H.264 video.

    Raises:
        MissingToolError: imageio-ffmpeg is not installed.
    """
    with of_extra("video", "a video", "imageio_ffmpeg"):
        ffmpeg = import_module("imageio_ffmpeg")
    options = {"pix_fmt_in": "rgb24", "codec": "libx264", "macro_block_size": 2, "fps": fps}
    writer = ffmpeg.write_frames(str(path), film.size, output_params=_QUIETLY, **options)
    writer.send(None)
    try:
        for picture in _held(film, fps, watch):
            writer.send(picture)
    finally:
        writer.close()


def _held(film: Film, fps: float, watch: Watch) -> Iterator[bytes]:
    """Every picture as often as it lasts."""
    for number in watch(range(len(film))):
        picture = _image(film, number).tobytes()
        for _ in range(max(1, round(float(film.lasts_s[number]) * fps))):
            yield picture


def _image(film: Film, number: int) -> Image.Image:
    with Image.open(BytesIO(png_of(film.picture(number)))) as drawn:
        return drawn.convert("RGB")


def _palette(pictures: list[Image.Image], theme: Theme, bodies: Iterable[str]) -> Image.Image:
    """One palette for all, from some of them, so that colours do not flicker.

    What is small and rare, a way or a pedestrian, gets its colours too, on all that lies beneath.
    """
    every = max(1, len(pictures) // _SAMPLED)
    sample = pictures[::every][:_SAMPLED]
    width, height = sample[0].size
    inks = [*bodies, theme.hazard, theme.brake_light, theme.signal_red, theme.accent]
    grounds = (theme.road, theme.ground, theme.sidewalk)
    swatches = [
        Image.blend(Image.new("RGB", _SWATCH, ground), Image.new("RGB", _SWATCH, ink), share)
        for ink in inks
        for ground in grounds
        for share in _SHARES
    ]
    per_row = max(1, width // _SWATCH[0])
    rows = -(-len(swatches) // per_row)
    together = Image.new("RGB", (width, height * len(sample) + rows * _SWATCH[1]), theme.road)
    for place, picture in enumerate(sample):
        together.paste(picture, (0, place * height))
    for place, swatch in enumerate(swatches):
        row, column = divmod(place, per_row)
        together.paste(swatch, (column * _SWATCH[0], height * len(sample) + row * _SWATCH[1]))
    return together.quantize(_COLOURS, method=Image.Quantize.MEDIANCUT, kmeans=1)
