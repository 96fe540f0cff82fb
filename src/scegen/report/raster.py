"""Pictures as PNG, with letters of our own: the same picture gives the same bytes everywhere."""

from functools import lru_cache
from pathlib import Path

from PIL import ImageFont
from resvg_py import svg_to_bytes

_FONTS = Path(__file__).parent / "fonts"
_REGULAR, _BOLD = _FONTS / "DejaVuSans.ttf", _FONTS / "DejaVuSans-Bold.ttf"
_FAMILY = "DejaVu Sans"
_MEASURED_AT = 200


def png_of(svg: str, zoom: float = 1.0) -> bytes:
    """A picture drawn pixel by pixel, ``zoom`` for each unit of the SVG document."""
    return svg_to_bytes(
        svg_string=svg,
        zoom=zoom if zoom != 1.0 else None,
        skip_system_fonts=True,
        font_files=[str(_REGULAR), str(_BOLD)],
        font_family=_FAMILY,
        sans_serif_family=_FAMILY,
    )


@lru_cache(maxsize=4096)
def text_width(words: str, size: float, *, bold: bool = False) -> float:
    """How wide words are when written at this size, in the same unit."""
    return _font(bold).getlength(words) * size / _MEASURED_AT


def wrapped(words: str, size: float, width: float, most: int = 3) -> list[str]:
    """Words in lines no wider than ``width``; what does not fit in ``most`` ends in an ellipsis."""
    rows = [""]
    for word in words.split():
        longer = f"{rows[-1]} {word}".strip()
        if rows[-1] and text_width(longer, size) > width:
            rows.append(word)
        else:
            rows[-1] = longer
    if len(rows) <= most:
        return rows
    last = rows[most - 1]
    while text_width(f"{last} …", size) > width:
        last = last[:-1]
    return [*rows[: most - 1], f"{last} …"]


@lru_cache(maxsize=2)
def _font(bold: bool) -> ImageFont.FreeTypeFont:
    return ImageFont.truetype(
        _BOLD if bold else _REGULAR, _MEASURED_AT, layout_engine=ImageFont.Layout.BASIC
    )
