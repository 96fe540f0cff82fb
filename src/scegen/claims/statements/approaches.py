"""Where somebody comes from: seen from the ego, or from who is named."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from scegen.claims.boxes import Boxes, Seen, box_at, course, seen
from scegen.claims.claim import NEVER, Claim, ClaimKind, Judged
from scegen.claims.told import Told, either, plain
from scegen.claims.tolerances import SAME_LANE_M
from scegen.claims.view import View
from scegen.motion.batch.arrays import Bools, Floats
from scegen.scenario.in_line import in_next_lane
from scegen.scenario.logical import Reverses, Walking
from scegen.scenario.spacings import START, Measure
from scegen.scenario.vocabulary import ON_FOOT, Approach, DrivingSide, Maneuver

_SIDES = {Approach.LEFT: 1.0, Approach.RIGHT: -1.0}
_COURSES = frozenset({Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE})
_LEAST_DEG, _MOST_DEG, _FACING_DEG = 20.0, 160.0, 110.0
"""Courses from a side, and towards one: where many arms meet, an arm may count as either."""
_BESIDE_M, _FARTHEST_M = 1.0, 8.0
_SAME_WAY = 0.7
"""Cosine between the headings of two who go the same way: 45 degrees."""
_ASIDE_M = 8.0
_SETS_OUT_M = 1.0
_ROUNDING_M = 0.1
_DEG_PER_M = 10.0
_WORDS = {
    Approach.AHEAD: "ahead of {} in its lane",
    Approach.BEHIND: "behind {} in its lane",
    Approach.OPPOSITE: "coming towards {}",
    Approach.LEFT: "coming from the left of {}",
    Approach.RIGHT: "coming from the right of {}",
    Approach.ADJACENT: "in the lane beside {}",
}


def claims(told: Told) -> Iterator[Claim]:
    """One for everybody of whom it is said."""
    sayings = [
        (p.id, told.ego, p.approaches, f"participants.{p.id}.approaches")
        for p in told.people
        if p.approaches and p.id != told.ego and not p.circulating
    ]
    sayings += [
        (r.participant, r.reference, r.approaches, f"relations.{r.participant}.approaches")
        for r in told.functional.relations
    ]
    for name, reference, words, field in sayings:
        yield Claim(
            id=f"approach.{name}.{reference}",
            kind=ClaimKind.APPROACH,
            statement=f"{name} is {_told(told, words, name, reference)} at the start",
            field=field,
            unit="deg" if words <= _COURSES else "m",
            test=partial(_judge, told, name, reference, words),
            scale=_DEG_PER_M if words <= _COURSES else 2.0,
            fixed=words <= _COURSES and _by_other_arms(told, name, reference),
        )


def _by_other_arms(told: Told, name: str, reference: str) -> bool:
    """Whether two drive and come by different arms of a junction: their courses are their ways'."""
    one, other = told.drive(name), told.drive(reference)
    if one is None or other is None or told.plain_road or one.maneuver is Maneuver.STAY:
        return False
    return one.entry != other.entry


def _aside(told: Told, name: str, reference: str) -> bool:
    """Whether one of two is beside the lanes at first: on a strip; or somebody on foot, parked."""
    participant, other = map(told.functional.participant, (name, reference))
    strips = participant.strip is not None or other.strip is not None
    return participant.parked or strips or participant.kind in ON_FOOT


def _told(told: Told, words: frozenset[Approach], name: str, reference: str) -> str:
    the = "the ego" if reference == "ego" else reference
    if Approach.ADJACENT in words:
        sides = [plain(word) for word in words if word in _SIDES]
        where = f" on its {either(sorted(sides))}" if sides else ""
        along = in_next_lane(words)
        far = f", {plain(along)}" if along is not None else ""
        return _WORDS[Approach.ADJACENT].format(the) + where + far
    phrases = [_WORDS[word].format(the) for word in Approach if word in words]
    aside = _aside(told, name, reference)
    return either([p.removesuffix(" in its lane") for p in phrases] if aside else phrases)


def _judge(told: Told, name: str, reference: str, words: frozenset[Approach], view: View) -> Judged:
    frame, box = (box_at(view, who, 0) for who in (reference, name))
    place = seen(frame, box)
    turned = np.degrees(_course(view, name, frame))
    moves = view.place_m(name)[:, -1] - view.place_m(name)[:, 0] > 0.5
    sides = [word for word in words if word in _SIDES]
    along = in_next_lane(words)
    if Approach.ADJACENT in words and (sides or along):
        choices = [_beside(place.y * _SIDES[word]) for word in sides] or [_beside(np.abs(place.y))]
        if along is not None:
            choices = [np.minimum(c, _ahead_m(along, place, frame)) for c in choices]
        elif _stand(told, name, reference):
            level_m = np.minimum(frame.half_length - place.rear, place.front + frame.half_length)
            choices = [np.minimum(c, level_m) for c in choices]
    else:
        walks = told.functional.participant(name).kind in ON_FOOT
        lane = _in_lane_m(told, name, reference, frame.half_width + box.half_width)
        choices, drive = [], told.drive(name)
        for word in words:
            if word is Approach.ADJACENT:
                choices.append(_beside(np.abs(place.y)))
            elif word in {Approach.AHEAD, Approach.BEHIND}:
                # Who goes back in its lane is ahead of who is behind it, however it moves.
                backs_up = drive is not None and drive.reverses is Reverses.BACKS_UP
                faces = np.degrees(course(frame, box)) if backs_up else turned
                same = walks | ~moves | (np.cos(np.radians(faces)) > _SAME_WAY)
                inside = np.minimum(_ahead_m(word, place, frame), lane - np.abs(place.y))
                choices.append(np.where(same, inside, -NEVER))
            elif told.crossing(name) is not None:
                choices.append(_crosses(view, name, reference, word))
            else:
                choices.append(_comes(told, view, name, reference, word, turned, moves, place.y))
    measured = turned if words <= _COURSES else place.x
    return Judged(np.max(choices, axis=0), measured, np.zeros(view.count))


