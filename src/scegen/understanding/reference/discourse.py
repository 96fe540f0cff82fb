"""Decides whom a mention refers to: somebody new, or somebody already known."""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Mention
from scegen.understanding.clauses.located import as_the_ego_sees, loci_of
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.reference.groups import (
    Group,
    of_both,
    opened,
    vehicle_around,
    with_the_ranked,
)
from scegen.understanding.reference.mention_words import DEFAULT_COUNT, Reading, read_mention
from scegen.understanding.reference.pronouns import Pronouns, picked
from scegen.understanding.reference.reference import (
    elsewhere,
    is_pronoun,
    kin,
    own_vehicle,
    refers_to_nobody,
    refine,
    tells,
)
from scegen.understanding.reference.roster import Roster
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.tokens import Token

_MOST = 20
_A_PAIR = 2
_ALONG = {"front": "ahead", "rear": "behind"}


class Discourse:
    """The participants of a text in the order in which they come up.

    Args:
        draft: where participants are kept.
        tokens: the tokens of the text.
        arms: arms of the junction, for "from all directions".
    """

    def __init__(self, draft: Draft, tokens: list[Token], arms: int) -> None:
        self._draft = draft
        self.tokens = tokens
        self._arms = arms
        self._own = [k for k, token in enumerate(tokens) if token.low in {"my", "our"}]
        self._roster = Roster(draft, tokens)
        self._pronouns = Pronouns(draft, self._roster, tokens)

    @property
    def entities(self) -> list[Entity]:
        """Everybody known so far."""
        return self._draft.entities

    def resolve(
        self,
        mention: Mention,
        *,
        subject: bool,
        exclude: list[Entity],
        sides: int | None = None,
        settled: bool = False,
    ) -> list[Entity]:
        """The participants that a mention refers to.

        Args:
            mention: the mention; its ``entities`` are set.
            subject: it is the subject of its clause.
            exclude: participants that it cannot mean (the subject, for an object).
            sides: its members come one from each of so many sides; 0: from each arm.
            settled: the text says which way all its members go.
        """
        if mention.entities:
            return mention.entities
        if mention.same_as is not None:
            same = mention.same_as  # "riding a moped, I …": whom comes later
            mention.entities = list(same.entities or self.resolve(same, subject=True, exclude=[]))
            refine(mention, self._draft)
            if mention.pronoun is not None:
                self._roster.spoken_of(mention.entities, subject=subject, settled=settled)
            return mention.entities
        if refers_to_nobody(mention) or self._their_own_queue(mention):
            return []
        if self._of_a_size(mention):
            return []
        located = any(p.word.cat == "locus" and is_pronoun(p.target) for p in mention.pps)
        if located or mention.besides:
            exclude = [*exclude, *self._roster.subject]  # "the car behind it" is not "it"
        if (known := self._of_two(mention) or self._at_the_wheel(mention)) != []:
            found = known
        elif mention.pronoun is not None:
            found = self._we(mention) or self._pronouns.resolve(mention, exclude)
        else:
            reading = read_mention(mention, self.tokens, self._arms if sides == 0 else sides)
            one = of_both(reading, loci_of(mention), self._roster.groups, self._draft.entities)
            found = one or self._noun(reading, mention, exclude)
        found = self._share(mention, found)
        mention.entities = list(found)
        if mention.landmark:
            self._roster.landmark = list(found)
        for entity in found:
            entity.loci |= loci_of(mention)
            entity.sides |= mention.sides
        self._roster.spoken_of(found, subject=subject, settled=settled)
        return found

    def _of_two(self, mention: Mention) -> list[Entity]:
        """``both vehicles``, ``the two``: of two who are known already."""
        if len(self._draft.entities) != _A_PAIR:
            return []
        first = mention.i - (mention.pronoun == "count")
        words = " ".join(t.low for t in self.tokens[max(0, first) : mention.j])
        meant = self._roster.together([]) if words in word_list("two_of_them") else []
        return meant if len(meant) == _A_PAIR else []

    def _at_the_wheel(self, mention: Mention) -> list[Entity]:
        """``the ego's driver``: the ego."""
        owner, head = mention.owner, mention.head
        drives = owner is not None and head is not None and head.value == "driver"
        return list(owner.entities) if drives and owner is not None else []

    def _share(self, mention: Mention, whole: list[Entity]) -> list[Entity]:
        """``half of them``: so many, no matter which; ``some of them`` says not how many."""
        words = [*mention.mods, *([mention.head] if mention.head is not None else [])]
        share = next((m.data["share"] for m in words if "share" in m.data), None)
        if share is None or not whole:
            return whole
        count = len(whole) * share
        if not count or count != int(count):
            instead = "how many of them is not said; what they do is left out"
            self._draft.note(mention.i, mention.j, instead)
            return []
        return picked([e for e in whole if not e.claimed][: int(count)])

    def _their_own_queue(self, mention: Mention) -> bool:
        """``five cars wait in a queue``: they are the queue."""
        mass = bool(mention.head and mention.head.data.get("mass"))
        within = mention.prep is not None and mention.prep.value == "in"
        end = mention.prep is not None and mention.prep.value == "of" and bool(self._roster.groups)
        return mass and ((within and len(self._roster.subject) > 1) or end)

    def _of_a_size(self, mention: Mention) -> bool:
        """``half a vehicle's width``, ``and one of 12 m/s``: a measure, nobody."""
        if mention.i and self.tokens[mention.i - 1].low == "(" and not mention.mods:
            return mention.head is not None and bool(mention.head.data.get("driver"))
        of = [t.low for t in self.tokens[mention.j : mention.j + 2]]
        if mention.j - mention.i == 1 and len(of) > 1 and of[0] == "of":
            return quantity_at(self.tokens, mention.j + 1) is not None
        after = {t.low for t in self.tokens[mention.j : mention.j + 2]}
        indefinite = any((m.cat, m.value) == ("det", "indef") for m in mention.mods)
        return mention.possessor and indefinite and bool(after & {"width", "length", "widths"})

    def _we(self, mention: Mention) -> list[Entity]:
        """``three of us``: the ego and two more."""
        whole = mention.whole
        if mention.pronoun != "count" or whole is None or not any(e.ego for e in whole.entities):
            return []
        count, basis = int(mention.mods[0].data["number"]), Basis(mention.i, whole.j)
        ego = self._ego(ParticipantKind.CAR, basis)
        further = range(min(count, _MOST) - 1)
        others = [self._roster.new(ParticipantKind.CAR, basis) for _ in further]
        if others:
            self._roster.groups.append(Group(others, vague=False, unnamed=True))
        return [ego, *others]

    def _noun(self, reading: Reading, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        basis = Basis(mention.i, mention.j)
        if reading.ego and not reading.plural:
            self._roster.ego_by_order(mention)
            if mention.prep is None and (mention.joined is not None or not exclude):
                self._roster.last_is_ego(mention)
            ego = self._ego(reading.kind, basis, told=not reading.generic)
            ego.named_by |= {"speaks"} if tells(mention) else set()
            return [ego]
        if reading.ego:
            return self._roster.subject  # "we arrive in our cars"
        of_whom = next((p.target for p in mention.pps if p.value == "of"), None)
        if reading.driver and isinstance(of_whom, Mention):
            vehicle = self.resolve(of_whom, subject=False, exclude=[])
            still = any(m.cat == "state" for m in of_whom.mods)
            still = still or any(e.parked for e in vehicle)
            out = mention.walks and not mention.drives and still
            afoot = ParticipantKind.PEDESTRIAN  # "the driver of the stalled van steps out"
            return [self._roster.new(afoot, basis)] if out else vehicle
        parked = opened(reading, mention, self._draft.entities)
        if parked:
            return parked
        inside = vehicle_around(reading, mention)
        if inside is not None:
            return self.resolve(inside, subject=False, exclude=[])
        if own_vehicle(reading, mention, self._roster.subject) and len(self._roster.subject) == 1:
            owner = self._roster.subject[0]
            if owner.is_vehicle:
                owner.parked = owner.parked or (reading.parked and not owner.ego)
                return [owner]
        if kin(reading, mention):
            strangers = [e for e in self._draft.entities if not e.named_by & reading.called]
            exclude = [*exclude, *strangers]  # "a man with his son"
        known = self._known(reading, mention, exclude)
        if known:
            self._roster.enrich(known, reading)
            return known
        reading = replace(reading, count=reading.count - (mention.ranked is not None))
        found = with_the_ranked(mention, self._roster.introduce(reading, basis))
        opened_by = [(m.cat, m.value) for m in mention.mods[:1]]
        numbered = mention.mod("num") is not None and not reading.parked
        numbered = numbered and reading.kind is ParticipantKind.CAR
        numbered = numbered and not (reading.dirs or mention.pps or mention.prep is not None)
        both = opened_by == [("quant", "both")] or (opened_by == [("det", "def")] and numbered)
        if both and len(found) == _A_PAIR:
            self._roster.groups[-1].both = True
        return found

    def tells(self, i: int, j: int) -> bool:
        """Whether words name the one who tells it ("on my side of the road").

        Args:
            i: index of the first token of the words.
            j: index after the last one.
        """
        return any(i <= k < j for k in self._own)

    def observer(self, i: int, j: int) -> Entity:
        """``our lane``: whoever tells it takes part.

        Args:
            i: index of the first token of the words.
            j: index after the last one.
        """
        return self._ego(ParticipantKind.CAR, Basis(i, j))

    def _ego(self, kind: ParticipantKind, basis: Basis, *, told: bool = False) -> Entity:
        """The ego; what it drives may be said later than who it is."""
        for entity in self._draft.entities:
            if entity.ego:
                if told and kind is not entity.kind and entity.kind is ParticipantKind.CAR:
                    entity.kind, entity.basis = kind, basis
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
            return known or self._roster.named(reading, names, exclude)
        counted = self._roster.by_order(reading, mention)
        if counted is not None:
            return counted
        included = self._roster.included(reading, mention)
        if included:
            return included
        if reading.plural and det == "other":
            return self._other_ones(reading, mention, exclude)
        if reading.plural:
            return self._known_plural(reading, mention)
        if det == "def" and not reading.driver:
            told = self._roster.told_what(reading, Basis(mention.i, mention.j))
            if told:
                return told
        if det == "other":
            if not self._draft.entities and not reading.plural:
                self.observer(mention.i, mention.j)
                return []  # "the other car": other than mine
            claimed = self._roster.claim(1, exclude, reading)
            rest = [e for e in self._roster.rest(exclude) if self._roster.compatible(e, reading)]
            alone = len(self._draft.entities) == 1 and self._draft.entities[0].ego
            return claimed or ([] if alone else rest)  # other than the ego
        if det in {"another", "ordinal"}:
            return self._another(reading, exclude)
        if det in {"one", "indef"}:
            return self._member(reading, mention, exclude)
        return self._definite(reading, mention, exclude)

    def _other_ones(
        self, reading: Reading, mention: Mention, exclude: list[Entity]
    ) -> list[Entity]:
        if mention.mod("num") is not None:
            return self._roster.claim(reading.count, exclude, reading)
        rest = [g.members for g in self._roster.groups[-1:]]
        others = [e for e in (rest[0] if rest else []) if e not in exclude]
        if others and all(self._roster.compatible(e, reading) for e in others):
            return others  # "three other cars …; one of the other cars"
        return self._known_plural(reading, mention)

    def _known_plural(self, reading: Reading, mention: Mention) -> list[Entity]:
        quantity = mention.mod("quant")
        if quantity is not None and quantity.value == "all":
            everybody = [e for e in self._draft.entities if self._roster.compatible(e, reading)]
            counted = mention.mod("num") is None or len(everybody) == reading.count
            return everybody if len(everybody) > 1 and counted else []
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
        pair = mention.mod("num") is None or reading.count == _A_PAIR
        if reading.det == "def" and pair and len(fitting) == 1 and not fitting[0].ego:
            moving = not (reading.dirs or reading.parked or fitting[0].parked)
            if moving and not any(e.ego for e in self._draft.entities):
                return [*fitting, self.observer(mention.i, mention.j)]  # "between the vehicles"
        if reading.det == "bare" and not reading.vague:
            counted = len(fitting) == reading.count
            told = any(e.ego and e.named_by & {"speaks", "ego"} for e in fitting)
            return fitting if counted and not told else []
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
        return []

    def _definite(self, reading: Reading, mention: Mention, exclude: list[Entity]) -> list[Entity]:
        alike = [e for e in reversed(self._roster.recent) if self._roster.compatible(e, reading)]
        options = [e for e in alike if not (e in exclude or elsewhere(reading, mention, e))]
        told = any(m.cat in {"verb", "manner", "state"} for m in mention.mods)
        which = [p for p in mention.pps if not p.predicate]
        narrowed = bool(which) or mention.narrowed or told
        loci = loci_of(mention)
        only_placed = bool(loci) and not (mention.narrowed or told) and as_the_ego_sees(mention)
        options = options or self._roster.cast(
            reading, narrowed=narrowed, loci=loci if only_placed else set()
        )
        if reading.dirs:
            options = [e for e in options if e.dirs == reading.dirs or _known_there(e, reading)]
        options = [e for e in options if not (loci and e.loci) or loci & e.loci]
        options = [e for e in options if not ("behind" in loci and "opposite" in e.dirs)]
        elsewise = bool(loci) and not reading.parked  # a parked van is not "the car behind it"
        options = [e for e in options if not (elsewise and e.parked) or loci & e.loci]
        options = [e for e in options if not (mention.sides and e.sides) or mention.sides & e.sides]
        others = [e for e in options if not e.ego]
        others = [e for e in others if e.named_by & reading.called] or others
        done = any(m.cat == "verb" and m.form == "ed" for m in mention.mods)  # "the overtaken car"
        placed = which or mention.elsewhere or mention.narrowed or done
        restricted = reading.dirs or reading.labels or placed
        only = [e for e in self._draft.entities if e.is_vehicle]
        own = all(p.value == "to" for p in which) and not (mention.narrowed or loci)
        own = own and not (reading.dirs or reading.labels or reading.plural or mention.sides)
        ego = next((e for e in only if e.ego and "speaks" not in e.named_by), None)
        car = reading.kind is ParticipantKind.CAR and not reading.driver and mention.i > 0
        own = own and ego not in exclude and "target" not in " ".join(reading.called)
        if own and car and len(only) == 1 and ego is not None and reading.det == "def":
            return [ego]  # "the ego reverses; a child stands behind the car"
        rest = [e for e in self._draft.entities if not e.ego]
        if reading.called == {"target"} and reading.det == "def" and len(rest) == 1:
            return rest  # "a pedestrian target walks …; the target is hit"
        seen_by = mention.prep is not None and mention.prep.value == "by" and reading.driver
        if seen_by and reading.det == "def" and len(only) == 1 and not reading.labels:
            return only  # "as seen by the driver facing forward"
        if others or reading.det == "bare" or restricted:
            return others[:1]
        return options[:1]


def _known_there(entity: Entity, reading: Reading) -> bool:
    """``follows a car … the lead vehicle``: who is followed is the one ahead."""
    dirs = {_ALONG.get(d, d) for d in reading.dirs}
    along = dirs <= {"ahead", "behind"} and entity.dirs <= dirs
    return along and dirs <= entity.loci | entity.dirs
