"""Every colour of every picture and page, by what it stands for; a light and a dark variant.

Participants keep apart for the colour-blind too (a test simulates them); shape, name and dash
pattern tell the same again, so that no picture rests on colour alone.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields


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
    background: str
    panel: str
    text: str
    text_soft: str
    line: str
    accent: str
    ground: str
    road: str
    parking: str
    cycle_lane: str
    shoulder: str
    sidewalk: str
    kerb: str
    mark: str
    halo: str
    outline: str
    glass: str
    ego: str
    participants: tuple[str, ...]
    thing: str
    plant: str
    brake_light: str
    signal_red: str
    signal_amber: str
    signal_green: str
    signal_off: str
    hazard: str
    conflict: str
    hidden: str
    held: str
    held_wash: str
    failed: str
    failed_wash: str
    open: str
    open_wash: str
    understood: str
    understood_edge: str
    inferred: str
    inferred_edge: str
    assumed: str
    assumed_edge: str
    contradicted: str
    contradicted_edge: str
    unsupported: str
    unsupported_edge: str

    def colours(self, ids: Iterable[str], ego: str) -> dict[str, str]:
        """A colour for each participant, the ego's first; beyond the last they begin again."""
        others = (name for name in ids if name != ego)
        count = len(self.participants)
        return {ego: self.ego} | {n: self.participants[i % count] for i, n in enumerate(others)}

    def properties(self) -> dict[str, str]:
        """The colours as CSS custom properties, such as ``--road`` and ``--participant-1``."""
        found: dict[str, str] = {}
        for field in fields(self):
            value = getattr(self, field.name)
            if isinstance(value, tuple):
                found |= {f"--participant-{i}": colour for i, colour in enumerate(value, start=1)}
            elif field.name != "name":
                found[f"--{field.name.replace('_', '-')}"] = value
        return found


LIGHT = Theme(
    name="light",
    background="#f5f7f9",
    panel="#ffffff",
    text="#1b2330",
    text_soft="#4e5968",
    line="#dde2e8",
    accent="#00558a",
    ground="#e9efe4",
    road="#c3c9d1",
    parking="#b4bbc5",
    cycle_lane="#c98f86",
    shoulder="#d6dbd6",
    sidewalk="#e0dbd0",
    kerb="#9aa2ad",
    mark="#ffffff",
    halo="#ffffff",
    outline="#1b2330",
    glass="#ffffff",
    ego="#0072b2",
    participants=(
        "#d55e00",
        "#87c300",
        "#6900a5",
        "#ff78c3",
        "#4b5a1e",
        "#3cb4ff",
        "#69001e",
        "#a55aff",
        "#c30078",
        "#0000f0",
    ),
    thing="#8f8675",
    plant="#6f9a5a",
    brake_light="#ff2a1a",
    signal_red="#e0221b",
    signal_amber="#f5a300",
    signal_green="#12a150",
    signal_off="#5b6675",
    hazard="#b3261e",
    conflict="#b3261e",
    hidden="#4e5968",
    held="#0b6b3f",
    held_wash="#d3efdf",
    failed="#7d1610",
    failed_wash="#f8d0cf",
    open="#6a3f00",
    open_wash="#fbe3c0",
    understood="#cfe6f7",
    understood_edge="#0072b2",
    inferred="#fbe3c0",
    inferred_edge="#b26a00",
    assumed="#e6e6ea",
    assumed_edge="#6d6d78",
    contradicted="#e5d0f5",
    contradicted_edge="#6a2c91",
    unsupported="#f8d0cf",
    unsupported_edge="#b3261e",
)
DARK = Theme(
    name="dark",
    background="#14181d",
    panel="#1c2229",
    text="#e8edf3",
    text_soft="#a9b4c2",
    line="#353d47",
    accent="#7cc4ff",
    ground="#1e2822",
    road="#3d444d",
    parking="#343a43",
    cycle_lane="#6d3f3a",
    shoulder="#2f3633",
    sidewalk="#4a4740",
    kerb="#6c7683",
    mark="#c9d1db",
    halo="#14181d",
    outline="#0b0e12",
    glass="#14181d",
    ego="#56b4e9",
    participants=(
        "#ff8a3d",
        "#1e8778",
        "#781eff",
        "#e1ff00",
        "#ff0f96",
        "#c32d00",
        "#00fff0",
        "#ffd296",
        "#b400b4",
        "#9678f0",
    ),
    thing="#a79c88",
    plant="#7fae68",
    brake_light="#ff4a3a",
    signal_red="#ff4a3f",
    signal_amber="#ffb420",
    signal_green="#2fd07a",
    signal_off="#6c7683",
    hazard="#ff7b72",
    conflict="#ff7b72",
    hidden="#a9b4c2",
    held="#7ee0ad",
    held_wash="#12402a",
    failed="#ffb3ae",
    failed_wash="#5c1a17",
    open="#ffd08a",
    open_wash="#4d3200",
    understood="#173f5c",
    understood_edge="#56b4e9",
    inferred="#4d3200",
    inferred_edge="#f0a638",
    assumed="#363a42",
    assumed_edge="#9aa2ad",
    contradicted="#41265a",
    contradicted_edge="#c79bea",
    unsupported="#5c1a17",
    unsupported_edge="#ff7b72",
)
THEMES = {theme.name: theme for theme in (LIGHT, DARK)}


def css() -> str:
    """Both variants as CSS: what the system prefers, unless ``data-theme`` on an element says."""
    light, dark = _block(LIGHT), _block(DARK)
    return (
        f":root, [data-theme='light'] {{ color-scheme: light; {light} }}\n"
        f"@media (prefers-color-scheme: dark) {{ :root:not([data-theme]) "
        f"{{ color-scheme: dark; {dark} }} }}\n"
        f"[data-theme='dark'] {{ color-scheme: dark; {dark} }}\n"
    )


def _block(theme: Theme) -> str:
    return " ".join(f"{name}: {colour};" for name, colour in theme.properties().items())
