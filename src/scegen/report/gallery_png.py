"""The gallery as a PNG: the same picture as the SVG, for where no browser draws it."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
from resvg_py import svg_to_bytes

FAMILY = "DejaVu Sans"
_FILES = ("DejaVuSans.ttf", "DejaVuSans-Bold.ttf")


def png_of(svg: str) -> bytes:
    """A picture drawn pixel by pixel, one for each unit of the SVG document.

    The letters are those that matplotlib brings along, not the system's, so the same picture
    gives the same bytes everywhere. It takes about 0.02 s for each scenario, far longer than the
    SVG, so it is made only when asked for.
    """
    fonts = Path(mpl.get_data_path()) / "fonts" / "ttf"
    return svg_to_bytes(
        svg_string=svg,
        skip_system_fonts=True,
        font_files=[str(fonts / name) for name in _FILES],
        font_family=FAMILY,
        sans_serif_family=FAMILY,
    )
