"""Which participants are interchangeable, and which rotations change nothing.

Two vehicles are interchangeable if nothing that the functional scenario says tells them apart.
A rotation counts if it carries everything said, and with distinct arms the road as built, onto
itself. Mirror images never count: they swap the sides of the road.
"""

import math
from collections.abc import Hashable, Set
from dataclasses import dataclass

from scegen.enumeration.problem import Problem
from scegen.scenario.acts import AfterAct
from scegen.scenario.arms import seen_from, turn_name
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.vocabulary import ArmsMode, Control, JunctionKind

ANGLE_TOLERANCE_DEG = 1e-6


@dataclass(frozen=True)
class Group:
    """Interchangeable participants, in listing order; ``entries`` None = open."""

    members: tuple[str, ...]
    entries: tuple[int, ...] | None
    drives: bool

    @property
    def alone(self) -> bool:
        """Whether there is just one."""
        return len(self.members) == 1


@dataclass(frozen=True)
class Symmetry:
    """Groups, and for every rotation (in arms, 0 first) the group that each group becomes."""

    groups: tuple[Group, ...]
    rotations: dict[int, tuple[int, ...]]

    @property
    def order(self) -> int:
        """Number of symmetries: rotations times the swaps within every group."""
        swaps = math.prod(math.factorial(len(group.members)) for group in self.groups)
        return len(self.rotations) * swaps

    @property
    def anchor(self) -> str | None:
        """A vehicle that is one of a kind on all arms: every rotation moves it."""
        return self.anchor_among({name for group in self.groups for name in group.members})

    def anchor_among(self, names: Set[str]) -> str | None:
        """The first of these that is one."""
        alone = (g.members[0] for g in self.groups if g.drives and g.entries is None and g.alone)
        return next((name for name in alone if name in names), None)


def symmetry_of(problem: Problem, arms: ArmsMode) -> Symmetry:
    """The symmetry that the reduction ``exact`` divides by."""
    role_counts = role_matters(problem.functional, arms)
    open_to = [name for name, _ in problem.open_places]
    kinds: dict[tuple[Hashable, tuple[int, ...] | None], list[str]] = {}
    for member in (*problem.vehicles, *problem.crossers):
        said: Hashable = _what_is_said(problem.functional, member, role_counts=role_counts)
        if open_to.count(member.id) > 1:
            said = (said, member.id)  # several places to choose: rare enough to list apart
        kinds.setdefault((said, problem.entries.get(member.id)), []).append(member.id)
    drivers = {v.id for v in problem.vehicles}
    groups = [
        Group(tuple(names), problem.entries.get(names[0]), names[0] in drivers)
        for names in kinds.values()
    ]
    number = {key: index for index, key in enumerate(kinds)}
    rotations: dict[int, tuple[int, ...]] = {0: tuple(range(len(groups)))}
    for turn in range(1, problem.arms):
        if not _road_allows(problem, turn, arms):
            continue
        images = [number.get((said, _turned(e, turn, problem.arms))) for said, e in kinds]
        found = tuple(image for image in images if image is not None)
        sizes_fit = len(found) == len(groups) and all(
            len(groups[image].members) == len(group.members)
            for image, group in zip(found, groups, strict=True)
        )
        if sizes_fit:
            rotations[turn] = found
    return Symmetry(tuple(groups), rotations)


def role_matters(functional: FunctionalScenario, arms: ArmsMode) -> bool:
    """Whether the ego differs from a like vehicle by its role alone.

    With equal arms, the source paper's view, cars are cars, unless something is seen from the
    ego; with arms as built, the vehicle under test is somebody.
    """
    seen = any(m.approaches for m in functional.participants) or functional.outcome is not None
    seen = seen or not all(hazard.by and hazard.to for hazard in functional.hazards)
    others = len(functional.participants) > len(functional.vehicles)
    return arms is ArmsMode.DISTINCT or seen or others


def like_but_for_role(problem: Problem, one: Participant) -> bool:
    """Whether the role is all that tells a vehicle from some other."""

    def said(member: Participant) -> Hashable:
        what = _what_is_said(problem.functional, member, role_counts=False)
        return what, problem.entries.get(member.id)

    return any(other != one and said(other) == said(one) for other in problem.vehicles)


def _turned(entries: tuple[int, ...] | None, turn: int, arms: int) -> tuple[int, ...] | None:
    return None if entries is None else tuple(sorted((e + turn) % arms for e in entries))


_TOLD_OF_SEVERAL = ("relations", "groups", "hazards", "objects", "spacings", "acts")


def _what_is_said(
    functional: FunctionalScenario, member: Participant, *, role_counts: bool
) -> Hashable:
    """Everything said about a participant, except its name and its arms."""
    referred = {s.at for s in functional.spacings}
    referred |= {a.when.act for a in functional.acts if isinstance(a.when, AfterAct)}
    own = member.model_dump(exclude={"id", "role", "entries"}, mode="json")
    told: list[object] = []
    for section in _TOLD_OF_SEVERAL:
        for index, item in enumerate(getattr(functional, section)):
            data = item.model_dump(mode="json")
            if section == "acts" and data["id"] not in referred:
                del data["id"]  # its name tells nothing
            told += _mention(section, index, data, member.id)
    if functional.outcome is not None:
        told += _mention("outcome", 0, functional.outcome.model_dump(mode="json"), member.id)
    return repr(own), member.role if role_counts else None, tuple(sorted(map(repr, told)))


