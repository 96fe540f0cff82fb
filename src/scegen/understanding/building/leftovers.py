"""Reports words that matter but that no field holds, and words that no rule understood."""

from itertools import groupby

from scegen.scenario.evidence import Unsupported
from scegen.scenario.functional import FunctionalScenario
from scegen.understanding.building.coverage import with_remarks
from scegen.understanding.chunks import Chunk, Event, Mention, Place
from scegen.understanding.draft import Draft
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import chunk_at, value_at
from scegen.understanding.words.numbers import POSITIONS
from scegen.understanding.words.terms import Term

_QUALITIES = frozenset({"colour", "quality"})
_PLACES = {
    "ramp": "ramps are built where somebody joins or leaves by them; here the plain road is",
    "exit": "exits of a road are built where somebody leaves by one; here the plain road is",
    "bus_stop": "bus stops are built only where somebody stands at one",
    "feature": "this shape of road is not built; a level, plain road is",
    "parking": "bays are built only where somebody is parked; this one is not",
}
ONE_RAMP = "one ramp, or lane that ends, is built; this other one is left out"
_NOT_DRIVEN_OVER = "nobody is driven over one; who comes over it is on this side from the start"
_NOBODY_THERE = "nobody is put on a median; where they are is left open"
_ONE_LANE = "nobody is shared out among lanes: those told of together are in one"
_PLACE_IN_A_ROW = "which place in a row it has is not read from that"
_NOT_UNDERSTOOD = "not understood, ignored"
_MOST_NOTES = 200


def report(draft: Draft, terms: list[Term], chunks: list[Chunk], *, crossing: bool) -> None:
    """Adds a note for everything that is not expressed; at a ``crossing`` exits are its arms."""
    known = {c.label_at for c in chunks if isinstance(c, Mention)}
    events = (c for c in chunks if isinstance(c, Event) and c.name != "unknown")
    known |= {i for event in events for i in range(event.i, event.j)}
    bases = [e.speed_basis for e in draft.entities if e.speed_basis]  # "20 km/h faster"
    known |= {i for basis in bases for i in range(basis.i or 0, basis.j or 0)}
    _unknown(draft, [t for t in terms if t.i not in known])
    beside = [t for t in terms if t.cat == "place" and "auxiliary" in t.data]
    for term in beside:
        other = term.data["auxiliary"] != beside[0].data["auxiliary"]
        if other or draft.tokens[max(term.i - 1, 0)].low in word_list("one_more"):
            draft.note(term.i, term.j, ONE_RAMP)
    for term in terms:
        if "median" in term.data:
            on = "on" in {t.low for t in draft.tokens[max(term.i - 2, 0) : term.i]}
            if on or _gone_over(draft, term):
                draft.note(term.i, term.j, _NOBODY_THERE if on else _NOT_DRIVEN_OVER)
        if term.cat in {"noted", "place", "manner"} and "instead" in term.data:
            calls = [e.on_call for e in draft.entities if e.on_call is not None]
            # not what tells, once or again, by what an emergency vehicle is on call
            if not ("on_call" in term.data and any((b.i or 0) <= term.i for b in calls)):
                draft.note(term.i, term.j, term.data["instead"])
        elif term.cat == "place" and term.value in _PLACES and not _used(draft, term, crossing):
            draft.note(term.i, term.j, _PLACES[term.value])
    for chunk in chunks:
        if isinstance(chunk, Mention):
            _mention(draft, chunk)
    _shared_out(draft, chunks)
    del draft.notes[_MOST_NOTES:]


def _shared_out(draft: Draft, chunks: list[Chunk]) -> None:
    """``two lanes of stopped cars``, ``in both lanes``; ``drives fifth in a row of eight``."""
    for k, place in enumerate(chunks):
        if place.cat == "label" and draft.tokens[place.i].low in POSITIONS:
            row = chunk_at(chunks, k + 2)
            before = next((c for c in reversed(chunks[:k]) if isinstance(c, Mention | Event)), None)
            own = before.entities if isinstance(before, Mention) else []
            ranked = isinstance(row, Mention) and row.ranked is not None
            ranked = ranked or any(p.basis.i == place.i for p in draft.placements)
            if not ranked and not any("ranked" in e.named_by for e in own):
                draft.note(place.i, place.j, _PLACE_IN_A_ROW)
        if not isinstance(place, Place) or place.kind != "lane" or place.head is None:
            continue
        words = {t.low for t in draft.tokens[place.i : place.j]}
        filled = value_at(chunks, k + 1) == "of" and isinstance(chunk_at(chunks, k + 2), Mention)
        if place.head.form == "s" and (filled or words & {"both", "all", "every"}):
            draft.note(place.i, place.j, _ONE_LANE)


def _gone_over(draft: Draft, median: Term) -> bool:
    """``crosses the median``, ``drives over the median``."""
    before = draft.tokens[max(median.i - 3, 0) : median.i]
    driven = any(e.moving_vehicle and not e.ego for e in draft.entities)
    return driven and any({t.low, t.forms[-1][0]} & word_list("going_over") for t in before)


def _used(draft: Draft, term: Term, crossing: bool) -> bool:
    """Whether it is built: a ramp by which somebody comes or leaves, a bay where one stands."""
    if crossing and term.value == "exit":
        return True
    if term.value in {"ramp", "exit"}:
        return any(e.by_ramp is not None or "exits" in e.told for e in draft.entities)
    strips = [(*e.strip, e.ego) for e in draft.entities if e.strip is not None]
    return any(
        (b.i or 0) <= term.i < (b.j or 0) or (ego and strip.value == term.value)
        for strip, b, ego in strips
    )


def _unknown(draft: Draft, terms: list[Term]) -> None:
    """Neighbouring unknown words make one note."""
    for unknown, together in groupby(terms, lambda t: "unknown" in {t.cat, t.value}):
        run = list(together)
        if unknown:
            draft.note(run[0].i, run[-1].j, _NOT_UNDERSTOOD)


def left_out(scenario: FunctionalScenario, spans: list[tuple[int, int]]) -> FunctionalScenario:
    """The scenario with remarks on words that were left out before reading."""
    text = scenario.description
    found = [Unsupported(text=text[i:j], start=i, end=j, instead=_NOT_UNDERSTOOD) for i, j in spans]
    return with_remarks(scenario, [*scenario.unsupported, *found])


def _mention(draft: Draft, mention: Mention) -> None:
    """Vehicles outside the vocabulary, and adjectives that no field holds."""
    for head in mention.heads:
        if "instead" in head.data:
            draft.note(head.i, head.j, head.data["instead"])
    for mod in mention.mods:
        said = any(m.cat == "quantity" and m.j == mod.i for m in mention.mods)  # "12 m long"
        if mod.cat == "label" and mod.value in _QUALITIES and not said:
            draft.note(mod.i, mod.j, "colour, age and size are not modelled")
