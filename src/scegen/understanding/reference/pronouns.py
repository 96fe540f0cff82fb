"""Decides whom "it", "they", "one", "the other", "the second" and the like mean."""

from scegen.scenario.vocabulary import ANIMALS, ParticipantKind
from scegen.understanding.chunks import Mention
from scegen.understanding.clauses.located import loci_of
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.reference.generic import everybody
from scegen.understanding.reference.mention_words import ENDS
from scegen.understanding.reference.roster import Roster, claimed
from scegen.understanding.words.numbers import POSITIONS
from scegen.understanding.words.terms import Term

_PERSONS = ("ist", "rider", "biker", "driver", "courier")
_MOST = 20
_TWO = 2


def of_pronoun(
    roster: Roster, mention: Mention, exclude: list[Entity], near: str | None
) -> list[Entity]:
    """The participants that a pronoun refers to; ``near`` as in ``discourse.resolve``."""
    which = mention.pronoun
    basis = Basis(mention.i, mention.j)
    if which == "everybody":
        return everybody(mention, roster.draft)
    if which in {"it", "him"}:
        others = any(e not in (*exclude, *roster.measured) for e in roster.recent)
        exclude = [*exclude, *(roster.measured if others else [])]
        beside = [e for e in roster.still_near(near) if e not in exclude]
        told = beside if _word(roster, mention) == "it" else []
        return told or _single(roster, mention, exclude)
    unnamed = which == "they" and (mention.goes_by or "walks" not in mention.marks)
    if unnamed and all(e.ego for e in roster.entities):
        acts = (mention.goes_by or "drives" in mention.marks) and _word(roster, mention) == "they"
        return _new_person(roster, mention) if acts else roster.together([])
    if which in {"they", "both", "all", "neither"}:
        return _together(roster, mention, exclude)
    if which == "other":
        told = [e for e in roster.subject if not e.ego]  # "both …; the other", "each … the other"
        told = told[-1:] if len(roster.subject) == _TWO else []
        left = roster.besides(exclude)
        left = [e for e in left if not e.ego] or left
        rest = roster.claim(1, exclude) or (left if len(left) == 1 else told)
        return rest or [roster.new(ParticipantKind.CAR, basis)]
    if which == "ordinal" and (found := _ordinal(roster, mention, exclude)):
        return found
    if which == "another" or (which == "ordinal" and mention.opened_by("indef")):
        return roster.further(exclude, basis)
    return _counted(roster, mention, exclude, basis)


def _together(roster: Roster, mention: Mention, exclude: list[Entity]) -> list[Entity]:
    """``they``; ``the lead car slows down; both drive 100 km/h``: all who are meant."""
    before = roster.tokens[max(mention.i - 1, 0)].low
    if mention.pronoun == "both" and before in word_list("first_person"):
        near = [e for e in roster.recent if not e.ego]
        return [e for e in roster.entities if e.ego] + near[-1:]  # "us and the van. We both do …"
    number = mention.mod("num")
    joined = roster.joined if roster.subject == roster.joined[-len(roster.subject) :] else []
    count = _TWO if mention.pronoun == "both" else len(joined)
    count = int(number.data["number"]) if number is not None else count
    if joined and len(joined) == count and "walks" not in mention.marks:
        return joined  # "a van and a bus drive ahead of the ego; both brake"
    others = [e for e in roster.entities if not e.ego and e not in exclude]
    afoot = [e for e in others if not e.is_vehicle]
    if mention.pronoun == "they" and "walks" in mention.marks and afoot and number is None:
        return afoot  # "a child waits, the ego comes; they walk across": the child
    apart = mention.pronoun == "both" and not any(e.ego for e in roster.before + roster.subject)
    apart |= mention.pronoun == "they" and any("speaks" in e.named_by for e in roster.entities)
    told = mention.pronoun == "they" and any("speaks" in e.named_by for e in roster.subject[:1])
    if apart and number is None and (len(others) == _TWO or (told and others)):
        return others  # "a van is ahead of us, a bus behind us; they drive 60 km/h"
    meant = roster.together(exclude)
    if number is not None and count != len(meant):
        people = [e for e in everybody(mention, roster.draft) if e not in exclude]
        return people if len(people) == count else meant
    opens = mention.i == 0 or roster.tokens[mention.i - 1].kind == "punct"
    if opens and _word(roster, mention) in word_list("all_of_them") and len(meant) == _TWO:
        return everybody(mention, roster.draft)  # of two one would say "both"
    return meant


def _word(roster: Roster, mention: Mention) -> str:
    return roster.tokens[mention.i].low


