"""When two are so far apart: at the start, at the contact, or as somebody does something."""

from __future__ import annotations

from typing import Literal

from scegen.scenario.acts import ActKind
from scegen.scenario.spacings import CONTACT, LENGTHWISE, START, Measure
from scegen.scenario.vocabulary import Approach
from scegen.understanding.amounts.teller import Teller
from scegen.understanding.amounts.whom import in_file
from scegen.understanding.draft import Entity
from scegen.understanding.frames import Measured, words
from scegen.understanding.happenings import Doing

_ANSWERING = frozenset({ActKind.BRAKE, ActKind.STOP, ActKind.CHANGE_LANE})
_LANED = frozenset({ActKind.CHANGE_LANE, ActKind.OVERTAKE})
_MOVES_INTO = frozenset({ActKind.SWERVE, ActKind.CROSS, ActKind.OPEN_DOOR})


class Moments(Teller):
    """Finds the moment of a spacing."""

    def at(
        self, number: Measured, measure: Measure, entity: Entity, reference: Entity
    ) -> Doing | str:
        """An act, the contact or the start.

        Args:
            number: how far or how long.
            measure: what it measures.
            entity: whose it is.
            reference: from whom.
        """
        if measure is Measure.OVERLAP_PERCENT:
            return CONTACT
        start, end = self._text.bounds(number.i)
        acts = [a for a in self._happenings.acts if a.entity in (entity, reference)]
        if measure is Measure.LATERAL_GAP_M:
            passing = [a for a in acts if a.kind is ActKind.OVERTAKE and start <= a.i < end]
            return passing[-1] if passing else START
        if measure not in LENGTHWISE:
            return START
        if self._text.says("starts", start, end):
            return START
        own = self._text.verb_at(number.i, number.j)
        told = {own.i} if own is not None and own.i < number.i else set()
        into = [a for a in acts if a.kind in _LANED | _MOVES_INTO and told & {a.i, *a.told}]
        into = into or [a for a in acts if self._in_trigger(a, start, end, number.i)]
        into = into or [a for a in [self._revealed_by(number, entity, reference)] if a is not None]
        if into:
            return into[0]  # "when it has passed it moves in 15 m ahead of the ego"
        here = [a for a in acts if any(start <= i < number.i for i in (a.i, *a.told))]
        laned = [a for a in here if a.kind in _LANED | _MOVES_INTO]
        laned += [a for a in here if a.kind is ActKind.SET_OFF and a.entity.pulls_out]
        laned = laned or [
            a
            for a in here
            if told & {a.i, *a.told}
            and (measure is Measure.TTC_S or number.around.closes("at_that"))
        ]  # "brakes at a TTC of 3 s", "brakes with 6 m/s² at 2 s time gap"
        if laned:
            return laned[-1]
        return self._until_it_brakes(entity, reference, acts)

    def _until_it_brakes(self, entity: Entity, reference: Entity, acts: list[Doing]) -> Doing | str:
        """Between two who are as fast: as far as when the one in front brakes."""
        one, other = entity.speed, reference.speed
        unequal = one is not None and other is not None and one != other
        stands = any(e.stands is not None or e.parked for e in (entity, reference))
        if unequal or stands or not (entity.is_vehicle and reference.is_vehicle):
            return START
        leader = in_file(entity, reference, self._context)[1]
        later = [a for a in acts if a.kind in _ANSWERING and a.always]
        return later[0] if later and later[0].entity is leader else START

    def _in_trigger(self, doing: Doing, start: int, end: int, i: int) -> bool:
        """``… is 150 m away when the ego pulls out``: at that moment."""
        for told in (doing.i, *doing.told):
            clause = self._text.subordinate(told)
            if clause is None or not start <= told < end or clause[0] <= i < clause[1]:
                continue
            if clause[2] in words()["triggers"] and told >= clause[0]:
                return True
        return False

    def since(self, at: Doing | str, one: Entity, other: Entity) -> Literal["begin", "end"]:
        """``when it has changed lanes``; what somebody reveals who leaves the lane.

        Args:
            at: the moment.
            one: one of the two.
            other: the other.
        """
        if not isinstance(at, Doing) or at.kind is not ActKind.CHANGE_LANE:
            return "begin"
        told = {at.i, *at.told}
        over = any(s.event.perfect and s.event.i in told for s in self._text.scenes)
        return "end" if over or at.entity not in (one, other) else "begin"

    def _revealed_by(self, number: Measured, one: Entity, other: Entity) -> Doing | None:
        """``the car ahead changes lanes and reveals a truck 60 m ahead``: as it has done so."""
        if not (one.still or other.still) or not (one.ego or other.ego):
            return None
        ahead = [
            a
            for a in self._happenings.acts
            if a.kind is ActKind.CHANGE_LANE
            and a.entity not in (one, other)
            and a.into is None
            and a.i < self._text.bounds(number.i)[1]
            and self._context.placed(a.entity, Approach.AHEAD)
        ]
        return ahead[0] if len(ahead) == 1 and ahead[0].when is None else None
