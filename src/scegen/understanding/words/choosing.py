"""Chooses among the meanings that a phrase has by itself, by the words around it."""

from scegen.understanding.lexicon import Entry, word_list
from scegen.understanding.words.numbers import POSITIONS
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.terms import Match, Term, begins, longest_match, noun_follows
from scegen.understanding.words.tokens import Token, low_at

_NOMINAL_BEFORE = frozenset(
    {"det", "possessive", "dir", "manner", "num", "quant", "label", "noted", "shape", "quantity"}
)
_VERBAL_BEFORE = frozenset({"actor", "pronoun", "aux", "rel", "neg"})
_RESTS = frozenset({"stop", "park"})
_DOINGS = frozenset({"cut_in", "lane_change", "merge", "overtake", "u_turn"})
_NOUNS = ("place", "inert", "thing", "view", "env", "limit")
_ADJECTIVE_CATS = ("dir", "state", "manner", "label", "control")


def _attributive(match: Match, tokens: list[Token], previous: Term) -> bool:
    """Whether a participle stands before the noun that it describes."""
    following = longest_match(tokens, match.j)
    opens = longest_match(tokens, match.j, match.j + 1)
    if opens is not None and opens.has("possessive", "det"):
        return False  # "struck my vehicle"
    apart = previous.cat not in _VERBAL_BEFORE  # "ego following car, 2 s"
    measured = following is not None and apart and _with_a_number(match, following, tokens)
    # "the van cuts out, stopped car ahead": nobody stops a car
    rests = previous.value == "," and match.form == "ed" and match.get("verb").value in _RESTS
    # after a subject or a comma it is a verb: "a van overtaking cars", "…, overtaking cars"
    describes = measured or rests or (apart and previous.value != ",")
    if not (describes and noun_follows(tokens, match.j)):
        return False
    adverb = previous.cat in {"conj", "manner", "sub"}
    singular = following is not None and following.has("actor") and following.form == "base"
    return not (adverb and singular and match.form == "ed")  # "brakes and struck pedestrian"


def _with_a_number(match: Match, noun: Match, tokens: list[Token]) -> bool:
    """``ego 100 km/h, merging truck 80 km/h``: with no article it is no object, and is measured."""
    bare = noun.only("actor") and noun.form == "base" and match.form == "ing"
    return bare and any(t.kind == "number" for t in tokens[noun.j : noun.j + 2])


def _clause_follows(tokens: list[Token], j: int) -> bool:
    """Whether the next noun has a verb of its own ("because leading vehicle brakes")."""
    for _ in range(6):
        if j >= len(tokens) or tokens[j].kind == "punct":
            return False
        following = longest_match(tokens, j)
        if following is None:
            j += 1
            continue
        verbal = following.has("verb") and following.form in {"s", "ed"}
        if following.has("aux") or (verbal and not following.has("dir")):  # "from the left"
            return not following.has("actor")
        if following.has("sub", "conj", "rel"):
            return False  # "following a car that brakes"
        j = following.j
    return False


def _single_one(tokens: list[Token], j: int) -> bool:
    """``ego and preceding car``: one of several would have an article, or a name, as an object."""
    following = longest_match(tokens, j)
    if following is None or not following.only("actor") or following.form != "base":
        return False
    mass = "mass" in following.get("actor").data
    after = tokens[following.j] if following.j < len(tokens) else None
    named = after is not None and after.kind in {"label", "number"}
    return not mass and (not named or quantity_at(tokens, following.j) is not None)


def is_adverb(token: Token) -> bool:
    """Whether a word ends like an adverb, or is one of time or place ("and later brakes")."""
    return token.low.endswith("ly") or token.low in word_list("adverbs")


def _verb_or_other(match: Match, tokens: list[Token], previous: Term) -> tuple[Entry, bool]:
    """Decides between a verb and the other meanings of its form; says if it is a premodifier."""
    before = previous.cat
    verb = match.get("verb")
    participle = match.form in {"ing", "ed"}
    infinitive = previous.value == "to" and match.form == "base"
    # "the car behind dodges to the left", "the car that we follow dodges a box"
    behind = before in {"locus", "quantity"} or begins(tokens, match.j, "det")
    told = match.form == "s" and behind
    named = match.has("actor") and not told
    if named and not (participle or infinitive) and before not in _VERBAL_BEFORE:
        return match.get("actor"), False  # "a cycle", not "they cycle"
    attributive = _attributive(match, tokens, previous)
    if participle and before in {"conj", "sub", "punct"} and match.has("dir"):
        # "turning left and following vehicle B": without an article it is no adjective
        attributive = _clause_follows(tokens, match.j) or _single_one(tokens, match.j)
    if match.has("place", "dir") and match.get("place").value == "junction":
        # "crossing" describes a vehicle or is what somebody does, unless it is a shaped one
        named = before in {"shape", "control", "det"} or _opens_noun(tokens, previous)
        return match.get("dir" if attributive else "place" if named else "verb"), attributive
    if match.has("dir") and match.get("dir").value == "left":
        return _left_or_gone(match, tokens, previous), False
    if match.form == "base" and (before, previous.value) == ("aux", "be"):
        return match.get(*_ADJECTIVE_CATS, "verb"), False
    if participle and attributive:
        return match.get(*_ADJECTIVE_CATS, "verb"), True
    if match.has("dir", "state", "manner") and attributive:
        return match.get("dir", "state", "manner"), True
    if _must_be_verb(match, tokens, previous):
        return verb, False
    if _names_a_measure(match, tokens, previous):
        return match.get("inert", "limit"), False
    if match.has(*_NOUNS) and match.form in {"base", "s"} and _noun_slot(match, tokens, previous):
        part = match.has("dir") and match.get("dir").value == "rear"
        return match.get("dir") if part else match.get(*_NOUNS), False  # "hit the back of it"
    if match.has("dir") and match.form == "base" and not _verb_due(match, tokens, previous):
        across = match.get("dir").value == "lateral" and not noun_follows(tokens, match.j)
        return (verb if across else match.get("dir")), False  # "they … cross in front of it"
    return verb, False


