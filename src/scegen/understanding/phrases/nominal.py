"""Words before a noun that are adjectives only there, and verb forms: events, or nouns."""

from scegen.understanding.chunks import Chunk, Event, Mention, Place
from scegen.understanding.words.numbers import POSITIONS
from scegen.understanding.words.terms import Term, term_at

OPENERS = frozenset({"det", "possessive", "num", "quant"})
WAYS = frozenset({"left", "right", "straight"})
_SIDE_ONLY = 2
_NAMED_BY_SIDE = frozenset({"turn", "u_turn", "lane_change", "sharp_turn", "merge", "leave"})
"""Actions that a side tells apart: "the left turn"."""
_OWNED = frozenset({"lane", "path", "side"})
ENDS = frozenset({"front", "rear"})
VERBAL_LINKS = frozenset({"prep", "locus"})


def is_nominal(mods: list[Term], head: Term, following: Term, chunks: list[Chunk]) -> bool:
    """Whether a verb form after these words is a noun ("a sudden stop")."""
    if head.cat != "verb" or head.form == "ed" or "predicate" in head.data:
        return False
    previous = chunks[-1] if chunks else None
    owned = ["dir"] if isinstance(previous, Mention) and previous.possessor else []
    sided = [m.cat for m in mods] in (["possessive", "dir"], owned)
    if sided and head.form in {"s", "ing"}:
        return False  # "the van to the ego's right creeps forward", "the VUT front strikes it"
    counted = [m.value for m in mods if m.cat != "manner"][-1:]
    if counted in (["both"], ["all"]):
        return False  # "both initially go"
    named = any(m.cat in {"label", "noted"} for m in mods) and head.form == "base"
    if not any(m.cat in {*OPENERS, "dir", "manner"} for m in mods) and not named:
        return False  # "evasive lane change" is one as well
    told = isinstance(previous, Event) and previous.control is None
    if mods[0].cat == "dir" and previous is not None and (told or previous.cat == "aux"):
        return False  # "a bus that is oncoming turns left"
    if mods[0].value == "opposite" and len(mods) == 1 and isinstance(previous, Mention):
        return False  # "the car opposite turns left"
    placed = has_dir(mods) or mods[-1].cat == "compass"
    turned = head.value == "turn" and following.cat == "dir"
    turned = turned or mods[-1].cat == "compass" or mods[-1].value in {"front", "rear"}
    if governed(chunks) and placed:  # "cars from the right enter"
        bare = len(mods) <= _SIDE_ONLY and (head.form == "ing" or head.value not in _NAMED_BY_SIDE)
        if bare or head.form == "s" or turned or _after_a_side(chunks):
            return False
    last = next((m for m in reversed(mods) if m.cat != "manner"), mods[-1])
    pronominal = last.cat == "num" or last.value in {"another", "other", *POSITIONS}
    done = mods[0].cat == "manner" and head.form == "s"
    return not (done or (pronominal and head.form != "base"))


def _after_a_side(chunks: list[Chunk]) -> bool:
    """``from the left and the right stop …``: the second side, not a noun."""
    if len(chunks) < 2:
        return False
    place, joint = chunks[-2:]
    if joint.value not in {"and", "or"} or not isinstance(place, Place) or place.kind != "side":
        return False
    return place.mods[0].value != "indef"  # "either a left or a right turn"


def has_dir(mods: list[Term]) -> bool:
    """Whether a direction stands among the words before a noun."""
    return any(m.cat == "dir" for m in mods)


def compound_end(head: Term, following: Term, chunks: list[Chunk]) -> Term:
    """``a construction area``, ``at test start``: the last noun of a compound, or the head."""
    if (following.cat, following.form) != ("verb", "base"):
        return head
    singular = head.value == "noun" and head.form != "s"  # no singular noun has such a verb
    return following if singular and governed(chunks) else head


def ego_owns(heads: list[Term], following: Term) -> bool:
    """``the ego lane``, ``the VUT front strikes the GVT rear``: what follows is theirs."""
    if (following.cat, following.form) == ("dir", "base") and following.value in ENDS:
        return heads[-1].form != "s"
    own = any(h.data.get("ego") for h in heads)
    named = "ranked" in following.data  # "ego middle lane, van left lane"
    return own and following.cat == "place" and following.value in _OWNED and not named


def governed(chunks: list[Chunk]) -> bool:
    """Whether a side named next belongs to a preposition ("from left and right")."""
    return (bool(chunks) and chunks[-1].cat in VERBAL_LINKS) or _after_a_side(chunks)


_ROADS = frozenset({"highway", "road", "ramp"})


def loose_modifier(terms: list[Term], m: int, mods: list[Term]) -> bool:
    """Participles before a noun, and nouns or weather words used as adjectives."""
    term, noun = terms[m], term_at(terms, m + 1)
    if term.cat == "verb" and term.premod:
        return True
    opened = any(t.cat in {*OPENERS, "state"} for t in mods)
    nounlike = {"actor", "place", "thing", "view", "verb", "inert", "shape"}
    several = any(t.data.get("number", 0) > 1 for t in mods) and noun.form == "s"
    if several and noun.cat == "actor" and term.cat in {"place", "inert"}:
        return term.form == "base"  # "three road cyclists"
    if term.cat == "inert":
        return opened and term.value == "adjective" and noun.cat in nounlike
    if term.cat == "place" and term.value in _ROADS:
        mass = noun.cat == "actor" and "mass" in noun.data  # "slow highway traffic"
        return mass and not (m and terms[m - 1].value == "def")
    if term.cat == "env":
        return noun.cat in {"place", "actor"}
    return opened and term.cat == "unknown" and noun.cat in {"actor", "place", "unknown", "thing"}


def event_of(term: Term, mods: list[Term], *, nominal: bool = False) -> Event:
    """The event that a verb makes."""
    start = mods[0].i if mods else term.i
    event = Event(term.value, start, term.j, term.form, nominal=nominal, mods=list(mods))
    event.control = term.data.get("control")
    event.data = term.data
    event.negated = any((m.cat, m.value) == ("det", "negative") for m in mods)
    if "how" in term.data:
        event.mods.append(Term("manner", term.data["how"], term.i, term.j))
    if "way" in term.data:
        event.mods.append(Term("dir", term.data["way"], term.i, term.j))
    return event