def _single(roster: Roster, mention: Mention, exclude: list[Entity]) -> list[Entity]:
    subject, recent = roster.subject, roster.recent
    word = _word(roster, mention)
    if word in word_list("persons"):  # "he" is no woman, "she" no man
        not_so = word_list("women" if word in {"he", "him"} else "men")
        named = ((e, roster.tokens[e.basis.i or 0 : e.basis.j or 0]) for e in roster.entities)
        exclude = [*exclude, *(e for e, own in named if any(t.base in not_so for t in own))]
    afoot = [e for e in recent if not e.is_vehicle and e not in exclude]
    drives, walks = "drives" in mention.marks, "walks" in mention.marks
    if word == "it" and walks and not drives and afoot:
        return afoot[-1:]  # "two cars hide a child; it walks out"
    if word == "it":
        recent = [e for e in recent if e.is_vehicle] or recent
    others = [e for e in recent if "speaks" not in e.named_by]
    if others and word != "that":  # whoever tells it is no "it", and no "he"
        recent = others
        subject = [e for e in subject if "speaks" not in e.named_by]
    if word == "it" and len(subject) > 1:
        others = [e for e in recent if e not in subject]  # "two cars pass; it turns"
        told = roster.before if len(roster.before) == 1 else recent
        recent = others or told  # "a car cuts in while both drive …; it brakes"
    options = subject if len(subject) == 1 and word != "that" else recent[-1:]
    options = _persons(roster, mention, [e for e in recent if e not in exclude], options)
    if word == "it" and any(_person(roster, e) for e in options):
        order = roster.recent
        ahead = mention.prep is not None and mention.prep.value == "ahead"  # "the van ahead of it"
        on_foot = (drives or ahead) and not options[0].is_vehicle
        on_foot = on_foot and options[0].kind not in ANIMALS
        since = order if on_foot else order[order.index(options[0]) + 1 :]
        others = [e for e in since if not _person(roster, e) and e not in exclude]
        # "a rider passes the ego as it turns"; "a child behind a parked car; it is hit"
        options = [e for e in others if drives or not e.still][-1:] or options
    if word in {"he", "she"} and all("speaks" in e.named_by for e in roster.entities):
        return _new_person(roster, mention)  # not the one who tells it
    if "stood" in mention.marks:
        standing = [e for e in recent if e.still and e not in exclude]
        standing = [e for e in options if e.still] or standing[-1:]
        options = standing or options  # "as the ego passes a parked car, it sets off"
    elif drives and any(e.parked for e in options):
        driving = [e for e in recent if e.moving_vehicle and e not in exclude]
        running = [e for e in roster.recent if e.kind in ANIMALS and e not in exclude]
        options = (driving or running)[-1:] or options  # "a van is parked in its lane; it swerves"
    before = roster.before if len(roster.before) == 1 else []
    before = [e for e in before if word != "it" or "speaks" not in e.named_by]  # "I", never "it"
    there = roster.landmark if word == "it" and mention.prep is None else None
    if there is not None and there[1] != "ahead" and there[2] == roster.turns:
        before = there[0]  # "the car behind the ego hits it"
    left = [e for e in (*before, *reversed(recent)) if e not in exclude]
    people = [e for e in left if word == "it" and _person(roster, e) and e.kind not in ANIMALS]
    left = [e for e in left if not (e in people or e.still)] or left  # "a man stops the ego; …"
    other = _new_person(roster, mention) if word in {"he", "she"} and not left else []
    found = [e for e in options if e not in exclude] or left[:1] or other  # "she brakes, he …"
    return found or [e for e in subject if drives and roster.entities == [e]]  # nobody else drives


def _persons(
    roster: Roster, mention: Mention, known: list[Entity], options: list[Entity]
) -> list[Entity]:
    """``he``, ``she``: somebody on foot, on two wheels or called a driver before any vehicle.

    "The ego hits a cyclist; he rides …"; "the driver of a van saw a truck stop; she braked".
    """
    if _word(roster, mention) not in word_list("persons"):
        return options
    known = [e for e in known if e.kind not in ANIMALS] or known
    people = [e for e in known if _person(roster, e)]
    drivers = [e for e in known if "somebody" in e.named_by and e.is_vehicle]
    along = mention.prep is not None and mention.prep.cat == "locus"  # "the van behind him"
    if "drives" in mention.marks or (along and drivers):
        people = drivers or [e for e in people if e.is_vehicle] or people
    elif "walks" in mention.marks:
        people = [e for e in people if not e.is_vehicle] or people
    people = people or drivers
    told = [e for e in options if e in people]
    return told or people[-1:] or options


def _person(roster: Roster, entity: Entity) -> bool:
    """Whether a word for a person named them: "he" or "she" would mean them."""
    last = roster.tokens[(entity.basis.j or 1) - 1].low if entity.basis.i is not None else ""
    return not entity.is_vehicle or last.endswith(_PERSONS)


