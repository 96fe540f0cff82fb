"""Which of those who are known a noun means: by name, number, order, place and kind."""

from scegen.scenario.vocabulary import ParticipantKind
from scegen.understanding.chunks import Mention
from scegen.understanding.clauses.located import as_the_ego_sees, loci_of
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.reference.egos import the_ego
from scegen.understanding.reference.mention_words import (
    DEFAULT_COUNT,
    ENDS,
    Reading,
    elsewhere,
    states_of,
)
from scegen.understanding.reference.roster import Roster

A_PAIR = 2
_LOOKS_WITHIN = 3
"""Words in which a driver "who looks forward" is said to."""


def known(
    roster: Roster, reading: Reading, mention: Mention, exclude: list[Entity]
) -> list[Entity]:
    """Whom a noun means of those who are known; empty if it is somebody new."""
    det = reading.det
    if looker := _looks_on(roster, reading, mention):
        return looker
    names = {label for label in reading.labels if label.startswith("#")}
    if names:
        same = [e for e in roster.entities if names & e.labels][:1]
        return same or roster.named(reading, names, exclude)
    counted = roster.by_order(reading, mention)
    if counted is not None:
        return counted
    included = roster.included(reading, mention)
    if included or mention.listed:
        return included or roster.claim(reading.count, exclude, reading)
    if reading.plural and det == "other":
        if mention.mod("num") is not None or mention.has("quant", "both"):
            free = roster.claim(reading.count, exclude, reading)
            return free or roster.others(exclude, reading.count)
        rest = [e for g in roster.groups[-1:] for e in g.members if e not in exclude]
        rest = [e for e in rest or roster.others(exclude) if not e.ego]
        if len(rest) > 1 and all(roster.compatible(e, reading) for e in rest):
            return rest  # "three other cars …; one of the other cars"
    if reading.plural:
        return _several(roster, reading, mention, exclude)
    if det == "other":
        return _other(roster, reading, mention, exclude)
    if det in {"another", "ordinal"}:
        return _another(roster, reading, exclude)
    if det in {"one", "indef"}:
        return _member(roster, reading, mention, exclude)
    return _definite(roster, reading, mention, exclude)


def _looks_on(roster: Roster, reading: Reading, mention: Mention) -> list[Entity]:
    """``as seen by the driver``, ``in the view of one facing forward``, ``the driver's left``."""
    before = [t.low for t in roster.tokens[max(0, mention.i - 2) : mention.i]]
    seen_by = before[-1:] == ["by"] and reading.det == "def"
    view = before[-1:] == ["of"] and before[0] in word_list("views_of")
    told = [t.low for t in roster.tokens[mention.i : mention.j + _LOOKS_WITHIN]]
    beside = told if "'s" in told else before * (before[-1:] == ["of"])
    sides = {"left", "right"} & {*beside} and reading.det == "def"
    forward = sides or bool({"forward", "forwards"} & {*told})  # "a driver who faces forward"
    drive = [e for e in roster.entities if e.is_vehicle]
    if forward and len(drive) > 1:
        drive = [e for e in drive if e.ego]
    alone = len(drive) == 1 and reading.driver and not reading.labels
    return drive if alone and (seen_by or view or forward) else []


def _other(
    roster: Roster, reading: Reading, mention: Mention, exclude: list[Entity]
) -> list[Entity]:
    """``the other car``: the only one beside the ego, or beside who was just spoken of."""
    if not roster.entities:
        the_ego(roster, ParticipantKind.CAR, Basis(mention.i, mention.j))
        return []  # other than mine
    others = [e for e in _compatible(roster, reading) if not (e.ego or e.still or e in exclude)]
    rest = [e for e in others if e not in roster.subject]
    return next((found for found in (others, rest) if len(found) == 1), [])


def _compatible(roster: Roster, reading: Reading) -> list[Entity]:
    return [e for e in roster.entities if roster.compatible(e, reading)]


def _several(
    roster: Roster, reading: Reading, mention: Mention, exclude: list[Entity]
) -> list[Entity]:
    quantity = mention.mod("quant")
    if quantity is not None and quantity.value == "all":
        everybody = _compatible(roster, reading)
        counted = mention.mod("num") is None or len(everybody) == reading.count
        return everybody if len(everybody) > 1 and counted else []
    if reading.det != "def" and reading.count != DEFAULT_COUNT:
        oncoming = mention.is_mass and "opposite" in reading.dirs
        return _another(roster, reading, exclude) if oncoming else []  # of six, two turn across it
    both = not reading.vague and reading.det in {"bare", "def"}
    if reading.det != "def" and not (both and not reading.dirs):
        return []
    for group in reversed(roster.groups):
        counted = reading.det == "bare" and not reading.vague
        if counted and (group.settled or len(group.members) != reading.count):
            continue
        if all(roster.compatible(e, reading) for e in group.members):
            return list(group.members)
    fitting = _compatible(roster, reading)
    pair = mention.mod("num") is None or reading.count == A_PAIR
    if reading.det == "def" and pair and len(fitting) == 1 and not fitting[0].ego:
        moving = not (reading.dirs or reading.parked or fitting[0].parked)
        if moving and fitting[0].is_vehicle and roster.draft.ego is None:  # "between the vehicles"
            ego = the_ego(roster, ParticipantKind.CAR, Basis(mention.i, mention.j))
            return [*fitting, ego]
    if reading.det == "bare" and not reading.vague:
        return []
    return fitting if len(fitting) > 1 else []


