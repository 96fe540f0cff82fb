"""Which lane everybody along the road starts in: one small choice problem.

Every word about lanes is a wish with a weight; the assignment that breaks the least is taken, and
none that breaks what was said. As many lanes are built as that needs, up to three, unless the text
says how many there are.
"""

from collections.abc import Callable, Iterator
from itertools import product

from scegen.concretization.along.parked import endangered, inner_doors
from scegen.concretization.along.story import Story
from scegen.concretization.tale import SWERVING, outward, side_of
from scegen.concretization.wishes import LIKELY, SAID, USUAL, Wish, least_broken
from scegen.errors import MotionInfeasibleError
from scegen.scenario.acts import ActKind
from scegen.scenario.hazards import FROM_BESIDE
from scegen.scenario.in_line import words_between
from scegen.scenario.logical import InLine
from scegen.scenario.roadway import Carriageway
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, Side
from scegen.scenario.wording import counted

MOST_LANES = 3
_LANE = 0.1
"""What one lane more costs."""
_INNERMOST = frozenset({1})
_ANYWHERE = frozenset({Approach.AHEAD, Approach.BEHIND, Approach.ADJACENT})
_FROM_BESIDE = FROM_BESIDE | {HazardKind.CUT_IN}


def choose_lanes(story: Story) -> None:
    """Give everybody a lane, and the road as many as that needs.

    Raises:
        MotionInfeasibleError: what is said of lanes cannot all be had.
    """

    def wishes_of(count: int) -> list[Wish]:
        told = [*_from_words(story), *_from_acts(story, count)]
        return [*told, *_from_hazards(story), *_usual(story, count)]

    def tried(count: int) -> tuple[float, dict[str, int], int]:
        # Next to the outermost: in a lane that ends, or on a strip.
        strips = {n for n in people if story.functional.participant(n).strip is not None}
        beyond = story.merging | strips
        options = {n: (count + 1,) if n in beyond else range(count, 0, -1) for n in people}
        return (*least_broken(options, wishes_of(count)), count)

    junction, people = story.functional.junction, story.people
    said = max(junction.lanes, default=0)
    # Nobody passes another on the other side of a median: there must be a lane for that.
    undivided = junction.carriageway is Carriageway.UNDIVIDED
    counts = [said] if said else range(1 if undivided else 2, MOST_LANES + 1)
    cost, lanes, story.lane_count = min(
        map(tried, counts), key=lambda each: round(each[0] + _LANE * each[2], 6)
    )
    if cost >= SAID:
        broken = [w for w in wishes_of(story.lane_count) if w.weight >= SAID and not w.met(lanes)]
        raise MotionInfeasibleError(
            f"on a road with {counted(story.lane_count, 'lane')} a direction, these cannot all be "
            "had: " + "; ".join(w.words for w in broken[:3]),
            where=broken[0].who[0],
            hint="Say how many lanes the road has, or leave one of these out.",
        )
    for name, lane in lanes.items():
        people[name].lane = lane


def _beside(a: str, b: str, weight: float, step: int | None, words: str) -> Wish:
    """``a`` is next to ``b``, ``step`` lanes farther out if that is said."""
    if step is None:
        return Wish((a, b), weight, lambda own, other: abs(own - other) == 1, words)
    return Wish((a, b), weight, lambda own, other: own - other == step, words)


def _room(step: int, count: int) -> Callable[..., bool]:
    """There is a lane on that side, or it drives on that side of whom it passes."""
    return lambda own, *passed: (
        1 <= own + step <= count or any((own - lane) * step > 0 for lane in passed)
    )


def _among(name: str, weight: float, allowed: frozenset[int], words: str) -> Wish:
    return Wish((name,), weight, lambda lane: lane in allowed, words)


def _from_words(story: Story) -> Iterator[Wish]:
    """Lanes, sides, lines and lateral distances that are said."""
    functional, runners = story.functional, story.people
    aside = _lanes_aside(story)
    passing = {act.participant for act in story.acts if act.kind is ActKind.OVERTAKE}
    for (a, b), step in aside.items():
        yield _beside(a, b, SAID, step, f"{a} is {step} lanes from {b}")
    for name, runner in runners.items():
        participant = functional.participant(name)
        allowed = frozenset({runner.lane}) if runner.lane >= 1 else participant.lanes
        if allowed:
            numbers = ", ".join(str(lane) for lane in sorted(allowed))
            yield _among(name, SAID, allowed, f"{name} is in lane {numbers}")
        assignment = story.logical.assignment(name)
        seen = {r: words_between(functional, name, r) for r in runners if r != name}
        beside = assignment.beside if isinstance(assignment, InLine) else None
        if beside is not None and beside in runners and name not in passing:
            seen[beside] = seen.get(beside, frozenset()) | {Approach.ADJACENT}
        for reference, words_of in seen.items():
            if (name, reference) in aside or (reference, name) in aside:
                continue
            if words_of >= _ANYWHERE and reference != beside:
                words_of -= {Approach.ADJACENT}  # one of these: in line
            if Approach.ADJACENT in words_of:
                said = getattr(assignment, "beside_on", None)
                if said is None or reference != beside:
                    said = side_of(functional, name, reference)
                step_out = None if said is None else outward(functional, said)
                words = f"{name} is in the lane beside {reference}"
                yield _beside(name, reference, SAID, step_out, words)
            strips = {functional.participant(n).strip for n in (name, reference)}
            in_line = bool(words_of & {Approach.AHEAD, Approach.BEHIND}) and len(strips) == 1
            same_way = runners[reference].forward == runner.forward
            if in_line and same_way and Approach.ADJACENT not in words_of:
                yield _beside(name, reference, SAID, 0, f"{name} is in the lane of {reference}")


