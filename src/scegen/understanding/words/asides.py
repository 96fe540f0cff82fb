"""Words that the reader does not know must not part those that it knows.

``a brindled van``, ``bloopily brakes``, ``at an unvarying 60 km/h``, ``brakes, as agreed, at
6 m/s²``, ``a van (see annex B)``: adjectives, adverbs and asides are put aside, and reported.
"""

from collections.abc import Iterator
from itertools import pairwise

from scegen.understanding.lexicon import known_words, word_list
from scegen.understanding.words.numbers import number_at
from scegen.understanding.words.quantities import quantity_at
from scegen.understanding.words.tagging import tag
from scegen.understanding.words.terms import NOTHING, Match, Term, begins, longest_match, term_at
from scegen.understanding.words.tokens import Token, low_at

_OPENS_A_NOUN = frozenset({"det", "possessive", "num", "quant", "label", "state", "dir", "prep"})
_DESCRIBES = frozenset({"state", "label", "dir", "manner", "shape", "compass", "control", "noted"})
_NAMES = frozenset({"actor", "thing", "place", "inert", "view", "leg", "limit", "side"})
_SPACED = frozenset({"length", "time"})
_ADJECTIVAL = ("ly", "ing", "ed", "ous", "ful", "less", "able", "ible", "ive", "al", "ic", "ish")
_REACH = 4
_SOME_ONE = Match((), 0, "base", frozenset({"num"}))
_JOINTS = frozenset({"and", ","})
_TELLING = frozenset({"actor", "place", "dir", "compass", "env", "control", "shape", "state"})
_AWAY = frozenset({"locus", "dir", "manner", "unknown"})
_ENDS_A_NOUN = frozenset({"prep", "locus", "sub", "aux", "conj", "det"})
_STEADY = frozenset({"mild", "adjective"})
_MARKS = frozenset({",", "(", ")", ".", ";", ":", "!", "?"})
_ENDS = frozenset({".", ";", ":", "!", "?", ""})
_EMPTY = frozenset({"unknown", "inert", "prep", "sub", "det", "aux", "conj", "possessive",
                    "copy", "rel", "neg", "quant"})  # fmt: skip
_OPENS_AN_ASIDE = frozenset({"prep", "sub", "manner"})
_LISTED = frozenset({"det", "num", "conj", "possessive", "actor"})
_SUBJECTS = frozenset({"actor", "unknown", "pronoun", "label", "rel", "aux", "conj", "sub"})
_ANEW = frozenset({"det", "actor", "pronoun", "num", "possessive", "rel", "sub"})


def tag_known(
    text: str, tokens: list[Token]
) -> tuple[list[Token], list[Term], list[tuple[int, int]]]:
    """The tokens that say something, their terms, and where what is not understood stood.

    Returns:
        Tokens, terms, and spans of the text with unknown words that are left out.
    """
    terms = tag(tokens)
    silent = _adverbs(terms, tokens) | _adjectives(terms, tokens)
    silent |= _compounds(text, tokens, silent)
    strange = {t.i for t in terms if "unknown" in {t.cat, t.value} or t.cat == "num"}
    strange |= {i for i in silent if _is_unknown(tokens[i])}
    for aside, inner in _asides(terms, tokens, silent):
        silent |= aside
        if _said(inner, tokens) in word_list("asides"):
            strange -= aside
    if not silent:
        return tokens, terms, []
    kept = [token for i, token in enumerate(tokens) if i not in silent]
    return kept, tag(kept), list(_spans(tokens, silent, strange))


def _spans(tokens: list[Token], silent: set[int], strange: set[int]) -> Iterator[tuple[int, int]]:
    """From the first word that is not understood to the last, in each run of silent ones."""
    run: list[int] = []
    for i in range(len(tokens) + 1):
        if i in silent and tokens[i].kind != "punct":
            run += [i] if i in strange else []
        elif run:
            yield tokens[run[0]].start, tokens[run[-1]].end
            run = []


def _is_unknown(token: Token) -> bool:
    """Whether neither phrases nor lists have the word, in whatever form."""
    bases = (base for base, _ in token.forms)
    known = not known_words().isdisjoint([token.low, *bases])
    return token.kind == "word" and not known and number_at([token], 0) is None


def _adverbs(terms: list[Term], tokens: list[Token]) -> set[int]:
    """``bloopily brakes``, ``brakes jarringly``; but "to comply"."""
    found = set[int]()
    for before, term in pairwise([NOTHING, *terms]):
        token = tokens[term.i]
        if term.j - term.i == 1 and token.low.endswith("ly") and _is_unknown(token):
            verbal = before.cat == "aux" or before.value == "to"
            if not verbal or begins(tokens, term.j, "verb"):
                found.add(term.i)
    return found


