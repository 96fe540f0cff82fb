"""Which lanes drives take at a junction: where words place them, and where those meet who are to.

The outermost lane is taken where nothing is said. Where two leave by one arm and none of their
lanes lets them meet, one of them moves over into the other's lane behind the junction.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial

from scegen.concretization.aside import change_length_m
from scegen.concretization.drafts import DriveDraft
from scegen.concretization.encounters import pairs, same_arm
from scegen.concretization.meetings import first_ground
from scegen.concretization.rings import goes_outwards
from scegen.concretization.roads import passing_who_hides
from scegen.concretization.setup import Setup, require_room
from scegen.concretization.tale import SIDEWAYS
from scegen.concretization.turning_ways import abreast, is_outward, lanes_abreast
from scegen.concretization.wishes import LIKELY, SAID, USUAL, Wish, least_broken
from scegen.motion.paths import END_MARGIN_M
from scegen.scenario.concrete import LaneChange
from scegen.scenario.logical import MEETING
from scegen.scenario.vocabulary import Approach, HazardKind, JunctionKind, Maneuver

_BEHIND_JUNCTION_M = 2.0
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


def choose_junction_lanes(scene: Setup) -> None:
    """Give every drive its lanes.

    Of those who are to meet, dangers count first, then the ego's conflicts; those of others only
    where nobody else could meet. Somebody moves over only for a danger, or where else nobody would
    meet at all.
    """
    options = {name: _options(scene, draft) for name, draft in scene.drives.items()}
    placed = [w for w in _from_words(scene) if w.can_be_met(options)]
    _, before = least_broken(options, placed)
    for name in _bound(scene, placed):
        options[name] = [before[name]]
    blocked = any(stand.motion.in_lane for stand in scene.stands.values())
    meetings = [] if blocked else [*_meetings(scene)]
    possible = [wish for wish in meetings if wish.can_be_met(options)]
    if any(wish.weight >= USUAL for wish in possible):
        possible = [wish for wish in possible if wish.weight >= USUAL]
    kept = [_stays(scene, name, lanes) for name, lanes in before.items()]
    _, chosen = least_broken(options, [*placed, *possible, *kept])
    for name, lanes in chosen.items():
        lanes.give(scene.drives[name])
        _note(scene, name, before[name], lanes, possible)
    met = any(wish.met(chosen) for wish in meetings)
    for wish in meetings:
        if not wish.met(chosen) and (wish.weight >= LIKELY or not met):
            met |= _move_over(scene, chosen, *(scene.drives[name] for name in wish.who))


def _options(scene: Setup, draft: DriveDraft) -> list[Lanes]:
    """The lanes that lead to a drive's exit, the outermost and those that stay so first."""
    found = {Lanes(r.entry_lane, r.ring_lane, r.exit_lane) for r in scene.routes_of(draft)}
    usual = sorted(found, key=lambda o: (-o.entry, -(o.ring or 0), o.exit != o.entry, -o.exit))
    reached = {lanes_abreast(scene.functional, scene.logical, scene.road).get(draft.id)}
    return [lanes for lanes in usual if lanes.entry in reached] or usual


def _from_words(scene: Setup) -> Iterator[Wish]:
    """Who drives beside whom, on the side that is said; who is in which lane."""
    for drive, other in abreast(scene.logical):
        name, reference = drive.participant, other.participant
        if {name, reference} <= scene.drives.keys():
            yield from _beside(scene, name, reference)
    for name, draft in scene.drives.items():
        participant = scene.functional.participant(name)
        if participant.lanes:
            said_in = participant.lanes
            yield Wish(
                (name,), SAID, lambda own, n=said_in: own.entry in n, f"{name} is in its lane"
            )
        said = participant.approaches
        diagonal = Approach.ADJACENT in said and said & {Approach.AHEAD, Approach.BEHIND}
        level = draft is scene.ego or draft.drive.entry != scene.ego.drive.entry
        if diagonal and not level and not draft.drive.beside:
            yield from _beside(scene, name, scene.ego.id)
        if not level and said and said <= {Approach.AHEAD, Approach.BEHIND}:
            pair, same = (name, scene.ego.id), _steps(lambda out: out == 0)
            yield Wish(pair, SAID, same, f"{name} is in the lane of {scene.ego.id}")
    yield from _from_dangers(scene)
    yield from _clear_of_turning_back(scene)


def _from_dangers(scene: Setup) -> Iterator[Wish]:
    """Who hides another is passed by on the outside; who cuts in in a ring comes from inside."""
    for name, hiding in passing_who_hides(scene.functional, scene.logical.drives):
        outside = _steps(lambda out: out > 0)
        yield Wish((name, hiding), SAID, outside, f"{name} passes {hiding} by, which hides it")
    for hazard in scene.functional.hazards:
        for cause, sufferer in pairs(scene, hazard):
            if hazard.kind is HazardKind.CUT_IN and scene.ring:
                inside = cause if goes_outwards(scene, cause) else sufferer
                yield from _inmost(scene, inside, lambda lanes: lanes.ring or 0)


