"""Which lanes drives take at a junction: where words place them, and where those meet who are to.

The outermost lane is taken where nothing is said. Where those who are to meet do not by the usual
markings, the junction gets a way by which they do: across another's nose, or into its lane.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial
from itertools import combinations

from scegen.concretization.drafts import DriveDraft
from scegen.concretization.hazards.aside import goes_outwards
from scegen.concretization.hazards.parties import pairs, same_arm
from scegen.concretization.meetings import ways_touch
from scegen.concretization.setup import Setup
from scegen.concretization.tale import SIDEWAYS, outward, side_of
from scegen.concretization.turning_ways import abreast, at_odds, least_radius_m
from scegen.concretization.wishes import LIKELY, SAID, USUAL, Wish, least_broken
from scegen.scenario.arms import arm_angles_deg, seen_from
from scegen.scenario.logical import ConflictKind
from scegen.scenario.road_parameters import Turn
from scegen.scenario.vocabulary import (
    Approach,
    DrivingSide,
    HazardKind,
    JunctionKind,
    Maneuver,
    Side,
)

_WITHOUT_TURNS = frozenset({JunctionKind.STRAIGHT, JunctionKind.ROUNDABOUT})
_MEETS = frozenset({ConflictKind.CROSSING, ConflictKind.MERGING})
_LATE_RADIUS_M = 6.5
_ABREAST = LIKELY / 2
"""What it weighs that one turns across another beside it: less than the side that is said."""
_AS_IT_WAS, _EGO_AS_IT_WAS = 0.1, 0.15


@dataclass(frozen=True, slots=True)
class Lanes:
    """Lanes of a drive, as in the scenario files."""

    entry: int
    ring: int | None
    exit: int

    def give(self, draft: DriveDraft) -> None:
        """Let it have them; it is to be laid anew."""
        draft.entry_lane, draft.ring_lane, draft.exit_lane = self.entry, self.ring, self.exit
        draft.laid_ = None


Choice = Mapping[str, Lanes]
LaneWish = Wish[Lanes]


def choose_junction_lanes(scene: Setup) -> None:
    """Give every drive its lanes, and the junction the markings that they need.

    Of those who are to meet, dangers count first, then the ego's conflicts; those of others only
    where nobody else could meet. Other markings than the usual are made only for a danger, or where
    else nobody would meet at all.
    """
    options = {name: _options(scene, draft) for name, draft in scene.drives.items()}
    words = [*_from_words(scene)]
    placed = [wish for wish in words if wish.can_be_met(options)]
    _, before = least_broken(options, placed)
    for name in {name for wish in placed for name in wish.who} | _sideways(scene):
        options[name] = [before[name]]
    blocked = any(stand.standing.in_lane for stand in scene.stands.values())
    meetings = [] if blocked else [*_meetings(scene)]
    kept = [_stays(scene, name, lanes) for name, lanes in before.items()]

    def best() -> Choice:
        placed, possible = (
            [wish for wish in wishes if wish.can_be_met(options)] for wishes in (words, meetings)
        )
        if any(wish.weight >= USUAL for wish in possible):
            possible = [wish for wish in possible if wish.weight >= USUAL]
        return least_broken(options, [*placed, *possible, *kept])[1]

    chosen, usual = best(), scene.road
    wanted = [w for w in (*words, *meetings) if w.weight >= _ABREAST and not w.met(chosen)]
    if not (wanted or any(wish.met(chosen) for wish in meetings)):
        wanted = meetings
    turns = _other_turns(scene, wanted)
    if any(turns.values()) and scene.road.kind not in _WITHOUT_TURNS:
        scene.mark(usual, [turn for ways in turns.values() for turn in ways])
        meetings = [*_meetings(scene)]
        for name in turns:
            found = (*options[name], *_options(scene, scene.drives[name]))
            options[name] = [*dict.fromkeys(found)]
        chosen = best()
        needed = [t for n, ways in turns.items() for t in ways if _by(t) == chosen[n]]
        scene.mark(usual, needed)
    for name, lanes in chosen.items():
        lanes.give(scene.drives[name])
        _note(scene, name, before[name], lanes, meetings)


def _by(turn: Turn) -> Lanes:
    return Lanes(turn.lane_in, None, turn.lane_out)


def _other_turns(scene: Setup, unmet: Sequence[LaneWish]) -> dict[str, list[Turn]]:
    """Ways beside the usual ones by which two do what they cannot by these, by who may take them.

    One of two beside each other goes from the other's lane, one of two who leave by one arm comes
    into the other's lane there. Two who come towards each other and both turn across pass in front
    of each other on the widest arcs: who goes on to the middle and turns there crosses the other's.
    """
    found: dict[str, list[Turn]] = {}
    for wish in (each for each in unmet if len(each.who) > 1):
        pair = [scene.drives[name] for name in wish.who]
        together = pair[0].drive.exit == pair[1].drive.exit
        for draft in pair:
            entry, exit_ = draft.drive.entry, draft.drive.exit
            usual = {(r.entry_lane, r.exit_lane) for r in scene.routes_of(draft)}
            out, radius_m = scene.road.arms[exit_].lanes_out, None
            if same_arm(*pair):
                lanes = range(1, scene.lanes_in(draft) + 1)
                ways = {(lane, min(usual)[1] if together else min(lane, out)) for lane in lanes}
            elif draft.id in _sideways(scene):
                ways = set()
            elif together:
                ways = {(lane, after) for lane, _ in usual for after in range(1, out + 1)}
            else:
                late = _both_turn_across(scene, *pair)
                ways, usual = (usual, set()) if late else (set(), usual)
                radius_m = round(max(_LATE_RADIUS_M, 1.1 * least_radius_m(draft.body)), 3)
            other = sorted(ways - usual) if entry != exit_ else []
            found.setdefault(draft.id, []).extend(
                Turn(entry=entry, lane_in=a, exit=exit_, lane_out=b, radius_m=radius_m)
                for a, b in other
            )
    return found


def _both_turn_across(scene: Setup, first: DriveDraft, second: DriveDraft) -> bool:
    """Whether two who come towards each other both turn across the oncoming lane."""
    angles = arm_angles_deg(scene.functional.junction)
    across = Maneuver.LEFT if scene.road.driving_side is DrivingSide.RIGHT else Maneuver.RIGHT
    facing = Approach.OPPOSITE in seen_from(angles, first.drive.entry, second.drive.entry)
    return facing and first.drive.turn is second.drive.turn is across


def _options(scene: Setup, draft: DriveDraft) -> list[Lanes]:
    """The lanes that lead to a drive's exit, the outermost and those that stay so first."""
    found = {Lanes(r.entry_lane, r.ring_lane, r.exit_lane) for r in scene.routes_of(draft)}
    usual = sorted(found, key=lambda o: (-o.entry, -(o.ring or 0), o.exit != o.entry, -o.exit))
    reached: set[int] = set()
    if draft.from_arm is not None:  # from where it comes out backwards
        out = scene.network.routes.get((draft.drive.entry, draft.from_arm), ())
        reached = {route.entry_lane for route in out}
    return [lanes for lanes in usual if lanes.entry in reached] or usual


