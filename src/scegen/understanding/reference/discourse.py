"""Decides whom a mention refers to: somebody new, or somebody already known."""

from dataclasses import replace

from scegen.scenario.vocabulary import ON_FOOT, ParticipantKind
from scegen.understanding.chunks import Mention
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.clauses.located import is_it, loci_of
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.reference.egos import (
    ego_by_order,
    last_is_ego,
    of_both,
    the_ego,
    the_teller,
    with_the_ranked,
)
from scegen.understanding.reference.known import A_PAIR, known
from scegen.understanding.reference.mention_words import (
    Reading,
    is_pronoun,
    kin,
    mine,
    read_mention,
    refers_to_nobody,
    refine,
    states_of,
    tells,
)
from scegen.understanding.reference.pronouns import of_pronoun, picked
from scegen.understanding.reference.roster import Group, Roster, opened, vehicle_around
from scegen.understanding.words.tokens import low_at

_MOST = 20


def resolve(
    roster: Roster,
    mention: Mention,
    *,
    subject: bool,
    exclude: list[Entity],
    sides: int | None = None,
    settled: bool = False,
    near: str | None = None,
) -> list[Entity]:
    """The participants that a mention refers to.

    Args:
        roster: the participants in the order in which they come up.
        mention: the mention; its ``entities`` are set.
        subject: it is the subject of its clause.
        exclude: participants that it cannot mean (the subject, for an object).
        sides: its members come one from each of so many sides; 0: from each arm.
        settled: the text says which way all its members go.
        near: where it says that somebody is, by it ("behind it").
    """
    if mention.entities:
        return mention.entities
    if mention.same_as is not None:
        same = mention.same_as  # "riding a moped, I …": whom comes later
        mention.entities = list(same.entities or resolve(roster, same, subject=True, exclude=[]))
        refine(mention, roster.draft)
        _as_somebody(mention)
        if mention.pronoun is not None:
            roster.spoken_of(mention.entities, subject=subject, settled=settled)
        return mention.entities
    if refers_to_nobody(mention) or _their_own_queue(roster, mention):
        return []
    located = any(p.word.cat == "locus" and is_pronoun(p.target) for p in mention.pps)
    about = roster.subject or roster.recent[-1:]
    about = about if len(about) == 1 or not roster.draft.ego else []
    if (located and not is_it(mention)) or "besides" in mention.marks:
        exclude = [*exclude, *about]  # "the car behind it" is not "it"
    if two := _of_two(roster, mention, exclude):
        found = two
    elif mention.pronoun is not None:
        found = _we(roster, mention) or of_pronoun(roster, mention, exclude, near)
    else:
        reading = read_mention(mention, roster.tokens, roster.arms if sides == 0 else sides)
        one = of_both(reading, loci_of(mention), roster)
        for entity in one if not (reading.generic or reading.ego) else []:
            entity.kind = reading.kind  # "both vehicles …; the lead van"
            entity.named_by |= reading.called
        found = one or _noun(roster, reading, mention, exclude)
    found = _share(roster, mention, found)
    mention.entities = list(found)
    for entity in found:
        entity.loci |= loci_of(mention)
        entity.sides |= mention.sides
        entity.named_by |= states_of(mention)
    _as_somebody(mention)
    roster.spoken_of(found, subject=subject, settled=settled)
    if subject or _measured_to(mention, roster):
        roster.measured = [] if subject else list(found)
    roster.stands_near(near, found)
    if subject and mention.joined is not None:
        roster.joined = [e for m in chain(mention) for e in m.entities]
    return found


def _measured_to(mention: Mention, roster: Roster) -> bool:
    """``when the gap to the ego is 20 m, it brakes``: the one whose gap it is."""
    to = mention.prep if mention.stands_after("to") else None
    return to is not None and low_at(roster.tokens, to.i - 1) in word_list("to_another")


def _as_somebody(mention: Mention) -> None:
    """``the driver of a van``, ``my wife``: "she" means them before any vehicle."""
    if mention.noun == "pedestrian" or any("driver" in h.data for h in mention.heads):
        for entity in mention.entities:
            entity.named_by.add("somebody")


