"""Things on and beside the road: what blocks, what hides, also what no lexicon lists."""

from scegen.scenario.vocabulary import HazardKind
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES, chunk_at
from scegen.understanding.reference.describing import carried
from scegen.understanding.words.terms import NOTHING, Term

_IN_THE_WAY = 9
_CARRIAGEWAY = frozenset({"road", "lane", "highway", "path", "crosswalk", "middle"})
_REACH = 4
_BESIDE = "things beside the road are built only where they hide somebody"
_TOWED = "what a vehicle tows is not modelled"
_ENDS = frozenset({"punct", "conj", "locus"})
_FOR_IT = frozenset({"avoid", "brake", "hard_brake", "stop", "slow", "swerve"})


def read_thing(thing: Thing, k: int, chunks: list[Chunk], draft: Draft) -> None:
    """What a thing on or beside the road means."""
    basis = Basis(thing.i, thing.j)
    possessed = thing.owner is not None or thing.has("possessive")
    chased = draft.tokens[max(thing.i - 1, 0)].low == "after"
    none = any((m.cat, m.value) == ("det", "negative") for m in thing.mods)
    none = none or (thing.stands_after("without"))
    if none or chased or _bursts(thing, draft):
        return  # "no obstruction"; "a child runs after a ball": where it goes, not where it lies
    lost = possessed and _comes_off(thing, draft)
    if thing.kind == "obstacle" and not lost and (possessed or _held(thing, k, chunks, draft)):
        return  # "its tyre bursts", "a man with a parcel": a part of somebody
    if thing.kind == "obstacle" or (
        thing.kind == "object" and _in_the_way(thing, k, chunks, draft)
    ):
        draft.hazard(HazardKind.OBSTACLE, basis, [])
        draft.lying.append(thing)
    elif thing.kind == "object":
        towed = (thing.head.data.get("thing") if thing.head else None) == "trailer"
        draft.note(thing.i, thing.j, _TOWED if towed else _BESIDE)
    elif thing.kind == "view" and any(m.cat == "verb" for m in thing.mods):
        who = next((c for c in chunks[k + 1 : k + 4] if isinstance(c, Mention)), None)
        owing = who is not None and who.stands_after("due", "by")  # "due to parked cars"
        draft.hazard(HazardKind.OCCLUSION, basis, who.entities if who and owing else [])


def _in_the_way(thing: Thing, k: int, chunks: list[Chunk], draft: Draft) -> bool:
    """``a wall stands in the ego's lane``, ``a bin on the road``, ``brakes for a caravan``."""
    if thing.stands_after("with") and isinstance(chunk_at(chunks, k - 2), Mention):
        return False  # "the one with the trailer"
    if thing.prep is None or thing.prep.value == "for":
        before = [c for c in chunks[max(0, k - 2) : k] if isinstance(c, Event)][-1:]
        if before and not before[0].nominal and before[0].name in _FOR_IT | {"tow"}:
            return before[0].name != "tow"
    put = False
    for m, chunk in enumerate(chunks[k + 1 : k + _IN_THE_WAY], k + 2):
        if isinstance(chunk, Place) and put and chunk.kind in _CARRIAGEWAY:
            return True
        if isinstance(chunk, Event):
            put = chunk.name == "block"
        elif chunk.cat == "prep":
            put = draft.tokens[chunk.i].low in word_list("upon") or chunk.value == "into"
        elif chunk.cat == "conj" and isinstance(chunk_at(chunks, m), Event):
            continue  # "stands at the kerb and juts into the lane"
        elif chunk.cat in _ENDS if isinstance(chunk, Term) else not put and chunk.prep is None:
            return False
    return False


def _bursts(thing: Thing, draft: Draft) -> bool:
    """``a tyre bursts``, ``a tire goes flat``: on the vehicle, not on the road."""
    tyre = draft.tokens[thing.j - 1].forms[-1][0] in {"tyre", "tire"}
    after = {t.low for t in draft.tokens[thing.j : thing.j + _REACH]}
    return tyre and bool(after & word_list("bursting"))


def _comes_off(thing: Thing, draft: Draft) -> bool:
    """``the truck's cargo falls onto the road``, ``sheds its load``: no longer a part of it."""
    words = [t.forms[-1][0] for t in draft.tokens[thing.j : thing.j + _REACH]]
    before = [t.forms[-1][0] for t in draft.tokens[max(0, thing.i - 2) : thing.j]]
    return bool(word_list("falling") & set(words) or word_list("shedding") & set(before))


def _held(thing: Thing, k: int, chunks: list[Chunk], draft: Draft) -> bool:
    """Whether it is with somebody on foot, or aboard."""
    who = chunk_at(chunks, k - 2)
    along = thing.stands_after("with")
    if along and thing.head is not None and "part" in thing.head.data:
        return True  # "parked with a flat tyre"
    afoot = isinstance(who, Mention) and any(not e.is_vehicle for e in who.entities)
    return (along and afoot) or carried(thing, chunks, draft.tokens)


_OPENERS = frozenset({"det", "possessive"})
_DESCRIBING = frozenset({"unknown", "label", "inert", "state", "noted", "env"})
_NOUN_ENDS = frozenset({"prep", "conj", "sub", "rel", "aux", "locus", "punct", "manner", "copy"})
_LONGEST = 5


def name_hiders(chunks: list[Chunk]) -> list[Chunk]:
    """The chunks, with unknown nouns after "behind" and "hidden by" as things."""
    found: list[Chunk] = []
    end = 0
    for k, chunk in enumerate(chunks):
        if k < end:
            continue
        found.append(chunk)
        end = _end(chunks, k + 1) if _hides(chunks, k) else 0
        if end:
            *before, last = chunks[k + 1 : end]
            mods = [w for w in before if isinstance(w, Term)]
            head = Term("thing", "object", last.i, last.j)
            found.append(Thing(chunks[k + 1].i, last.j, mods, head, kind="object"))
    return found


def _hides(chunks: list[Chunk], k: int) -> bool:
    """Whether what stands after this word is something one cannot see through."""
    word = chunks[k]
    if not isinstance(word, Term):
        return False
    if word.cat == "locus":
        return word.value in {"behind", "between"}
    before = chunks[max(0, k - 2) : k]
    hidden = any(isinstance(c, Event) and c.name == "hide" and c.form == "ed" for c in before)
    return word.value == "by" and hidden


def _end(chunks: list[Chunk], k: int) -> int:
    """Where a noun with an article ends whose last word is in no lexicon; 0 if none begins."""
    opener = chunk_at(chunks, k)
    if opener.cat not in _OPENERS:
        return 0
    m = k + 1
    while m < len(chunks) and m - k < _LONGEST:
        chunk = chunks[m]
        noun_like = isinstance(chunk, Event) and chunk.form == "base" and m > k + 1
        if not (noun_like or (chunk.cat in _DESCRIBING)):
            break
        m += 1
    last, after = chunks[m - 1], chunk_at(chunks, m)
    named = m > k + 1 and (isinstance(last, Event) or last.cat == "unknown")
    ends = after is NOTHING or after.cat in _NOUN_ENDS or after.value in BOUNDARIES
    verb = isinstance(after, Event) and after.form in {"s", "ed", "ing"}
    return m if named and (ends or verb) else 0
