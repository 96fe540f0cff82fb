"""The highway code, as tables: who meets whom, who gives way, and why.

A row is what you do, a column what the other does. A cell holds

    X crossing, M merging, . the paths do not meet
    - you give way, + you go first, ? nobody can say in advance
    r  the one from the right goes first        VC 18.4a
    o  who turns across lets the oncoming pass  VC 16.2
    s  the sign: minor road before major        CS 10, B,1 and B,2
    l  the light decides                        CS 23
    u  who turns round gives way to all         VC 14.2
    R  the ring before those who come in        Highway Code 185
    1  who is first on the ring

VC is the Convention on Road Traffic, CS that on Road Signs and Signals (Vienna, 1968).
You come from the south; movements are l left, s straight, r right, u round (back).
Left-hand traffic keeps "priority to the right" (Australian Road Rules 72), so its tables are not
mirror images: what is mirrored are the paths, and who turns across.
"""

from __future__ import annotations

import pytest

from scegen.enumeration.right_of_way import road_rules
from scegen.scenario.junction import Junction
from scegen.scenario.logical import ConflictKind, Rule

LETTERS = {
    Rule.PRIORITY_TO_RIGHT: "r", Rule.ONCOMING: "o", Rule.SIGN: "s", Rule.SIGNAL: "l",
    Rule.U_TURN: "u", Rule.RING: "R", Rule.FIRST_COME: "1",
}  # fmt: skip
EAST, NORTH, WEST, SOUTH = range(4)


def cell(rules, mine, other):
    kind = rules.kinds.get((*mine, *other), ConflictKind.NONE)
    if kind is ConflictKind.NONE:
        return "."
    letter = {ConflictKind.CROSSING: "X", ConflictKind.MERGING: "M"}[kind]
    waits = rules.gives_way.get((*mine, *other))
    goes = rules.gives_way.get((*other, *mine))
    undecided = rules.open.get((*mine, *other))
    assert [waits, goes, undecided].count(None) == 2, (
        mine,
        other,
        "one rule says it, and one only",
    )
    if waits:
        return f"{letter}-{LETTERS[waits]}"
    return f"{letter}+{LETTERS[goes]}" if goes else f"{letter}?{LETTERS[undecided]}"


def table(rules, rows, columns):
    """Rows and columns are (name, way)."""
    lines = ["   " + " ".join(f"{name:<3}" for name, _ in columns)]
    for name, mine in rows:
        lines.append(f"{name:<2} " + " ".join(f"{cell(rules, mine, w):<3}" for _, w in columns))
    return [line.rstrip() for line in lines]


def four_way(control, side, me):
    """From arm ``me``: the other comes from my right R, ahead A or left L."""
    rules = road_rules(Junction(kind="four_way", arms=4, control=control, driving_side=side))
    moves = {"l": 3, "s": 2, "r": 1, "u": 0}
    rows = [(name, (me, (me + move) % 4)) for name, move in moves.items()]
    columns = [
        (f"{place}{name}", ((me + turn) % 4, (me + turn + move) % 4))
        for place, turn in {"R": 1, "A": 2, "L": 3}.items()
        for name, move in moves.items()
    ]
    return table(rules, rows, columns)


# --- a four-way crossing ----------------------------------------------------------------------

LEVEL_RIGHT = """
   Rl  Rs  Rr  Ru  Al  As  Ar  Au  Ll  Ls  Lr  Lu
l  X-r M-r .   .   .   X-o M-o .   X+r X+r .   M+u
s  X-r X-r M-r .   X+o .   .   M+u M+r X+r .   .
r  .   .   .   M+u M+o .   .   .   .   M+r .   .
u  M-u .   .   .   .   M-u .   .   .   .   M-u .
"""
"""Traffic keeps right, nobody has a sign, or everybody the same."""

MINOR_RIGHT = """
   Rl  Rs  Rr  Ru  Al  As  Ar  Au  Ll  Ls  Lr  Lu
l  X-s M-s .   .   .   X-o M-o .   X-s X-s .   M-s
s  X-s X-s M-s .   X+o .   .   M+u M-s X-s .   .
r  .   .   .   M-s M+o .   .   .   .   M-s .   .
u  M-s .   .   .   .   M-u .   .   .   .   M-s .
"""
"""You have the sign (north and south are the minor road); so has who comes from ahead."""

MAJOR_RIGHT = MINOR_RIGHT.replace("-s", "+s")
"""You are on the major road (east and west)."""