def _mention(section: str, index: int, data: dict[str, object], name: str) -> list[object]:
    """What one item says of somebody, with its own name left out; nothing if it is not named.

    Of several who are named together each is told alike, so these items count by their place.
    """
    together = {
        key: tuple(value)
        for key, value in data.items()
        if isinstance(value, list) and name in value
    }
    plain = {key: value for key, value in data.items() if key not in together}
    words = _without(plain, name)
    if not together and words == plain:
        return []
    several = any(len(names) > 1 for names in together.values())
    return [(section, index if several else None, sorted(together), words)]


def _without(data: object, name: str) -> object:
    """The same with somebody's name replaced, however deep."""
    if isinstance(data, dict):
        return {key: _without(value, name) for key, value in data.items()}
    if isinstance(data, list):
        return [_without(value, name) for value in data]
    return "·" if data == name else data


def _road_allows(problem: Problem, turn: int, arms: ArmsMode) -> bool:
    junction = problem.functional.junction
    n = junction.arms
    lanes_fit = junction.lanes == (*junction.lanes[turn:], *junction.lanes[:turn])
    if not lanes_fit or any(m.parked and m.entries for m in problem.functional.participants):
        return False
    if arms is ArmsMode.EQUAL:
        return not _words_need_geometry(problem) or _same_words(problem, turn)
    marked = frozenset((arm + turn) % n for arm in junction.crosswalks)
    return (
        marked == junction.crosswalks
        and _same_angles(problem.angles_deg, turn)
        and _same_control(problem, turn)
    )


def _words_need_geometry(problem: Problem) -> bool:
    functional = problem.functional
    told = functional.relations, functional.groups, functional.hazards, functional.acts
    moves = any(m.maneuvers or m.approaches for m in functional.participants)
    return moves or any(told) or functional.outcome is not None


def _same_words(problem: Problem, turn: int) -> bool:
    """Every movement and every view keeps its name when the arms turn."""
    angles, n = problem.angles_deg, problem.arms

    def words(entry: int, move: int) -> tuple[Hashable, Hashable]:
        other = (entry + move) % n
        return turn_name(angles, entry, move), seen_from(angles, entry, other)

    return all(words(e, d) == words((e + turn) % n, d) for e in range(n) for d in range(n))


def _same_angles(angles: tuple[float, ...], turn: int) -> bool:
    n = len(angles)
    by = angles[turn] - angles[0]
    return all(
        abs((angles[(arm + turn) % n] - angles[arm] - by + 180.0) % 360.0 - 180.0)
        < ANGLE_TOLERANCE_DEG
        for arm in range(n)
    )


def _same_control(problem: Problem, turn: int) -> bool:
    """Yield, stop and signals that work set one road above the other, except round a ring."""
    junction = problem.functional.junction
    ranking = {Control.SIGNALS}
    if junction.kind is not JunctionKind.ROUNDABOUT:
        ranking |= {Control.YIELD, Control.STOP}
    return junction.control not in ranking or (junction.arms == 4 and turn == 2)


def symmetry_in_words(problem: Problem, symmetry: Symmetry, arms: ArmsMode) -> str:
    """Which rotations and swaps make no other scenario, and why the ego is told apart if it is."""
    alike = [_either(group) for group in symmetry.groups if not group.alone]
    swaps = f"interchangeable: {'; '.join(alike)}" if alike else "no two are interchangeable"
    return ", ".join([_rotations(symmetry, arms), swaps]) + _ego(problem, symmetry, arms)


def _rotations(symmetry: Symmetry, arms: ArmsMode) -> str:
    turns = len(symmetry.rotations)
    if turns > 1:
        return f"the junction turns onto itself in {turns} ways"
    carried = "what is said" if arms is ArmsMode.EQUAL else "the road and what is said"
    return f"no turn of the junction carries {carried} onto itself"


def _either(group: Group) -> str:
    names = group.members
    few = len(names) < 5
    shown = ", ".join(names) if few else f"{names[0]}, {names[1]} … {names[-1]} ({len(names)})"
    if group.entries is not None and len(group.entries) == 1:
        shown += f" at arm {group.entries[0]}"
    return shown


def _ego(problem: Problem, symmetry: Symmetry, arms: ArmsMode) -> str:
    """Why the ego is nobody's like, where its role alone makes it so."""
    ego = problem.functional.ego
    alone = any(group.members == (ego.id,) for group in symmetry.groups)
    if not alone or not like_but_for_role(problem, ego):
        return ""
    if arms is ArmsMode.EQUAL:
        return f"; the ego {ego.id} is told apart: the others are described as it meets them"
    return f"; the ego {ego.id} is told apart as the vehicle under test (--arms equal does not)"
