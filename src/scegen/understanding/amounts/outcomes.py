"""How it ends: who touches whom, nearly or not at all, and where on the ego."""

from __future__ import annotations

from scegen.scenario.model import Interval
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.spacings import CONTACT, Measure
from scegen.scenario.vocabulary import Approach, BodySide, Maneuver, ParticipantKind, Side
from scegen.understanding.amounts.teller import Teller
from scegen.understanding.amounts.whom import counterpart, ego_of
from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured, words
from scegen.understanding.happenings import Amount, Apart, Ending, amount_of
from scegen.understanding.semantics.context import Clause
from scegen.understanding.words.quantities import ends_a_quantity

_BEFORE = 4
_WHOLE, _HALF, _LITTLE = 100.0, 50.0, 10.0
_PARTS = {"front": BodySide.FRONT, "rear": BodySide.REAR, "left": BodySide.LEFT,
          "right": BodySide.RIGHT}  # fmt: skip
_OPPOSED = {BodySide.FRONT: BodySide.REAR, BodySide.REAR: BodySide.FRONT}
_REACH = 7
_NOBODY = frozenset({"neither", "nobody"})


class Judge(Teller):
    """Reads the outcome."""

    def read(self) -> None:
        """The outcome, as verbs tell it, or nouns where none does."""
        endings = [e for s in self._text.scenes if (e := self._of_verb(s)) is not None]
        endings += self._of_phrases()
        for kind in (OutcomeKind.COLLISION, OutcomeKind.NEAR_MISS, OutcomeKind.AVOIDED):
            told = [e for e in endings if e.kind is kind]
            if told:
                self._happenings.ending = told[0]
                break
        ending = self._happenings.ending
        if ending is not None and ending.kind is not OutcomeKind.AVOIDED:
            self._where(ending)
        self._overlaps()

    def _of_verb(self, scene: Clause) -> Ending | None:
        event = scene.event
        if event.premod_of is not None or not self._meets(scene):
            return None
        start = max(self._text.bounds(event.i)[0], event.i - _BEFORE)
        basis = Basis(event.i, event.j)
        nearly = self._phrase("nearly", start, event.i)
        parent = event.parent
        held_off = parent is not None and parent.name in {"avoid", "prevent", "fail"}
        if event.name == "overlook":
            kind = OutcomeKind.NEAR_MISS
        elif nearly is not None:
            kind, basis = OutcomeKind.NEAR_MISS, Basis(nearly[0], event.j)
        elif event.negated or held_off or self._before_it(event) or self._of_nobody(event):
            kind = OutcomeKind.AVOIDED
        elif event.modal or self._supposed(start, event.i):
            return None
        else:
            kind = OutcomeKind.COLLISION
        return Ending(kind, basis, self._between(scene))

    def _meets(self, scene: Clause) -> bool:
        """Verbs of contact; "meets head-on"; "just misses"."""
        event = scene.event
        lemma = event.lemma
        if event.name == "overlook" and lemma == "miss":
            start = max(0, event.i - _BEFORE)
            return self._phrase("nearly", start, event.i) is not None
        part = isinstance(event.object, Place) and event.object.kind in {"side", "middle", "front"}
        meets = lemma == "meet" and (event.how("head_on") is not None or part)
        return event.name == "collide" or meets

    def _supposed(self, start: int, end: int) -> bool:
        """``could hit``, ``to avoid hitting``: not that it happens."""
        low = self._text.low(start, end)
        return any(f" {w} " in low for w in words()["supposed"] if w != "to") or low.endswith(
            " to "
        )

    def _of_nobody(self, event: Event) -> bool:
        """``nobody is hit``, ``touches neither``, ``hits no car``: who is named is not touched.

        Not so "nobody reacts, and its front hits the van": there nobody has a verb already.
        """
        done = [
            m
            for s in self._text.scenes
            if s.event.i < event.i and s.event is not event.parent
            for m in s.event.subject
        ]
        own = [m for m in event.subject if all(m is not other for other in done)]
        named = [*own, event.object, *(p.target for p in event.pps)]
        return any(
            isinstance(m, Mention) and (m.negated or m.denied or m.pronoun in _NOBODY)
            for m in named
        )

    def _before_it(self, event: Event) -> bool:
        """``stops just before hitting it``."""
        before = {t.low for t in self._text.tokens[max(0, event.i - 2) : event.i]}
        timed = ends_a_quantity(self._text.tokens, event.i - 1)  # "brakes 1 s before contact"
        told = event.form == "ing" or (event.form == "base" and not timed)
        return bool(before & {"before", "without"}) and told

    def _phrase(self, name: str, start: int, end: int) -> tuple[int, int] | None:
        """Where a phrase of a list stands between two tokens."""
        return self._text.find(words()[name], start, end)

    def _of_phrases(self) -> list[Ending]:
        found = []
        for name in ("near_miss", "avoided", "collision"):
            span = self._phrase(name, 0, len(self._text.tokens))
            if span is None:
                continue
            start = max(self._text.bounds(span[0])[0], span[0] - _BEFORE)
            vain = any(_in_vain(c.event) for c in self._text.within(start, span[0]))
            if name == "collision" and self._supposed(start, span[0]) and not vain:
                continue
            if name == "avoided" and ends_a_quantity(self._text.tokens, span[0]):
                continue
            who = self._around(span[0], None)
            found.append(Ending(OutcomeKind(name), Basis(*span), who))
        return found

    def _between(self, scene: Clause) -> list[Entity]:
        """Who touches whom: by the verb, by whose part is named, by who is named around."""
        who = [*scene.actors, *scene.targets]
        alike = len({e.kind for e in scene.targets}) == 1 and len(scene.targets) > 1
        if alike and any(e.ego for e in scene.actors):
            return []  # "drives into the tail of a queue": whichever of them is the last
        if len(who) > 2 and scene.actors and scene.targets:
            return [scene.actors[0], scene.targets[0]]
        if len(who) == 2:
            return who
        return self._around(scene.event.i, who[0] if who else None)

    def _around(self, i: int, known: Entity | None) -> list[Entity]:
        start, end = self._text.bounds(i)
        before = [e for m in self._text.mentions if start <= m.i < i for e in m.entities]
        after = [e for m in self._text.mentions if i <= m.i < end for e in m.entities]
        if not before and not after and known is None:
            before = [e for m in self._text.mentions for e in m.entities]
        chosen = [known] if known is not None else []
        for entity in (*reversed(before), *after):
            if entity not in chosen and not entity.parked and len(chosen) < 2:
                chosen.append(entity)
        if len(chosen) == 1:
            near = [e for m in self._text.mentions if m.i < i for e in m.entities]
            other = counterpart(chosen[0], self._context, near)
            chosen += [other] if other is not None else []
        return chosen if len(chosen) == 2 else []

    def _where(self, ending: Ending) -> None:
        """``the middle of the ego's front``, ``hits its rear``: which side, and where on it."""
        i = ending.basis.i or 0
        start, end = self._text.bounds(i)
        ego = ego_of(self._context)
        for place in self._text.places(start, end, {"side", "front", "flank"}):
            if self._is_portion(place) or self._text.tokens[place.i - 2].low == "overlap":
                continue
            part = next((_PARTS[d] for d in place.dirs if d in _PARTS), None)
            whose = self._owner(place, i)
            flank = part is not None and part not in _OPPOSED
            hit_by = place.prep is not None and place.prep.value in {"by", "with"}
            on = place.prep is not None and place.prep.value == "in" and place.head is not None
            hit_by = hit_by or (on and ego is not None and self._is_hit(ego, i))
            into = place.prep is not None and place.prep.value in {"in", "into"}
            told = place.owner is not None or any(m.cat == "possessive" for m in place.mods)
            hit_by = hit_by or (into and told and whose is ego)
            direct = any(s.event.i == i and s.event.object is place for s in self._text.scenes)
            hit_by = hit_by or (direct and whose is ego)
            if part is None or whose is None or (flank and not (hit_by and whose is ego)):
                continue
            basis = Basis(place.i, place.j)
            half = self._portion(place) if whose is ego and part is BodySide.FRONT else None
            if half is not None:
                ending.half = Side.LEFT if "left" in half.dirs else Side.RIGHT
                ending.half_basis = basis = Basis(half.i, place.j)
            if whose is ego and ending.struck is None:
                ending.struck, ending.struck_basis = part, basis
                self._middle(ending, place, start)
            elif (
                ending.struck is None
                and not flank
                and ego in ending.between
                and part is BodySide.REAR
            ):
                ending.struck, ending.struck_basis = BodySide.FRONT, basis
        self._by_the_bonnet(ending, start, end)

    def _portion(self, place: Place) -> NounPhrase | None:
        """``the left half`` of its front, ``the right corner`` of the ego's front."""
        of = (place.i if place.owner is None else place.owner.i) - 1
        if self._text.tokens[of].low != "of":
            return None
        named = [c for c in self._text.chunks if isinstance(c, Place | Thing) and c.i < of]
        ends = (p for p in named if p.j in {of - 1, of} and {"left", "right"} & set(p.dirs))
        return next(ends, None)

    def _is_portion(self, place: Place) -> bool:
        """Whether it is the side of a part that is named behind it."""
        following = self._text.places(place.j, place.j + _REACH, {"side", "front"})
        return any(self._portion(other) is place for other in following if "front" in other.dirs)

    def settle(self) -> None:
        """What half of the front is touched, by the numbers if any: by whom it is narrow, where."""
        ending, ego = self._happenings.ending, ego_of(self._context)
        if ending is None or ending.half is None or ending.impact is not None:
            return
        basis, left = ending.half_basis or ending.basis, ending.half is Side.LEFT
        other = next((e for e in ending.between if e is not ego), None)
        told = [s for s in self._happenings.spacings if s.measure is Measure.OVERLAP_PERCENT]
        for overlap in told:
            known = overlap.amount.basis
            begins, ends = min(known.i or 0, basis.i or 0), max(known.j or 0, basis.j or 0)
            overlap.amount = Amount(overlap.amount.value, Basis(begins, ends, known.reason))
            overlap.side = overlap.side or ending.half
        if told:
            return
        if other is not None and other.is_vehicle and other.kind is not ParticipantKind.BICYCLE:
            amount = Amount(Interval(low=_LITTLE, high=_HALF), basis)
            apart = Apart(Measure.OVERLAP_PERCENT, other, ego, amount, CONTACT, ending.half)
            self._happenings.spacings.append(apart)
        else:
            value = Interval(low=0.0 if left else _HALF, high=_HALF if left else _WHOLE)
            ending.impact = Amount(value, basis)

    def _by_the_bonnet(self, ending: Ending, start: int, end: int) -> None:
        """``by the centre of the bonnet``: a part that only the ego can mean."""
        tokens = self._text.tokens
        for k in range(start, end):
            if tokens[k].low not in words()["middle"] or ending.impact is not None:
                continue
            after = [t.low for t in tokens[k + 1 : min(k + _REACH, end)]]
            part = next((n for n, low in enumerate(after) if low in words()["parts"]), None)
            owners = [
                e
                for m in self._text.mentions
                if part is not None and k < m.i <= k + 1 + part
                for e in m.entities
            ]
            if part is not None and after[:1] == ["of"] and all(e.ego for e in owners):
                value = Interval(low=_HALF, high=_HALF)
                ending.impact = Amount(value, Basis(k, k + 2 + part))

    def _is_hit(self, ego: Entity, i: int) -> bool:
        return any(
            ego in s.targets and ego not in s.actors for s in self._text.scenes if s.event.i == i
        )

    def _owner(self, place: Place, i: int) -> Entity | None:
        """Whose part it is: "the ego's front", "the rear of the car", "its rear"."""
        if place.owner is not None and place.owner.entities:
            return place.owner.entities[0]  # type: ignore[no-any-return]
        if any((m.cat, m.value) == ("possessive", "first_person") for m in place.mods):
            return ego_of(self._context)
        own = any(m.cat == "possessive" and m.value == "its" for m in place.mods)
        done = [s for s in self._text.scenes if s.event.object is place]
        scene = next((s for s in (*done, *self._text.scenes) if s in done or s.event.i == i), None)
        if scene is None:
            return None
        direct = scene.event.object is place
        flank = bool({"left", "right"} & set(place.dirs))
        at = place.prep is not None and place.prep.value == "in"
        if at and not own and scene.event.name == "collide" and scene.targets:
            return scene.targets[0]  # "hits us in the side"
        met = direct or (flank and place.prep is not None and place.prep.value == "into")
        if met and own and scene.actors:  # "a car behind hits its rear"
            return None if scene.actors[0].ego else ego_of(self._context)
        if own and scene.event.passive and place.prep is not None and place.prep.value == "in":
            return scene.targets[0] if scene.targets else None  # "is hit on its right side"
        if own or not direct:
            doer = scene.actors[0] if scene.actors else None
            hit_by = scene.event.passive and place.prep is not None and place.prep.value == "by"
            return ego_of(self._context) if hit_by or doer is None else doer
        return None

    def _middle(self, ending: Ending, place: NounPhrase, start: int) -> None:
        """``with the middle of its front``."""
        tokens = self._text.tokens
        for k in range(max(start, place.i - _REACH), place.i):
            part = k + 1 == place.i or tokens[k + 1].low in {"of", "front"}
            if part and tokens[k].low in words()["middle"]:
                value = Interval(low=_HALF, high=_HALF)
                ending.impact = Amount(value, Basis(k, place.j))

    def impact(self, number: Measured) -> bool:
        """``at 25 % of its width counted from its right side``.

        Args:
            number: the share.
        """
        ego = ego_of(self._context)
        ending = self._happenings.ending
        if ending is None:
            who = self._around(number.i, ego)
            ending = Ending(OutcomeKind.COLLISION, amount_of(number).basis, who)
            self._happenings.ending = ending
        _, end = self._text.bounds(number.i)
        left = self._phrase("left_edge", number.j, end)
        right = self._phrase("right_edge", number.j, end)
        value, basis = number.quantity.exact, amount_of(number).basis
        edge = left or right
        if edge is not None:
            basis = Basis(basis.i, edge[1], basis.reason)
        if edge is None:
            other = next((e for e in ending.between if e is not ego), None)
            mirrored = other is not None and self._from_the_right(other)
            if value.low != value.high or value.low != _HALF:
                side = "right" if mirrored else "left"
                reason = f"counted from the {side}, from where the other comes"
                basis = Basis(basis.i, basis.j, reason)
        else:
            mirrored = left is None
        if mirrored:
            value = Interval(low=_WHOLE - value.high, high=_WHOLE - value.low)
        if ending.impact is None or basis.reason is None:
            ending.impact = Amount(value, basis)
        return True

    def _from_the_right(self, entity: Entity) -> bool:
        crosses = Maneuver.CROSS in entity.maneuvers or not entity.is_vehicle
        return crosses and self._context.placed(entity, Approach.RIGHT)

    def _overlaps(self) -> None:
        """``with full overlap``: the share that no number tells."""
        ending = self._happenings.ending
        ego = ego_of(self._context)
        span = self._phrase("full_overlap", 0, len(self._text.tokens))
        if span is None or ego is None:
            return
        named = [e for e in ending.between if e is not ego] if ending is not None else []
        near = [e for m in self._text.mentions if m.i < span[0] for e in m.entities]
        other = named[0] if named else counterpart(ego, self._context, near)
        if other is not None:
            amount = Amount(Interval(low=_WHOLE, high=_WHOLE), Basis(*span))
            apart = Apart(Measure.OVERLAP_PERCENT, other, ego, amount, CONTACT)
            self._happenings.spacings.append(apart)


def _in_vain(event: Event) -> bool:
    """``cannot avoid hitting him``, ``fails to prevent it``: it happens all the same."""
    denied = event.negated or event.unable
    failed = event.parent is not None and event.parent.name == "fail"
    return event.name in {"avoid", "prevent"} and (denied or failed)