def _another(roster: Roster, reading: Reading, exclude: list[Entity]) -> list[Entity]:
    """A further one: of a group that is being picked apart, else somebody new."""
    for group in reversed(roster.groups):
        started = len(group.free) < len(group.members)
        if (started or group.vague) and roster.agree(group, reading):
            return roster.claim(1, exclude, reading)
    return []


def _member(
    roster: Roster, reading: Reading, mention: Mention, exclude: list[Entity]
) -> list[Entity]:
    """``including one vehicle``, and any single one where only "traffic" was named."""
    within = mention.stands_after("with")
    for group in reversed(roster.groups):
        if not (within or group.vague or reading.det == "one"):
            continue
        apart = any(elsewhere(reading, mention, e) for e in group.members)
        if apart or not roster.agree(group, reading) or (group.settled and not within):
            continue
        if free := roster.claim(1, exclude, reading):
            return free
    return []


def _definite(
    roster: Roster, reading: Reading, mention: Mention, exclude: list[Entity]
) -> list[Entity]:
    alike = [e for e in reversed(roster.recent) if roster.compatible(e, reading)]
    options = [e for e in alike if not (e in exclude or elsewhere(reading, mention, e))]
    which = [p for p in mention.pps if not (p.predicate or p.fronted)]
    fronted = {p.value for p in mention.pps if p.fronted}
    loci = loci_of(mention) - fronted  # "15 m ahead of the ego the van cuts in": no other van
    told = any(m.cat in {"verb", "manner", "state"} for m in mention.mods)
    narrowed, elsewise = "narrowed" in mention.marks, "elsewhere" in mention.marks
    if not (told or narrowed or (which and not as_the_ego_sees(mention))):
        options = options or roster.cast(reading, loci)
    if reading.dirs:
        options = [e for e in options if _from_there(e, reading)]
    again = reading.called if elsewise and not (which or narrowed) else set()
    options = [e for e in options if not (loci and e.loci) or loci & e.loci or again & e.named_by]
    moving = bool(loci) and not reading.parked  # a parked van is not "the car behind it"
    options = [e for e in options if not (moving and e.parked) or loci & e.loci]
    options = [e for e in options if not (mention.sides and e.sides) or mention.sides & e.sides]
    options = [e for e in options if loci & e.loci] or options  # who is known to be there
    if loci & {"ahead", "behind"}:  # "a car stands at the line; the car behind hits it"
        with_ego = any(e.ego for e in roster.joined)  # "the ego and a van drive …, the van ahead"
        by_itself = [e for e in roster.subject if not (with_ego and e in roster.joined)]
        options = [e for e in options if e.ego or e.loci or not (e.sides or e in by_itself)]
    others = [e for e in options if not e.ego]
    others = [e for e in others if e.named_by & reading.called] or others
    others = [e for e in others if e.named_by & states_of(mention)] or others
    done = any(m.cat == "verb" and m.form == "ed" for m in mention.mods)  # "the overtaken car"
    placed = which or elsewise or narrowed or done
    restricted = reading.dirs or reading.labels or placed
    only = [e for e in roster.entities if e.is_vehicle and e.kind is not ParticipantKind.BICYCLE]
    own = all(p.value == "to" for p in which) and not (narrowed or loci or fronted)
    own = own and not (
        reading.dirs or reading.labels or reading.plural or mention.sides or reading.parked
    )
    ego = next((e for e in only if e.ego and "speaks" not in e.named_by), None)
    car = reading.kind is ParticipantKind.CAR and not reading.driver and mention.i > 0
    own = own and ego not in exclude and not reading.is_target
    alone = len(only) == 1 and ego is not None and not elsewhere(reading, mention, ego)
    told_of = reading.det == "def" or (reading.det == "bare" and mention.possessor)
    if own and car and alone and ego is not None and told_of:
        return [ego]  # "the ego reverses; a child stands behind the car", "60 % of vehicle front"
    rest = [e for e in roster.entities if not e.ego]
    if reading.is_target and reading.generic and reading.det in {"def", "bare"} and len(rest) == 1:
        return rest  # "a pedestrian target walks …; the target is hit"; a GVT is a vehicle
    return others[:1] if others or reading.det == "bare" or restricted else options[:1]


def _from_there(entity: Entity, reading: Reading) -> bool:
    """``the crossing car``: one that comes from either side.

    In "follows a car … the lead vehicle" who is followed is the one ahead; "the oncoming car" is
    one that comes towards the ego, if nothing says from where; "the oncoming lorry" any lorry.
    """
    placed = entity.dirs or entity.loci or entity.sides
    meets = entity.nears or entity.kind is not ParticipantKind.CAR
    if meets and not placed and reading.dirs == {"opposite"}:
        return True
    across = {"left", "right"} if "lateral" in reading.dirs else set[str]()
    if any(known and known <= reading.dirs | across for known in (entity.dirs, entity.sides)):
        return True
    dirs = {ENDS.get(d, d) for d in reading.dirs}
    along = dirs <= {"ahead", "behind"} and entity.dirs <= dirs
    return (along and dirs <= entity.loci | entity.dirs) or dirs <= entity.sides
