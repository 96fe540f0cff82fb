"""Distances, headways, offsets and overlaps between two."""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.acts import ActKind
from scegen.scenario.spacings import LENGTHWISE, Measure
from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.amounts.aside import Aside
from scegen.understanding.amounts.moments import Moments
from scegen.understanding.amounts.pairs import pair_of, row_of
from scegen.understanding.amounts.releasing import JUNCTION, Releaser
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.amounts.teller import Teller
from scegen.understanding.amounts.whom import behind_or_ahead, ego_of, in_file
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured
from scegen.understanding.happenings import Amount, Apart, Doing, Happenings, amount_of
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Context

MEASURES = {
    "gap": Measure.GAP_M,
    "headway": Measure.HEADWAY_S,
    "ttc": Measure.TTC_S,
    "lateral_gap": Measure.LATERAL_GAP_M,
    "lateral_offset": Measure.LATERAL_OFFSET_M,
    "overlap": Measure.OVERLAP_PERCENT,
}
_ARMS_LENGTH = 3
"""Nearer than so many metres, who drives by somebody parked is beside them."""
_TWO_LANES = 7
_PLACES = frozenset({"crosswalk", "bus_stop", "parking", "exit", "ramp"})
_PASSED = frozenset({"overtake", "pass", "bypass"})
_WHOLE = 100