def _of_two(roster: Roster, mention: Mention, exclude: list[Entity]) -> list[Entity]:
    """``both vehicles``, ``the two``: of two who are known already, or of one and the ego."""
    first = mention.i - (mention.pronoun == "count")
    words = " ".join(t.low for t in roster.tokens[max(0, first) : mention.j])
    told = words in word_list("two_cars") | word_list("two_of_them")
    if (told or mention.pronoun == "both") and [e.ego for e in roster.entities] == [False]:
        the_ego(roster, ParticipantKind.CAR, Basis(mention.i, mention.j))
    here = [e for e in roster.entities if e not in exclude]
    cars = [e for e in here if e.kind is ParticipantKind.CAR]  # besides a lorry
    meant = [cars] if words in word_list("two_cars") else [here]
    named = (*meant, [e for e in here if e.is_vehicle], roster.joined, roster.others(exclude))
    return next((list(two) for two in named if told and len(two) == A_PAIR), [])


def _share(roster: Roster, mention: Mention, whole: list[Entity]) -> list[Entity]:
    """``half of them``: so many, no matter which; ``some of them`` says not how many."""
    words = [*mention.mods, *([mention.head] if mention.head is not None else [])]
    share = next((m.data["share"] for m in words if "share" in m.data), None)
    if share is None or not whole:
        return whole
    count = len(whole) * share
    if not count or count != int(count):
        instead = "how many of them is not said; what they do is left out"
        roster.draft.note(mention.i, mention.j, instead)
        return []
    return picked([e for e in whole if not e.claimed][: int(count)])


def _their_own_queue(roster: Roster, mention: Mention) -> bool:
    """``five cars wait in a queue``, ``behind a truck in a queue``: they are the queue."""
    several = max(len(roster.subject), len(roster.entities)) > 1
    within = mention.stands_after("in") and several and not mention.dirs
    end = mention.stands_after("of") and bool(roster.groups)
    return mention.is_mass and (within or end)


def _we(roster: Roster, mention: Mention) -> list[Entity]:
    """``three of us``: the ego and two more."""
    whole = mention.whole
    if mention.pronoun != "count" or whole is None or not any(e.ego for e in whole.entities):
        return []
    count, basis = int(mention.mods[0].data["number"]), Basis(mention.i, whole.j)
    ego = the_ego(roster, ParticipantKind.CAR, basis)
    further = range(min(count, _MOST) - 1)
    others = [roster.new(roster.teller, basis) for _ in further]
    if others:
        roster.groups.append(Group(others, vague=False))
    return [ego, *others]


def _driver_of(roster: Roster, reading: Reading, mention: Mention) -> Entity | None:
    """``the driver behind us brakes late, his van hits us``: who is so far named as a driver."""
    own = mention.mod("possessive") if mention.opened_by("its") and not reading.plural else None
    if own is None or roster.tokens[own.i].low not in word_list("somebodys"):
        return None
    named = (e for e in reversed(roster.recent) if "somebody" in e.named_by and not e.ego)
    driver = next((e for e in named if e.kind is ParticipantKind.CAR), None)
    return driver if reading.kind not in ON_FOOT else None


def _noun(
    roster: Roster, reading: Reading, mention: Mention, exclude: list[Entity]
) -> list[Entity]:
    basis = Basis(mention.i, mention.j)
    if reading.ego and not reading.plural:
        ego_by_order(roster, mention)
        if mention.prep is None and (mention.joined is not None or not exclude):
            last_is_ego(roster, mention)
        if tells(mention) or mine(mention, reading.kind):
            return [the_teller(roster, reading.kind, basis)]
        return [the_ego(roster, reading.kind, basis)]
    of_whom = next((p.who for p in mention.pps if p.value == "of"), None)
    if reading.driver and of_whom is not None:
        return resolve(roster, of_whom, subject=False, exclude=[])
    if parked := opened(reading, mention, roster.entities):
        return parked
    if (inside := vehicle_around(reading, mention)) is not None:
        around = resolve(roster, inside, subject=False, exclude=[])
        roster.enrich(around, reading)
        return around
    if (drives := _driver_of(roster, reading, mention)) is not None:
        drives.kind = reading.kind
        drives.named_by |= reading.called
        return [drives]
    if kin(reading, mention):
        strangers = [e for e in roster.entities if not e.named_by & reading.called]
        exclude = [*exclude, *strangers]  # "a man with his son"
    if meant := known(roster, reading, mention, exclude):
        roster.enrich(meant, reading)
        return meant
    if mention.ranked is not None:
        reading = replace(reading, count=reading.count - 1)
    found = with_the_ranked(mention, roster.introduce(reading, basis))
    numbered = mention.mod("num") is not None and not reading.parked
    numbered = numbered and reading.kind is ParticipantKind.CAR
    numbered = numbered and not (reading.dirs or mention.pps or mention.prep is not None)
    both = mention.opened_by("both") or "both" in mention.marks
    both = both or (mention.opened_by("def") and numbered)
    if both and len(found) == A_PAIR:
        roster.groups[-1].both = True
    return found
