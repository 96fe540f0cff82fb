"""Those who drive, called by a noun that no rule knows, or by none: "a cut-in from the right"."""

from __future__ import annotations

from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term, cat_at, term_at
from scegen.understanding.words.tokens import Token

_OPENERS = frozenset({"det", "num"})
_GOVERNING = frozenset({"prep", "locus", "verb"})
_BETWEEN = frozenset({"label", "dir", "manner", "state"})
_DOINGS = frozenset({"cut_in", "brake", "hard_brake", "u_turn", "lane_change", "swerve"})
_OPENING = frozenset({"det", "manner", "dir", "inert"})
_INSTEAD = "no known kind of road user; as it drives, it is read as a car"


def who_drive(terms: list[Term], tokens: list[Token]) -> list[Term]:
    """The terms with such nouns as cars, which is said.

    A driving verb would else find its subject in the next noun, and turn who does it to whom.
    """
    unknown = [k for k, t in enumerate(terms) if t.cat == "unknown"]
    nouns = [k for k in unknown if cat_at(terms, _opener(terms, k)) in _OPENERS]
    named = [(k, tokens[terms[k].i]) for k in nouns]
    drive = {n.low for k, n in named if _acts(terms, k, _number(n)) or _suffers(terms, k)}
    found = list(terms)
    for k in nouns:  # "follows the EVT until the EVT brakes"
        t = terms[k]
        if tokens[t.i].low in drive:
            found[k] = Term("actor", "car", t.i, t.j, _number(tokens[t.i]), {"instead": _INSTEAD})
    return found


def _number(noun: Token) -> str:
    return "s" if noun.low.endswith("s") else "base"


def _opener(terms: list[Term], k: int) -> int:
    """Where the words before a noun end that are said of it."""
    k -= 1
    while cat_at(terms, k) in _BETWEEN:
        k -= 1
    return k


def _acts(terms: list[Term], k: int, number: str) -> bool:
    verb = term_at(terms, k + 1)
    governed = cat_at(terms, _opener(terms, k) - 1) in _GOVERNING  # "a kid on a BMX shoots out"
    if verb is None or verb.cat != "verb" or governed:
        return False
    forms = {"base", "ed"} if number == "s" else {"s", "ed"}
    return verb.form in forms and verb.value in word_list("driving")


def _suffers(terms: list[Term], k: int) -> bool:
    """``overtakes a Transit``, unless a compound goes on."""
    opener = _opener(terms, k)
    verb, after = term_at(terms, opener - 1), cat_at(terms, k + 1)
    ends = after in {"", "punct", "conj", "prep", "locus", "sub", "verb", "rel"}
    met = verb is not None and verb.cat == "verb" and verb.value in word_list("met_driving")
    return ends and met and terms[opener].value == "indef"


def whose_doing(terms: list[Term]) -> list[Term]:
    """``A cut-in from the right``, ``hard braking ahead of the ego``: a car's, if none is named."""
    if any(t.cat == "actor" and not t.data.get("ego") for t in terms):
        return terms
    found: list[Term] = []
    opens = True
    for k, term in enumerate(terms):
        found.append(term)
        after = term_at(terms, k + 1)
        placed = after is not None and (after.cat == "locus" or after.value == "from")
        placed = placed and term.form not in {"s", "ed"}
        if opens and placed and term.cat == "verb" and term.value in _DOINGS:
            at = term.j
            found += [Term("prep", "of", at, at), Term("det", "indef", at, at)]
            found.append(Term("actor", "car", at, at))
        opens = term.cat == "punct" or (opens and term.cat in _OPENING)
    return found
