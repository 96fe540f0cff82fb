"""What the words of a mention say about whom it refers to: kind, number, names, places."""

from dataclasses import dataclass, field

from scegen.scenario.vocabulary import ON_FOOT, ParticipantKind
from scegen.understanding.chunks import Mention
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.tokens import Token, base_words

KINDS = {kind.value: kind for kind in ParticipantKind}
_VAGUE_COUNTS = {"couple": 2, "pair": 2, "few": 3, "several": 3, "multiple": 3, "various": 3}
_MANY = 4
ENDS = {"front": "ahead", "rear": "behind"}
"""Where the front one, and the rear one, of two is."""
DEFAULT_COUNT = 2
_PEOPLE = frozenset({"driver", "rider", "pedestrian", "adversary"})


@dataclass(slots=True)
class Reading:
    """What the words of a mention say about whom they refer to."""

    kind: ParticipantKind
    generic: bool
    det: str
    count: int
    plural: bool
    vague: bool
    labels: set[str]
    dirs: set[str]
    parked: bool
    ego: bool
    driver: bool
    reason: str | None
    called: set[str] = field(default_factory=set)

    @property
    def is_target(self) -> bool:
        """Whether it is what a test calls the other vehicle."""
        return not word_list("targets").isdisjoint(" ".join(self.called).split())


def read_mention(mention: Mention, tokens: list[Token], arms: int | None) -> Reading:
    """What the words of a mention say."""
    heads = mention.heads
    kinds: list[ParticipantKind] = [KINDS[h.value] for h in heads if h.value in KINDS]
    words = [tokens[h.j - 1] for h in heads]
    last = words[-1]
    specific: list[ParticipantKind] = [k for k in kinds if k is not ParticipantKind.CAR]
    told = {key for h in heads for key in h.data}
    driver = "driver" in told
    bare = "label" in told or last.base in word_list("generic_words")  # "V2", "vehicle"
    kind = (specific or kinds or [ParticipantKind.CAR])[0]
    afoot = "afoot" in told
    if kind in ON_FOOT and "drives" in mention.marks and not afoot:
        kind, driver, kinds = ParticipantKind.CAR, True, []
    if heads[-1].value == "rider" and not kinds:
        kind = ParticipantKind.MOTORCYCLE
    people = all(h.value in _PEOPLE for h in heads) and not afoot
    if mention.goes_by is not None and people:
        kind, driver = mention.goes_by, False
        kinds, specific = [kind], [kind]
    named = (mention.label or "").startswith("#")
    plural = "mass" in told or "several" in heads[-1].data or (heads[-1].form == "s" and not named)
    plural = plural or (mention.has("quant", "all") and "ego" not in told)  # "each vehicle"
    count, vague, reason = _count(mention, tokens, plural, arms)
    det = next((m for m in mention.mods if m.cat in {"det", "possessive"}), None)
    numbered = mention.mod("num")
    single = numbered is not None and numbered.data["number"] == 1  # "one in each lane", too
    det_value = det.value if det else ("one" if single else "bare")
    if det and det.cat == "possessive":
        det_value = "def"
    elif det is None and last.base in word_list("indefinite"):
        det_value = "indef"  # "somebody hits me"
    labels = {h.data["label"] for h in heads if "label" in h.data}
    labels |= {"adversary"} if mention.has("label", "adversary") else set()
    labels |= {tokens[m.i].low for m in mention.mods if m.cat == "label" and m.value == "colour"}
    if mention.has("label", "second", "third"):
        det_value = "ordinal"
    return Reading(
        kind=kind,
        generic=not specific and (bare or not kinds),
        det=det_value,
        count=count,
        plural=count > 1 or plural,
        vague=vague,
        labels=labels | ({_name(mention.label, kind)} if mention.label else set()),
        dirs=set(mention.dirs),
        parked=mention.has("state", "parked"),
        ego="ego" in told or mine(mention, kind),
        driver=driver and not kinds,
        reason=reason,
        called=called(mention, tokens),
    )


def states_of(mention: Mention) -> set[str]:
    """``a van stands there … the stationary van``: in what state it is said to be."""
    told = {m.value for m in mention.mods if m.cat == "state"}
    return told | ({"stationary"} if "stands" in mention.marks else set())


def mine(mention: Mention, kind: ParticipantKind) -> bool:
    """``my bike``, ``our old lorry``: whoever tells it drives it."""
    named = mention.head is not None and mention.head.value in KINDS
    vehicle = named and mention.noun != "pedestrian" and kind not in ON_FOOT  # not "my neighbour"
    return vehicle and mention.opened_by("first_person")


def _name(label: str, kind: ParticipantKind) -> str:
    """Pedestrian 1 is not vehicle 1: people on foot and bicycles are counted for themselves."""
    own = {ParticipantKind.PEDESTRIAN: "#p", ParticipantKind.BICYCLE: "#b"}.get(kind, "#")
    digits = label.lstrip("#ped")
    return f"{own}{digits}" if digits.isdigit() else label


