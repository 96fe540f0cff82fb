"""The participants of a text so far, singly and in the groups in which they came up."""

from collections.abc import Callable
from dataclasses import dataclass, field

from scegen.scenario.vocabulary import ON_FOOT, ParticipantKind
from scegen.understanding.chunks import Mention
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.reference.mention_words import KINDS, Reading
from scegen.understanding.words.numbers import POSITIONS
from scegen.understanding.words.tokens import Token


@dataclass(slots=True)
class Group:
    """Participants introduced together ("two cars", "traffic")."""

    members: list[Entity]
    vague: bool
    dirs: set[str] = field(default_factory=set)
    specific: bool = False
    settled: bool = False
    """What they do is said of all of them, so that "one car" is somebody else."""
    both: bool = False
    """The text says "both": there is nobody else."""

    @property
    def free(self) -> list[Entity]:
        """Members that no later mention has picked out."""
        return [e for e in self.members if not e.claimed]


def opened(reading: Reading, mention: Mention, entities: list[Entity]) -> list[Entity]:
    """``parked cars … a driver opens his door``: the driver stands for one of them."""
    aboard = mention.head is not None and bool(mention.head.data.get("aboard"))
    if "seated" not in mention.marks or not (reading.driver or aboard):
        return []
    return [e for e in entities if e.parked][-1:]


def vehicle_around(reading: Reading, mention: Mention) -> Mention | None:
    """``someone in a van``, ``a cyclist on a racing bike``: they stand for the vehicle."""
    person = reading.driver or reading.kind in ON_FOOT or mention.goes_by is not None
    for prep in mention.pps:
        target = prep.target
        if prep.value == "in" and isinstance(target, Mention):
            kinds = [KINDS[h.value] for h in target.heads if h.value in KINDS]
            if set(kinds) - ON_FOOT and (person or set(kinds) == {reading.kind}):
                return target
    return None


_RIDDEN = ParticipantKind.MOTORCYCLE
_NARROWER = {ParticipantKind.BICYCLE: _RIDDEN, ParticipantKind.ANIMAL: ParticipantKind.LARGE_ANIMAL}