SIGNALS_RIGHT = """
   Rl  Rs  Rr  Ru  Al  As  Ar  Au  Ll  Ls  Lr  Lu
l  X?l M?l .   .   .   X-o M-o .   X?l X?l .   M?l
s  X?l X?l M?l .   X+o .   .   M+u M?l X?l .   .
r  .   .   .   M?l M+o .   .   .   .   M?l .   .
u  M?l .   .   .   .   M-u .   .   .   .   M?l .
"""
"""Opposite arms have green together."""

LEVEL_LEFT = """
   Rl  Rs  Rr  Ru  Al  As  Ar  Au  Ll  Ls  Lr  Lu
l  .   M-r .   .   .   .   M+o .   .   .   .   M+u
s  .   X-r M-r .   .   .   X+o M+u M+r X+r X+r .
r  .   X-r X-r M+u M-o X-o .   .   .   M+r X+r .
u  M-u .   .   .   .   M-u .   .   .   .   M-u .
"""
"""Traffic keeps left: now the right turn crosses the oncoming lane."""

MINOR_LEFT = """
   Rl  Rs  Rr  Ru  Al  As  Ar  Au  Ll  Ls  Lr  Lu
l  .   M-s .   .   .   .   M+o .   .   .   .   M-s
s  .   X-s M-s .   .   .   X+o M+u M-s X-s X-s .
r  .   X-s X-s M-s M-o X-o .   .   .   M-s X-s .
u  M-s .   .   .   .   M-u .   .   .   .   M-s .
"""
"""You have the sign."""

MAJOR_LEFT = MINOR_LEFT.replace("-s", "+s")
"""You are on the major road."""

SIGNALS_LEFT = MINOR_LEFT.replace("-s", "?l")
"""Whom the sign tells apart, the light does."""

FOUR_WAY = [
    (side, control, me, expected)
    for side, level, minor, major, signals in (
        ("right", LEVEL_RIGHT, MINOR_RIGHT, MAJOR_RIGHT, SIGNALS_RIGHT),
        ("left", LEVEL_LEFT, MINOR_LEFT, MAJOR_LEFT, SIGNALS_LEFT),
    )
    for control, north_south, east_west in (
        ("uncontrolled", level, level),
        ("priority_to_right", level, level),
        ("all_way_stop", level, level),  # all arrive at once: order of arrival is not known
        ("yield", minor, major),
        ("stop", minor, major),
        ("signals", signals, signals),
    )
    for me, expected in (
        (SOUTH, north_south), (NORTH, north_south), (EAST, east_west), (WEST, east_west)
    )
]  # fmt: skip


@pytest.mark.parametrize(("side", "control", "me", "expected"), FOUR_WAY)
def test_four_way(side, control, me, expected):
    assert four_way(control, side, me) == expected.strip("\n").split("\n")


# --- a T: the road runs east and west, the stem south -----------------------------------------


def tee(control, side):
    """EW is from east to west; blank where both come from one arm."""
    rules = road_rules(Junction(kind="t", arms=3, control=control, driving_side=side))
    ways = {"EW": (0, 1), "ES": (0, 2), "WE": (1, 0), "WS": (1, 2), "SE": (2, 0), "SW": (2, 1)}
    lines = ["   " + " ".join(f"{name:<3}" for name in ways)]
    for name, mine in ways.items():
        cells = ["" if mine[0] == way[0] else cell(rules, mine, way) for way in ways.values()]
        lines.append(f"{name} " + " ".join(f"{text:<3}" for text in cells))
    return [line.rstrip() for line in lines]


T_LEVEL_RIGHT = """
   EW  ES  WE  WS  SE  SW
EW         .   .   .   M+r
ES         X-o M-o .   X+r
WE .   X+o         M-r X-r
WS .   M+o         .   .
SE .   .   M+r .
SW M-r X-r X+r .
"""
"""The stem has no lower rank: VC knows no rule for the T."""

T_SIGNS_RIGHT = """
   EW  ES  WE  WS  SE  SW
EW         .   .   .   M+s
ES         X-o M-o .   X+s
WE .   X+o         M+s X+s
WS .   M+o         .   .
SE .   .   M-s .
SW M-s X-s X-s .
"""
"""The sign stands at the stem."""

T_SIGNALS_RIGHT = T_SIGNS_RIGHT.replace("-s", "?l").replace("+s", "?l")
"""The stem has a green of its own."""

T_LEVEL_LEFT = """
   EW  ES  WE  WS  SE  SW
EW         .   X+o X+r M+r
ES         .   M+o .   .
WE .   .           M-r .
WS X-o M-o         X-r .
SE X-r .   M+r X+r
SW M-r .   .   .
"""
"""Traffic keeps left."""

