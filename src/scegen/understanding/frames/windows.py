"""What each number of a text is: the words around it, and which frame they make."""

from collections.abc import Collection
from dataclasses import dataclass, replace
from functools import cache

from scegen.understanding.frames.loader import AmountFrame, amounts
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.quantities import Quantity
from scegen.understanding.words.terms import Term, longest_match
from scegen.understanding.words.tokens import Token, low_at

_REACH = 13
_BETWEEN = 3
_NEAR = 5


@cache
def _any_of(*names: str) -> frozenset[str]:
    """The words of some lists."""
    return frozenset(word for name in names for word in word_list(name))


@dataclass(frozen=True, slots=True)
class Window:
    """Words before and after a number, each with a blank at either end.

    What stands after it begins at the token ``resumes``, for two numbers behind the second.
    """

    before: str
    after: str
    resumes: int

    def fits(self, frame: AmountFrame, verbs: frozenset[str]) -> bool:
        """Whether all that a frame asks for is there; ``verbs``: what happens there."""
        if (frame.verb and not verbs & frame.verb) or (frame.ends and self.after.strip()):
            return False
        around = self.before, self.after
        if frame.near and not any(f" {p} " in words for p in frame.near for words in around):
            return False
        if any(self.after.startswith(f" {p} ") or self.preceded(p) for p in frame.unless):
            return False
        if not (frame.before or frame.next or frame.named):
            return True
        after = self.after.replace(" of ", " ", 1) if self.after.startswith(" of ") else self.after
        return (
            any(self.preceded(p) for p in frame.before)
            or any(after.startswith(f" {p} ") for p in (*frame.next, *frame.named))
            or any(self._linked(p) for p in frame.named)
        )

    def _linked(self, name: str) -> bool:
        """Whether the name of a measure stands before, with nothing but small words between."""
        at = self.before.rfind(f" {name} ")
        return at >= 0 and _any_of("fillers", "links").issuperset(
            self.before[at + len(name) + 2 :].split()
        )

    def preceded(self, phrase: str) -> bool:
        """Whether a phrase stands before the number; short words only right before it."""
        at = self.before.rfind(f" {phrase} ")
        if at < 0:
            return False
        if phrase.split(maxsplit=1)[0] not in _any_of("only_before"):
            return True
        return _any_of("fillers").issuperset(self.before[at + len(phrase) + 2 :].split())

    def opens(self, name: str) -> bool:
        """Whether what follows begins with a phrase of a list."""
        return any(self.after.startswith(f" {p} ") for p in word_list(name))

    def closes(self, name: str) -> bool:
        """Whether what stands before ends with a phrase of a list."""
        return any(self.before.endswith(f" {p} ") for p in word_list(name))


def window(tokens: list[Token], i: int, j: int, ends: dict[int, int]) -> Window:
    """The words around the tokens ``i`` to ``j - 1``, a number with its unit.

    ``ends``: where each number of the text begins, by where it ends.
    """
    bracketed = i > 0 and tokens[i - 1].low == "(" and i - 1 in ends
    if bracketed and j < len(tokens) and tokens[j].low == ")":
        return window(tokens, ends[i - 1], j + 1, {})  # "26.7 m (1.6 s) behind": as the first
    aside = tokens[j : j + 1] and tokens[j].low == "," and _opens_aside(tokens, i)
    alone = j == len(tokens) or tokens[j].kind == "punct"
    listed = alone and low_at(tokens, i - 1) == ","  # "a van ahead, 60 m", "ahead of the ego, 60 m"
    near = range(i - 2, max(-1, i - _NEAR - 1), -1) if listed else ()
    begin = next((k + 1 for k in near if _ends_apart(tokens, k, i)), i)
    resumes = _shared(tokens, j, ends)
    return Window(_before(tokens, begin, ends), _after(tokens, resumes + bool(aside)), resumes)


def _ends_apart(tokens: list[Token], k: int, i: int) -> bool:
    """Whether a word of place stands right before a comma, or before "of" and somebody there."""
    last = k == i - 2 or low_at(tokens, k + 1) == "of"
    return last and tokens[k].low in _any_of("places_before_lengths")


def _shared(tokens: list[Token], j: int, ends: dict[int, int]) -> int:
    """``a van 60 m and a bus 75 m ahead``: where what holds for both of two numbers follows."""
    named = longest_match(tokens, j + 1) if j + 1 < len(tokens) else None
    if tokens[j : j + 1] and tokens[j].low in {"and", "or"} and not (named and named.has("verb")):
        for end, begin in ends.items():
            between = {t.low for t in tokens[j + 1 : begin]}
            alike = tokens[end - 1].low == tokens[j - 1].low and 0 <= begin - j - 1 <= _BETWEEN
            own = low_at(tokens, end) in _any_of("faster_than", "slower_than")  # "10 km/h more"
            if alike and not own and not between & {"of", *_any_of("only_before", "clause_words")}:
                return end
    return j