def _new_person(roster: Roster, mention: Mention) -> list[Entity]:
    """``they pulled out in front of me``: somebody not named before, who drives if not on foot."""
    return [roster.new(mention.goes_by or ParticipantKind.CAR, Basis(mention.i, mention.j))]


def _ordinal(roster: Roster, mention: Mention, exclude: list[Entity]) -> list[Entity]:
    position = POSITIONS[mention.label or "first"]
    vehicles = [e for e in roster.entities if e.moving_vehicle and not e.ego]
    named = vehicles or roster.entities
    group = roster.groups[-1].members if roster.groups else named
    if mention.label in {"former", "latter"}:
        two = [e for e in roster.recent if e not in exclude]
        beside = [e for e in two if roster.landmark is None or e not in roster.landmark[0]]
        two = beside if len(beside) > 1 else two  # "a van ahead of the ego, a bus behind the ego"
        two = two if len(two) > 1 else group  # "the ego follows a bus; a van passes the latter"
        group = list(two[-2:]) if position == 0 or not roster.pair else roster.pair
        roster.pair = group if position == 0 else []
    position += len(group) if position < 0 else 0
    return claimed(group[position : position + 1])


def _counted(roster: Roster, mention: Mention, exclude: list[Entity], basis: Basis) -> list[Entity]:
    which = mention.pronoun
    whole = mention.whole.entities if mention.whole is not None else []
    if whole:  # "one of the cars": no truck
        exclude = [*exclude, *(e for e in roster.entities if e not in whole)]
    named = [e for e in roster.recent if mention.sides & e.sides and e not in exclude]
    if named and which == "one" and mention.opened_by("def"):
        return named[-1:]  # "the one from the left"
    if which == "one" and (known := _known_one(roster, mention, exclude)):
        return known
    number = mention.mod("num") if which in {"count", "others", "further"} else None
    if which == "others" and number is None:
        opened = [g for g in roster.groups if 0 < len(g.free) < len(g.members)]
        return picked(opened[-1].free if opened else roster.besides(exclude))
    count = int(number.data["number"]) if number is not None else 1
    left = [e for e in whole if not e.some]  # "six vehicles: … three cars; one of the cars …"
    free = (roster.claim(count, exclude) or left[:count]) if which != "further" else []
    free = free or (roster.others(exclude, count) if which == "others" else [])
    alike = [e.kind for e in roster.recent if not e.ego and which in {"further", "one"}]
    kind = (alike or [ParticipantKind.CAR])[-1]
    if which in {"others", "further"} and not free:
        return [roster.new(kind, basis) for _ in range(min(count, _MOST))]
    if free or which == "count":
        return picked(free) if which != "further" and not mention.sides else free
    new = which != "one" or bool(roster.recent)
    return [roster.new(kind, basis)] if new else []


def _known_one(roster: Roster, mention: Mention, exclude: list[Entity]) -> list[Entity]:
    """``the one in front``, ``this one``: of those who are known."""
    if not mention.opened_by("def"):
        return []
    others = [e for e in roster.recent if e.is_vehicle and not e.ego and e not in exclude]
    if _word(roster, mention) in word_list("pointing"):
        return others[-1:]
    colour = next((roster.tokens[m.i].low for m in mention.mods if m.value == "colour"), None)
    if colour is not None:  # "the grey one": nobody who is called white
        words = [{t.low for t in roster.tokens[e.basis.i or 0 : e.basis.j or 0]} for e in others]
        return [e for e, own in zip(others, words, strict=True) if colour in own][-1:]
    if last := _of_a_file(roster, mention):
        return last
    there = loci_of(mention) | {ENDS.get(d, d) for d in mention.dirs}
    placed = [e for e in others if e.loci & there]
    alone = bool(there) and len(others) == 1 and not others[0].loci
    alone = alone and (roster.draft.ego is not None or others != roster.subject)  # "a car waits; …"
    return placed[-1:] or (others if alone else [])


def _of_a_file(roster: Roster, mention: Mention) -> list[Entity]:
    """``two vans drive ahead of the ego; the one behind``: the last of them, not behind the ego."""
    group = roster.groups[-1].members if roster.groups else []
    along = (p for p in mention.pps if p.target is None and p.value in ENDS.values())
    prep = next(along, None)
    places = [(e.loci, e.dirs, e.nears) for e in group if not e.still]
    alike = len(places) == _TWO and places[0] == places[1] and any(places[0])
    if prep is None or not alike:
        return []
    which = "first" if prep.value == "ahead" else "last"
    said = Term("label", which, prep.word.i, prep.word.j, data={"in_file": True})
    mention.pps, mention.mods = [], [*mention.mods, said]
    return claimed([group[POSITIONS[which]]])


def picked(entities: list[Entity]) -> list[Entity]:
    """Some of several alike, no matter which."""
    for entity in entities:
        entity.some = True
    return claimed(entities)
