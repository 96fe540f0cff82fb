"""Fills in verbs that are left out (``one goes left, the other right``), and who is meant again."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice, takewhile

from scegen.scenario.acts import ActKind
from scegen.understanding.chunks import Chunk, Event, Mention, NounPhrase, Place, Prep
from scegen.understanding.clauses.located import is_it
from scegen.understanding.frames import acts
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.lookahead import BOUNDARIES, cat_at, chunk_at
from scegen.understanding.phrases.nominal import WAYS
from scegen.understanding.phrases.predicates import complete
from scegen.understanding.words.terms import NOTHING, Term
from scegen.understanding.words.tokens import Token

_JOINTS = frozenset({"and", "but", ",", "while", "when", ";"})
_EMPTY = frozenset({"light", "try", "cause", "inert", "unknown", "likewise", "avoid"})
_MOST_AFTER = 3


def fill_in(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> list[Event]:
    """The events with a copy of the verb before for each clause that leaves its verb out.

    Such a clause is a participant after "and" or a comma, followed by nothing but a direction,
    an exit or a phrase of place: what the verb before says of somebody else.
    An ordinal that stands for an exit is replaced by it.
    """
    for event in events:
        event.lemma = tokens[event.j - 1 if event.nominal else event.i].forms[-1][0]
    _likewise(events, tokens)
    _only_owed(events, tokens)
    acting = {id(m) for e in events for m in (*e.subject, e.object)}
    found = [*events, *_taken_up(chunks, events, tokens)]
    for k, chunk in enumerate(chunks):
        if not isinstance(chunk, Mention) or id(chunk) in acting or chunk.prep is not None:
            continue
        joint, verb = chunk_at(chunks, k - 1), _verb_before(chunk.i, events)
        joined = joint.value in _JOINTS and cat_at(chunks, k + 1) != "aux"  # "while one is coming"
        joined = joined and "lateral" not in chunk.dirs  # "crossing car": it does that
        after = k + 2 + isinstance(chunk_at(chunks, k + 2), Mention)  # "and the taxi by the ego"
        if verb is None or verb.premod_of is not None or not joined or not _ends(chunks, after):
            continue
        if not _further(chunk, chunks, k, verb):
            found += _copy(verb, chunk, chunks, k + 1)
    return complete(chunks, found, tokens)


def _further(mention: Mention, chunks: list[Chunk], k: int, verb: Event) -> bool:
    """``waits for a car from the left and a van from the right``: for both.

    Whom the verb governs has a phrase of place of its own there, and so has the second one.
    """
    last = next((c for c in reversed(chunks[: k - 1]) if isinstance(c, Mention)), None)
    governs = next((p for p in verb.pps if p.who is last and p.word.cat == "prep"), None)
    if last is None or governs is None or not last.pps or last.i < verb.i:
        return False
    mention.joined = last
    verb.pps.append(replace(governs, target=mention))
    return True


def _likewise(events: list[Event], tokens: list[Token]) -> None:
    """``and the van ahead does the same``: what somebody else was last said to do."""
    for k, event in enumerate(events):
        does = tokens[event.i].low in word_list("does")
        so = event.i > 0 and tokens[event.i - 1].low in {"so", "as"}
        said = [m for m in (event.object, *event.subject) if isinstance(m, Mention)]
        if does and so and said[:1] and said[0].i > event.i:  # "and so does the van opposite"
            event.name, event.subject, event.object = "likewise", said[:1], None
            said[0].mods, event.mods = [*said[0].mods, *event.dirs], []
        times = [m for m in event.mods if (m.cat, m.value) == ("quantity", "time")]
        later = any(_in_order(tokens, m) for m in times)
        if event.name == "follow" and later and not (event.object or event.pps):
            event.name = "likewise"  # "a van sets off and the ego follows 1 s later"
        if event.name == "light" and does and _in_turn(event, tokens):
            event.name = "likewise"
        _the_same_way(event, events, tokens)
        if event.name != "likewise":
            continue
        who = _called(event)
        others = [e for e in events[:k] if e.subject and not who & _called(e)]
        for model in [e for e in others if e.name not in _EMPTY][-1:]:
            event.name, event.object = model.name, event.object or model.object
            event.mods = [*event.mods, *model.dirs]
            event.pps = [*event.pps, *(p for p in model.pps if p.place is not None)]


def _in_order(tokens: list[Token], time: Term) -> bool:
    """``2 s later``, ``after 2 s``: not how far apart the two drive."""
    around = {t.low for t in (*tokens[time.i - 1 : time.i], *tokens[time.j : time.j + 1])}
    return not around.isdisjoint(word_list("order"))


def _called(event: Event) -> set[int]:
    """Who acts, the ego by whatever word: "we have to stop … and we do" is no likewise."""
    return {-1 if m.is_ego else id(m) for m in event.subject}


def _the_same_way(event: Event, events: list[Event], tokens: list[Token]) -> None:
    """``turns right, and a car makes the same turn``, ``turns with it``, ``also turns``: too."""
    also = {t.low for t in tokens[max(0, event.i - 1) : event.i]} & word_list("likewise")
    also |= {p.value for p in event.pps if p.who is not None} & {"with"}
    same = event.nominal and "same" in {m.value for m in event.dirs}
    if same or (also and event.name == "turn" and not event.dirs):
        ways = (m for e in events if e.name == event.name for m in e.dirs if m.value in WAYS)
        event.mods = [*(m for m in event.mods if m.value != "same"), *islice(ways, 1)]


def _in_turn(event: Event, tokens: list[Token]) -> bool:
    """``the first one stops, then the second does``: nothing else is said to be done."""
    opened = {tokens[m.i - 1].low for m in event.subject[:1] if m.i > 0 and not is_it(m)}
    return bool(opened & {"then", "and"}) and not (event.object or event.pps or event.children)


def _taken_up(chunks: list[Chunk], events: list[Event], tokens: list[Token]) -> list[Event]:
    """``has to yield but does not``, ``but fails to``: the verb before, denied.

    ``shouldn't overtake, but does``: the verb before, done after all.
    """
    found = []
    for k, chunk in enumerate(chunks[1:], start=1):
        helper, after = chunk_at(chunks, k - 1), chunk_at(chunks, k + 1)
        begin = k - 1 if (helper.cat, helper.value) == ("aux", "do") else k
        denied, does = chunk.cat == "neg" and begin < k, False
        if isinstance(chunk, Event):
            denied = chunk.name == "fail" and after.value == "to"
            does = chunk.name in {"light", "likewise"} and tokens[chunk.i].low in word_list("does")
            after = chunk_at(chunks, k + 2) if denied else after
        verb = _verb_before(chunks[begin].i, events) if denied or does else None
        if verb is None or not (after is NOTHING or _parts(after)):
            continue
        clause = takewhile(lambda c: not _parts(c) and c.cat != "sub", reversed(chunks[:begin]))
        named = [c for c in clause if isinstance(c, Mention) and c.prep is None]
        last = chunk_at(chunks, begin - 2)
        if chunks[begin - 1].value == "," and isinstance(last, Mention) and last.same_as:
            named = [last.same_as]  # "the follower, a van, does not"
        opened = bool(named) and chunk_at(chunks, chunks.index(named[-1]) - 1).cat == "sub"
        likewise = does and opened  # "brakes because the car ahead does"
        if (opened and not named[-1].heads) if likewise else does != _is_denied(verb):
            continue
        again = _again(verb, named[-1:] or verb.subject, chunks[begin].i, chunk.j)
        found.append(replace(again, negated=denied, modal=False))
        owed = (does and not likewise) or verb.modal or verb.link == "inf"
        if owed and not any(m.heads for m in named[-1:]):
            verb.name = "inert"  # what is said of it is said again
    return found


def _only_owed(events: list[Event], tokens: list[Token]) -> None:
    """``was meant to brake but kept its speed``, ``should have stopped``: it did not."""
    for owed, done in zip(events, [*events[1:], *events[-1:]], strict=True):
        helped = {t.low for t in tokens[max(0, owed.i - _MOST_AFTER) : owed.i]}
        between = {t.low for t in tokens[owed.j : done.i]}
        same = all(m in owed.subject or not m.heads for m in done.subject)
        said = done.finite and same and not between.isdisjoint({"but", "yet"})
        goes = owed.name == "yield" and owed.embedded and done.name in word_list("goes")
        undone = owed.modal and (said or goes or owed.perfect)
        owed.negated = owed.negated or (undone and not helped.isdisjoint(word_list("owing")))


def _is_denied(verb: Event) -> bool:
    """``did not brake``, ``is not allowed to pass``; not "brakes so as not to hit it"."""
    return verb.negated and (verb.link != "inf" or (verb.parent or verb).negated)


def _parts(chunk: Chunk) -> bool:
    """Whether a clause ends, or another begins, there."""
    return isinstance(chunk, Term) and chunk.value in _JOINTS | BOUNDARIES


def _verb_before(i: int, events: list[Event]) -> Event | None:
    before = [e for e in events if e.j <= i and e.subject and not e.nominal and e.lemma != "do"]
    return before[-1] if before else None


def _again(verb: Event, subject: list[Mention], i: int, j: int) -> Event:
    """What a verb says, said of others by words that leave it out."""
    return replace(verb, subject=subject, i=i, j=j, parent=None, children=[], alternative=None)


def _ends(chunks: list[Chunk], k: int) -> bool:
    """Whether the clause ends before a verb comes: nothing but a phrase of place may follow."""
    for chunk in chunks[k : k + _MOST_AFTER]:
        if chunk.value in _JOINTS or chunk.value in BOUNDARIES:
            return True
        if isinstance(chunk, Event | Mention) or (chunk.cat == "aux"):
            return False
    return True


def _copy(verb: Event, who: Mention, chunks: list[Chunk], k: int) -> list[Event]:
    """The verb again, with what stands after its new subject: nothing if that is not alike."""
    rest, target = chunk_at(chunks, k), chunk_at(chunks, k + 1)
    if isinstance(rest, Mention) and rest.pronoun == "ordinal" and isinstance(verb.object, Place):
        place = Place(rest.i, rest.j, rest.mods, verb.object.head, kind=verb.object.kind)
        chunks[k] = rest = place  # "one takes the first exit, the other the second"
    if isinstance(rest, NounPhrase) and type(rest) is type(verb.object):
        return [replace(_again(verb, [who], rest.i, rest.j), object=rest)]
    if not isinstance(rest, Term) or rest.cat != "prep":
        return []
    if (target.cat, target.value) == ("quantity", "speed"):
        # "from the left a man crosses at 3 km/h and a woman at 7 km/h"
        mods = [m for m in verb.mods if (m.cat, m.value) != ("quantity", "speed")]
        alike = len(mods) < len(verb.mods) and chunks[k - 2].value in {"and", "but", "while"}
        ends = cat_at(chunks, k + 2) in {"", "punct", "conj", "sub"}
        alike = alike and ends and not (who.is_ego or isinstance(verb.object, Mention))
        return [replace(_again(verb, [who], rest.i, target.j), mods=mods)] if alike else []
    if isinstance(target, Mention):
        whom = [p for p in verb.pps if p.value == rest.value and isinstance(p.target, Mention)]
        verb.pps = [p for p in verb.pps if p.target is not target]
        others = [p for p in verb.pps if p not in whom]
        who.joined = None if whom else who.joined  # "overtaken by a van and the van by a bus"
        again = _again(verb, [who], rest.i, target.j)
        return [replace(again, pps=[*others, Prep(rest, target)])] if whom else []
    if not isinstance(target, Place):
        return []
    # "a car comes from the left and a van from the right", no "turns left out of a street; a van …"
    turns, kind = bool(verb.dirs), target.kind
    own = [p for p in verb.pps if p.on_mention is not who]
    kept = [p for p in own if p.value != rest.value or (turns and not p.names(kind))]
    alike = len(kept) < len(own) and (rest.value != "in" or verb.form != "ing")
    verb.pps = own if alike else verb.pps
    again = _again(verb, [who], rest.i, target.j)
    mods = [m for m in verb.mods if (m.cat, m.value) != ("quantity", "speed")]
    return [replace(again, mods=mods, pps=[*kept, Prep(rest, target)])] if alike else []


_SEVERAL = frozenset({"both", "all", "they"})


def named_again(events: list[Event]) -> None:
    """``… as the lane change begins``, ``2 s after the cut-in the ego brakes``: whose it was.

    Not of who acts there, unless it is called its own, or of its verb.
    """
    for event in events:
        known = any((m.cat, m.value) == ("det", "def") for m in event.mods)
        owners = [m for p in event.pps for m in [p.target] if isinstance(m, Mention)]
        own = event.parent is not None or any(m.possessor or m in owners for m in event.subject)
        later = [m for e in events if e.sentence > event.sentence for m in e.subject]
        others = any(m.pronoun in _SEVERAL or m in later for m in event.subject)
        if event.nominal and event.form != "s" and (others or not own):
            kind = acts().get(event.name)
            told = [e for e in events if e.i < event.i and e.finite and kind in _done(e)]
            if told and kind and (known or not event.mods):  # "… the gap at braking: 15 m"
                event.subject = list(told[-1].subject)
            elif known and others:
                event.subject = []


def _done(event: Event) -> Iterator[ActKind | None]:
    """What a verb is as an act; who comes into a lane has changed lanes."""
    yield acts().get(event.name)
    if any(isinstance(n, Place) and n.kind == "lane" for n in event.nouns("into")):
        yield ActKind.CHANGE_LANE


def names_another(events: list[Event]) -> None:
    """``comes up to a lorry that does 60 km/h and slows to the lorry's speed``: not the lorry.

    Nobody calls himself by his noun again: then the verb goes with the one outside the clause.
    """
    for k, event in enumerate(events):
        if event.embedded or event.nominal or len(event.subject) != 1:
            continue
        (one,) = event.subject
        said = (m for m, e in enumerate(events[:k]) if e.embedded and e.subject == [one])
        first = next(said, 0)  # the clause within another that tells of it
        outer = [e for e in events[:first] if not e.embedded and one not in e.subject]
        if outer and outer[-1].subject and any(_same_noun(m, one) for m in _named_with(event)):
            event.subject = outer[-1].subject


def _named_with(event: Event) -> list[Mention]:
    """Whom a verb takes, and who owns what it takes."""
    taken = [event.object, *(p.target for p in event.pps)]
    owners = [t.owner for t in taken if isinstance(t, NounPhrase)]
    return [m for m in (*taken, *owners) if isinstance(m, Mention)]


def _same_noun(mention: Mention, one: Mention) -> bool:
    later = mention.i > one.i and mention.has("det", "def") and mention.head is not None
    return later and one.noun == mention.noun and one.label == mention.label
