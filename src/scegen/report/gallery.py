"""All logical scenarios of a description in one picture, after the source paper's figure.

Where there are many, those with the same moves are folded into a group of which a few are drawn,
and the groups are paged: a picture of a height that people look at.
"""

from dataclasses import dataclass

from scegen.errors import InputError
from scegen.report.drawing import Style, box, document, element, group, letters
from scegen.report.theme import LIGHT
from scegen.report.tile import TILE_WIDTH, arm_legend, moves_words, roads, tile_body, tile_height
from scegen.scenario.logical import LogicalScenario, LogicalSet
from scegen.scenario.wording import counted

MOST_TILES = 500
"""More than this nobody looks at; the rest is counted in a note."""
MOST_CHARACTERS = 2_800_000
"""Larger reports open slowly; tiles beyond are counted, too."""
PAGE = 40
"""Tiles on a page of the gallery."""
_JUNCTION = '<use href="#junction"/>'
_COLUMNS, _FEWEST = 5, 3
_GAP = 12
_HEAD = 40
_HEADING = 40
_NOTE = 17
_GROUPED = 20
"""So many scenarios are grouped by pattern."""


@dataclass(frozen=True, slots=True)
class Tiles:
    """The scenarios of a set that are drawn, and each as elements that refer to ``junction``."""

    shown: tuple[LogicalScenario, ...]
    bodies: tuple[str, ...]
    junction: str


@dataclass(frozen=True, slots=True)
class _Card:
    """A tile of the gallery; the first of a group has its heading."""

    scenario: LogicalScenario
    heading: str = ""
    folded: int = 0


def draw_tiles(logical_set: LogicalSet) -> Tiles:
    """As many as anybody looks at, from the first."""
    functional = logical_set.functional
    shown = logical_set.scenarios[:MOST_TILES]
    bodies = [tile_body(s, functional, _JUNCTION) for s in shown]
    room = sum(map(len, bodies))
    while room > MOST_CHARACTERS:
        room -= len(bodies.pop())
    junction = group(roads(functional), id="junction")
    return Tiles(shown[: len(bodies)], tuple(bodies), junction)


