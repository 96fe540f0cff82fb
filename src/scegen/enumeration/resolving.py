"""Who causes and who suffers a danger in one scenario, where the text does not say.

By the table of hazards: the first party that is found there. This is the one place where that is
decided; what follows reads it in the logical scenario.
"""

from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass

from scegen.enumeration.presuming import Parties, known_by_itself, yielding
from scegen.scenario.acts import Act, ActKind
from scegen.scenario.arms import arm_angles_deg, seen_from
from scegen.scenario.functional import FunctionalScenario, Hazard
from scegen.scenario.hazards import HAZARDS, Party
from scegen.scenario.in_line import unconcerned
from scegen.scenario.logical import MEETING, Assignment, Conflict, Drive, InLine, Standing, Walking
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach, Maneuver


def hazard_resolver(
    functional: FunctionalScenario, sides: Sequence[Parties]
) -> Callable[[Sequence[Assignment], Sequence[Conflict]], tuple[Hazard, ...]]:
    """What names both sides of every danger in a scenario; ``sides`` as said or presumed."""
    hazards = functional.hazards
    if all(hazard.by and hazard.to for hazard in hazards):
        return lambda _, __: hazards

    def resolved(
        assignments: Sequence[Assignment], conflicts: Sequence[Conflict]
    ) -> tuple[Hazard, ...]:
        scene = _View(functional, {a.participant: a for a in assignments}, tuple(conflicts))
        return tuple(
            _named(scene, hazard, presumed) for hazard, presumed in zip(hazards, sides, strict=True)
        )

    return resolved


def act_resolver(
    functional: FunctionalScenario,
) -> Callable[[Sequence[Assignment]], tuple[Act, ...]]:
    """What says of the first lane change of everybody to which side it goes, and beside whom."""
    acts = functional.acts
    first: dict[str, int] = {}
    for index, act in enumerate(acts):
        if act.kind is ActKind.CHANGE_LANE:
            first.setdefault(act.participant, index)
    if not first:
        return lambda _: acts
    far = {
        (spacing.participant, spacing.reference)
        for spacing in functional.spacings
        if spacing.measure is Measure.LATERAL_OFFSET_M
        and abs(spacing.value.middle) > 1.5 * functional.junction.lanes_wide_m
    }  # more than a lane between them: a change of lane does not lead into that one's

    def resolved(assignments: Sequence[Assignment]) -> tuple[Act, ...]:
        out = list(acts)
        for drive in assignments:
            index = first.get(drive.participant)
            if index is not None and isinstance(drive, Drive):
                out[index] = _with_side(acts[index], drive, far)
        return tuple(out)

    return resolved


def _with_side(act: Act, drive: Drive, far: Container[tuple[str, str | None]]) -> Act:
    over = drive.beside_on is not None and drive.changes_to not in {None, drive.beside_on}
    over = over and (act.participant, drive.beside) not in far
    into = act.into or (drive.beside if over else None)
    return act.but(side=act.side or drive.changes_to, into=into)


@dataclass(frozen=True)
class _View:
    """A scenario, as far as it tells who is where."""

    functional: FunctionalScenario
    assignments: dict[str, Assignment]
    conflicts: tuple[Conflict, ...]


def _named(scene: _View, hazard: Hazard, known: Parties) -> Hazard:
    if hazard.by and hazard.to:
        return hazard
    row, ego = HAZARDS[hazard.kind], scene.functional.ego.id
    by, to = hazard.by, hazard.to
    if known.by and known.by != by:
        by = known.by  # presumed, or one of two who merge into each other
    by = by or _party(scene, row.causes, to or (ego,), to, ())
    things = (thing for thing in scene.functional.objects if thing.id in by)
    to = to or tuple(dict.fromkeys(t.in_way_of for t in things if t.in_way_of is not None))
    out = unconcerned(scene.functional, hazard.kind, by)
    to = to or _party(scene, row.suffers, by, out, known.to)
    return hazard.but(by=by, to=to)


_IN_LINE = frozenset({Party.TAILGATED, Party.LEADER, Party.FOLLOWER, Party.BESIDE})


