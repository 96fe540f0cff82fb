"""What sets acts off by how far or how near somebody is."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.amounts.teller import Teller
from scegen.understanding.amounts.whom import behind_or_ahead, counterpart, in_file
from scegen.understanding.chunks import Mention, Place, Word
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured, words
from scegen.understanding.happenings import Apart, Doing, Trigger, amount_of

JUNCTION = frozenset({"junction", "signal", "stop_line", "stop_sign", "yield_sign"})
_SOON = 14


class Releaser(Teller):
    """Turns numbers into what sets acts off."""

    def until(self, number: Measured) -> bool:
        """``drifts until only 0.3 m remain``: how far apart they end up."""
        clause = self._text.subordinate(number.i)
        if clause is None or clause[2] not in {"until", "till"}:
            return False
        return not any(a.i >= clause[1] for a in self._happenings.acts if a.i < clause[1] + _SOON)

    def sets_off(self, number: Measured, measure: Measure) -> bool:
        """``when the gap is 20 m``, ``50 m before the junction``: what sets an act off."""
        text = self._text
        start, end = text.bounds(number.i)
        clause = text.subordinate(number.i)
        opened = clause is not None and clause[2] in words()["triggers"]
        if opened and self.until(number):
            return False
        after = text.phrase_after(number.j)
        noun = after[1] if after is not None else None
        word = (
            text.tokens[after[0].i].low if after is not None and isinstance(after[0], Word) else ""
        )
        short = word in {"before", "short", "from", "away", "off", "of", "in", "ahead", "prior"}
        junction = isinstance(noun, Place) and noun.kind in JUNCTION and short
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
        behind_or_ahead(number, subject, other, self._context)
        if measure is not Measure.GAP_M:
            entity, reference = in_file(entity, reference, self._context)
        doing.when = Trigger("measure", amount_of(number).basis, amount_of(number))
        doing.when.measure, doing.when.entity, doing.when.reference = measure, entity, reference
        return True

    def driven(self, number: Measured) -> bool:
        """``after 250 m``, ``the ego has driven 600 m when the van slows``: what sets it off.

        Args:
            number: the way that somebody has gone.
        """
        start, end = self._text.bounds(number.i)
        clause = self._text.scene_at(number.i, number.j)
        who = [e for e in (clause.actors if clause is not None else []) if e.is_vehicle]
        who = who or [e for e in self._text.subject_before(number.i) if e.is_vehicle]
        opened = self._text.subordinate(number.i)
        doing = self._main(opened, number, start, end) if opened is not None else None
        acts = [a for a in self._happenings.acts if a.i > number.i or start <= a.i]
        free = [a for a in acts if a.when is None and a.i > number.i]
        own = [a for a in free if a.entity in who]
        told = [a for a in acts if start <= a.i < number.i]
        chosen = (
            [doing] if doing is not None else [*[a for a in free if a.i < end], *told[-1:], *own]
        )
        if not chosen or chosen[0].when is not None:
            return False
        moved = who[0] if who and who[0] is not chosen[0].entity else None
        amount = amount_of(number)
        chosen[0].when = Trigger("driven", amount.basis, amount, entity=moved)
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
