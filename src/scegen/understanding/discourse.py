"""Decides whom a mention refers to: somebody new, or somebody already known."""

from __future__ import annotations

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Mention
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.groups import Group, vehicle_around
from scegen.understanding.mention_words import DEFAULT_COUNT, KINDS, Reading, read_mention
from scegen.understanding.tokens import Token

_MOTOR = frozenset(ParticipantKind) - {ParticipantKind.PEDESTRIAN}
_POSITIONS = {"first": 0, "second": 1, "third": 2, "fourth": 3, "fifth": 4, "former": 0, "latter": -1}
"""Place within those spoken of last; "the former" and "the latter" are of two."""


class Discourse:
    """The participants of a text in the order in which they come up.

    Args:
        draft: where participants are kept.
        tokens: the tokens of the text.
        arms: arms of the junction, for "from all directions".
    """

    def __init__(self, draft: Draft, tokens: list[Token], arms: int) -> None:
        self._draft = draft
        self._tokens = tokens
        self._arms = arms
        self._groups: list[Group] = []
        self._recent: list[Entity] = []
        self._subject: list[Entity] = []

    def resolve(
        self,
        mention: Mention,
        *,
        subject: bool,
        exclude: list[Entity],
        all_directions: bool = False,
    ) -> list[Entity]:
        """The participants that a mention refers to.

        Args:
            mention: the mention; its ``entities`` are set.
            subject: it is the subject of its clause.
            exclude: participants that it cannot mean (the subject, for an object).
            all_directions: its members come one from each arm.
        """
        if mention.entities:
            return mention.entities
        if mention.same_as is not None:
            mention.entities = list(mention.same_as.entities)
            self._refine(mention)
            return mention.entities
        surrounded = mention.prep is not None and mention.prep.value in {"in", "of", "for"}
        if surrounded and len(mention.mods) == 0 and mention.head and mention.head.data.get("mass"):
            return []
        if mention.negated or mention.pronoun == "reflexive":
            return []
        if mention.pronoun == "ordinal" and mention.prep and mention.prep.value == "in":
            return []  # "at the first crossing …, at the second": a place
        if mention.pronoun is not None:
            found = self._pronoun(mention, exclude)
        else:
            found = self._noun(
                read_mention(mention, self._tokens, self._arms if all_directions else None),
                mention,
                exclude,
            )
        mention.entities = list(found)
        for entity in found:
            if entity in self._recent:
                self._recent.remove(entity)
            self._recent.append(entity)
        if subject and found:
            self._subject = found
        return found

    def _refine(self, mention: Mention) -> None:
        """``vehicle 1, a pickup truck, …``: the apposition says what kind it is."""
        if not mention.heads:
            return
        reading = read_mention(mention, self._tokens, None)
        for entity in mention.entities:
            if not reading.generic and reading.kind in _MOTOR:
                entity.kind, entity.basis = reading.kind, Basis(mention.i, mention.j)
            entity.labels |= reading.labels

    def _pronoun(self, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        which = mention.pronoun
        if which in {"it", "him"}:
            options = self._subject if len(self._subject) == 1 else self._recent[-1:]
            left = [e for e in reversed(self._recent) if e not in exclude]
            return [e for e in options if e not in exclude] or left[:1]
        if which in {"they", "both", "all", "neither"}:
            return self._together()
        count = 1
        if which == "count":
            count = int(mention.mods[0].data["number"])
        basis = Basis(mention.i, mention.j)
        if which == "other":
            rest = self._claim(1, exclude) or self._rest(exclude)
            return rest or [self._new(ParticipantKind.CAR, basis)]
        if which == "ordinal":
            position = _POSITIONS[mention.label or "first"]
            group = self._groups[-1].members if self._groups else self._draft.entities
            if position < 0 or mention.label == "former":
                group = (group if len(group) > 1 else self._draft.entities)[-2:]
                position %= max(len(group), 1)
            if position < len(group):
                group[position].claimed = True
                return [group[position]]
        claimed = self._claim(count, exclude)
        if claimed or which == "count":
            return claimed
        return [self._new(ParticipantKind.CAR, basis)] if which != "one" or self._recent else []

    def _together(self) -> list[Entity]:
        if self._groups and len(self._groups[-1].members) > 1:
            return list(self._groups[-1].members)
        return list(self._draft.entities[-2:])

    def _rest(self, exclude: list[Entity]) -> list[Entity]:
        """The one vehicle besides those just spoken of, if only one is left."""
        out = {e.index for e in (*exclude, *self._subject)}
        rest = [e for e in self._draft.entities if e.index not in out and e.is_vehicle]
        return rest if len(rest) == 1 else []

    def _claim(
        self, count: int, exclude: list[Entity], reading: Reading | None = None
    ) -> list[Entity]:
        """Members of an earlier group that nobody has picked out yet."""
        for group in reversed(self._groups):
            free = [e for e in group.free if e not in exclude and self._fits(e, reading)]
            if len(free) >= count:
                for entity in free[:count]:
                    entity.claimed = True
                return free[:count]
        return []

    def _fits(self, entity: Entity, reading: Reading | None) -> bool:
        if reading is None:
            return True
        generic = reading.generic or reading.driver
        same = entity.kind is reading.kind or (generic and entity.kind in _MOTOR)
        return same and entity.parked == reading.parked

    def _new(self, kind: ParticipantKind, basis: Basis) -> Entity:
        return self._draft.add(kind, basis)

    def _noun(self, reading: Reading, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        basis = Basis(mention.i, mention.j)
        if reading.ego:
            return [self._ego(reading, basis)]
        of_whom = next((p.target for p in mention.pps if p.value == "of"), None)
        if reading.driver and isinstance(of_whom, Mention):
            return self.resolve(of_whom, subject=False, exclude=[])
        inside = vehicle_around(reading, mention)
        if inside is not None:
            return self.resolve(inside, subject=False, exclude=[])
        known = self._known(reading, mention, exclude)
        if known:
            self._enrich(known, reading)
            return known
        return self._introduce(reading, basis)

    def _ego(self, reading: Reading, basis: Basis) -> Entity:
        for entity in self._draft.entities:
            if entity.ego:
                return entity
        entity = self._new(reading.kind, basis)
        entity.ego = True
        entity.named_by.add("ego")
        entity.claimed = True
        return entity

    def _known(self, reading: Reading, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        det = reading.det
        names = {label for label in reading.labels if label.startswith("#")}
        if names:
            return [e for e in self._draft.entities if names & e.labels][:1]
        if reading.plural:
            return self._known_plural(reading)
        if det == "other":
            claimed = self._claim(1, exclude, reading)
            rest = [e for e in self._rest(exclude) if self._compatible(e, reading)]
            return claimed or rest
        if det in {"another", "ordinal"}:
            return self._another(reading, exclude)
        if det in {"one", "indef"}:
            return self._member(reading, mention, exclude)
        return self._definite(reading, mention, exclude)

    def _known_plural(self, reading: Reading) -> list[Entity]:
        if reading.det != "def" and reading.count != DEFAULT_COUNT:
            return []
        both = not reading.vague and reading.det in {"bare", "def"}
        if reading.det != "def" and not (both and not reading.dirs):
            return []
        for group in reversed(self._groups):
            if all(self._compatible(e, reading) for e in group.members):
                return list(group.members)
        fitting = [e for e in self._draft.entities if self._compatible(e, reading)]
        return fitting if len(fitting) > 1 else []

    def _another(self, reading: Reading, exclude: list[Entity]) -> list[Entity]:
        """A further one: of a group that is being picked apart, else somebody new."""
        for group in reversed(self._groups):
            started = len(group.free) < len(group.members)
            if (started or group.vague) and self._agree(group, reading):
                return self._claim(1, exclude, reading)
        return []

    def _member(self, reading: Reading, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        """``including one vehicle``, and any single one where only "traffic" was named."""
        within = mention.prep is not None and mention.prep.value == "with"
        for group in reversed(self._groups):
            if not (within or group.vague or reading.det == "one"):
                continue
            if not self._agree(group, reading):
                continue
            claimed = self._claim(1, exclude, reading)
            if claimed:
                return claimed
            free = [e for e in group.free if e not in exclude and e.kind is ParticipantKind.CAR]
            if free and group.vague and reading.dirs and group.dirs == reading.dirs:
                free[0].kind = reading.kind
                free[0].basis = Basis(mention.i, mention.j)
                free[0].claimed = True
                return free[:1]
        return []

    def _agree(self, group: Group, reading: Reading) -> bool:
        return not reading.dirs or not group.dirs or reading.dirs == group.dirs

    def _definite(self, reading: Reading, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        options = [
            e for e in reversed(self._recent) if e not in exclude and self._compatible(e, reading)
        ]
        if reading.dirs:
            options = [e for e in options if e.dirs == reading.dirs]
        others = [e for e in options if not e.ego]
        restricted = reading.dirs or reading.labels or mention.pps
        if others or reading.det == "bare" or restricted:
            return others[:1]
        return options[:1]

    def _compatible(self, entity: Entity, reading: Reading) -> bool:
        """Whether the words of a mention can stand for a known participant."""
        if reading.driver or reading.generic:
            kind = entity.kind in _MOTOR
        else:
            kind = entity.kind is reading.kind
        adversary = reading.labels == {"adversary"} and not reading.plural
        if adversary:
            if entity.ego or (reading.generic is False and not kind):
                return False
            return "adversary" in entity.labels
        if reading.labels and not reading.labels <= entity.labels:
            return False
        return kind and (entity.parked or not reading.parked)

    def _enrich(self, known: list[Entity], reading: Reading) -> None:
        for entity in known:
            entity.labels |= reading.labels
            if reading.dirs and not entity.dirs:
                entity.dirs |= reading.dirs

    def _introduce(self, reading: Reading, basis: Basis) -> list[Entity]:
        found = []
        for _ in range(reading.count):
            entity = self._new(reading.kind, basis)
            entity.labels |= reading.labels
            entity.dirs |= reading.dirs
            entity.parked = reading.parked
            entity.parked_basis = basis if reading.parked else None
            if reading.reason:
                entity.counted = Basis(basis.i, basis.j, reading.reason)
            entity.claimed = reading.count == 1
            found.append(entity)
        if len(found) > 1:
            self._groups.append(Group(found, reading.vague, set(reading.dirs)))
        return found
