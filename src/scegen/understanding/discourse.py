"""Decides whom a mention refers to: somebody new, or somebody already known."""

from __future__ import annotations

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Mention
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.groups import Group, vehicle_around
from scegen.understanding.mention_words import DEFAULT_COUNT, Reading, read_mention
from scegen.understanding.roster import Roster
from scegen.understanding.tokens import Token

_MOTOR = frozenset(ParticipantKind) - {ParticipantKind.PEDESTRIAN}
_POSITIONS = {
    "first": 0,
    "second": 1,
    "third": 2,
    "fourth": 3,
    "fifth": 4,
    "former": 0,
    "latter": -1,
}
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
        self._roster = Roster(draft, tokens)

    def resolve(
        self,
        mention: Mention,
        *,
        subject: bool,
        exclude: list[Entity],
        all_directions: bool = False,
        settled: bool = False,
    ) -> list[Entity]:
        """The participants that a mention refers to.

        Args:
            mention: the mention; its ``entities`` are set.
            subject: it is the subject of its clause.
            exclude: participants that it cannot mean (the subject, for an object).
            all_directions: its members come one from each arm.
            settled: the text says which way all its members go.
        """
        if mention.entities:
            return mention.entities
        if mention.same_as is not None:
            mention.entities = list(mention.same_as.entities)
            self._refine(mention)
            return mention.entities
        if _refers_to_nobody(mention):
            return []
        if any(p.word.cat == "locus" and _is_pronoun(p.target) for p in mention.pps):
            exclude = [*exclude, *self._roster.subject]  # "the car behind it" is not "it"
        if mention.pronoun is not None:
            found = self._pronoun(mention, exclude)
        else:
            found = self._noun(
                read_mention(mention, self._tokens, self._arms if all_directions else None),
                mention,
                exclude,
            )
        mention.entities = list(found)
        if mention.landmark:
            self._roster.landmark = list(found)
        for entity in found:
            entity.loci |= _loci(mention)
        self._roster.spoken_of(found, subject=subject, settled=settled)
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
        whole = mention.whole
        if which == "count" and whole is not None and any(e.ego for e in whole.entities):
            return self._we(int(mention.mods[0].data["number"]), basis=Basis(mention.i, whole.j))
        if mention.landmark and which == "it" and self._roster.landmark:
            return self._roster.landmark
        if which in {"it", "him"}:
            subject, recent = self._roster.subject, self._roster.recent
            if mention.head is not None and self._tokens[mention.i].low == "it":
                recent = [e for e in recent if e.is_vehicle] or recent
            options = subject if len(subject) == 1 else recent[-1:]
            before = self._roster.before if len(self._roster.before) == 1 else []
            left = [e for e in (*before, *reversed(recent)) if e not in exclude]
            return [e for e in options if e not in exclude] or left[:1]
        if which in {"they", "both", "all", "neither"}:
            return self._roster.together()
        count = 1
        if which in {"count", "others"}:
            count = int(mention.mods[0].data["number"])
        basis = Basis(mention.i, mention.j)
        if which == "other":
            rest = self._roster.claim(1, exclude) or self._roster.rest(exclude)
            return rest or [self._roster.new(ParticipantKind.CAR, basis)]
        if which == "ordinal":
            position = _POSITIONS[mention.label or "first"]
            group = self._roster.groups[-1].members if self._roster.groups else self._draft.entities
            if position < 0 or mention.label == "former":
                group = (group if len(group) > 1 else self._draft.entities)[-2:]
                position %= max(len(group), 1)
            if position < len(group):
                group[position].claimed = True
                return [group[position]]
        if which == "another":
            return self._roster.further(exclude, basis)
        claimed = self._roster.claim(count, exclude)
        if which == "others" and not claimed:
            return [self._roster.new(ParticipantKind.CAR, basis) for _ in range(min(count, 20))]
        if claimed or which == "count":
            return claimed
        return (
            [self._roster.new(ParticipantKind.CAR, basis)]
            if which != "one" or self._roster.recent
            else []
        )

    def _we(self, count: int, basis: Basis) -> list[Entity]:
        """``three of us``: the ego and two more."""
        ego = self._ego(ParticipantKind.CAR, basis)
        others = [self._roster.new(ParticipantKind.CAR, basis) for _ in range(min(count, 20) - 1)]
        if others:
            self._roster.groups.append(Group(others, vague=False))
        return [ego, *others]

    def _noun(self, reading: Reading, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        basis = Basis(mention.i, mention.j)
        if reading.ego:
            return [self._ego(reading.kind, basis)]
        of_whom = next((p.target for p in mention.pps if p.value == "of"), None)
        if reading.driver and isinstance(of_whom, Mention):
            return self.resolve(of_whom, subject=False, exclude=[])
        inside = vehicle_around(reading, mention)
        if inside is not None:
            return self.resolve(inside, subject=False, exclude=[])
        known = self._known(reading, mention, exclude)
        if known:
            self._roster.enrich(known, reading)
            return known
        return self._roster.introduce(reading, basis)

    def observer(self, i: int, j: int) -> None:
        """``our lane``: whoever tells it takes part.

        Args:
            i: index of the first token of the words.
            j: index after the last one.
        """
        self._ego(ParticipantKind.CAR, Basis(i, j))

    def _ego(self, kind: ParticipantKind, basis: Basis) -> Entity:
        for entity in self._draft.entities:
            if entity.ego:
                return entity
        entity = self._roster.new(kind, basis)
        entity.ego = True
        entity.named_by.add("ego")
        entity.claimed = True
        return entity

    def _known(self, reading: Reading, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        det = reading.det
        names = {label for label in reading.labels if label.startswith("#")}
        if names:
            known = [e for e in self._draft.entities if names & e.labels][:1]
            return known or self._roster.named(reading, names)
        counted = self._counted(reading, mention)
        if counted is not None:
            return counted
        included = self._roster.included(reading, mention)
        if included:
            return included
        if reading.plural:
            return self._known_plural(reading)
        if det == "other":
            claimed = self._roster.claim(1, exclude, reading)
            rest = [e for e in self._roster.rest(exclude) if self._roster.compatible(e, reading)]
            return claimed or rest
        if det in {"another", "ordinal"}:
            return self._another(reading, exclude)
        if det in {"one", "indef"}:
            member = self._member(reading, mention, exclude)
            return member or self._roster.from_title(reading, mention)
        return self._definite(reading, mention, exclude)

    def _counted(self, reading: Reading, mention: Mention) -> list[Entity] | None:
        """``the first car``, ``the second truck``: by the order in which they came up."""
        which = next((m.value for m in mention.mods if m.value in _POSITIONS), None)
        if which is None or reading.det not in {"def", "ordinal"} or reading.plural:
            return None
        if mention.mods[0].value != "def":
            return None
        for group in reversed(self._roster.groups):
            alike = [e for e in group.members if self._roster.compatible(e, reading)]
            if len(alike) > abs(_POSITIONS[which]):
                return self._claimed(alike[_POSITIONS[which]])
        alike = [e for e in self._draft.entities if self._roster.compatible(e, reading)]
        alike = [e for e in alike if not e.ego]
        if not alike:
            return None
        known = alike[_POSITIONS[which] :][:1] if _POSITIONS[which] < len(alike) else []
        return self._claimed(known[0]) if known else []

    def _claimed(self, entity: Entity) -> list[Entity]:
        entity.claimed = True
        return [entity]

    def _known_plural(self, reading: Reading) -> list[Entity]:
        if reading.det != "def" and reading.count != DEFAULT_COUNT:
            return []
        both = not reading.vague and reading.det in {"bare", "def"}
        if reading.det != "def" and not (both and not reading.dirs):
            return []
        for group in reversed(self._roster.groups):
            counted = reading.det == "bare" and not reading.vague
            if counted and (group.settled or len(group.members) != reading.count):
                continue
            if all(self._roster.compatible(e, reading) for e in group.members):
                return list(group.members)
        fitting = [e for e in self._draft.entities if self._roster.compatible(e, reading)]
        if reading.det == "bare" and not reading.vague:
            return fitting if len(fitting) == reading.count else []
        return fitting if len(fitting) > 1 else []

    def _another(self, reading: Reading, exclude: list[Entity]) -> list[Entity]:
        """A further one: of a group that is being picked apart, else somebody new."""
        for group in reversed(self._roster.groups):
            started = len(group.free) < len(group.members)
            if (started or group.vague) and self._roster.agree(group, reading):
                return self._roster.claim(1, exclude, reading)
        return []

    def _member(self, reading: Reading, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        """``including one vehicle``, and any single one where only "traffic" was named."""
        within = mention.prep is not None and mention.prep.value == "with"
        for group in reversed(self._roster.groups):
            if not (within or group.vague or reading.det == "one"):
                continue
            if group.settled and not within:
                continue
            if not self._roster.agree(group, reading):
                continue
            claimed = self._roster.claim(1, exclude, reading)
            if claimed:
                return claimed
            free = [e for e in group.free if e not in exclude and e.kind is ParticipantKind.CAR]
            if free and group.vague and reading.dirs and group.dirs == reading.dirs:
                free[0].kind = reading.kind
                free[0].basis = Basis(mention.i, mention.j)
                free[0].claimed = True
                return free[:1]
        return []

    def _definite(self, reading: Reading, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        options = [
            e
            for e in reversed(self._roster.recent)
            if e not in exclude and self._roster.compatible(e, reading)
        ]
        if reading.dirs:
            options = [e for e in options if e.dirs == reading.dirs]
        loci = _loci(mention)
        options = [e for e in options if not (loci and e.loci) or loci & e.loci]
        others = [e for e in options if not e.ego]
        restricted = reading.dirs or reading.labels or mention.pps
        if others or reading.det == "bare" or restricted:
            return others[:1]
        return options[:1]


def _is_pronoun(target: object) -> bool:
    return isinstance(target, Mention) and target.pronoun in {"it", "him", "they"}


def _loci(mention: Mention) -> set[str]:
    """Where a noun is said to be: "the car behind" is not "the car in front"."""
    loci = {p.value for p in mention.pps if p.word.cat == "locus"}
    return loci | ({"elsewhere"} if mention.elsewhere else set())


def _refers_to_nobody(mention: Mention) -> bool:
    """``in traffic``, ``no pedestrians``, ``at the second``: words that name no participant."""
    prep = mention.prep.value if mention.prep is not None else ""
    mass = bool(mention.head and mention.head.data.get("mass")) and not mention.mods
    if mass and prep in {"in", "of", "for"}:
        return True
    place = mention.pronoun == "ordinal" and prep == "in"  # "at the first junction …, the second"
    return place or mention.negated or mention.pronoun == "reflexive"