def _adjectives(terms: list[Term], tokens: list[Token]) -> set[int]:
    """``a brindled van``, ``an unvarying 60 km/h``, ``a tatty column of lorries``."""
    found = set[int]()
    for k, term in reversed([*enumerate(terms)]):
        if term.cat == "quantity":
            found.update(_before_a_quantity(terms, k, tokens))
        elif term.cat == "unknown" and _is_unknown(tokens[term.i]):
            joined = low_at(tokens, term.j) in _JOINTS and term.j + 1 in found
            stands = term.j in found or joined or _describes(terms, k, tokens)
            if (stands or _within(tokens, term.i)) and _opened(terms, k, tokens):
                found.update(range(term.i, term.j + joined))
    return found


def _compounds(text: str, tokens: list[Token], silent: set[int]) -> set[int]:
    """``a mud-spattered van``, ``the run-of-the-mill ego``; but "a left-flurbing van"."""
    found = set[int]()
    joined = [text[a.end : b.start] == "-" for a, b in pairwise(tokens)]
    i = 0
    while i < len(joined):
        j = i
        while j < len(joined) and joined[j]:
            j += 1
        parts = range(i, j + 1)
        strange = j > i and any(_is_unknown(tokens[k]) for k in parts)
        if strange and (i == 0 or low_at(tokens, i - 1) in word_list("whose") or i - 1 in silent):
            told = any(begins(tokens[: k + 1], k, *_TELLING) for k in parts)
            noun = _noun_at(tokens, j + 1)[0]
            if not told and (j + 1 in silent or (noun is not None and not noun.has("verb"))):
                found.update(parts)
        i = j + 1
    return found


def _before_a_quantity(terms: list[Term], k: int, tokens: list[Token]) -> Iterator[int]:
    """``an unvarying 60 km/h``, ``a measly 5 m``; but "a moose 20 m ahead", "an even 20 m gap"."""
    m = k - 1
    while term_at(terms, m).value in _STEADY or term_at(terms, m).cat == "unknown":
        m -= 1 + (term_at(terms, m - 1).value == "and" and term_at(terms, m - 2).cat == "unknown")
    words = terms[m + 1 : k]
    strange = [t.i for t in words if t.cat == "unknown"]
    away = terms[k].value in _SPACED and not (
        term_at(terms, m - 1).cat == "prep" and term_at(terms, k + 1).cat not in _AWAY
    )
    if not words or (away and not all(tokens[i].low.endswith(_ADJECTIVAL) for i in strange)):
        return
    kept = word_list("undeterred") | word_list("about")
    if term_at(terms, m).value != "indef":
        yield from strange if term_at(terms, m).cat == "prep" else []
    elif (noun := _noun_at(tokens, terms[k].j)[0]) is None or noun.has("verb"):
        yield terms[m].i
        yield from (t.i for t in words if tokens[t.i].low not in kept)
    else:
        yield from strange