def _clear_of_turning_back(scene: Setup) -> Iterator[Wish]:
    """Who goes straight on is passed on its own side by nobody who turns back from the kerb."""
    back = {d.drive.entry for d in scene.drives.values() if d.drive.turn is Maneuver.U_TURN}
    for draft in scene.drives.values():
        plain = draft.drive.maneuver is draft.drive.turn is Maneuver.STRAIGHT
        if scene.road.kind is JunctionKind.STRAIGHT and plain and draft.drive.entry in back:
            yield from _inmost(scene, draft, lambda lanes: lanes.entry)


def _inmost(scene: Setup, draft: DriveDraft, lane: Callable[[Lanes], int]) -> Iterator[Wish]:
    """In the innermost lane that leads where it goes."""
    name, least = draft.id, min(map(lane, _options(scene, draft)))
    yield Wish((name,), LIKELY, lambda own: lane(own) == least, f"{name} keeps inside")


def _beside(scene: Setup, name: str, reference: str) -> Iterator[Wish]:
    """In the next lane, on the side that is said; where none is, rather the inner one."""
    words = f"{name} is beside {reference}"
    yield Wish((name, reference), SAID, _steps(lambda out: abs(out) == 1), words)
    outward = is_outward(scene.functional, name, reference)
    step, weight = (1 if outward else -1), (USUAL / 2 if outward is None else LIKELY)
    yield Wish((name, reference), weight, _steps(lambda out: out == step), words)


def _steps(right: Callable[[int], bool]) -> Callable[[Lanes, Lanes], bool]:
    return lambda own, other: right(own.entry - other.entry)


def _bound(scene: Setup, placed: Sequence[Wish]) -> set[str]:
    """Those whose lanes follow from something else than whom they meet."""
    bound = {name for wish in placed for name in wish.who}
    sideways = {d.drive.entry for d in scene.drives.values() if d.drive.maneuver in SIDEWAYS}
    return bound | {d.id for d in scene.drives.values() if d.drive.entry in sideways}


def _stays(scene: Setup, name: str, own: Lanes) -> Wish:
    weight = _EGO_AS_IT_WAS if name == scene.functional.ego.id else _AS_IT_WAS
    return Wish((name,), weight, lambda lanes: lanes == own, f"{name} keeps its lanes")


def _meetings(scene: Setup) -> Iterator[Wish]:
    """Who is to meet, the most important first."""
    way = cache(partial(_laid, scene))

    @cache
    def meet(first: str, second: str, lanes: Lanes, others: Lanes) -> bool:
        return first_ground(way(first, lanes), way(second, others)) is not None

    dangers = (pair for hazard in scene.functional.hazards for pair in pairs(scene, hazard))
    told = [((a.id, b.id), LIKELY) for a, b in dangers if not same_arm(a, b)]
    for conflict in scene.logical.conflicts:
        who = (conflict.first, conflict.second)
        if conflict.kind in MEETING and scene.drives.keys() >= {*who}:
            told.append((who, USUAL if scene.functional.ego.id in who else USUAL / 2))
    return (Wish(who, weight, partial(meet, *who), "they meet") for who, weight in told)


def _laid(scene: Setup, name: str, lanes: Lanes) -> DriveDraft:
    """A drive laid in some lanes; its own stay as they are."""
    known = scene.drives[name]
    draft = DriveDraft(name, known.body, known.drive, 1.0)
    lanes.give(draft)
    draft.lane_changes = list(known.lane_changes)
    draft.lay(scene.network)
    return draft


def _move_over(scene: Setup, lanes: Choice, first: DriveDraft, second: DriveDraft) -> bool:
    """Let one of two who leave by one arm change into the other's lane there; whether it can.

    Rather not the ego: its way is the text's.
    """
    if scene.ring or scene.network.plain or first.drive.exit != second.drive.exit:
        return False
    laid = {draft.id: _laid(scene, draft.id, lanes[draft.id]) for draft in (first, second)}
    fixed = _bound(scene, ())
    for draft, other in sorted([(first, second), (second, first)], key=lambda o: o[0] is scene.ego):
        own, lane = laid[draft.id], laid[other.id].exit_lane
        if draft.id in fixed or draft.lane_changes or abs(lane - own.exit_lane) != 1:
            continue
        change = LaneChange(
            position_m=round(own.laid.turning_ends_m + _BEHIND_JUNCTION_M, 3),
            length_m=round(change_length_m(draft), 3),
            lane_after=lane,
        )
        over = change.position_m + change.length_m - own.laid.stretches[-1].end_m + END_MARGIN_M
        require_room(draft.id, -over, 0.0)
        draft.lane_changes.append(change)
        ways = (_laid(scene, each.id, lanes[each.id]) for each in (draft, other))
        if first_ground(*ways) is not None:
            reason = f"moves over behind the junction, so that its way and that of {other.id} meet"
            scene.note(f"{draft.id}.exit_lane", lane, reason, own.exit_lane)
            return True
        draft.lane_changes.clear()
    return False


def _note(scene: Setup, name: str, before: Lanes, after: Lanes, wishes: Sequence[Wish]) -> None:
    """Say which lanes were changed."""
    partners = [other for wish in wishes if name in wish.who for other in wish.who if other != name]
    for field in ("entry", "ring", "exit"):
        was, now = getattr(before, field), getattr(after, field)
        if was != now and now is not None and partners:
            reason = f"so that its way and that of {partners[0]} meet"
            scene.note(f"{name}.{field}_lane", now, reason, was)