def _opens_noun(tokens: list[Token], previous: Term) -> bool:
    """``on one crossing``, ``at a busy crossing``: a noun that a preposition or verb governs."""
    if previous.cat not in _NOMINAL_BEFORE | {"unknown"}:
        return False
    return begins(tokens, previous.i - 1, "prep" if previous.cat == "num" else "det")


def _must_be_verb(match: Match, tokens: list[Token], previous: Term) -> bool:
    """``one exits``, ``a car from the left speeds through``, ``all three brake``."""
    if previous.cat == "quant" and previous.value in {"all", "both"}:
        single = tokens[previous.i].low in word_list("each_one")  # "everybody brakes"
        return single or not (match.has(*_NOUNS) and match.form == "s")
    several = previous.cat == "num" and previous.data.get("number", 0) > 1
    several = several or (previous.cat, previous.form) == ("det", "s")  # "the others brake"
    if several and match.form == "base":
        return not noun_follows(tokens, match.j)
    if match.form != "s":
        return False
    if (previous.cat, tokens[previous.i].text) == ("det", "A"):
        return True  # "A brakes, B follows": no article, before a plural
    headed = low_at(tokens, previous.j - 1) in {"way", "direction"}
    if previous.cat in {"dir", "compass"} and headed:
        return True  # "a car coming the other way brakes"
    one = previous.cat == "num" and previous.data.get("number") == 1
    one = one or (previous.cat == "label" and previous.value in POSITIONS)  # "the first brakes"
    of = [low_at(tokens, previous.i - n) for n in (2, 1)] == ["of", "the"] and previous.cat == "num"
    one = one or (of and not match.has("place"))  # "the second of the two brakes"
    sided = previous.cat == "dir" and previous.value in {"left", "right"}
    sided = sided and match.has("inert", "thing")  # "from the left barrels through"
    bare = match.has("thing") and previous.cat not in {"det", "possessive", "num", "quant"}
    if bare and low_at(tokens, match.j) in word_list("where"):
        return True  # "a car without lights stands in the lane"
    return one or sided


def _noun_slot(match: Match, tokens: list[Token], previous: Term) -> bool:
    """Whether a noun may stand here: after an article, an adjective or a preposition."""
    preposed = previous.cat == "prep" and previous.value != "to"
    adverb = previous.cat == "manner" and is_adverb(tokens[previous.j - 1])
    compound = previous.cat == "place" and match.form == "base" and match.has("inert", "place")
    compound = compound or low_at(tokens, previous.i) == "whose"
    told = previous.cat == "quantity" and match.form == "s"  # "at t = 4 s brakes"
    return (previous.cat in _NOMINAL_BEFORE and not (adverb or told)) or preposed or compound


def _verb_due(match: Match, tokens: list[Token], previous: Term) -> bool:
    """Whether a verb is due: after its subject, "to" or a verb of its own ("get off and cross")."""
    controls = previous.cat == "verb" and "control" in previous.data and previous.value != "unknown"
    if controls or previous.cat in _VERBAL_BEFORE or previous.value == "to":
        return True
    joined = previous.cat == "conj" or previous.value == ","
    lateral = match.get("dir").value == "lateral"
    return joined and lateral and not noun_follows(tokens, match.j)


def _not_inflected(match: Match) -> Match:
    """``the neighbouring lane``, ``boxed in``: no noun has such a form."""
    if match.form not in {"ing", "ed"} or not match.has("actor", "thing"):
        return match
    kept = tuple(e for e in match.entries if e.cat not in {"actor", "thing"})
    return Match(kept, match.j, match.form, match.cats - {"actor", "thing"})