def _from_words(scene: Setup) -> Iterator[LaneWish]:
    """Who drives beside whom, on the side that is said; who is in which lane."""
    groups: dict[str, list[str]] = {}
    for drive, other in abreast(scene.logical):
        name, reference = drive.participant, other.participant
        if {name, reference} <= scene.drives.keys():
            groups.setdefault(reference, []).append(name)
            yield from _beside(scene, name, reference, drive.beside_on)
    for names in groups.values():
        for a, b in combinations(names, 2):
            yield Wish((a, b), USUAL, _steps(a, b, lambda out: out != 0), f"{a} is not before {b}")
    for name, draft in scene.drives.items():
        participant = scene.functional.participant(name)
        if participant.lanes:
            yield Wish((name,), SAID, _in(name, participant.lanes), f"{name} is in its lane")
        said = participant.approaches
        diagonal = Approach.ADJACENT in said and said & {Approach.AHEAD, Approach.BEHIND}
        level = draft is scene.ego or draft.drive.entry != scene.ego.drive.entry
        if diagonal and not level and not draft.drive.beside:
            yield from _beside(scene, name, scene.ego.id)
    yield from _from_dangers(scene)
    yield from _clear_of_turning_back(scene)


def _from_dangers(scene: Setup) -> Iterator[LaneWish]:
    """Who reverses does so in the lane of the other; who cuts in in a ring comes from inside."""
    for hazard in scene.functional.hazards:
        for cause, sufferer in pairs(scene, hazard):
            if hazard.kind is HazardKind.REVERSING and same_arm(cause, sufferer):
                who = cause.id, sufferer.id
                same = _steps(*who, lambda out: out == 0)
                yield Wish(who, LIKELY, same, f"{cause.id} reverses in the lane of {sufferer.id}")
            elif hazard.kind is HazardKind.CUT_IN and scene.ring:
                inside = cause if goes_outwards(scene, cause) else sufferer
                inner = min(lanes.ring or 0 for lanes in _options(scene, inside))
                met = partial(_is_in_ring, inside.id, inner)
                yield Wish((inside.id,), LIKELY, met, f"{inside.id} is inside in the ring")