@dataclass(slots=True)
class Roster:
    """Who is known, and who was spoken of last.

    Attributes:
        draft: where participants are kept.
        tokens: the tokens of the text.
        arms: arms of the junction, for "from all directions".
        groups: participants that came up together.
        recent: everybody, the one spoken of last at the end.
        subject: who acted last.
        before: who acted before them.
        pair: the two of whom one was called "the former".
        joined: who was named as one subject ("a van and a bus").
        measured: to whom a gap was just told ("the gap to the ego").
        landmark: of whom the last phrase of place told where somebody is, its word and since when.
        turns: how many mentions came up.
        teller: what the one who tells it goes by.
        apart: that one is not the ego.
    """

    draft: Draft
    tokens: list[Token]
    arms: int
    groups: list[Group] = field(default_factory=list)
    recent: list[Entity] = field(default_factory=list)
    subject: list[Entity] = field(default_factory=list)
    before: list[Entity] = field(default_factory=list)
    pair: list[Entity] = field(default_factory=list)
    joined: list[Entity] = field(default_factory=list)
    measured: list[Entity] = field(default_factory=list)
    landmark: tuple[list[Entity], str, int] | None = None
    turns: int = 0
    teller: ParticipantKind = ParticipantKind.CAR
    apart: bool = False

    def spoken_of(self, found: list[Entity], *, subject: bool, settled: bool) -> None:
        """Remembers a mention; ``settled``: the text says which way all of them go."""
        for group in self.groups[-1:]:
            group.settled = group.settled or (settled and group.members == found)
        self.recent = [*(e for e in self.recent if e not in found), *dict.fromkeys(found)]
        if subject and found:
            if found != self.subject:
                self.before = self.subject
            self.subject = found

    def stands_near(self, word: str | None, found: list[Entity]) -> None:
        """Remembers of whom a phrase of place says where somebody is ("ahead of the ego")."""
        self.turns += 1
        if word is not None and len(found) == 1:
            self.landmark = (found, word, self.turns)

    def still_near(self, word: str | None) -> list[Entity]:
        """``a van drives ahead of the ego, a bus behind it``: "it" is the ego, not the van."""
        if self.landmark is None or word is None:
            return []
        found, before, since = self.landmark
        parallel = before != word and self.turns - since == 1
        return found if parallel else []

    @property
    def entities(self) -> list[Entity]:
        """Everybody known so far."""
        return self.draft.entities

    def new(self, kind: ParticipantKind, basis: Basis) -> Entity:
        """A new participant."""
        return self.draft.add(kind, basis)

    def claim(
        self, count: int, exclude: list[Entity], reading: Reading | None = None
    ) -> list[Entity]:
        """Members of an earlier group that nobody has picked out yet."""
        return _pick(count, self.groups, lambda e: e not in exclude and self.fits(e, reading))

    def besides(self, exclude: list[Entity]) -> list[Entity]:
        """The vehicles besides those just spoken of."""
        return [e for e in self.entities if e.is_vehicle and e not in (*exclude, *self.subject)]

    def others(self, exclude: list[Entity], count: int | None = None) -> list[Entity]:
        """The vehicles besides the ego; if a number is given, only if they are so many."""
        found = [e for e in self.entities if e.is_vehicle and not (e.ego or e in exclude)]
        return found if count in {None, len(found)} else []

    def together(self, exclude: list[Entity]) -> list[Entity]:
        """The last group, or the last two."""
        if self.groups and len(self.groups[-1].members) > 1:
            return list(self.groups[-1].members)
        return [e for e in self.entities if e not in exclude][-2:]

    def further(self, exclude: list[Entity], basis: Basis) -> list[Entity]:
        """``another``, ``a third one``: of a group that is being picked apart, else a new one."""
        apart = any(group.vague or len(group.free) < len(group.members) for group in self.groups)
        if apart and (free := self.claim(1, exclude)):
            return free
        afoot = len(self.subject) == 1 and self.subject[0] is self.entities[-1]
        others = [e for e in self.recent if not e.ego]
        alike = [e.kind for e in others if e.is_vehicle or (afoot and e in self.subject)]
        return [self.new((alike or [ParticipantKind.CAR])[-1], basis)]

    def named(self, reading: Reading, names: set[str], exclude: list[Entity]) -> list[Entity]:
        """``Two cars collided. Vehicle 1 …``: a new name goes to one without a name."""
        named = [e for e in self.entities if e.numbered]
        apart = [g for g in self.groups if g.vague and named and "ahead" in g.members[0].loci]
        others = [e for group in apart for e in group.members]  # "V1 slows for traffic ahead. V2 …"
        found = self.claim(1, [*exclude, *named, *others], reading)
        for entity in found:
            entity.labels |= names
        return found

    def included(self, reading: Reading, mention: Mention) -> list[Entity]:
        """``five vehicles, including a bus and two trucks``: members get their kind."""
        head = chain(mention)[0]
        before = self.tokens[head.prep.i if head.prep is not None else max(0, head.i - 1)].low
        listed = mention.listed or before == ":" or before in word_list("including")
        if not listed or reading.generic:
            return []
        of_any_kind = [g for g in self.groups if not g.specific]
        found = _pick(reading.count, of_any_kind, lambda e: e.kind is ParticipantKind.CAR)
        for entity in found:
            entity.kind = reading.kind
            entity.basis, entity.counted = Basis(mention.i, mention.j), None
        return found

    def by_order(self, reading: Reading, mention: Mention) -> list[Entity] | None:
        """``the first car``, ``the second truck``: by the order in which they came up.

        Returns:
            Whom it means; None if it says nothing of an order.
        """
        which = next((m.value for m in mention.mods if m.value in POSITIONS), None)
        file = any("in_file" in m.data for m in mention.mods)
        leads = mention.head is not None and self.tokens[mention.head.i].low == "leader"
        if leads and self.groups and all(e.is_vehicle for e in self.groups[-1].members):
            which = which or "first"  # "three cars in a platoon; the leader brakes"
        if which is None or reading.det not in {"def", "ordinal"} or reading.plural:
            return None
        if not mention.opened_by("def"):
            return None
        for group in reversed(self.groups):
            alike = [e for e in group.members if leads or self.compatible(e, reading)]
            alike = [e for e in alike if not (file and e.ego)]
            if -len(alike) <= POSITIONS[which] < len(alike):
                return claimed([alike[POSITIONS[which]]])
        alike = [e for e in self.entities if self.compatible(e, reading) and not e.ego]
        return claimed(alike[POSITIONS[which] :][:1]) if alike else None

    def fits(self, entity: Entity, reading: Reading | None) -> bool:
        """Whether a member of a group can be meant."""
        if reading is None:
            return True
        generic = reading.generic or reading.driver
        any_kind = reading.kind is not _RIDDEN or entity.kind is ParticipantKind.BICYCLE
        same = entity.kind is reading.kind or (generic and entity.is_vehicle and any_kind)
        return same and entity.parked == reading.parked

    def agree(self, group: Group, reading: Reading) -> bool:
        """Whether a group comes from where the mention says."""
        return not reading.dirs or not group.dirs or reading.dirs == group.dirs

    def compatible(self, entity: Entity, reading: Reading) -> bool:
        """Whether the words of a mention can stand for a known participant."""
        if reading.driver or reading.generic:
            rides = entity.kind is ParticipantKind.BICYCLE and not reading.plural
            kind = entity.is_vehicle and (not rides or reading.kind is _RIDDEN)
        else:
            kind = entity.kind is reading.kind or self._wider(entity, reading)
        kind = kind or _called_so(entity, reading)
        if reading.labels and not reading.labels <= entity.labels:
            return False
        if entity.ego and reading.is_target:
            return False  # a target is never the vehicle under test
        return kind and (entity.parked or not reading.parked)

    def _wider(self, entity: Entity, reading: Reading) -> bool:
        """``a motorcyclist … the bike``, ``a deer … the animal``: if nobody is more so."""
        named = reading.called <= word_list("wider_names") and reading.det in {"def", "bare"}
        kinds = {e.kind for e in self.entities}
        return named and entity.kind is _NARROWER.get(reading.kind) and reading.kind not in kinds

    def cast(self, reading: Reading, loci: set[str]) -> list[Entity]:
        """``a bus … the adversarial bus``: somebody known gets the role, if only one can."""
        named = any("adversary" in e.labels for e in self.entities)
        if named or reading.plural or reading.labels != {"adversary"}:
            return []
        others = [e for e in self.entities if not (e.ego or e.parked)]
        alike = [e for e in others if e.kind is reading.kind and reading.dirs <= e.dirs]
        one = len(alike) == 1 and reading.det in {"def", "bare"}  # "a slower car …; POV 20 mph"
        return alike if one and (not loci or loci & alike[0].loci) else []

    def enrich(self, known: list[Entity], reading: Reading) -> None:
        """What a further mention says of known participants."""
        for entity in known:
            entity.labels |= reading.labels
            entity.named_by |= reading.called if len(known) == 1 else set()
            if reading.dirs and not entity.dirs:
                entity.dirs |= reading.dirs

    def introduce(self, reading: Reading, basis: Basis) -> list[Entity]:
        """New participants."""
        found = []
        for _ in range(reading.count):
            entity = self.new(reading.kind, basis)
            entity.labels |= reading.labels
            entity.named_by |= reading.called
            entity.dirs |= reading.dirs
            entity.parked = reading.parked
            entity.parked_basis = basis if reading.parked else None
            if reading.reason:
                entity.counted = Basis(basis.i, basis.j, reading.reason)
            entity.claimed = reading.count == 1
            found.append(entity)
        if len(found) > 1:
            self.groups.append(
                Group(found, reading.vague, set(reading.dirs), specific=not reading.generic)
            )
        return found


def claimed(entities: list[Entity]) -> list[Entity]:
    """Those whom a mention picks out of all that are known: no later one does."""
    for entity in entities:
        entity.claimed = True
    return entities


def _pick(count: int, groups: list[Group], may: Callable[[Entity], bool]) -> list[Entity]:
    """So many members that are free, of the last group that has as many who may be meant."""
    for group in reversed(groups):
        free = [e for e in group.free if may(e)]
        if len(free) >= count:
            return claimed(free[:count])
    return []


def _called_so(entity: Entity, reading: Reading) -> bool:
    """``a child on a bicycle … the child``; ``a kick scooter … the scooter``: its last word."""
    names = {name.rpartition(" ")[2] for name in entity.named_by}
    return reading.det == "def" and bool(reading.called) and reading.called <= names