def _party(
    scene: _View,
    wanted: tuple[Party, ...],
    seen_from: tuple[str, ...],
    taken: tuple[str, ...],
    presumed: tuple[str, ...],
) -> tuple[str, ...]:
    """The first party that there is; who is presumed comes after those in line and beside."""
    for party in wanted:
        if presumed and party not in _IN_LINE:
            return presumed
        found = [name for name in _found(scene, party, seen_from) if name not in taken]
        if party is Party.OTHERS:
            meeting = [n for n in found if _meets(scene, n, seen_from)]
            return tuple(meeting or found)
        if found:
            return (found[0],)
    return ()


def _found(scene: _View, party: Party, seen_from: tuple[str, ...]) -> list[str]:
    match party:
        case Party.LEADER:
            return [n for name in seen_from for n in _in_line(scene, name, ahead=True)]
        case Party.FOLLOWER:
            behind = [n for name in seen_from for n in _in_line(scene, name, ahead=False)]
            return sorted(behind, key=lambda name: _gets_away(scene, name, seen_from))
        case Party.BESIDE:
            return [
                a.participant
                for a in scene.assignments.values()
                if isinstance(a, InLine) and _beside(scene, a, seen_from)
            ]
        case Party.ONCOMING:
            return [n for n in scene.assignments if _oncoming(scene, n, seen_from)]
        case Party.CROSSING:
            return [n for n in scene.assignments if _meets(scene, n, seen_from)]
        case Party.YIELDING:
            return yielding(scene.functional, seen_from)
        case Party.OTHERS:
            ego = scene.functional.ego.id
            return [n for n, a in scene.assignments.items() if n != ego and _moves(a)]
        case _:
            return known_by_itself(scene.functional, party)


def _gets_away(scene: _View, name: str, others: tuple[str, ...]) -> bool:
    """Whether it leaves the lane of these: what they do then concerns the one behind it."""
    changes = (a for a in scene.functional.acts if a.kind is ActKind.CHANGE_LANE)
    return any(a.participant == name and a.into not in others for a in changes)


def _moves(assignment: Assignment) -> bool:
    stays = isinstance(assignment, Drive) and assignment.maneuver is Maneuver.STAY
    return not (stays or isinstance(assignment, Standing))


def _in_line(scene: _View, name: str, *, ahead: bool) -> list[str]:
    """Those before or behind somebody in one lane, the next first."""
    own = scene.assignments.get(name)
    if not isinstance(own, InLine) or _line(own) is None:
        return []
    others = [
        a
        for a in scene.assignments.values()
        if isinstance(a, InLine)
        and _line(a) == _line(own)
        and (a.lane is None or own.lane is None or a.lane == own.lane)
        and (a.rank < own.rank if ahead else a.rank > own.rank)
    ]
    others.sort(key=lambda a: -a.rank if ahead else a.rank)
    return [a.participant for a in others]


def _line(assignment: InLine) -> int | None:
    """The arm in whose lanes it is."""
    if isinstance(assignment, Drive):
        return assignment.entry
    if isinstance(assignment, Standing | Walking) and assignment.in_lane:
        return assignment.arm
    return None


def _beside(scene: _View, one: InLine, others: tuple[str, ...]) -> bool:
    besides = [scene.assignments.get(name) for name in others]
    return one.beside in others or any(
        isinstance(other, InLine) and other.beside == one.participant for other in besides
    )


def _oncoming(scene: _View, name: str, others: tuple[str, ...]) -> bool:
    angles = arm_angles_deg(scene.functional.junction)
    one = scene.assignments[name]
    return isinstance(one, Drive) and any(
        isinstance(other, Drive)
        and other.entry != one.entry
        and Approach.OPPOSITE in seen_from(angles, other.entry, one.entry)
        for other in (scene.assignments.get(n) for n in others)
    )


def _meets(scene: _View, name: str, others: tuple[str, ...]) -> bool:
    met = [{c.first, c.second} for c in scene.conflicts if c.kind in MEETING]
    return any({name, other} in met for other in others)