def _opens_aside(tokens: list[Token], i: int) -> bool:
    """``three lengths, roughly 50 feet, behind a car``: whether a comma stands before it."""
    k = i - 1
    while k >= 0 and tokens[k].low in _any_of("fillers"):
        k -= 1
    return k >= 0 and tokens[k].low == ","


def _before(tokens: list[Token], i: int, ends: dict[int, int]) -> str:
    k = i - 1
    found: list[str] = []
    while k >= 0 and len(found) < _REACH:
        token = tokens[k]
        told = token.low == "and" or k in ends or k + 1 in ends
        pair = _both_ends(tokens, k) if told else None
        if pair is not None:
            found.insert(0, "between")
            k = pair - 1
            continue
        opened = _bracketed(tokens, k)
        if opened is not None:  # "behind a van (70 km/h) at 1.8 s"
            k = opened - 1
            continue
        if token.low in {"(", ":"} and _any_of("fillers", "only_before").issuperset(found):
            k -= 1
            continue
        measured = k > 0 and token.low == "when" and tokens[k - 1].low in _any_of("gauged")
        inside = token.low == "between" and tokens[i - 1].low in _any_of("attached_by")
        if token.kind in {"punct", "number"} or k + 1 in ends or inside:
            break
        if token.low in _any_of("clause_words") and not measured:
            break
        found.insert(0, token.low)
        k -= 1
    return f" {' '.join(found)} "


def _bracketed(tokens: list[Token], k: int) -> int | None:
    """Where brackets open that close at a token."""
    if tokens[k].low != ")":
        return None
    return next((b for b in range(k - 1, max(-1, k - _REACH), -1) if tokens[b].low == "("), None)


def _both_ends(tokens: list[Token], k: int) -> int | None:
    """``between the ego and the bus``, ``… at 80 km/h``: where it begins, if an "and" joins them.

    Between one and the other may stand how fast they are.
    """
    for b in range(k, max(-1, k - 2 * _REACH), -1):
        if tokens[b].low == "between" and b + 1 < k and tokens[b + 1].kind != "number":
            return b if any(t.low == "and" for t in tokens[b : k + 1]) else None
        if tokens[b].low in {".", ";", ":"} | _any_of("until", "clause_words") - {"and"}:
            break
    return None


def _after(tokens: list[Token], j: int) -> str:
    k = j
    if k < len(tokens) and tokens[k].low == "(":
        while k < len(tokens) and tokens[k].low != ")":
            k += 1
    while k < len(tokens) and tokens[k].low == ")":
        k += 1
    found: list[str] = []
    while k < len(tokens) and len(found) < _REACH:
        token = tokens[k]
        if token.kind in {"punct", "number"} or token.low in _any_of("clause_words", "further"):
            break
        found += [token.low] if token.kind != "clitic" or found else []  # "2 seconds' distance"
        k += 1
    return f" {' '.join(found)} "


def frame_of(dimension: str, value: float, around: Window, verbs: frozenset[str]) -> AmountFrame:
    """The first frame that fits a number in SI units.

    ``verbs``: what happens in its clause, in the names of the frames; empty if nothing does.
    """
    words = {*around.before.split(), *around.after.split()}
    for frame in amounts(dimension):
        near = not any(cues.isdisjoint(words) for cues in frame.cues)
        if near and (frame.most is None or value <= frame.most) and around.fits(frame, verbs):
            return frame
    return AmountFrame(dimension, "other", instead="a measure that no rule could attach; left out")


class Numbers:
    """The numbers of a text; ``of_the_road``: those that are said of the road (a limit)."""

    def __init__(
        self, terms: list[Term], tokens: list[Token], of_the_road: Collection[Term]
    ) -> None:
        self._tokens = tokens
        found: list[Quantity] = [
            t.data["quantity"]
            for t in terms
            if t.data.get("quantity") is not None and all(t is not r for r in of_the_road)
        ]
        self.quantities = sorted(found, key=lambda q: q.i)
        self._ends = {q.j: q.i for q in found}
        self._around: dict[int, Window] = {}
        self._behind = {t.i: t.j - t.i for t in terms if (t.cat, t.value) == ("locus", "behind")}

    def measured(
        self, quantity: Quantity, verb: str = "", at: int | None = None
    ) -> tuple[Window, AmountFrame]:
        """What a number is by its words and its verb, ``at`` a token unless it is over."""
        lemma = [f"to {self._tokens[at].forms[-1][0]}"] if at is not None else []
        around = self._around.get(quantity.i)
        if around is None:
            around = window(self._tokens, quantity.i, quantity.j, self._ends)
            self._around[quantity.i] = around
        if quantity.j in self._behind:  # "20 m after the lead", "1.9 s astern"
            rest = around.after.split()[self._behind[quantity.j] :]
            around = replace(around, after=f" {' '.join(['behind', *rest])} ")
        low, verbs = quantity.value.low, frozenset([verb, *lemma])
        return around, frame_of(quantity.dimension, low, around, verbs)
