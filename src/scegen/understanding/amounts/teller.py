"""What those who read amounts have in common."""

from __future__ import annotations

from collections.abc import Collection

from scegen.scenario.acts import ActKind
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.chunks import Event
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured
from scegen.understanding.frames import acts as frames
from scegen.understanding.happenings import Doing, Happenings, amount_of
from scegen.understanding.semantics.context import Context


class Teller:
    """Reads a part of what a text tells of.

    Args:
        text: the text with its clauses.
        context: the scenario in the making.
        happenings: what the text tells of; what is read is added.
    """

    def __init__(self, text: Sentences, context: Context, happenings: Happenings) -> None:
        self._text = text
        self._context = context
        self._happenings = happenings

    def add(self, doing: Doing) -> Doing:
        """One more act, at its place in the order of the text."""
        self._happenings.acts.append(doing)
        self._happenings.acts.sort(key=lambda a: a.i)
        return doing

    def same(self, model: Doing, entity: Entity, i: int, basis: Basis) -> Doing:
        """What somebody else does, done by this one too."""
        return self.add(Doing(model.kind, entity, basis, i, always=model.always))

    def likewise(self, number: Measured, kinds: Collection[ActKind]) -> Doing | None:
        """``the car brakes with 4 m/s², the van with 3``: it does the same, without a verb.

        Args:
            number: the number that is said of it.
            kinds: what it may be that both do.
        """
        part = self._text.elided(number.i)
        if part is None:
            return None
        start, _ = self._text.bounds(number.i)
        told = [a for a in self._happenings.acts if start <= a.i < part[0] and a.kind in kinds]
        if not told or told[-1].entity in part[1]:
            return None
        basis = amount_of(number).basis
        made = [self.same(told[-1], entity, number.i, basis) for entity in part[1]]
        return made[0]

    def named_by(self, event: Event, acts: list[Doing]) -> list[Doing]:
        """``the lane change takes 5 s``: of the act that a noun names.

        Args:
            event: a verb that depends on the noun.
            acts: those that it may be.
        """
        noun = event.parent
        kind = frames().get(noun.name) if noun is not None and noun.nominal else None
        return [a for a in acts if a.kind is kind]
