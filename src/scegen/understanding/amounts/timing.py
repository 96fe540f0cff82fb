"""When acts happen: after one another, so much later, as soon as another begins."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import AtLight
from scegen.understanding.amounts.teller import Teller
from scegen.understanding.chunks import Word
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured, words
from scegen.understanding.happenings import Doing, Trigger, amount_of, exactly
from scegen.understanding.words.quantities import ends_a_quantity, quantity_at

_ANY = frozenset(ActKind)
_COMING = frozenset({"enter", "move", "pass", "cross", "turn", "approach", "appear", "merge"})
_GREEN_REACH = 9
_REACTION_REACH = 4


class Clock(Teller):
    """Says what sets acts off."""

    def delay(self, number: Measured) -> bool:
        """``after 3 s``, ``2 s later``, ``1 s after the van has cut in``.

        Args:
            number: the time.
        """
        if self._since(number) == "before":
            return self._earlier(number)
        if self._since(number) == "after" and (waiting := self._at_green(number)) is not None:
            waiting.green_delay = waiting.green_delay or exactly(number)
            return True
        doing = self.likewise(number, _ANY) or self._delayed(number) or self._comes_in(number)
        if doing is None or doing.when is not None:
            return False
        basis = amount_of(number).basis
        base, since = self._base(number, doing)
        if base is None and self._after_another(number):
            return False
        doing.when = Trigger("after" if base else "start", basis, amount_of(number), base, since)
        return True

    def _at_green(self, number: Measured) -> Entity | None:
        """``sets off 0.8 s after the light has turned green``: who waits for that."""
        _, end = self._text.bounds(number.i)
        ends = [k for k in range(number.j, end) if self._text.tokens[k].low in {",", "and"}]
        said = self._text.low(number.j, min([*ends[:1], number.j + _GREEN_REACH, end]))
        if " green " not in said:
            return None
        doing = self._delayed(number)
        who = [doing.entity] if doing is not None else self._text.subject_before(number.i)
        waits = [e for e in self._context.draft.entities if e.light and e.light[0] is AtLight.WAITS]
        named = [e for e in waits if e in who]
        return next(iter(named or ([] if who else waits)), None)

    def _since_green(self, doing: Doing) -> None:
        """``the light turns green. The car ahead sets off 3 s later``: since the green."""
        light, when = doing.entity.light, doing.when
        waits = light is not None and light[0] is AtLight.WAITS
        if not waits or when is None or when.kind != "start" or doing.kind is not ActKind.SET_OFF:
            return
        if " green " in self._text.low(0, when.basis.i or 0):
            doing.entity.green_delay = doing.entity.green_delay or when.amount
            doing.when = None

    def _earlier(self, number: Measured) -> bool:
        """``the van enters 1.5 s before the ego gets there``: the other's act comes later."""
        start, end = self._text.bounds(number.i)
        told = [a for a in self._happenings.acts if start <= a.i < number.i]
        first = told[-1] if told else self._comes_in(number)
        if first is None:
            return False
        later = [a for a in self._happenings.acts if number.j <= a.i < end]
        named = [m for m in self._text.mentions if number.j <= m.i < end and m.entities]
        who = [m.entities[0] for m in named if m.entities[0] is not first.entity]
        if not later and (not who or first.kind is not ActKind.ENTER):
            return False
        second = later[0] if later else self.same(first, who[0], number.j, first.basis)
        amount = amount_of(number)
        second.when = Trigger("after", amount.basis, amount, first, "begin")
        return True

    def _comes_in(self, number: Measured) -> Doing | None:
        """``a van from the right 2 s after the ego``: it comes into the junction."""
        met = self._context.junction.crossing or self._context.draft.crossing_implied is not None
        _, end = self._text.bounds(number.i)
        told = [c for c in self._text.within(number.i, end) if c.event.name in _COMING]
        who = [e for c in told for e in c.drivers] or self._text.part(number.i)[1]
        if not met or not who or not who[0].is_vehicle:
            return None
        return self.add(Doing(ActKind.ENTER, who[0], amount_of(number).basis, number.i))

    def _of_the_other(self, number: Measured, doing: Doing) -> Doing | None:
        """``1 s after the van``, and no verb: after it has done the same."""
        named = [m for m in self._text.mentions if m.i == number.j + 1 and m.entities]
        ends = bool(named) and self._text.tokens[named[0].j : named[0].j + 1]
        goes_on = bool(named) and any(m.i == named[0].j for m in self._text.mentions)
        if (
            not ((ends and ends[0].kind == "punct") or goes_on)
            or named[0].entities[0] is doing.entity
        ):
            return None
        other = named[0].entities[0]
        alike = [a for a in self._happenings.acts if a.entity is other and a.kind is doing.kind]
        told = named[0]
        return alike[0] if alike else self.same(doing, other, told.i, Basis(told.i, told.j))

    def _after_another(self, number: Measured) -> bool:
        """``2 s after the car has passed the sign``: since something that is no act."""
        _, end = self._text.bounds(number.i)
        told = bool(self._text.within(number.j, end))
        return self._since(number) == "after" and told

    def _endless(self, doing: Doing) -> bool:
        """``1 s after the lead car brakes``: nothing says when it has done so."""
        over = [c for c in self._text.scenes if c.event.i == doing.i and c.event.perfect]
        amounts = {"target_speed_mps", "duration_s", "distance_m"} & set(doing.amounts)
        told = [c for c in self._text.scenes if c.event.i in {doing.i, *doing.told}]
        steps = doing.kind is ActKind.CROSS and all(c.event.lemma != "cross" for c in told)
        lasting = doing.kind in {ActKind.BRAKE, ActKind.ACCELERATE} and not (over or amounts)
        return lasting or steps  # "has stepped off the kerb": that is where the crossing begins

    def _since(self, number: Measured) -> str:
        """The word after a time: "after" only where it opens a clause."""
        after = self._text.low(number.j, number.j + 4)
        if after.startswith(" after ") and self._text.says("starts", number.j, number.j + 4):
            return "start"
        return after.split()[0] if after.split() else ""

    def _delayed(self, number: Measured) -> Doing | None:
        """The act that is delayed: the one before the time in its clause, else the next."""
        start, end = self._text.bounds(number.i)
        here = self._told_in(start, end)
        opening = max(
            [
                start,
                *(k + 1 for k in range(start, number.i) if self._text.tokens[k].low == ","),
                *(
                    k + 1
                    for k in range(max(start, number.i - 2), number.i)
                    if self._text.tokens[k].low in {"and", "then"}
                ),
            ]
        )
        before = [a for i, a in here if opening <= i < number.i]
        after = [(i, a) for i, a in here if i > number.i]
        if self._since(number) == "after" and len(after) > 1 and not before:
            return after[1][1]
        joined = {t.low for t in self._text.tokens[number.i - 2 : number.i]} & {"and", "then"}
        earlier = [a for i, a in here if i < number.i and not joined]
        if self._since(number) == "after" and len(after) == 1 and earlier and not before:
            return earlier[-1]  # "brakes with 4 m/s², 0.5 s after the van has braked"
        if before:
            return before[-1]
        comma = next((k for k in range(number.j, end) if self._text.tokens[k].low == ","), -1)
        first = [a for i, a in after if i > comma] or [a for _, a in after]
        return first[0] if first else None

    def _clause_end(self, opens: Word, start: int, stop: int) -> int:
        """At the comma, or where the sentence goes on without one: "once it stands the ego …"."""
        comma = next((k for k in range(opens.j, stop) if self._text.tokens[k].low == ","), None)
        if comma is not None or opens.i > start:
            return stop if comma is None else comma
        told = [i for i, _ in self._told_in(opens.j, stop)]
        return told[1] if len(told) > 1 else stop

    def _told_in(self, start: int, end: int) -> list[tuple[int, Doing]]:
        """The acts that are told of in a part of the text, with where, also for another time."""
        acts = self._happenings.acts
        found = [(i, a) for a in acts for i in {a.i, *a.told} if start <= i < end]
        return sorted(found, key=lambda f: f[0])

    def _base(self, number: Measured, doing: Doing) -> tuple[Doing | None, str]:
        """Since when a delay counts."""
        tokens = self._text.tokens
        _, end = self._text.bounds(number.i)
        since = self._since(number)
        if since == "after":
            clause = [a for _, a in self._told_in(number.j, end) if a is not doing]
            if clause:
                begins = self._text.low(number.j, clause[0].i)
                begun = any(f" {w} " in begins for w in words()["begun"])
                begun = begun or self._endless(clause[0])
                return clause[0], "begin" if begun else "end"
            other = self._of_the_other(number, doing)
            return other, "begin" if other is not None else "end"
        before = [a for a in self._happenings.acts if a.i < doing.i]
        if doing.kind is ActKind.ENTER and since not in {"into", "past", "from"}:
            came = [c for c in self._text.within(0, doing.i) if c.event.name in _COMING]
            others = [e for c in came for e in c.drivers if e is not doing.entity]
            if others and not before:
                return self.same(doing, others[-1], came[-1].event.i, doing.basis), "begin"
        if not before:
            return None, "end"
        nearby = {t.low for t in tokens[number.j : number.j + 2]}
        own = before[-1].entity is doing.entity
        over = {"target_speed_mps", "duration_s", "distance_m"} & set(before[-1].amounts)
        ends = own and bool(over)
        ends = ends or before[-1].kind not in {ActKind.BRAKE, ActKind.ACCELERATE}
        since = "end" if ends else "begin"  # of braking without an end, or that another answers
        if own or nearby & {*words()["later"]}:
            return before[-1], since
        return before[-1], "begin"  # "the ego reacts after 1 s"

    def order(self) -> None:
        """Acts without a number: "then", "as soon as", and what one does in turn."""
        acts = self._happenings.acts
        self._clauses()
        for doing in acts:
            self._since_green(doing)
        for doing in acts:  # "both brake when they are 80 m apart"
            alike = [a for a in acts if a.i == doing.i and a.kind is doing.kind and a.when]
            doing.when = doing.when or (alike[0].when if alike else None)
        acts = sorted(acts, key=self._moment)
        for n, (doing, before) in enumerate(zip(acts[1:], acts, strict=False), start=1):
            if doing.when is not None or doing.i == before.i:
                continue
            if before.when is not None and before.when.act is doing:
                continue
            phrase = self._then(before, doing)
            basis = Basis(*phrase) if phrase is not None else doing.basis
            mine = [a for a in acts[:n] if a.entity is doing.entity and a.i != doing.i]
            told = before.always or bool(before.amounts) or doing.always
            if phrase is not None and (told or before.entity is not doing.entity):
                doing.when = Trigger("after", basis, act=before)
            elif doing.forced and before.always and before.entity is not doing.entity:
                basis = Basis(basis.i, basis.j, "what one has to do answers what the other does")
                doing.when = Trigger("after", basis, act=before, since="begin")
            elif mine and mine[-1].always and doing.always:
                reason = "what one does in turn happens in the order of the text"
                doing.when = Trigger("after", Basis(basis.i, basis.j, reason), act=mine[-1])

    def _moment(self, doing: Doing) -> int:
        """``before it brakes, it swerves``: the first clause comes last."""
        start, stop = self._text.bounds(doing.i)
        opens = next((c for c in self._text.chunks if c.i == start), None)
        if not isinstance(opens, Word) or self._text.tokens[start].low != "before":
            return doing.i
        return stop if doing.i < self._clause_end(opens, start, stop) else doing.i

    def _then(self, before: Doing, doing: Doing) -> tuple[int, int] | None:
        start = max(before.basis.j or before.i, self._text.bounds(doing.i)[0])
        span = self._text.find("then", start, doing.i)
        forwards = span is not None and self._text.tokens[span[0]].low != "before"
        return span if forwards else None

    def _clauses(self) -> None:
        """``as soon as the lead brakes, the ego changes lanes``."""
        acts = self._happenings.acts
        for chunk in self._text.chunks:
            if not isinstance(chunk, Word) or chunk.cat != "sub":
                continue
            opening = self._text.low(chunk.i, chunk.j).strip()
            because = opening in {"because", "since"}
            if (not because and opening not in words()["triggers"]) or opening in {"if", "until"}:
                continue
            start, stop = self._text.bounds(chunk.i)
            if chunk.j >= stop or quantity_at(self._text.tokens, chunk.j) is not None:
                continue  # "after 2 s"
            end = self._clause_end(chunk, start, stop)
            inside = [a for a in acts if any(chunk.j <= i < end for i in (a.i, *a.told))]
            outside = [a for a in acts if start <= a.i < stop and a not in inside]
            opens = chunk.i - (2 if ends_a_quantity(self._text.tokens, chunk.i) else 0)
            joined = self._text.low(max(start, opens - 2), opens).replace(",", " ").split()
            put_between = joined[-1:] in (["and"], ["but"])  # "brakes and, once it stands, turns"
            front = [a for a in outside if a.i < chunk.i and not put_between]
            main = front[-1:] or [a for a in outside if a.i >= end][:1]
            if not inside or not main or main[0].when is not None:
                continue
            if opening == "when" and not main[0].always:
                continue  # "passes a bus when a child runs out": what goes on meanwhile
            begun = because or opening in words()["while_begun"]
            over = [c for c in self._text.within(chunk.j, end) if c.event.perfect]
            over += [r for r in inside[0].entity.rests if r.i in inside[0].told]  # type: ignore[misc]
            steps = inside[0].kind is ActKind.CROSS and self._endless(inside[0])
            since = "begin" if steps or (begun and not over) else "end"  # "when it has stopped"
            main[0].when = Trigger("after", Basis(chunk.i, chunk.j), act=inside[0], since=since)