def _relates(match: Match, tokens: list[Token], previous: Term) -> bool:
    """``a bus that turns``, ``a bus from the right that turns``."""
    if previous.cat in {"actor", "place", "leg", "thing", "inert"}:
        return True
    after = longest_match(tokens, match.j)
    # "a car ahead that stops", "ahead of it that stops"
    told = {"s"} if previous.cat in {"locus", "pronoun"} else {"s", "ed"}
    verbal = after is not None and (after.has("aux") or after.form in told)
    if previous.value == ")":  # "a van (40 km/h) that changes lanes"
        return verbal or not begins(tokens, match.j, "actor", "place", "thing", "inert", "num")
    adverb = previous.cat == "manner" and is_adverb(tokens[previous.j - 1])  # "there that blocks"
    sided = adverb or previous.cat in {"dir", "compass", "quantity", "locus", "pronoun"}
    if previous.value == ",":  # "a van, also at 80 km/h, that brakes"
        sided = after is not None and after.has("verb")
    return sided and verbal and not begins(tokens, match.j, "actor", "place")


def _before_a_noun(match: Match, tokens: list[Token]) -> bool:
    """``the red car``, ``the red one``: a colour; ``the red`` alone is a light."""
    after = low_at(tokens, match.j)
    noun = begins(tokens, match.j, "actor", "place", "label")
    we = after in word_list("first_person")  # "as it turns green we set off"
    return after in {"one", "ones"} or (noun and not we)


_PRIORITY = (
    "noted", "cue", "control", "side", "env", "view", "actor", "possessive", "det", "pronoun",
    "aux", "neg", "sub", "conj", "quant", "dir", "locus", "state", "place", "prep", "manner",
    "rel", "shape", "leg", "compass", "thing", "label", "copy", "roadmod", "inert",
)  # fmt: skip


def _of_a_kind(match: Match, tokens: list[Token], previous: Term) -> bool:
    """``the cut-in vehicle``, ``a lane-change car``: a doing that tells which one is meant."""
    opens = previous.cat in {"", "det", "punct", "sub"}
    noun = longest_match(tokens, match.j)
    hyphen = match.j - 1 > 0 and tokens[match.j - 1].start == tokens[match.j - 2].end + 1
    owned = low_at(tokens, match.j) in word_list("whose")  # "after the cut-in our car brakes"
    actor = noun is not None and noun.only("actor") and noun.form == "base"
    return opens and hyphen and actor and not owned


def _describes_a_noun(match: Match, tokens: list[Token], previous: Term) -> bool:
    """Whether the only meaning is a verb that stands before the noun it describes."""
    entry = match.entries[0]
    if entry.cat != "verb":
        return False
    if entry.value in _DOINGS and match.form == "base":
        return _of_a_kind(match, tokens, previous)
    return match.form in {"ing", "ed"} and _attributive(match, tokens, previous)


def choose(match: Match, tokens: list[Token], previous: Term) -> tuple[Entry, bool]:
    """The meaning that fits the words around, and whether it is a participle before a noun."""
    match = _not_inflected(match)
    if len(match.entries) == 1:
        return match.entries[0], _describes_a_noun(match, tokens, previous)
    before = previous.cat
    if match.has("noted") and match.has("actor") and before == "det":
        return match.get("noted" if noun_follows(tokens, match.j) else "actor"), False
    if match.has("verb"):
        return _verb_or_other(match, tokens, previous)
    if match.has("rel") and match.has("det"):
        return match.get("rel" if _relates(match, tokens, previous) else "det"), False
    if match.has("label") and match.has("place"):
        return match.get("label" if _before_a_noun(match, tokens) else "place"), False
    if match.has("neg") and match.has("pronoun"):
        listed = begins(tokens, match.j, "det", "actor", "possessive")
        return match.get("neg" if listed else "pronoun"), False
    if match.has("leg") and before == "num":
        return match.get("leg"), False
    inside = before in {"actor", "pronoun", "num", "aux"}
    if match.has("conj") and match.has("manner") and inside:
        return match.get("manner"), False  # "a jogger then ran"
    if match.has("manner") and match.has("label") and before == "det":
        return match.get("label"), False
    return match.get(*_PRIORITY), False


def _left_or_gone(match: Match, tokens: list[Token], previous: Term) -> Entry:
    """``left`` is nearly always the side; "V1 left the road" has a subject and an object."""
    before = {previous.cat, previous.value}
    subject = bool(before & {"actor", "pronoun", "aux", ")"})  # "a cyclist (V2) left the …"
    after = low_at(tokens, match.j)
    left = after != "lane" and begins(tokens, match.j, "det", "possessive", "place", "manner")
    left = left or after in word_list("leaving")
    return match.get("verb" if subject and left else "dir")


def _names_a_measure(match: Match, tokens: list[Token], previous: Term) -> bool:
    """``speed 50 km/h``, ``speed difference``, ``limit 60 km/h``: what is measured, not a verb."""
    speed = match.has("inert") and match.get("verb").value == "speed"
    if match.form != "base" or not (speed or match.has("limit")):
        return False
    if previous.cat in {"", "punct"}:
        return True  # "speed ego = 80 km/h"
    if previous.cat in {"aux", "pronoun"} or previous.value == "to":
        return False
    following = tokens[match.j : match.j + 1]
    return all(t.kind in {"number", "punct"} or t.low in word_list("measures") for t in following)