def gallery_svg(
    logical_set: LogicalSet, *, page: int = 1, moves: tuple[int, ...] | None = None
) -> str:
    """A page of the gallery as an SVG document; the same input gives the same text.

    Pages count from 1; ``moves`` is the pattern of a group to be shown unfolded, None for all
    groups.

    Raises:
        InputError: there is no such page or group.
    """
    functional, theme = logical_set.functional, LIGHT
    cards = _cards(logical_set, moves)
    if moves is not None and not cards:
        raise InputError(f"no scenario has the moves {' '.join(map(str, moves))}", where="--moves")
    pages = max(1, -(-len(cards) // PAGE))
    if not 1 <= page <= pages:
        raise InputError(f"there is no page {page}", where="--page", hint=f"There are {pages}.")
    shown = cards[(page - 1) * PAGE : page * PAGE]
    notes = _notes(logical_set, shown, page, pages)
    columns = max(min(_COLUMNS, len(shown)), _FEWEST)
    width = _GAP + columns * (TILE_WIDTH + _GAP)
    height = tile_height(functional)
    above = _HEADING if any(card.heading for card in shown) else 0
    top = _HEAD + _NOTE * len(notes)
    drawn = []
    for place, card in enumerate(shown):
        x = _GAP + (place % columns) * (TILE_WIDTH + _GAP)
        y = top + (place // columns) * (above + height + _GAP) + above
        drawn.append(_drawn(card, logical_set, height, x, y))
    total = top + -(-len(shown) // columns) * (above + height + _GAP) + _GAP
    title = counted(len(logical_set.scenarios), "logical scenario")
    head = element("defs", group(roads(functional), id="junction"))
    head += box(0, 0, width, total, theme.panel)
    head += letters(title, _GAP, 28, 18, theme.text, bold=True)
    for number, note in enumerate(notes):
        head += letters(note, _GAP, 47 + _NOTE * number, 12.5, theme.text_soft)
    described = summary(logical_set)
    return document(width, total, head + "".join(drawn), title=title, describes=described) + "\n"


def _drawn(card: _Card, logical_set: LogicalSet, height: int, x: float, y: float) -> str:
    """A tile with its heading, and the edges of those folded behind it."""
    theme = LIGHT
    moves, _, sizes = card.heading.partition(": ")
    words = letters(moves, 0, -22, 12.5, theme.text, bold=True) if moves else ""
    words += letters(sizes, 0, -7, 11, theme.text_soft) if sizes else ""
    frame: dict[str, Style] = {"rx": 8.0, "stroke": theme.line}
    behind = "".join(
        box(shift, shift, TILE_WIDTH, height, theme.panel, **frame)
        for shift in ((6, 3) if card.folded else ())
    )
    tile = box(0, 0, TILE_WIDTH, height, theme.background, **frame)
    tile += tile_body(card.scenario, logical_set.functional, _JUNCTION)
    return group(words + behind + tile, transform=f"translate({x} {y})")


def _cards(logical_set: LogicalSet, moves: tuple[int, ...] | None = None) -> list[_Card]:
    """What is drawn, in order: of each group as many as all pages together have room for."""
    everything = logical_set.scenarios
    if moves is not None:
        return [_Card(s) for s in everything if s.pattern == moves]
    found = groups(everything)
    if len(found) == 1 and not found[0][0]:
        return [_Card(scenario) for scenario in everything]
    each = PAGE if len(everything) <= PAGE else max(1, PAGE // len(found))
    cards = []
    for heading, members in found:
        for number, place in enumerate(members[:each]):
            last = number == each - 1
            folded = len(members) - each if last else 0
            cards.append(_Card(everything[place], heading if number == 0 else "", max(folded, 0)))
    return cards


def groups(shown: tuple[LogicalScenario, ...]) -> list[tuple[str, list[int]]]:
    """Places in the list by pattern, with a heading; few or all different ones stay in a row."""
    by_pattern: dict[tuple[int, ...], list[int]] = {}
    for place, scenario in enumerate(shown):
        by_pattern.setdefault(scenario.pattern, []).append(place)
    if len(shown) < _GROUPED or len(by_pattern) > len(shown) / 2:
        return [("", list(range(len(shown))))]
    found = []
    for pattern, members in sorted(by_pattern.items()):
        size = sum(shown[place].class_size for place in members)
        times = f", {counted(size, 'assignment')}" if size > len(members) else ""
        words = f"Moves {moves_words(pattern)}: {counted(len(members), 'scenario')}{times}"
        found.append((words, members))
    return found


def summary(logical_set: LogicalSet) -> str:
    """What was counted, and under which reduction, in one sentence."""
    certificate = logical_set.certificate
    return (
        f"{counted(certificate.total, 'assignment')} of entries and moves fall into "
        f"{counted(certificate.count, 'scenario')} "
        f"(reduction {logical_set.reduction}, arms {logical_set.arms}"
        f"{'' if certificate.complete else ', listing incomplete'})"
    )


def _notes(logical_set: LogicalSet, shown: list[_Card], page: int, pages: int) -> list[str]:
    missing = max(len(logical_set.scenarios), logical_set.certificate.count) - len(shown)
    more = f" — {missing:,} more not drawn" if missing > 0 else ""
    if pages > 1:
        more += f" on this page, {page} of {pages} (scegen gallery --page)"
    notes = [
        summary(logical_set) + more,
        f"Arms: {arm_legend(logical_set.functional)}",
        "Ways cross at a ring ○ and merge at a diamond ◇; E is the ego; "
        "×n: the scenario stands for n assignments.",
        "Moves: how many arms further on, counter-clockwise, each vehicle leaves.",
    ]
    if any(card.folded for card in shown):
        notes.append("A pile stands for more with the same moves: scegen gallery --moves 1,2,…")
    return notes
