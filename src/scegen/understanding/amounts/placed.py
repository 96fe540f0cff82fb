"""Distances, headways, offsets and overlaps between two."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.scenario.model import Interval
from scegen.scenario.spacings import CONTACT, START, Measure
from scegen.scenario.vocabulary import Approach, Maneuver, Side
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.amounts.whom import counterpart, ego_of, in_file
from scegen.understanding.chunks import Mention, Place, Word
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured, words
from scegen.understanding.happenings import Amount, Apart, Doing, Happenings, Trigger, amount_of
from scegen.understanding.meaning.context import Context

MEASURES = {
    "gap": Measure.GAP_M,
    "headway": Measure.HEADWAY_S,
    "ttc": Measure.TTC_S,
    "lateral_gap": Measure.LATERAL_GAP_M,
    "lateral_offset": Measure.LATERAL_OFFSET_M,
    "overlap": Measure.OVERLAP_PERCENT,
}
_APART = 4
_SIDE_REACH = 14
_JUNCTION = frozenset({"junction", "signal", "stop_line", "stop_sign", "yield_sign"})
_ALONG = frozenset({Measure.GAP_M, Measure.HEADWAY_S, Measure.TTC_S})
_ANSWERING = frozenset({ActKind.BRAKE, ActKind.STOP, ActKind.CHANGE_LANE})
_LANED = frozenset({ActKind.CHANGE_LANE, ActKind.OVERTAKE})


class Spacer:
    """Turns numbers into spacings and into what sets acts off.

    Args:
        text: the text with its clauses.
        context: the scenario in the making.
        happenings: what the text tells of; spacings are added.
    """

    def __init__(self, text: Sentences, context: Context, happenings: Happenings) -> None:
        self._text = text
        self._context = context
        self._happenings = happenings

    def read(self, number: Measured) -> bool:
        """One number that lies between two; whether a place was found for it.

        Args:
            number: the number.
        """
        measure = MEASURES[number.frame.role]
        if measure in _ALONG and self._sets_off(number, measure):
            return True
        after = self._text.phrase_after(number.j)
        if after is not None and isinstance(after[1], Place) and after[1].kind in _JUNCTION:
            return False  # so far from the junction: between no two
        if self._where_it_stops(number) or self._until(number):
            return False
        if measure is Measure.GAP_M and self._to_a_thing(number):
            return True
        pair = self._pair(number)
        if pair is None:
            return False
        entity, reference = pair
        past = self._verb(number) in {"pass", "bypass"} and (entity.parked or reference.parked)
        if measure is Measure.GAP_M and past:
            measure = Measure.LATERAL_GAP_M
        along = number.around.after.startswith((" ahead ", " in front ", " behind ", " before "))
        if measure is Measure.GAP_M and not along and self._beside(entity, reference):
            measure = Measure.LATERAL_GAP_M
        amount, side = self._with_place(amount_of(number), number), None
        if len(number.quantity.parts) > 1 and number.around.preceded("from"):
            amount = Amount(number.quantity.parts[0], amount.basis)  # "closes from 40 m to 15 m"
        if measure is Measure.LATERAL_OFFSET_M:
            amount = self._signed(number)
        if measure in {Measure.HEADWAY_S, Measure.TTC_S}:
            entity, reference = in_file(entity, reference, self._context)
        if measure is Measure.OVERLAP_PERCENT:
            side = self._half(number) if amount.value.high < 100 else None
            entity, reference = self._ego_last(entity, reference)
            self._happenings.spacings[:] = [
                s
                for s in self._happenings.spacings
                if s.measure is not measure or s.entity is not entity
            ]  # "with full overlap (100 %)"
        self._behind_or_ahead(number, *pair)
        self._in_file(measure, entity, reference, amount)
        at = self._moment(number, measure, entity, reference)
        self._happenings.spacings.append(Apart(measure, entity, reference, amount, at, side))
        return True

    def _to_a_thing(self, number: Measured) -> bool:
        """``a mattress lies 60 m ahead``, ``60 m ahead of the ego lies a mattress``."""
        start, end = self._text.bounds(number.i)
        items = {x.basis.i: x for x in self._happenings.items if start <= (x.basis.i or 0) < end}
        others = [
            m.i
            for m in self._text.mentions
            if start <= m.i < number.i and any(not e.ego for e in m.entities)
        ]
        before = [i for i in items if i is not None and i < number.i]
        nearest = max(before, default=None) if before else None
        if nearest is None and not others:
            nearest = min((i for i in items if i is not None), default=None)
        if nearest is None or any(i > nearest for i in others):
            return False
        amount = self._with_place(amount_of(number), number)
        apart = Apart(Measure.GAP_M, items[nearest], ego_of(self._context), amount)
        self._happenings.spacings.append(apart)
        return True

    def _behind_or_ahead(self, number: Measured, one: Entity, other: Entity) -> None:
        """``15 m behind``: who is said to be there, if no place of the two is said."""
        draft, after = self._context.draft, number.around.after
        way = {" behind ": Approach.BEHIND, " ahead ": Approach.AHEAD, " in front ": Approach.AHEAD}
        said = next((a for w, a in way.items() if after.startswith(w)), None)
        known = any(
            {p.entity, p.reference or ego_of(self._context)} == {one, other}
            for p in draft.placements
        )
        vehicles = one.is_vehicle and other.is_vehicle and not (one.parked or other.parked)
        sideways = {Maneuver.CROSS, Maneuver.LANE_CHANGE} & (one.maneuvers | other.maneuvers)
        if said is not None and not known and vehicles and not sideways:
            draft.place(one, other, {said}, amount_of(number).basis)

    def _in_file(self, measure: Measure, one: Entity, other: Entity, amount: Amount) -> None:
        """``ego and target at 50 km/h, gap 12 m``: the other is ahead, if no place is said."""
        two = [e for e in (one, other) if not e.ego]
        if measure not in _ALONG or len(two) != 1 or not two[0].is_vehicle:
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

    def _until(self, number: Measured) -> bool:
        """``drifts until only 0.3 m remain``: how far apart they end up."""
        clause = self._text.subordinate(number.i)
        if clause is None or clause[2] not in {"until", "till"}:
            return False
        return not any(
            a.i >= clause[1] for a in self._happenings.acts if a.i < clause[1] + _SIDE_REACH
        )

    def _verb(self, number: Measured) -> str:
        scene = self._text.scene_at(number.i, number.j)
        return scene.event.name if scene is not None else ""

    def _where_it_stops(self, number: Measured) -> bool:
        """``stops 1 m before the pedestrian``: how far apart they end up."""
        scene = self._text.scene_at(number.i, number.j)
        name = scene.event.name if scene is not None else ""
        stops = name in {"stop", "wait"} or (name == "pass" and not (scene and scene.targets))
        stops = stops and scene is not None and not any(e.still for e in scene.actors)
        return stops and number.around.after.startswith((" before ", " short ", " in front "))

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
        if after is None or after[0].i - number.j > _APART:
            return amount
        noun = after[1]
        part = noun is not None and isinstance(noun, Mention) and noun.possessor
        end = noun.j + 2 if noun is not None and part else after[0].j
        end = noun.j if isinstance(noun, Place) and noun.kind == "side" else end
        end = min(end, self._text.bounds(number.i)[1])
        return Amount(amount.value, Basis(basis.i, end, basis.reason))

    def _ego_last(self, entity: Entity, reference: Entity) -> tuple[Entity, Entity]:
        return (reference, entity) if entity.ego else (entity, reference)

    def _pair(self, number: Measured) -> tuple[Entity, Entity] | None:
        """Who lies how far from whom."""
        text = self._text
        after = text.phrase_after(number.j)
        noun = after[1] if after is not None else None
        own = noun is not None and any(m.cat == "possessive" for m in noun.mods)
        named = text.named(noun) if not own else []
        located = after is not None and isinstance(after[0], Word) and after[0].cat == "locus"
        scene = text.scene_at(number.i, number.j)
        subject = text.subject_before(number.i)
        if isinstance(noun, Mention) and noun.pronoun is not None and named == subject:
            named = []  # "and the ego, 15 m behind it": not behind itself
        bracketed = self._bracketed(number)
        if bracketed is not None and subject and bracketed not in subject:
            return subject[0], bracketed
        if noun is None and located:
            behind = self._named_in_front(number)
            if behind is not None and subject and behind not in subject:
                return behind, subject[0]
        by_verb = number.frame.role in {"overlap", "headway", "ttc"} or not (named or located)
        if by_verb and scene is not None and scene.actors and scene.targets:
            return scene.actors[0], scene.targets[0]
        subject = [e for e in subject if e not in named]
        if not subject and scene is not None:
            subject = [e for e in scene.actors if e not in named]
        if subject and named and (located or number.frame.role != "overlap"):
            return subject[0], named[0]
        near = [e for m in text.mentions if m.i < number.i for e in m.entities]
        first = subject[0] if subject else named[0] if named else ego_of(self._context)
        if first is None:
            return None
        other = counterpart(first, self._context, near)
        return (first, other) if other is not None and other is not first else None

    def _bracketed(self, number: Measured) -> Entity | None:
        """``in front of a stationary target (TTC 3 s)``: to whom it is."""
        tokens = self._text.tokens
        opening = next(
            (k for k in range(number.i - 1, max(-1, number.i - 4), -1) if tokens[k].low == "("),
            None,
        )
        if opening is None:
            return None
        before = [m for m in self._text.mentions if m.j == opening and m.entities]
        first: Entity | None = before[0].entities[0] if before else None
        return first

    def _named_in_front(self, number: Measured) -> Entity | None:
        """``changes lanes in front of a car, 20 m behind``: the car is behind."""
        if not number.around.after.startswith(" behind "):
            return None
        start, _ = self._text.bounds(number.i)
        before = [m for m in self._text.mentions if start <= m.i < number.i and m.entities]
        last = before[-1] if before else None
        ahead = last is not None and last.prep is not None and last.prep.value == "ahead"
        first: Entity | None = last.entities[0] if last is not None and ahead else None
        return first

    def _signed(self, number: Measured) -> Amount:
        """To the left is positive, to the right negative; the left where no side is said."""
        start, end = self._text.bounds(number.i)
        right = self._toward(number, start, end)
        value, basis = number.quantity.exact, Basis(number.i, number.j)
        if right is None:
            reason = "the side is not said; the left is taken"
            return Amount(value, Basis(number.i, number.j, reason))
        return (
            Amount(Interval(low=-value.high, high=-value.low), basis)
            if right
            else Amount(value, basis)
        )

    def _toward(self, number: Measured, start: int, end: int) -> bool | None:
        """Whether the side named next to a number is the right one."""
        for k in range(number.j, min(number.j + 8, end)):
            if self._text.tokens[k].low in {"left", "right"}:
                return self._text.tokens[k].low == "right"
            if self._text.tokens[k].kind in {"number", "punct"}:
                break
        for k in range(number.i - 1, max(start, number.i - _SIDE_REACH) - 1, -1):
            if self._text.tokens[k].low in {"left", "right"}:
                return self._text.tokens[k].low == "right"
        return None

    def _half(self, number: Measured) -> Side | None:
        """``the left 50 %``, ``the right half of its front (50 % overlap)``."""
        start, end = self._text.bounds(number.i)
        right = self._toward(number, start, end)
        return None if right is None else Side.RIGHT if right else Side.LEFT

    def _moment(
        self, number: Measured, measure: Measure, entity: Entity, reference: Entity
    ) -> Doing | str:
        if measure is Measure.OVERLAP_PERCENT:
            return CONTACT
        start, end = self._text.bounds(number.i)
        if self._text.says("contact", start, end):
            return CONTACT
        acts = [a for a in self._happenings.acts if a.entity in (entity, reference)]
        if measure is Measure.LATERAL_GAP_M:
            acts = [] if entity.parked or reference.parked else acts
            passing = [a for a in acts if a.kind is ActKind.OVERTAKE and start <= a.i < end]
            return passing[-1] if passing else START
        if measure not in _ALONG:
            return START
        if self._text.says("starts", start, end):
            named = self._text.low(start, end)
            of_act = any(f" {w} of the " in named for w in ("beginning", "start", "onset"))
            laned = [a for a in acts if a.kind in _LANED]
            return laned[-1] if of_act and laned else START
        begun = [a for a in acts if self._in_trigger(a, start, end, number.i)]
        if begun:
            return begun[0]
        trigger = self._text.subordinate(number.i)
        here = [a for a in acts if start <= a.i < end and a.i < number.i]
        if trigger is not None and trigger[2] in words()["triggers"] and here:
            return here[-1]
        laned = [a for a in here if a.kind in _LANED or a.kind is ActKind.CROSS]
        if laned:
            return laned[-1]
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

    def _sets_off(self, number: Measured, measure: Measure) -> bool:
        """``when the gap is 20 m``, ``50 m before the junction``: what sets an act off."""
        text = self._text
        start, end = text.bounds(number.i)
        clause = text.subordinate(number.i)
        opened = clause is not None and clause[2] in words()["triggers"]
        if opened and self._until(number):
            return False
        after = text.phrase_after(number.j)
        noun = after[1] if after is not None else None
        word = (
            text.tokens[after[0].i].low if after is not None and isinstance(after[0], Word) else ""
        )
        short = word in {"before", "short", "from", "away", "off", "of", "in", "ahead", "prior"}
        junction = isinstance(noun, Place) and noun.kind in _JUNCTION and short
        before = word == "before" and isinstance(noun, Mention)
        if not (opened or junction or before):
            return False
        doing = self._main(clause if opened else None, number, start, end)
        if doing is None and opened:
            doing = self._starts_crossing(start, number.i)
        if doing is None or (before and not opened and doing.kind is ActKind.STOP):
            return False
        if doing.when is not None:
            if doing.when.kind == "measure" and opened and doing.when.amount is not None:
                pair = (doing.when.entity, doing.when.reference)
                self._also(number, measure, doing, pair)
                return True
            return False
        subject = self._subject(number, clause if opened else None, doing)
        if opened and clause is not None and self._acts_inside(clause, number, subject):
            return False  # "when the truck moves over 30 m in front of it"
        if junction:
            if subject is not doing.entity:
                return False
            doing.when = Trigger("junction", amount_of(number).basis, amount_of(number))
            return True
        own = noun is not None and any(m.cat == "possessive" for m in noun.mods)
        named = [e for e in (text.named(noun) if not own else []) if e is not subject]
        other = named[0] if named else doing.entity if subject is not doing.entity else None
        near = [e for m in text.mentions if m.i < number.i for e in m.entities if e is not subject]
        other = other or doing.into or counterpart(subject, self._context, near)
        if other is None or other is subject:
            return False
        entity, reference = subject, other
        self._behind_or_ahead(number, subject, other)
        if measure is not Measure.GAP_M:
            entity, reference = in_file(entity, reference, self._context)
        doing.when = Trigger("measure", amount_of(number).basis, amount_of(number))
        doing.when.measure, doing.when.entity, doing.when.reference = measure, entity, reference
        return True

    def _starts_crossing(self, start: int, i: int) -> Doing | None:
        """``followed by a child when the ego is 18 m away``: when it crosses."""
        for mention in (m for m in self._text.mentions if start <= m.i < i):
            crossers = [e for e in mention.entities if Maneuver.CROSS in e.maneuvers]
            if crossers:
                basis = crossers[0].maneuver_basis or Basis(mention.i, mention.j)
                doing = Doing(ActKind.CROSS, crossers[0], basis, mention.i, always=False)
                self._happenings.acts.append(doing)
                self._happenings.acts.sort(key=lambda a: a.i)
                return doing
        return None

    def _acts_inside(self, clause: tuple[int, int, str], number: Measured, subject: Entity) -> bool:
        acts = self._happenings.acts
        return any(clause[0] <= a.i < number.i and a.entity is subject for a in acts)

    def _also(
        self,
        number: Measured,
        measure: Measure,
        doing: Doing,
        pair: tuple[Entity | None, Entity | None],
    ) -> None:
        """``3.6 s (60 m) away``: the same moment in another measure."""
        entity, reference = pair
        if entity is None or reference is None:
            return
        self._happenings.spacings.append(
            Apart(measure, entity, reference, amount_of(number), doing)
        )

    def _main(
        self, clause: tuple[int, int, str] | None, number: Measured, start: int, end: int
    ) -> Doing | None:
        """The act that a clause sets off: before it, or after it where it opens the sentence."""
        acts = self._happenings.acts
        if clause is None:
            here = [a for a in acts if start <= a.i < end]
            before = [a for a in here if a.i < number.i]
            return before[-1] if before else here[0] if here else None
        begin, stop, _ = clause
        inside = [a for a in acts if start <= a.i < end and not begin <= a.i < stop]
        before = [a for a in inside if a.i < begin]
        after = [a for a in inside if a.i >= stop]
        if not (before or after) and begin == start:  # no comma: "when it is 20 m away it brakes"
            after = [a for a in acts if number.i < a.i < end]
        return before[-1] if before else next(iter(after), None)

    def _subject(
        self, number: Measured, clause: tuple[int, int, str] | None, doing: Doing
    ) -> Entity:
        """Whose distance sets it off: who is named in that clause, else who acts."""
        if clause is None:
            return doing.entity
        inside = [m for m in self._text.mentions if clause[0] <= m.i < number.i and m.entities]
        free = [m for m in inside if m.prep is None and not m.possessor]
        chosen = free[-1] if free else inside[-1] if inside else None
        if chosen is not None:
            first: Entity = chosen.entities[0]
            return first
        return doing.entity