def _lanes_aside(story: Story) -> dict[tuple[str, str], int]:
    """How many lanes farther out one is than another, by a lateral offset that is said."""
    functional, runners, found = story.functional, story.people, {}
    for spacing in functional.spacings:
        a, b = spacing.participant, spacing.reference
        level = {a, b} <= runners.keys() and runners[a].forward == runners[b].forward
        if spacing.measure is Measure.LATERAL_OFFSET_M and level and a != b:
            right = -round(spacing.value.middle / runners[a].lane_width_m)
            found[a, b] = right * outward(functional, Side.RIGHT)
    return found


def _from_acts(story: Story, count: int) -> Iterator[Wish]:
    """Who changes lanes needs one there: the one of the person into whose lane it comes."""
    functional, runners, acts = story.functional, story.people, story.acts
    passing = {act.participant for act in acts if act.kind is ActKind.OVERTAKE}
    for act in acts:
        name = act.participant
        step = outward(functional, act.side) if act.side is not None else None
        if act.kind is ActKind.OVERTAKE and name in runners and step is not None:
            inwards = step < 0 and count == 1  # by the oncoming lane, unless it stays there
            comes_home = inwards and not story.does(name, Maneuver.LANE_CHANGE)
            passed = (act.into,) if act.into else functional.overtaken(name) or (*runners,)
            whom = tuple(n for n in passed if n in runners and n != name)
            makes_room = any(a.participant in whom and a.kind is ActKind.CHANGE_LANE for a in acts)
            if not comes_home and not makes_room:
                words = f"{name} has a lane on its {act.side} to pass in, or drives there"
                weight = LIKELY if inwards else SAID
                yield Wish((name, *whom), weight, _room(step, count), words)
            continue
        # Who swerves inwards may do so into the lane of the oncoming, who swerves outwards not.
        swerves = story.hazard_of(act) in SWERVING and step == 1 and act.lateral_m is None
        changes = act.kind is ActKind.CHANGE_LANE or swerves
        if not changes or name not in runners or name in passing:
            continue
        into = runners.get(act.into or "")
        if into is not None and into.forward != runners[name].forward:
            words = f"{name} is next to the lane of {into.id}"
            yield from (_among(n, LIKELY, _INNERMOST, words) for n in (name, into.id))
        elif into is not None:
            back = None if step is None else -step
            words = f"{name} changes into the lane of {into.id}"
            yield _beside(name, into.id, SAID, back, words)
        elif step is not None:
            words = f"{name} has a lane on its {act.side}"
            yield Wish((name,), LIKELY, _room(step, count), words)


def _from_hazards(story: Story) -> Iterator[Wish]:
    """Who endangers another from beside is beside it, and who strays is next to the oncoming."""
    runners = story.people
    for hazard in story.functional.hazards:
        for who, to in product(hazard.by, hazard.to):
            if not {who, to} <= runners.keys() or who == to:
                continue
            words = f"{hazard.kind} of {who} to {to}"
            if runners[who].forward != runners[to].forward:
                if hazard.kind in SWERVING:
                    yield from (_among(n, LIKELY, _INNERMOST, words) for n in (who, to))
            elif hazard.kind in _FROM_BESIDE:
                yield _beside(who, to, LIKELY, None, words)


def _usual(story: Story, count: int) -> Iterator[Wish]:
    """Drive in line with the ego; next to the exit that one takes, or the door that one passes."""
    for name, runner in story.people.items():
        if name != story.ego.id and runner.forward:
            yield _beside(name, story.ego.id, USUAL, 0, f"{name} is in line")
    for name in story.exiting & story.people.keys():
        words = f"{name} is in the outermost lane, beside which the exit begins"
        yield _among(name, LIKELY, frozenset({count}), words)
    for door in inner_doors(story):
        for name in endangered(story.functional, door) & story.people.keys():
            words = f"{name} passes the door of {door} in the lane next to it"
            yield _among(name, LIKELY, _INNERMOST, words)