T_SIGNS_LEFT = """
   EW  ES  WE  WS  SE  SW
EW         .   X+o X+s M+s
ES         .   M+o .   .
WE .   .           M+s .
WS X-o M-o         X+s .
SE X-s .   M-s X-s
SW M-s .   .   .
"""
"""The sign stands at the stem."""

T_SIGNALS_LEFT = T_SIGNS_LEFT.replace("-s", "?l").replace("+s", "?l")
"""The stem has a green of its own."""

LEVEL = ("uncontrolled", "priority_to_right", "all_way_stop", "signals_off")
"""Controls that set no arm above another."""


@pytest.mark.parametrize(
    ("side", "controls", "expected"),
    [
        ("right", LEVEL, T_LEVEL_RIGHT),
        ("right", ("yield", "stop"), T_SIGNS_RIGHT),
        ("right", ("signals",), T_SIGNALS_RIGHT),
        ("left", LEVEL, T_LEVEL_LEFT),
        ("left", ("yield", "stop"), T_SIGNS_LEFT),
        ("left", ("signals",), T_SIGNALS_LEFT),
    ],
)
def test_tee(side, controls, expected):
    for control in controls:
        assert tee(control, side) == expected.strip("\n").split("\n"), control


# --- a roundabout with four arms; movements are the number of the exit --------------------------


def roundabout(control, side, me):
    rules = road_rules(Junction(kind="roundabout", arms=4, control=control, driving_side=side))
    step = 1 if side == "right" else -1
    rows = [(str(k), (me, (me + step * k) % 4)) for k in (1, 2, 3, 4)]
    columns = [
        (f"{place}{k}", ((me + turn) % 4, (me + turn + step * k) % 4))
        for place, turn in {"R": 1, "A": 2, "L": 3}.items()
        for k in (1, 2, 3, 4)
    ]
    return table(rules, rows, columns)


RING_RIGHT = """
   R1  R2  R3  R4  A1  A2  A3  A4  L1  L2  L3  L4
1  .   .   .   M-R .   .   M-R M-R .   M-R M-R M-R
2  M+R M+R M+R M?1 .   .   M-R M-R .   M-R M-R M-R
3  M+R M+R M+R M?1 M+R M+R M?1 M?1 .   M-R M-R M-R
4  M+R M+R M+R M?1 M+R M+R M?1 M?1 M+R M?1 M?1 M?1
"""
"""The ring first: it runs counter-clockwise, so you enter before those from the left pass."""

ENTRY_RIGHT = """
   R1  R2  R3  R4  A1  A2  A3  A4  L1  L2  L3  L4
1  .   .   .   M+r .   .   M+r M+r .   M+r M+r M+r
2  M-r M-r M-r M?1 .   .   M+r M+r .   M+r M+r M+r
3  M-r M-r M-r M?1 M-r M-r M?1 M?1 .   M+r M+r M+r
4  M-r M-r M-r M?1 M-r M-r M?1 M?1 M-r M?1 M?1 M?1
"""
"""Who comes in comes from the right of the ring: the old French rule."""

RING_LEFT = """
   R1  R2  R3  R4  A1  A2  A3  A4  L1  L2  L3  L4
1  .   M-R M-R M-R .   .   M-R M-R .   .   .   M-R
2  .   M-R M-R M-R .   .   M-R M-R M+R M+R M+R M?1
3  .   M-R M-R M-R M+R M+R M?1 M?1 M+R M+R M+R M?1
4  M+R M?1 M?1 M?1 M+R M+R M?1 M?1 M+R M+R M+R M?1
"""
"""Traffic keeps left: the ring itself comes from the right."""


@pytest.mark.parametrize("me", range(4))
@pytest.mark.parametrize(
    ("side", "controls", "expected"),
    [
        ("right", ("uncontrolled", "yield", "stop", "all_way_stop", "signals_off"), RING_RIGHT),
        ("right", ("priority_to_right",), ENTRY_RIGHT),
        ("left", ("uncontrolled", "priority_to_right", "yield", "stop", "all_way_stop"), RING_LEFT),
    ],
)
def test_roundabout(side, controls, expected, me):
    for control in controls:
        assert roundabout(control, side, me) == expected.strip("\n").split("\n"), control


@pytest.mark.parametrize(("side", "expected"), [("right", RING_RIGHT), ("left", RING_LEFT)])
def test_signals_at_a_roundabout_leave_it_all_to_the_light(side, expected):
    found = [line[3:].split() for line in roundabout("signals", side, SOUTH)[1:]]
    drawn = [line[3:].split() for line in expected.strip("\n").split("\n")[1:]]
    assert found == [["." if text == "." else "M?l" for text in row] for row in drawn]
