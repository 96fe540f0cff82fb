"""How it ends: who touches whom, nearly or not at all, and where on the ego."""

from __future__ import annotations

from scegen.scenario.model import Interval
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.spacings import CONTACT, Measure
from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.amounts.struck import Struck
from scegen.understanding.amounts.teller import Teller
from scegen.understanding.amounts.whom import counterpart, ego_of
from scegen.understanding.chunks import Event, Mention, Place
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured, words
from scegen.understanding.frames.windows import frame_of, window
from scegen.understanding.happenings import Amount, Apart, Ending, amount_of
from scegen.understanding.semantics.contact import goal_of_contact, touched
from scegen.understanding.semantics.context import Clause
from scegen.understanding.words.quantities import ends_a_quantity

_BEFORE = 4
_WHOLE, _HALF = 100.0, 50.0
_NOBODY = frozenset({"neither", "nobody"})


class Judge(Teller):
    """Reads the outcome."""

    def read(self) -> None:
        """The outcome, as verbs and nouns tell it."""
        endings = [e for s in self._text.scenes if (e := self._of_verb(s)) is not None]
        endings += [*self._of_nouns(), *self._of_phrases()]
        for kind in (OutcomeKind.COLLISION, OutcomeKind.NEAR_MISS, OutcomeKind.AVOIDED):
            told = [e for e in endings if e.kind is kind]
            if told:
                self._happenings.ending = told[0]
                break
        ending = self._happenings.ending
        if ending is not None and ending.kind is not OutcomeKind.AVOIDED:
            Struck(self._text, self._context, self._happenings).read(ending)
        self._overlaps()

    def _of_verb(self, scene: Clause) -> Ending | None:
        event = scene.event
        if event.premod_of is not None or not self._meets(scene):
            return None
        start = max(self._text.bounds(event.i)[0], event.i - _BEFORE)
        nearly = self._text.find("nearly", start, event.i)
        parent = event.parent
        vain = parent is not None and _in_vain(parent)
        basis = Basis(parent.i if vain and parent is not None else event.i, event.j)
        held_off = parent is not None and parent.name in {"avoid", "prevent", "fail"} and not vain
        if nearly is not None:
            kind, basis = OutcomeKind.NEAR_MISS, Basis(nearly[0], event.j)
        elif event.negated or held_off or self._before_it(event) or self._of_nobody(event):
            kind = OutcomeKind.AVOIDED
        elif event.modal or (self._supposed(start, event.i) and not vain):
            return None
        else:
            kind = OutcomeKind.COLLISION
        return Ending(kind, basis, self._between(scene))

    def _bare(self, event: Event) -> bool:
        """``neither gives way, crash.``: a noun by itself, although it looks like a verb."""
        alone = event.i > 0 and self._text.tokens[event.i - 1].kind == "punct"
        return alone and event.form == "base" and event.lemma in words()["impacts"]

    def _meets(self, scene: Clause) -> bool:
        """Verbs of contact; "meets head-on"; "just misses"; "slides into it"."""
        event = scene.event
        lemma = event.lemma
        if event.name == "overlook" and lemma == "miss":
            start = max(0, event.i - _BEFORE)
            return self._text.find("nearly", start, event.i) is not None
        part = isinstance(event.object, Place) and event.object.kind in {"side", "middle", "front"}
        meets = lemma == "meet" and (event.how("head_on") is not None or part)
        into = goal_of_contact(scene, self._context) is not None
        return event.name == "collide" or meets or into

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

    def _of_phrases(self) -> list[Ending]:
        found = []
        for name in ("near_miss", "avoided", "collision"):
            span = self._text.find(name, 0, len(self._text.tokens))
            if span is not None:
                found.append(Ending(OutcomeKind(name), Basis(*span), self._around(span[0], None)))
        return found

    def _of_nouns(self) -> list[Ending]:
        """``no crash``, ``until impact``, ``a collision is avoided``: by the words around.

        What is denied of something else denies no contact: "neither brakes; collision".
        """
        tokens = self._text.tokens
        found = []
        for k in (k for k, t in enumerate(tokens) if t.low in words()["impacts"]):
            begin = k
            while begin and tokens[begin - 1].low in words()["before_impacts"]:
                begin -= 1
            done = [s.event for s in self._text.scenes if s.event.i <= k < s.event.j]
            if any(not (e.nominal or self._bare(e)) for e in done):
                continue
            prevented = self._prevented(begin - _BEFORE, k)
            verbs = {"in_vain" if _in_vain(e) else e.name for e in prevented}
            verbs |= {t.low for t in tokens[begin:k]}
            around = window(tokens, begin, k + 1, {})
            role = frame_of("contact", 0.0, around, frozenset(verbs)).role
            if role != "other":
                i = begin - (begin > 0 and tokens[begin - 1].low in words()["none"])
                i = min([i, *(e.i for e in prevented if e.i < begin)])  # "cannot avoid it"
                found.append(Ending(OutcomeKind(role), Basis(i, k + 1), self._around(k, None)))
        return found

    def _prevented(self, start: int, k: int) -> list[Event]:
        """What keeps a contact from happening, or does not, around its noun."""
        first, end = self._text.bounds(k)
        around = self._text.within(max(start, first), min(end, k + _BEFORE))
        return [s.event for s in around if s.event.name in {"avoid", "prevent"}]

    def _between(self, scene: Clause) -> list[Entity]:
        """Who touches whom: by the verb, by whose part is named, by who is named around."""
        into = goal_of_contact(scene, self._context)
        who = [*scene.actors, *(scene.targets or touched(into))]
        alike = len({e.kind for e in scene.targets}) == 1 and len(scene.targets) > 1
        if alike and any(e.ego for e in scene.actors):
            return []  # "drives into the tail of a queue": whichever of them is the last
        if len(who) == 1:  # "is hit by the front of the ego"
            by = [p.target for p in scene.event.pps if p.value == "by"]
            owners = [m.owner for m in by if isinstance(m, Place) and m.owner is not None]
            who += [e for owner in owners for e in owner.entities[:1] if e not in who][:1]
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
            near.sort(key=lambda e: not e.parked)  # who stands beside the road last of all
            other = counterpart(chosen[0], self._context, near)
            chosen += [other] if other is not None else []
        return chosen if len(chosen) == 2 else []

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
        left = self._text.find("left_edge", number.j, end)
        right = self._text.find("right_edge", number.j, end)
        value, basis = number.quantity.exact, amount_of(number).basis
        edge = left or right
        if edge is not None:
            basis = Basis(basis.i, edge[1], basis.reason)
        if edge is None:
            other = next((e for e in ending.between if e is not ego), None)
            mirrored = other is not None and self._from_the_right(other)
            if value.low != _HALF:
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
        span = self._text.find("full_overlap", 0, len(self._text.tokens))
        other = next((e for e in ending.between if not e.ego), None) if ending is not None else None
        if span is not None and other is not None:
            amount = Amount(Interval(low=_WHOLE, high=_WHOLE), Basis(*span))
            apart = Apart(Measure.OVERLAP_PERCENT, other, ego, amount, CONTACT)
            self._happenings.spacings.append(apart)


def _in_vain(event: Event) -> bool:
    """``cannot avoid hitting him``: it happens all the same."""
    return event.name in {"avoid", "prevent"} and event.negated
