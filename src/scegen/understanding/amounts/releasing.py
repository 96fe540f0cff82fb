"""What sets acts off by how far or how near somebody is."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.amounts.items import item_of, kind_of, number_them
from scegen.understanding.amounts.teller import Teller
from scegen.understanding.amounts.whom import behind_or_ahead, counterpart, in_file
from scegen.understanding.chunks import Mention, NounPhrase, Place, Thing
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured, words
from scegen.understanding.happenings import Doing, Trigger, amount_of

JUNCTION = frozenset({"junction", "signal", "stop_line", "stop_sign", "yield_sign"})
_LINES = JUNCTION | {"crosswalk"}
_SOON = 14
_ASIDE = frozenset({"side", "flank", "direction", "lane", "front"})


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
        noun, word = self._what_follows(number)
        nears = clause is not None and clause[2] == "as" and self._nears(number)
        opened = opened or (nears and not isinstance(noun, Place))
        short = word in words()["short"]
        line = self._line(noun, word)
        junction = line is not None and (line.kind in JUNCTION or self._context.junction.crossing)
        thing = self._thing(noun, number.i) if short and measure is Measure.GAP_M else None
        if thing is not None:
            return self._before_a_thing(number, thing, clause if opened else None)
        before = word == "before" and isinstance(noun, Mention)
        if not (opened or line is not None or before):
            return False
        doing = self._main(clause if opened else None, number, start, end)
        if doing is None and opened:
            doing = self._starts_crossing(start, number.i)
        if doing is None or (before and not opened and doing.ends_at_rest):
            return False
        if doing.when is not None:
            return False
        subject = self._subject(number, clause if opened else None, doing)
        if opened and clause is not None and self._acts_inside(clause, number, subject):
            return False  # "when the truck moves over 30 m in front of it"
        if junction:
            amount = amount_of(number)
            subject = subject if opened else self._text.said_of(number.i) or subject
            moved = subject if subject is not doing.entity else None
            if moved is not None and self._waits(number, moved):
                return False
            doing.when = Trigger("junction", amount.basis, amount, entity=moved)
            return True
        return self._comes_down(number, measure, doing, subject, line)

    def _comes_down(
        self, number: Measured, measure: Measure, doing: Doing, subject: Entity, line: Place | None
    ) -> bool:
        """Between whom a measure comes down to a value that sets something off."""
        text = self._text
        noun, _ = self._what_follows(number)
        own = noun is not None and any(m.cat == "possessive" for m in noun.mods)
        named = [e for e in (text.named(noun) if not own else []) if e is not subject]
        if line is not None:
            named = [e for e in self._on_it() if e is not subject]
            if len(named) != 1:
                return False  # from there, and from nobody
        other = named[0] if named else doing.entity if subject is not doing.entity else None
        near = [e for m in text.mentions if m.i < number.i for e in m.entities if e is not subject]
        other = other or doing.into or counterpart(subject, self._context, near)
        nowhere = line is None and self.from_elsewhere(number)
        if other is None or other is subject or nowhere:
            return False
        entity, reference = subject, other
        behind_or_ahead(number, subject, other, self._context)
        if measure is not Measure.GAP_M:
            entity, reference = in_file(entity, reference, self._context)
        doing.when = Trigger("measure", amount_of(number).basis, amount_of(number))
        doing.when.measure, doing.when.entity, doing.when.reference = measure, entity, reference
        return True

    def _line(self, noun: NounPhrase | None, word: str) -> Place | None:
        """The line across the road from which a distance counts: ``50 m before the junction``."""
        if isinstance(noun, Place):
            return noun if noun.kind in _LINES and word in {*words()["short"], "to"} else None
        return None

    def _on_it(self) -> list[Entity]:
        """Who crosses where a crosswalk is: how far that is off is how far they are."""
        return [e for e in self._context.draft.entities if Maneuver.CROSS in e.maneuvers]

    def from_elsewhere(self, number: Measured) -> bool:
        """``40 m from the line``, ``40 m before the bridge``: from nobody who takes part."""
        after = self._text.phrase_after(number.j)
        if after is None or number.quantity.dimension != "length":
            return False
        word, noun = after
        if self._text.tokens[word.i].low not in {"from", "before"}:
            return False
        return isinstance(noun, Place) and noun.kind not in _ASIDE and noun.owner is None

    def _waits(self, number: Measured, entity: Entity) -> bool:
        """``where a van waits 5 m before the line``: so far it stays, which sets nothing off."""
        scene = self._text.scene_at(number.i, number.j)
        rests = scene is not None and scene.event.name in {"wait", "stop", "park"}
        return entity.still or (rests and scene is not None and entity in scene.actors)

    def _nears(self, number: Measured) -> bool:
        """``as the ego comes within 30 m``: so near is a moment; "as it follows" lasts."""
        event = self._text.verb_at(number.i, number.j)
        return event is not None and event.lemma in words()["nearing"]

    def _what_follows(self, number: Measured) -> tuple[NounPhrase | None, str]:
        """The noun of the phrase of place after a number, and the word that opens it."""
        after = self._text.phrase_after(number.j)
        if after is None:
            return None, ""
        return after[1], self._text.tokens[after[0].i].low

    def _thing(self, noun: NounPhrase | None, i: int) -> Thing | None:
        """The thing that a phrase of place names, or that "it" stands for."""
        if isinstance(noun, Thing):
            return noun if noun.head is not None and "thing" in noun.head.data else None
        if not isinstance(noun, Mention) or noun.pronoun is None:
            return None
        before = [c for c in self._text.chunks if c.i < i and isinstance(c, Thing | Mention)]
        last = next(
            (c for c in reversed(before) if isinstance(c, Thing) or c.pronoun is None), None
        )
        named = isinstance(last, Thing) and last.head is not None and "thing" in last.head.data
        return last if named and isinstance(last, Thing) else None

    def _before_a_thing(
        self, number: Measured, thing: Thing, clause: tuple[int, int, str] | None
    ) -> bool:
        """``35 m before the crate it brakes``: the gap to what lies there sets it off."""
        doing = self._main(clause, number, *self._text.bounds(number.i))
        if doing is None:
            return False
        items = self._happenings.items
        item = next((x for x in items if x.kind.value == kind_of(thing)), None)
        if item is None:
            item = item_of(thing, self._text)
            item.blocks, item.blocked = True, None if doing.entity.ego else doing.entity
            items.append(item)
            number_them(items)
        amount = amount_of(number)
        doing.when = Trigger("measure", amount.basis, amount)
        doing.when.measure, doing.when.entity = Measure.GAP_M, doing.entity
        doing.when.reference = item
        return True

    def driven(self, number: Measured) -> bool:
        """``after 250 m``, ``the ego has driven 600 m when the van slows``: what sets it off.

        Args:
            number: the way that somebody has gone.
        """
        clause = self._text.scene_at(number.i, number.j)
        who = [e for e in (clause.actors if clause is not None else []) if e.is_vehicle]
        chosen = [a for a in self._happenings.acts if a.when is None and a.i > number.i]
        if not chosen:
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
                return self.add(Doing(ActKind.CROSS, crossers[0], basis, mention.i, always=False))
        return None

    def _acts_inside(self, clause: tuple[int, int, str], number: Measured, subject: Entity) -> bool:
        acts = self._happenings.acts
        return any(clause[0] <= a.i < number.i and a.entity is subject for a in acts)

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