def _opened(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """Whether a noun phrase has begun before a term, or begins with it."""
    before, further = term_at(terms, k - 1), term_at(terms, k - 2)
    if before.cat == "unknown" and _is_unknown(tokens[before.i]):
        return _opened(terms, k - 1, tokens)
    if before.value == "and" and further.cat == "unknown" and _is_unknown(tokens[further.i]):
        return _opened(terms, k - 2, tokens)
    return before.cat in _OPENS_A_NOUN or before is NOTHING or before.value in _MARKS


def _within(tokens: list[Token], i: int) -> bool:
    """``in a tatty column``, ``half a puce metre``: whether a phrase closes over the word."""
    if tokens[i - 1].low not in word_list("whose") or begins(tokens, i + 1, *_ENDS_A_NOUN):
        return False
    without = tokens[:i] + tokens[i + 1 :]
    for k in range(max(0, i - _REACH), i):
        phrase, amount = longest_match(without, k), quantity_at(without, k)
        if (phrase is not None and phrase.j > i) or (amount is not None and amount.j > i):
            return True
    return False


def _describes(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """Whether a noun follows that the word may describe; but "a moose following cars"."""
    word, opener = tokens[terms[k].i].low, term_at(terms, k - 1)
    if word.endswith("s") and not word.endswith(("ous", "ss")):
        return False
    noun, doing = _noun_at(tokens, terms[k].j)
    if noun is None or noun.only("num"):
        return noun is not None
    if tokens[noun.j - 1].low in word_list("pace_nouns"):
        return False  # "the design speed": of whom, or of what, it is
    if noun.has("verb") and not noun.has("actor"):
        # "a frobnicated lane change", but "the moose stops", "a moose cut the corner"
        base = noun.form == "base" and opener.cat in {"det", "possessive"}
        return base and low_at(tokens, terms[k].j) not in word_list("alike_in_the_past")
    mass = any("mass" in e.data for e in noun.entries)
    return not doing or (noun.form != "s" and not mass) or word.endswith(_ADJECTIVAL)


def _noun_at(tokens: list[Token], j: int) -> tuple[Match | None, bool]:
    """The noun after some adjectives, and whether one of these is a doing."""
    start, doing = j, False
    while j < start + _REACH and (match := longest_match(tokens, j)) is not None:
        stands_for_it = low_at(tokens, match.j) in {"one", "ones"}
        if stands_for_it or (
            tokens[j].low in word_list("compared") and low_at(tokens, j + 1) == "of"
        ):
            return _SOME_ONE, False  # "a bespoke stopped one", "the tatty slower of two"
        if match.has("prep", "det", "possessive", "pronoun", "aux", "sub"):
            break
        inflected = match.form in {"ing", "ed"}
        doing_named = match.only("verb") and (j > start or match.j > j + 1)
        describes = match.has(*_DESCRIBES) and begins(tokens, match.j, "actor", "verb")
        if not (inflected or describes) and (doing_named or match.has(*_NAMES)):
            return match, doing
        if not (match.has(*_DESCRIBES) or (inflected and match.has("verb"))):
            break
        doing = doing or (inflected and not match.has("state"))
        j = match.j
    return None, doing


def _asides(
    terms: list[Term], tokens: list[Token], silent: set[int]
) -> Iterator[tuple[set[int], list[Term]]]:
    """Each aside that says nothing: its tokens, with the marks that it brings along, its terms."""
    marks = [k for k, t in enumerate(terms) if t.cat == "punct" and t.value in _MARKS]
    for a, b in pairwise([-1, *marks, len(terms)]):
        left, right = term_at(terms, a).value, term_at(terms, b).value
        inner = terms[a + 1 : b]
        if left == "(":
            end = next((k for k in marks if k > a and terms[k].value == ")"), None)
            inner = terms[a + 1 : end]
            if end is not None and _says_nothing(inner, tokens, silent):
                yield set(range(terms[a].i, terms[end].j)), inner
            continue
        commas = {left, right} <= {",", *_ENDS} and "," in {left, right} and left != ":"
        after = term_at(terms, b + 1)
        if not (inner and commas and _is_aside(inner, after, tokens, silent)):
            continue
        drops = set(range(inner[0].i, inner[-1].j))
        if left == "," and (right != "," or _goes_on(terms, a, b)):
            drops.add(terms[a].i)
        if right == ",":
            drops.add(terms[b].i)
        yield drops, inner


def _says_nothing(inner: list[Term], tokens: list[Token], silent: set[int]) -> bool:
    """Whether none of these terms says anything of traffic."""
    if _said(inner, tokens) in word_list("asides"):
        return True
    empty = all(
        t.i in silent
        or (t.cat in _EMPTY and (t.cat != "unknown" or _strange(tokens[t.i])))
        or (t.cat == "num" and tokens[t.i].low.isdigit())
        or t.value in {"mild", "."}
        or (t.cat == "verb" and t.value in word_list("saying_nothing"))
        for t in inner
    )
    words = [t for t in inner if t.cat not in {"num", "punct"}]
    named = len(words) == 1 and len(tokens[words[0].i].text) == 1  # "a car (B)"
    return bool(words) and empty and not named


def _strange(token: Token) -> bool:
    return len(token.low) == 1 or _is_unknown(token)


def _said(inner: list[Term], tokens: list[Token]) -> str:
    return " ".join(token.low for t in inner for token in tokens[t.i : t.j])


def _is_aside(inner: list[Term], after: Term, tokens: list[Token], silent: set[int]) -> bool:
    """``as per annex C``, ``on a gloomy note``; what is told of it after it keeps it."""
    if not _says_nothing(inner, tokens, silent):
        return False
    unknown = any(t.i in silent or "unknown" in {t.cat, t.value} for t in inner)
    first, numbered = inner[0], any(t.cat == "num" for t in inner)
    opens = first.cat in _OPENS_AN_ASIDE or first.i in silent or (len(inner) > 1 and not numbered)
    told = first.cat in {"prep", "det"} and after.cat in {"quantity", "locus", "rel"}
    told = told or (first.cat == "det" and after.cat in _LISTED)
    said = _said(inner, tokens)
    cited = any(said.startswith(f"{words} ") for words in word_list("citing"))
    return (unknown and opens and not told) or cited or said in word_list("asides")


def _goes_on(terms: list[Term], a: int, b: int) -> bool:
    """Whether one clause goes on behind an aside: "the ego, as agreed, brakes, as agreed, at"."""
    before, after = term_at(terms, a - 1), term_at(terms, b + 1)
    return after.cat not in _ANEW and (after.cat != "verb" or before.cat in _SUBJECTS)