class Spacer(Teller):
    """Turns numbers into spacings and into what sets acts off."""

    def __init__(self, text: Sentences, context: Context, happenings: Happenings) -> None:
        super().__init__(text, context, happenings)
        self._releaser = Releaser(text, context, happenings)
        self._aside = Aside(text, context, happenings)
        self._moments = Moments(text, context, happenings)

    def read(self, number: Measured) -> bool:
        """One number that lies between two; whether a place was found for it.

        Args:
            number: the number.
        """
        measure = MEASURES[number.frame.role]
        if measure in LENGTHWISE and self._releaser.sets_off(number, measure):
            return True
        if self._releaser.from_elsewhere(number):
            return False
        after = self._text.phrase_after(number.j)
        place = after[1] if after is not None else None
        if isinstance(place, Place) and place.kind in JUNCTION | _PLACES:
            return False  # so far from the junction: between no two
        if self._where_it_stops(number):
            return self._at_rest(number, measure)
        if self._releaser.until(number):
            return False
        if measure is Measure.GAP_M and self._to_a_thing(number):
            return True
        if measure is Measure.LATERAL_OFFSET_M and self._aside.off_its_lane(number):
            return True
        row = row_of(number, self._text, self._context)
        pair = row[-1] if row else pair_of(number, self._text, self._context)
        if pair is None:
            return False
        measure = self._sideways(measure, number, *pair)
        at = self._moments.at(number, measure, *pair)
        if row:
            amount = amount_of(number)
            self._happenings.spacings += [Apart(measure, a, b, amount, at) for a, b in row]
        else:
            told = self._between(number, measure, *pair, at)
            self._happenings.spacings += [told, *self._past_all(told)]
        return True

    def _past_all(self, told: Apart) -> list[Apart]:
        """``overtakes two cyclists, leaving 1.5 m``: past each of them."""
        if told.measure is not Measure.LATERAL_GAP_M:
            return []
        pair = {told.entity, told.reference}
        return [
            replace(told, entity=by, reference=other)
            for scene in self._text.scenes
            if scene.event.name in _PASSED and len(scene.targets) > 1
            for by in scene.actors[:1]
            if by in pair and pair - {by} <= {*scene.targets}
            for other in scene.targets
            if other not in pair
        ]

    def _at_rest(self, number: Measured, measure: Measure) -> bool:
        """``stops 3 m behind the truck``: how far apart they are once it stands."""
        pair = pair_of(number, self._text, self._context)
        start, _ = self._text.bounds(number.i)
        stops = [
            a
            for a in self._happenings.acts
            if start <= a.i < number.i and a.entity in (pair or ())
            if a.always and a.ends_at_rest  # "must stop 2 m before": what is asked of it
        ]
        if pair is None or not stops:
            return False
        amount = self._with_place(amount_of(number), number)
        self._happenings.spacings.append(Apart(measure, *pair, amount, stops[-1], since="end"))
        return True

    def _sideways(self, measure: Measure, number: Measured, one: Entity, other: Entity) -> Measure:
        """``passes the parked van at 1 m``, ``drives beside it, 1 m away``: from side to side."""
        near = number.quantity.exact.high <= _ARMS_LENGTH
        past = (near and self._verb(number) == "move") or self._verb(number) in {"pass", "bypass"}
        past = past and (one.parked or other.parked)
        passing = [a for a in self._happenings.acts if a.kind is ActKind.OVERTAKE]
        past = past or (near and any(a.entity in (one, other) for a in passing))
        along = number.around.opens("along")
        beside = self._beside(one, other) and number.quantity.exact.high <= _TWO_LANES
        lateral = not along and (past or beside)
        return Measure.LATERAL_GAP_M if measure is Measure.GAP_M and lateral else measure

    def _between(
        self, number: Measured, measure: Measure, one: Entity, other: Entity, at: Doing | str
    ) -> Apart:
        """The spacing of two, the one whose it is first."""
        entity, reference, side = one, other, None
        amount = self._with_place(amount_of(number), number)
        if measure is Measure.LATERAL_OFFSET_M:
            amount = self._aside.signed(number)
        elif measure in {Measure.HEADWAY_S, Measure.TTC_S}:
            entity, reference = in_file(one, other, self._context)
        elif measure is Measure.OVERLAP_PERCENT:
            side = self._aside.half(number) if amount.value.high < _WHOLE else None
            entity, reference = (other, one) if one.ego else (one, other)
            self._happenings.spacings[:] = [
                s
                for s in self._happenings.spacings
                if s.measure is not measure or s.entity is not entity
            ]  # "with full overlap (100 %)"
        behind_or_ahead(number, one, other, self._context)
        self._in_file(measure, entity, reference, amount)
        return Apart(
            measure, entity, reference, amount, at, side, self._moments.since(at, one, other)
        )

    def _to_a_thing(self, number: Measured) -> bool:
        """``a mattress lies 60 m ahead``, ``60 m ahead of the ego lies a mattress``."""
        start, end = self._text.bounds(number.i)
        items = {x.basis.i: x for x in self._happenings.items if start <= (x.basis.i or 0) < end}
        said = [e for m in self._text.mentions if start <= m.i < number.i for e in m.entities]
        others = [e for e in said if not e.ego]
        nearest = min((i for i in items if i is not None), default=None)
        if nearest is None or others:
            return False
        amount = self._with_place(amount_of(number), number)
        apart = Apart(Measure.GAP_M, items[nearest], ego_of(self._context), amount)
        self._happenings.spacings.append(apart)
        return True

    def _in_file(self, measure: Measure, one: Entity, other: Entity, amount: Amount) -> None:
        """``ego and target at 50 km/h, gap 12 m``: the other is ahead, if no place is said."""
        two = [e for e in (one, other) if not e.ego]
        if measure not in LENGTHWISE or len(two) != 1 or not two[0].is_vehicle:
            return
        entity, draft = two[0], self._context.draft
        placed = any(p.entity is entity or p.reference is entity for p in draft.placements)
        meets = self._context.junction.crossing or draft.crossing_implied is not None
        sideways = bool(entity.maneuvers & {Maneuver.LANE_CHANGE, Maneuver.CROSS})
        free = not (placed or meets or sideways or entity.parked or entity.heading)
        if free and not any(p.entity.ego for p in draft.placements):
            basis = Basis(
                amount.basis.i, amount.basis.j, "a gap along the road is one to who is ahead"
            )
            draft.place(entity, None, {Approach.AHEAD}, basis)

    def _verb(self, number: Measured) -> str:
        scene = self._text.scene_at(number.i, number.j)
        return scene.event.name if scene is not None else ""

    def _where_it_stops(self, number: Measured) -> bool:
        """``stops 1 m before the pedestrian``, ``comes to rest 5 m behind it``: how they end up."""
        scene = self._text.scene_at(number.i, number.j)
        name = scene.event.name if scene is not None else ""
        before = self._text.low(number.i - 2, number.i).split()
        rests = before[-1:] and before[-1] in word_list("at_rest") and before[0] != "from"
        who = scene.actors if scene is not None else []
        stops = name == "stop" or bool(rests)
        stops = stops and bool(who) and not any(e.still for e in who)
        if scene is not None and (rests or scene.event.j == number.i):
            return stops and number.around.opens("short_of_or_behind")
        return stops and number.around.opens("short_of")

    def _beside(self, one: Entity, other: Entity) -> bool:
        """``drives alongside the ego, 1 m away``: from side to side."""
        return any(
            p.approaches == {Approach.ADJACENT}
            and {p.entity, p.reference or ego_of(self._context)} == {one, other}
            for p in self._context.draft.placements
        ) and not (one.maneuvers | other.maneuvers) & {Maneuver.LANE_CHANGE, Maneuver.OVERTAKE}

    def _with_place(self, amount: Amount, number: Measured) -> Amount:
        """The words of a number with those of place after it: "15 m in front of"."""
        after = self._text.phrase_after(number.j)
        basis = amount.basis
        if after is None:
            return amount
        noun = after[1]
        part = noun is not None and isinstance(noun, Mention) and noun.possessor
        end = noun.j + 2 if noun is not None and part else after[0].j
        end = noun.j if isinstance(noun, Place) and noun.kind == "side" else end
        end = min(end, self._text.bounds(number.i)[1])
        return Amount(amount.value, Basis(basis.i, end, basis.reason))
