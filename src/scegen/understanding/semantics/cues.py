"""Cues of a clause: its words and those around it, and what its verb, phrases and nouns are.

A cue is a word, or a kind with a value: ``event move``, ``manner sudden``, ``on ahead`` (in a
phrase), ``a lane`` (is named), ``to left`` (leads a noun), ``does.tailgating`` (says a noun).
Conditions that need others than a clause has are not asked of it.
"""

from itertools import compress

from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.patterns import ANY, FILTERS, FRONT, listed

SOON, SENTENCE = 5, 24
"""So many words count as near, as the rest of a sentence."""
_NAMED: dict[type, str] = {Mention: "a who", Place: "a place", Thing: "a thing"}
_FLAGS = ("negated ", "passive ", "nominal ")
_BY_VALUES = {"verbless": "event", "measured": "quantity", "how": "manner"} | {
    name: name for name in ("event", "lemma", "form", "above", "negated", "passive", "nominal")
}
"""Conditions of a value, with the kind of the cue that they need."""
_BY_WORDS = frozenset({"own", "via", "mod", "ends", "before", "next", "soon", "opened", "lately",
                       "tells"})  # fmt: skip
_BY_NOUNS = frozenset({"at", "object", "goal", "noun"})


def cues(clause: Clause, context: Context) -> frozenset[str]:
    """All cues of a clause, found once; what changes its event forgets them."""
    clause.cues = clause.cues or frozenset(_found(clause.event, context.words))
    return clause.cues


def _found(event: Event, words: list[str]) -> set[str]:
    flags = compress(_FLAGS, (event.negated, event.passive, event.nominal))
    found = {f"event {event.name}", f"lemma {event.lemma}", f"form {event.form}", *flags}
    found.update(words[max(event.i - SOON, 0) : max(event.i + SENTENCE, event.j + SOON)])
    for mod in event.mods:
        found |= {f"{mod.cat} {mod.value}", words[mod.j - 1]}
    for above in event.upwards():
        found.add(f"above {above.lemma}")
        found.update([f"manner {m.value}" for m in above.mods if m.cat == "manner"])
    phrases = dict.fromkeys([*event.pps, *(p for m in event.subject for p in m.pps)])
    for phrase in phrases:
        found |= {"on any", f"on {phrase.value}", f"out {phrase.outer}", words[phrase.word.i]}
    for noun in (event.object, *event.subject, *(p.target for p in phrases)):
        if noun is not None:
            found.update(words[max(noun.i - 1, 0) : noun.j])
        if isinstance(noun, NounPhrase):
            found |= {_NAMED[type(noun)], *(f"to {way}" for way in noun.dirs)}
        if isinstance(noun, Place):
            found.add(f"a {noun.kind}")
        elif isinstance(noun, Mention):
            found.update([f"{key}.{said}" for h in noun.heads for key, said in h.data.items()])
    return found


def needs(condition: str) -> frozenset[str]:
    """Cues of which a clause has one wherever a condition holds; none where no cue tells."""
    name, _, rest = condition.partition(" ")
    if name in _BY_VALUES:
        return frozenset(f"{_BY_VALUES[name]} {value}" for value in listed(rest) or {""})
    if name in _BY_WORDS:
        return frozenset(phrase.split()[0] for phrase in listed(rest))
    if name == "path":
        return _of_phrase(*rest.removeprefix("^").split())
    return _of_noun(*rest.split()) if name in _BY_NOUNS else frozenset()


def _of_phrase(prepositions: str, *noun: str) -> frozenset[str]:
    found: set[str] = set()
    for word in prepositions.removeprefix("&").split("|"):
        outer, inside, _ = word.rpartition("<")
        if inside:
            found |= {f"out {outer}", outer}
        elif word[0] in "!~" or word == ANY:
            return _of_noun(*noun) or frozenset({"on any"})
        else:
            found |= listed(word[1:]) if word[0] == "=" else {f"on {word}"}
    return frozenset(found | ({"on ahead"} if f"on {FRONT}" in found else set()))


def _of_noun(kinds: str = ANY, *filters: str) -> frozenset[str]:
    for wanted in (word[1:].split("|") for word in filters if word[0] == "+"):
        needs = [_of_filter(name) for name in wanted]
        if all(needs):
            return frozenset().union(*needs)
    names = [kind.partition(".")[0] for kind in kinds.split("|")]
    free = not {ANY, "none", "named"}.isdisjoint(names)
    return frozenset() if free else frozenset(f"a {name}" for name in names)


def _of_filter(name: str) -> frozenset[str]:
    if name in FILTERS or name.startswith("led@"):
        return frozenset()
    return listed(name) if name[0] == "@" else frozenset({name if "." in name else f"to {name}"})