def _count(
    mention: Mention, tokens: list[Token], plural: bool, arms: int | None
) -> tuple[int, bool, str | None]:
    number = mention.mod("num")
    if arms is not None and not plural and mention.heads[0].value != "ego":
        return arms, False, f"one from each of the {arms} directions"
    if number is not None and number.data["number"] >= 1 and (plural or not mention.mod("det")):
        return int(min(number.data["number"], 10**6)), False, None
    if mention.joined is not None and _shares_noun(mention):
        return 1, False, None
    quant = mention.mod("quant")
    if arms is not None and plural:
        return arms, True, f"one from each of the {arms} directions"
    if quant is not None and quant.value == "vague":
        word = tokens[quant.j - 1].low
        words = {t.low for t in tokens[quant.i : quant.j]}
        count = next((n for w, n in _VAGUE_COUNTS.items() if w in words), _MANY)
        return count, True, f"'{word}' is read as {count}"
    if quant is not None and quant.value == "both" and plural:
        return DEFAULT_COUNT, False, None
    head = mention.heads[-1].data
    if "several" in head:
        return int(head["several"]), False, None
    if not plural:
        return 1, False, None
    if "mass" in head and "opposite" in mention.dirs:
        return 1, True, "no number is given; one of the oncoming traffic is enough"
    return DEFAULT_COUNT, True, f"no number is given; {DEFAULT_COUNT} are assumed"


def _shares_noun(mention: Mention) -> bool:
    """``the ego and adversary vehicles``: the plural noun belongs to both adjectives."""
    first = mention.joined
    if first is None or not first.heads or any(mod.cat == "det" for mod in mention.mods[:1]):
        return False
    return len(first.heads) == 1 and first.heads[0].value in {"ego", "adversary"}


def called(mention: Mention, tokens: list[Token]) -> set[str]:
    """The nouns of a mention that say more than "vehicle" or "person"."""
    nouns = {base_words(tokens, head.i, head.j) for head in mention.heads}
    brands = {f"brand:{base_words(tokens, h.i, h.j)}" for h in mention.heads if h.data.get("brand")}
    return (nouns | brands) - word_list("everybody")


_DENSITY = frozenset({"manner", "inert", "unknown", "noted"})
"""Classes of words that say how dense traffic is."""


def is_pronoun(target: object) -> bool:
    """Whether a noun is "it", "him" or "they"."""
    return isinstance(target, Mention) and target.pronoun in {"it", "him", "they"}


def refers_to_nobody(mention: Mention) -> bool:
    """``in traffic``, ``no pedestrians``, ``at the second``: words that name no participant."""
    prep = mention.opening
    first = [m.value for m in mention.mods[:1]]
    several = mention.is_mass or mention.plural
    if prep == "without" and (
        first in (["indef"], ["other"], ["another"]) or (not first and several)
    ):
        return True  # "without any target", "without other cars", "free of traffic"
    jam = mention.head is not None and "stands" in mention.head.data
    scene = {("label", "quality"), *([("det", "indef")] if jam else [])}  # "in a jam"
    mass = mention.is_mass and all(
        m.cat in _DENSITY or (m.cat, m.value) in scene for m in mention.mods
    )
    if mass and prep in {"in", "of", "for"}:
        return True
    place = mention.pronoun == "ordinal" and prep == "in"  # "at the first junction …, the second"
    return place or mention.negated or mention.pronoun in {"reflexive", "nobody"}


def kin(reading: Reading, mention: Mention) -> bool:
    """``her daughter``, ``his two children``: nobody who was called otherwise."""
    people = reading.kind in ON_FOOT and not reading.driver
    return people and mention.opened_by("its")


def tells(mention: Mention) -> bool:
    """Whether it is the one who tells it ("I", "we")."""
    return mention.is_me or any("speaks" in h.data for h in mention.heads)


def elsewhere(reading: Reading, mention: Mention, entity: Entity) -> bool:
    """``lead car brakes; car on the left``: a bare noun with a place of its own is another one."""
    called = reading.called - entity.named_by - word_list("wider_names")
    other = called and not (reading.kind is entity.kind is not ParticipantKind.CAR)
    if entity.ego and (other or mention.has("verb", "approach")):
        return True  # "the ego turns; the SUV …", "…; the approaching car …"
    if mention.sides and entity.loci and reading.det != "def":
        return True  # "a jam ahead; a car on the left"
    bare = reading.det == "bare" and not reading.dirs and reading.kind is entity.kind
    return bare and bool(mention.pps) and bool(entity.dirs)


def refine(mention: Mention, draft: Draft) -> None:
    """``vehicle 1, a pickup truck, …``: it says what kind that is, or that it is the ego."""
    if not mention.heads:
        return
    reading = read_mention(mention, draft.tokens, None)
    afoot = any("afoot" in h.data for h in mention.heads)
    ego = draft.ego
    for entity in mention.entities:
        if not reading.generic and (reading.kind not in ON_FOOT or afoot):
            entity.kind, entity.basis = reading.kind, Basis(mention.i, mention.j)
        entity.ego = entity.ego or (reading.ego and ego is None)
        entity.labels |= reading.labels
        entity.named_by |= reading.called