def _clear_of_turning_back(scene: Setup) -> Iterator[LaneWish]:
    """Who goes straight on is passed on its own side by nobody who turns back from the kerb."""
    back = {d.drive.entry for d in scene.drives.values() if d.drive.turn is Maneuver.U_TURN}
    for name, draft in scene.drives.items():
        plain = draft.drive.maneuver is draft.drive.turn is Maneuver.STRAIGHT
        if scene.road.kind is JunctionKind.STRAIGHT and plain and draft.drive.entry in back:
            innermost = frozenset({min(r.entry_lane for r in scene.routes_of(draft))})
            yield Wish((name,), LIKELY, _in(name, innermost), f"{name} keeps inside")


def _beside(scene: Setup, name: str, reference: str, on: Side | None = None) -> Iterator[LaneWish]:
    """In the next lane, on the side that is said, else ``on`` one; else rather the inner one."""
    words, said = f"{name} is beside {reference}", side_of(scene.functional, name, reference)
    yield Wish((name, reference), SAID, _steps(name, reference, lambda out: abs(out) == 1), words)
    step, weight = -1, USUAL / 2
    if side := said or on:
        step, weight = outward(scene.functional, side), LIKELY if said else 2 * USUAL
    yield Wish((name, reference), weight, _steps(name, reference, lambda out: out == step), words)


def _steps(name: str, reference: str, right: Callable[[int], bool]) -> Callable[[Choice], bool]:
    return lambda lanes: right(lanes[name].entry - lanes[reference].entry)


def _in(name: str, allowed: frozenset[int]) -> Callable[[Choice], bool]:
    return lambda lanes: lanes[name].entry in allowed


def _is_in_ring(name: str, ring: int, lanes: Choice) -> bool:
    return lanes[name].ring == ring


def _sideways(scene: Setup) -> set[str]:
    """Those on whose arm somebody changes lanes: theirs follow from that."""
    arms = {d.drive.entry for d in scene.drives.values() if d.drive.maneuver in SIDEWAYS}
    return {d.id for d in scene.drives.values() if d.drive.entry in arms}


def _stays(scene: Setup, name: str, own: Lanes) -> LaneWish:
    weight = _EGO_AS_IT_WAS if name == scene.functional.ego.id else _AS_IT_WAS
    return Wish((name,), weight, lambda lanes: lanes[name] == own, f"{name} keeps its lanes")


def _meetings(scene: Setup) -> Iterator[LaneWish]:
    """Who is to meet, the most important first."""
    way = cache(partial(_laid, scene))

    @cache
    def touch(first: str, lanes: Lanes, second: str, others: Lanes) -> bool:
        return ways_touch(way(first, lanes), way(second, others))

    def meeting(first: str, second: str, weight: float) -> LaneWish:
        met = lambda lanes: touch(first, lanes[first], second, lanes[second])  # noqa: E731
        return Wish((first, second), weight, met, "they meet")

    for drive, other in abreast(scene.logical):
        names = drive.participant, other.participant
        turns = {drive.turn, other.turn} != {Maneuver.STRAIGHT}
        if (
            turns
            and not SIDEWAYS & {drive.maneuver, other.maneuver}
            and scene.drives.keys() >= {*names}
            and at_odds(scene.functional, drive, other)
        ):
            yield meeting(*names, _ABREAST)
    alone = len(scene.drives) == 2 and not (scene.functional.hazards or scene.walks)
    for one, two in combinations(scene.drives.values(), 2) if alone else ():
        if not same_arm(one, two):
            yield meeting(one.id, two.id, USUAL)  # of what else does it tell?
    for hazard in scene.functional.hazards:
        for cause, sufferer in pairs(scene, hazard):
            if cause.drive.entry != sufferer.drive.entry:
                yield meeting(cause.id, sufferer.id, LIKELY)
    for conflict in scene.logical.conflicts:
        who = (conflict.first, conflict.second)
        if conflict.kind in _MEETS and scene.drives.keys() >= {*who}:
            yield meeting(*who, USUAL if scene.functional.ego.id in who else USUAL / 2)


def _laid(scene: Setup, name: str, lanes: Lanes) -> DriveDraft:
    """A drive laid in some lanes; its own stay as they are."""
    known = scene.drives[name]
    draft = DriveDraft(name, known.kind, known.body, known.drive, 1.0)
    lanes.give(draft)
    draft.lane_changes = list(known.lane_changes)
    draft.lay(scene.network)
    return draft


def _note(scene: Setup, name: str, before: Lanes, after: Lanes, wishes: Sequence[LaneWish]) -> None:
    """Say which lanes were changed."""
    partners = [other for wish in wishes if name in wish.who for other in wish.who if other != name]
    for field in ("entry", "ring", "exit"):
        was, now = getattr(before, field), getattr(after, field)
        if was != now and now is not None and partners:
            reason = f"so that its way and that of {partners[0]} meet"
            scene.note(f"{name}.{field}_lane", now, reason, was)
