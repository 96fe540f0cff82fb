"""Groups terms into noun phrases and events."""

from dataclasses import replace
from itertools import pairwise, takewhile

from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.naming import name_further, name_noun, numbered
from scegen.understanding.phrases.nominal import (
    ENDS,
    OPENERS,
    WAYS,
    compound_end,
    ego_owns,
    event_of,
    governed,
    has_dir,
    is_nominal,
    loose_modifier,
)
from scegen.understanding.phrases.predicates import between_lanes, with_particles
from scegen.understanding.words.numbers import POSITIONS
from scegen.understanding.words.terms import Term, term_at
from scegen.understanding.words.tokens import Token

_MODIFIERS = frozenset(
    {"dir", "state", "label", "noted", "shape", "control", "compass", "roadmod", "cue", "quantity"}
)
_STRAY = frozenset({"manner", "env", "quantity"})
_MAX_MODS = 10
_SIDE_WORDS = 2
_COMING_FROM = frozenset({"opposite", "ahead", "behind", "lateral", "adjacent"})
_VEHICLES = frozenset({"car", "van", "truck", "bus", "motorcycle", "bicycle"})
_SIDE_DIRS = frozenset({"left", "right", "opposite", "front", "rear", "adjacent", "straight"})


class Chunker:
    """Reads the terms once, from left to right."""

    def __init__(self, terms: list[Term], tokens: list[Token]) -> None:
        self._terms = terms
        self._tokens = tokens
        self._chunks: list[Chunk] = []

    def run(self) -> list[Chunk]:
        """All chunks in order."""
        k = 0
        while k < len(self._terms):
            k = self._chunk_at(k)
        return between_lanes(with_particles(self._chunks, self._tokens), self._tokens)

    def _add(self, chunk: Chunk, k: int) -> int:
        """Takes a chunk that ends before term ``k``."""
        self._chunks.append(chunk)
        return k

    @property
    def _last(self) -> Chunk | None:
        return self._chunks[-1] if self._chunks else None

    def _chunk_at(self, k: int) -> int:
        term = self._terms[k]
        if term.cat == "verb" and term.data.get("noun"):
            return self._add(self._breach(term), k + 1)
        if term.cat == "verb" and not term.premod:
            return self._add(event_of(term, []), k + 1)
        if term.cat == "pronoun":
            return self._add(Mention(term.i, term.j, [], term, pronoun=term.value), k + 1)
        if (term.cat, term.value) == ("possessive", "mine"):
            return self._add(self._mine(term), k + 1)
        if (term.cat, term.value) == ("possessive", "genitive"):
            owner = self._last
            if not isinstance(owner, Mention):
                return self._add(term, k + 1)
            owner.possessor = True
        reached = self._noun_phrase(k)
        return self._add(term, k + 1) if reached is None else reached

    def _breach(self, term: Term) -> Event:
        """``red light violation``: a noun of a doing with what it is done to before it."""
        event = event_of(term, [], nominal=True)
        before = self._last
        event.object = before if isinstance(before, Place) and before.j == term.i else None
        return event

    def _mine(self, term: Term) -> Mention | Place:
        """``his car hits mine``: the teller's vehicle, or a place of the kind named last."""
        last = next((c for c in reversed(self._chunks) if _owned(c)), None)
        touched = self._last is not None and self._last.value == "with"
        if touched or isinstance(last, Mention):
            head = Term("actor", "ego", term.i, term.j, data={"ego": True, "me": True})
            return Mention(term.i, term.j, [], head, heads=[head])
        kind = last.kind if isinstance(last, Place) else "lane"
        mine = [replace(term, value="first_person")]
        return Place(term.i, term.j, mine, None, None, kind=kind)

    def _is_adverb(self, term: Term) -> bool:
        last = self._tokens[term.j - 1].low
        return last.endswith("ly") or (term.cat == "manner" and term.value == "mild")

    def _scan(self, k: int) -> tuple[list[Term], int]:
        """Words before a head from term ``k`` on, and where the head would stand."""
        mods: list[Term] = []
        m = k
        while m < len(self._terms) and len(mods) < _MAX_MODS:
            term = self._terms[m]
            other = self._tokens[term.i].low == "other"
            further = other and bool(mods) and mods[-1].cat == "num"
            closed = mods and mods[-1].cat != "quant" and not further  # "three other cars"
            if closed and term.cat in {"det", "possessive"}:
                break
            if term.cat == "manner":
                opened = any(t.cat in OPENERS for t in mods)
                sided = bool(mods) and mods[-1].cat == "dir"  # "from the left also going on"
                if self._is_adverb(term) and (sided or not opened):
                    break
            elif not (term.cat in OPENERS | _MODIFIERS or loose_modifier(self._terms, m, mods)):
                break
            mods.append(term)
            m += 1
        return mods, m

    def _noun_phrase(self, k: int) -> int | None:
        mods, m = self._scan(k)
        head = self._term(m)
        owner = self._owner()
        if head.cat == "actor":
            ours = self._tokens[head.i].low in word_list("first_person")
            if ours and any(m.cat in _STRAY or (m is mods[-1] and m.cat == "det") for m in mods):
                return self._bare(mods, k)  # "so close I can't see it", "after that our car brakes"
            if self._side_before_number(mods):
                return self._side(mods, k)
            thing = self._term(m + 1)
            if thing.cat == "thing" and thing.value != "door":
                return self._thing(mods, thing, m + 1, owner)  # "a truck tyre"
            return self._mention(mods, m, owner)
        if head.cat in {"place", "view", "thing", "inert", "leg"}:
            return self._thing(mods, head, m, owner)
        others = bool(mods) and _are_others(mods[0])  # "the others go left"
        if not others and is_nominal(mods, head, self._term(m + 1), self._chunks):
            coming = head.form == "ing" and mods[-1].value in _COMING_FROM
            if any(mod.cat == "num" for mod in mods) and (coming or not has_dir(mods)):
                return self._bare(mods, k)
            return self._add(event_of(head, mods, nominal=True), m + 1)
        return self._bare(mods, k)

    def _side_before_number(self, mods: list[Term]) -> bool:
        """``from the left two cars come``: the number begins a noun phrase of its own."""
        governed = self._last is not None and self._last.cat == "prep"
        before = (a for a, b in pairwise(mods) if b.cat in {"num", "quant"})
        return governed and any(a.cat == "compass" or a.value in {"left", "right"} for a in before)

    def _owner(self) -> Mention | None:
        previous = self._last
        return previous if isinstance(previous, Mention) and previous.possessor else None

    def _bare(self, mods: list[Term], k: int) -> int | None:
        """Modifiers without a head: "one", "another", "both", "from the right"."""
        if not mods:
            return None
        first = mods[0]
        after = self._term(k + 1)
        if _are_others(first):
            return self._stand_alone(mods[:1], "others", k)
        if first.cat == "num" and len(mods) == 1 and _are_others(after):
            return self._stand_alone([first, after], "others", k)  # "two others"
        if first.value == "other" and len(mods) > 1 and mods[1].data.get("number", 0) > 1:
            return self._stand_alone(mods[:2], "others", k)  # "the other three"
        if first.cat == "num" and first.data["number"] in range(1, 10):
            coming = mods[1:2] if mods[1:] and mods[1].value in _COMING_FROM else []
            named = "one" if first.data["number"] == 1 else "count"
            return self._stand_alone([first, *coming], named, k)  # "one", "one oncoming"
        if first.cat == "det" and first.value in {"another", "other"}:
            return self._one_after(self._stand_alone(mods[:1], first.value, k))
        second = mods[1] if len(mods) > 1 else None
        last_in_run = len(mods) < 3 or mods[2].cat in {"num", "quantity"}  # "takes the second left"
        if first.cat == "det" and second and second.value in POSITIONS and last_in_run:
            mention = Mention(first.i, second.j, mods, None, pronoun="ordinal", label=second.value)
            return self._one_after(self._add(mention, k + 2))
        compared = self._tokens[after.i].low in word_list("compared") and first.value == "def"
        if compared and self._term(k + 2).value == "of":
            return self._stand_alone([first, after], "one", k)  # "the slower of the two"
        one = next((m for m, mod in enumerate(mods) if mod.value == "one"), 0)
        verb = self._term(k + one + 1)  # "on the left one pulls out"
        acts = (verb.cat, verb.form) == ("verb", "s")
        side_first = one == _SIDE_WORDS and governed(self._chunks) and acts
        opened = first.value == "def" or (first.value == "indef" and one > 1)
        if one > 0 and opened and not side_first:  # "the one", "the red one", "a slow one"
            mention = Mention(first.i, mods[one].j, mods[:one], None, pronoun="one")
            return self._add(mention, k + one + 1)
        return self._everybody(mods, k) or self._side(mods, k)

    def _everybody(self, mods: list[Term], k: int) -> int | None:
        """``both``, ``all``, ``all three``; ``both initially (drive)``."""
        while len(mods) > 1 and mods[-1].cat == "manner":
            mods = mods[:-1]
        first, counted = mods[0], [m for m in mods[1:] if m.cat == "num"]
        whole = first.cat == "quant" and first.value in {"both", "all"}
        if not whole or len(mods) != 1 + len(counted):
            return None
        opens = first.value == "both" and not any(isinstance(c, Mention) for c in self._chunks)
        rest = takewhile(lambda t: t.value not in {".", ";"}, self._terms[k:])
        opens = opens and all(t.cat != "actor" for t in rest)
        if opens and not any("ego" in t.data for t in self._terms[k:]):  # "Both at 80 km/h. …"
            car = Term("actor", "car", first.i, first.j, "s", data={})
            return self._add(Mention(first.i, first.j, mods, car, heads=[car]), k + 1)
        return self._stand_alone(mods, first.value, k)

    def _term(self, k: int) -> Term:
        return term_at(self._terms, k)

    def _one_after(self, k: int) -> int:
        """``the other one``: the numeral adds nothing."""
        term = self._term(k)
        return k + ((term.cat, term.value) == ("num", "one"))

    def _stand_alone(self, mods: list[Term], pronoun: str, k: int) -> int:
        return self._add(Mention(mods[0].i, mods[-1].j, mods, None, pronoun=pronoun), k + len(mods))

    def _side(self, mods: list[Term], k: int) -> int | None:
        """``the right``, ``right front``, ``the north``: a side named without a noun."""
        length = 0
        seen = False
        for mod in mods:
            side = (mod.cat == "dir" and mod.value in _SIDE_DIRS) or mod.cat == "compass"
            if not side and (seen or mod.cat not in {"det", "possessive"}):
                break
            if seen and mod.value in WAYS:
                break  # "from the right straight on"
            seen = seen or side
            length += 1
        owner = self._owner()
        placed = governed(self._chunks) or mods[0].cat in {"det", "possessive"}
        of = self._term(k + length).value == "of"
        placed = placed or (of and mods[0].value in ENDS)  # "front of ego hits rear of van"
        if not seen or not (placed or owner is not None):
            return None
        used = mods[:length]
        return self._add(Place(used[0].i, used[-1].j, used, None, owner, kind="side"), k + length)

    def _mention(self, mods: list[Term], m: int, owner: Mention | None) -> int:
        heads = [self._terms[m]]
        m += 1
        while m < len(self._terms) and self._terms[m].cat == "actor":
            if "speaks" in self._terms[m].data:
                break  # "the lorry we follow"
            heads.append(self._terms[m])
            m += 1
        start = mods[0].i if mods else heads[0].i
        mention = Mention(start, heads[-1].j, mods, heads[-1], owner, heads=heads)
        mention.label = heads[-1].data.get("label") if len(heads) == 1 else None
        mention.negated = mention.has("det", "negative")
        m = name_noun(mention, m, self._terms, self._tokens)
        mention.possessor = ego_owns(heads, self._term(m))
        m = self._at_rest(mention, m)
        further, m = name_further(mention, m, self._terms, self._tokens)
        self._chunks += [mention, *further]
        return m

    def _at_rest(self, mention: Mention, m: int) -> int:
        """``two cars already at rest``, ``a car stranded there``: not of who acts."""
        adverb = m + (m < len(self._terms) and self._is_adverb(self._terms[m]))
        state = self._term(adverb)
        if state.cat != "state":
            return m
        mention.mods = [*mention.mods, state]
        return adverb + 1

    def _thing(self, mods: list[Term], head: Term, m: int, owner: Mention | None) -> int:
        start = mods[0].i if mods else head.i
        counted = head.value == "lane" and bool(mods) and mods[-1].cat == "num"
        if counted and (road := self._term(m + 1)).cat == "place":  # "a three-lane motorway"
            return self._thing([*mods, head], road, m + 1, owner)
        if head.cat in {"place", "leg"}:
            last = m + numbered(head, m + 1, self._terms, self._tokens)
            place = Place(start, self._terms[last].j, mods, head, owner, kind=head.value)
            return self._add(place, last + 1)
        kind = head.cat if head.cat == "view" else head.value
        end = compound_end(head, self._term(m + 1), self._chunks)
        thing = Thing(start, end.j, mods, head, owner, kind=kind)
        return self._add(thing, m + 1 + (end is not head))


def _are_others(term: Term) -> bool:
    """``the others``, ``the rest``."""
    return (term.cat, term.value, term.form) == ("det", "other", "s")


def _owned(chunk: Chunk) -> bool:
    """What "mine" may be: a place, or a vehicle."""
    if isinstance(chunk, Place):
        return chunk.kind != "flank"
    return isinstance(chunk, Mention) and chunk.head is not None and chunk.head.value in _VEHICLES
