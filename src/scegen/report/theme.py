"""Every colour of every picture and page, by what it stands for; a light and a dark variant.

Participants keep apart for the colour-blind too (a test simulates them); shape, name and dash
pattern tell the same again, so that no picture rests on colour alone.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field, fields
from typing import Any


def _both(light: object, dark: object) -> Any:  # noqa: ANN401 - stands for a colour
    """A colour in the light and in the dark variant."""
    return field(metadata={"light": light, "dark": dark})


@dataclass(frozen=True)
class Theme:
    """One variant; every colour is ``#rrggbb``.

    Pages: ``background`` lies behind everything, ``panel`` behind a part of a page; ``line`` rules
    and grids, ``accent`` links and focus. Each standing of a span of the description (understood,
    inferred, …) has a background that text can be read on, and an ``…_edge``.

    Pictures: ``ground`` is what no road covers, ``halo`` the rim of letters on it. ``mark`` are
    marks on roads, ``outline`` edges of bodies, ``glass`` the windscreen that shows their front.
    ``hidden`` is what somebody cannot see, ``conflict`` common ground of two ways. ``held``,
    ``failed`` and ``open`` say how a statement or a check came out, each with a ``…_wash`` to
    write on.
    """

    name: str
    background: str = _both("#f5f7f9", "#14181d")
    panel: str = _both("#ffffff", "#1c2229")
    text: str = _both("#1b2330", "#e8edf3")
    text_soft: str = _both("#4e5968", "#a9b4c2")
    line: str = _both("#dde2e8", "#353d47")
    accent: str = _both("#00558a", "#7cc4ff")
    ground: str = _both("#e9efe4", "#1e2822")
    road: str = _both("#c3c9d1", "#3d444d")
    parking: str = _both("#b4bbc5", "#343a43")
    cycle_lane: str = _both("#c98f86", "#6d3f3a")
    shoulder: str = _both("#d6dbd6", "#2f3633")
    sidewalk: str = _both("#e0dbd0", "#4a4740")
    kerb: str = _both("#9aa2ad", "#6c7683")
    mark: str = _both("#ffffff", "#c9d1db")
    halo: str = _both("#ffffff", "#14181d")
    outline: str = _both("#1b2330", "#0b0e12")
    glass: str = _both("#ffffff", "#14181d")
    ego: str = _both("#0072b2", "#56b4e9")
    participants: tuple[str, ...] = _both(
        ("#d55e00", "#87c300", "#6900a5", "#ff78c3", "#4b5a1e", "#3cb4ff",
         "#69001e", "#a55aff", "#c30078", "#0000f0"),
        ("#ff8a3d", "#1e8778", "#781eff", "#e1ff00", "#ff0f96", "#c32d00",
         "#00fff0", "#ffd296", "#b400b4", "#9678f0"),
    )  # fmt: skip
    thing: str = _both("#8f8675", "#a79c88")
    plant: str = _both("#6f9a5a", "#7fae68")
    brake_light: str = _both("#ff2a1a", "#ff4a3a")
    signal_red: str = _both("#e0221b", "#ff4a3f")
    signal_amber: str = _both("#f5a300", "#ffb420")
    signal_green: str = _both("#12a150", "#2fd07a")
    signal_off: str = _both("#5b6675", "#6c7683")
    hazard: str = _both("#b3261e", "#ff7b72")
    conflict: str = _both("#b3261e", "#ff7b72")
    hidden: str = _both("#4e5968", "#a9b4c2")
    held: str = _both("#0b6b3f", "#7ee0ad")
    held_wash: str = _both("#d3efdf", "#12402a")
    failed: str = _both("#7d1610", "#ffb3ae")
    failed_wash: str = _both("#f8d0cf", "#5c1a17")
    open: str = _both("#6a3f00", "#ffd08a")
    open_wash: str = _both("#fbe3c0", "#4d3200")
    understood: str = _both("#cfe6f7", "#173f5c")
    understood_edge: str = _both("#0072b2", "#56b4e9")
    inferred: str = _both("#fbe3c0", "#4d3200")
    inferred_edge: str = _both("#b26a00", "#f0a638")
    assumed: str = _both("#e6e6ea", "#363a42")
    assumed_edge: str = _both("#6d6d78", "#9aa2ad")
    contradicted: str = _both("#e5d0f5", "#41265a")
    contradicted_edge: str = _both("#6a2c91", "#c79bea")
    unsupported: str = _both("#f8d0cf", "#5c1a17")
    unsupported_edge: str = _both("#b3261e", "#ff7b72")

    def colours(self, ids: Iterable[str], ego: str) -> dict[str, str]:
        """A colour for each participant, the ego's first; beyond the last they begin again."""
        others = (name for name in ids if name != ego)
        count = len(self.participants)
        return {ego: self.ego} | {n: self.participants[i % count] for i, n in enumerate(others)}

    def properties(self) -> dict[str, str]:
        """The colours as CSS custom properties, such as ``--road`` and ``--participant-1``."""
        found: dict[str, str] = {}
        for each in fields(self):
            value = getattr(self, each.name)
            if isinstance(value, tuple):
                found |= {f"--participant-{i}": colour for i, colour in enumerate(value, start=1)}
            elif each.name != "name":
                found[f"--{each.name.replace('_', '-')}"] = value
        return found


def _variant(name: str) -> Theme:
    return Theme(name, **{f.name: f.metadata[name] for f in fields(Theme) if f.name != "name"})


LIGHT, DARK = _variant("light"), _variant("dark")
THEMES = {theme.name: theme for theme in (LIGHT, DARK)}


def css() -> str:
    """Both variants as CSS: what the system prefers, unless ``data-theme`` on an element says.

    Paper is light.
    """
    light, dark = _block(LIGHT), _block(DARK)
    return (
        f":root, [data-theme='light'] {{ color-scheme: light; {light} }}\n"
        f"@media screen and (prefers-color-scheme: dark) {{ :root:not([data-theme]) "
        f"{{ color-scheme: dark; {dark} }} }}\n"
        f"[data-theme='dark'] {{ color-scheme: dark; {dark} }}\n"
    )


def _block(theme: Theme) -> str:
    return " ".join(f"{name}: {colour};" for name, colour in theme.properties().items())