def _stand(told: Told, *names: str) -> bool:
    """Whether all of those stand in their lanes all the time: beside one another, or not at all."""
    drives = map(told.drive, names)
    return all(drive is not None and drive.maneuver is Maneuver.STAY for drive in drives)


def _ahead_m(word: Approach, place: Seen, frame: Boxes) -> Floats:
    """How far one is wholly ahead of another, or behind it."""
    clear: Floats = (place.rear if word is Approach.AHEAD else -place.front) - frame.half_length
    return clear


def _in_lane_m(told: Told, name: str, reference: str, touching_m: float) -> float:
    """How far to the side one may be at first to be in the other's lane.

    As far as it is said to be; where an overlap is said, as long as they share any width.
    """
    lane = _ASIDE_M if _aside(told, name, reference) else SAME_LANE_M
    for spacing in told.functional.spacings:
        if {spacing.participant, spacing.reference} != {name, reference}:
            continue
        if spacing.measure is Measure.OVERLAP_PERCENT:
            lane = max(lane, touching_m)
        elif spacing.measure is Measure.LATERAL_OFFSET_M and spacing.at == START:
            lane = max(lane, max(-spacing.value.low, spacing.value.high) + _ROUNDING_M)
    return lane


def _course(view: View, name: str, frame: Boxes) -> Floats:
    """Direction in which somebody sets out, from the frame's heading, rad.

    What counts is where it is a little later, not where it heads: one who backs out may come
    forwards a hand's breadth first. Of one who stays, the heading.
    """
    begin, step = box_at(view, name, 0), view.beyond(name, view.place_m(name)[:, 0] + _SETS_OUT_M)
    turned = _towards(frame, begin, box_at(view, name, step))
    return np.where(step < view.steps, turned, course(frame, begin))


def _towards(frame: Boxes, begin: Boxes, end: Boxes) -> Floats:
    """Direction from one place to another, from the frame's heading, rad."""
    return course(frame, begin._replace(cos=end.x - begin.x, sin=end.y - begin.y))


def _beside(aside_m: Floats) -> Floats:
    """How well a place is in a lane beside, by how far it is to that side."""
    inside: Floats = np.minimum(aside_m - SAME_LANE_M, _FARTHEST_M - aside_m)
    return inside


def _comes(
    told: Told,
    view: View,
    name: str,
    reference: str,
    word: Approach,
    turned: Floats,
    moves: Bools,
    aside: Floats,
) -> Floats:
    """For one who drives by its course, else (or on the same road) by where it is at first.

    For one who stays, by where it is when they are nearest.
    """
    if not moves.all():
        step = view.step_of(view.of_pair("closest_s", name, reference))
        nearest = seen(box_at(view, reference, step), box_at(view, name, step)).y
        aside = np.where(moves, aside, nearest)
    if word is Approach.OPPOSITE:
        keeps_right = told.functional.junction.driving_side is DrivingSide.RIGHT
        side = 1.0 if keeps_right else -1.0
        facing = _by_course(word, turned)
        there = (side * aside - SAME_LANE_M) * _DEG_PER_M
        return np.where(moves, facing, np.maximum(facing, there))
    side = _SIDES[word]
    along = np.cos(np.radians(turned)) > _SAME_WAY
    if any(isinstance(a, Walking) and a.participant == name for a in told.logical.assignments):
        along = np.abs(np.cos(np.radians(turned))) > _SAME_WAY  # beside the road, either way
    place = (side * aside - _BESIDE_M) * _DEG_PER_M
    return np.where(moves & ~along, _by_course(word, turned), place)


def _crosses(view: View, name: str, reference: str, word: Approach) -> Floats:
    """For one who crosses: by its course where the two come nearest."""
    frame = box_at(view, reference, view.step_of(view.of_pair("closest_s", name, reference)))
    begin, end = box_at(view, name, 0), box_at(view, name, view.steps - 1)
    return _by_course(word, np.degrees(_towards(frame, begin, end)))


def _by_course(word: Approach, turned: Floats) -> Floats:
    """How well a course fits who comes from a side, or towards one (deg)."""
    if word is Approach.OPPOSITE:
        return np.asarray(np.abs(turned) - _FACING_DEG)
    across = -_SIDES[word] * turned
    return np.minimum(across - _LEAST_DEG, _MOST_DEG - across)
