"""The one drawing layer: elements of SVG as text, for tiles, previews and films alike.

What comes from outside is escaped here and nowhere else; numbers are rounded, so that the same
picture is the same text everywhere.
"""

from collections.abc import Iterable, Sequence
from html import escape

import numpy as np
from numpy.typing import NDArray

from scegen.export.openscenario_text import legal

Line = Sequence[tuple[float, float]] | NDArray[np.float64]
"""Points, (n, 2)."""
Style = str | float | None
"""The value of an attribute; None leaves it out."""


def number(value: float) -> str:
    """A number as short as it goes, two places behind the point."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in {"-0", ""} else text


def element(name: str, content: str = "", /, **style: Style) -> str:
    """An element; ``stroke_width`` becomes ``stroke-width``, ``class_`` is ``class``."""
    written = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{_attribute(value)}"'
        for key, value in style.items()
        if value is not None
    )
    return f"<{name}{written}>{content}</{name}>" if content else f"<{name}{written}/>"


def told(words: str, *, quote: bool = True) -> str:
    """Words from outside, as an element or an attribute may hold them."""
    return escape(legal(words), quote=quote)


def _attribute(value: str | float) -> str:
    return told(value) if isinstance(value, str) else number(value)


def outline(points: Line, *, closed: bool = False) -> str:
    """Points as the data of a path."""
    return "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points) + ("Z" if closed else "")


def line(points: Line, colour: str, width: float, **style: Style) -> str:
    """A line through points."""
    return lines([points], colour, width, **style)


def lines(many: Iterable[Line], colour: str, width: float, **style: Style) -> str:
    """Lines that look alike, in one element; nothing where there are none."""
    data = "".join(outline(points) for points in many)
    drawn: dict[str, Style] = {"fill": "none", "stroke": colour, "stroke_width": width}
    return element("path", d=data, **(drawn | style)) if data else ""


def areas(many: Iterable[Line], fill: str, **style: Style) -> str:
    """Filled polygons that look alike; they may overlap. Nothing where there are none."""
    paths = "".join(element("path", d=outline(points, closed=True)) for points in many)
    return element("g", paths, fill=fill, **style) if paths else ""


def area(points: Line, fill: str, **style: Style) -> str:
    """A filled polygon."""
    return element("path", d=outline(points, closed=True), fill=fill, **style)


def circle(x: float, y: float, radius: float, fill: str, **style: Style) -> str:
    """A disc."""
    return element("circle", cx=x, cy=y, r=radius, fill=fill, **style)


def box(x: float, y: float, width: float, height: float, fill: str, **style: Style) -> str:
    """A rectangle along the axes, by its upper left corner."""
    return element("rect", x=x, y=y, width=width, height=height, fill=fill, **style)


def letters(
    words: str,
    x: float,
    y: float,
    size: float,
    fill: str,
    *,
    bold: bool = False,
    halo: str | None = None,
    **style: Style,
) -> str:
    """Words on a base line, with a rim of the colour ``halo`` where they lie on a picture."""
    rim: dict[str, Style] = {"paint_order": "stroke", "stroke": halo, "stroke_width": size / 4,
                             "stroke_linejoin": "round"}  # fmt: skip
    weight = "bold" if bold else None
    look = ({} if halo is None else rim) | style
    shown = told(words, quote=False)
    return element("text", shown, x=x, y=y, font_size=size, font_weight=weight, fill=fill, **look)


def group(content: str, **style: Style) -> str:
    """Elements that move or look alike together."""
    return element("g", content, **style)


def document(
    width: float, height: float, content: str, *, title: str = "", describes: str = ""
) -> str:
    """A picture of its own; ``title`` and ``describes`` speak to those who do not see it."""
    head = element("title", told(title)) if title else ""
    head += element("desc", told(describes)) if describes else ""
    return element(
        "svg",
        head + content,
        xmlns="http://www.w3.org/2000/svg",
        width=width,
        height=height,
        viewBox=f"0 0 {number(width)} {number(height)}",
        role="img",
        aria_label=title or None,
        font_family="system-ui, 'DejaVu Sans', sans-serif",
    )
