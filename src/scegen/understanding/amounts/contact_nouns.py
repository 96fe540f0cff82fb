"""How it ends, as nouns and set phrases tell it: "no crash", "until impact", "a near miss"."""

from scegen.scenario.outcome import OutcomeKind
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import Event, Mention
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.frames.windows import frame_of, window
from scegen.understanding.happenings import Ending
from scegen.understanding.lexicon import word_list

_BEFORE, _PAIR = 4, 2
_WITH_WHOM = frozenset({"with", "between"})
_DONE = frozenset({"brake", "stop", "yield", "slow", "react", "hard_brake"})
"""What may be left undone, and a contact follows."""
_KEEPING_OFF = frozenset({"avoid", "prevent"})


def of_phrases(text: Telling) -> list[Ending]:
    """``no contact``, ``nearly collide``: set phrases, of who is named around."""
    spans = {n: text.find(n, 0, len(text.tokens)) for n in ("near_miss", "avoided")}
    found = []
    for name, span in spans.items():
        if span is None:
            continue
        between = around_it(span[0], None, text)
        found.append(Ending(OutcomeKind(name), Basis(*span), between))
    return found


def of_nouns(text: Telling) -> list[Ending]:
    """``no crash``, ``until impact``, ``a collision is avoided``: by the words around.

    What is denied of something else denies no contact: "neither brakes; collision".
    """
    tokens, found = text.tokens, []
    for k in (k for k, t in enumerate(tokens) if t.base in word_list("impacts")):
        begin = k
        while begin and tokens[begin - 1].low in word_list("before_impacts"):
            joined = tokens[max(0, begin - 2)].low == "to"  # "a front-to-rear impact"
            begin -= 3 if joined and tokens[begin - 3].low in word_list("before_impacts") else 1
        done = [s.event for s in text.scenes if s.event.i <= k < s.event.j]
        if any(not (e.nominal or bare(e, text)) for e in done):
            continue
        prevented = _prevented(begin - _BEFORE, k, text)
        verbs = {"in_vain" if in_vain(e) else e.name for e in prevented}
        verbs |= {t.low for t in tokens[begin:k]}
        verbs |= _said_of(k, text)
        around = window(tokens, begin, k + 1, {})
        role = frame_of("contact", 0.0, around, frozenset(verbs)).role
        if role != "other":
            i = begin - (begin > 0 and tokens[begin - 1].low in word_list("none"))
            i = min([i, *(e.i for e in prevented if e.i < begin)])  # "cannot avoid it"
            found.append(Ending(OutcomeKind(role), Basis(i, k + 1), around_it(k, None, text)))
    return found


def bare(event: Event, text: Telling) -> bool:
    """``neither gives way, crash.``, ``Animal crash: …``: a noun, although it looks like a verb."""
    before = text.tokens[event.i - 1]
    alone = event.i == 0 or before.kind == "punct" or before.low in word_list("before_impacts")
    alone = alone or (bool(event.subject) and not event.doers)
    named = isinstance(event.object, Mention)  # "brakes hard, misses him"
    return alone and event.form == "base" and event.lemma in word_list("impacts") and not named


def _prevented(start: int, k: int, text: Telling) -> list[Event]:
    """What keeps a contact from happening, or does not, around its noun."""
    first, end = text.bounds(k)
    around = text.within(max(start, first), min(end, k + _BEFORE))
    return [s.event for s in around if s.event.name in _KEEPING_OFF]


def _said_of(k: int, text: Telling) -> set[str]:
    """``a crash does not occur``, ``stops before it can happen``: what verbs say of the noun."""
    first, end = text.bounds(k)
    events = [s.event for s in text.within(first, end)]
    done = [e.name for e in events if e.i < k]
    said = set(done[-1:])
    rest = [t.low for t in text.tokens[k + 1 : end]]
    ends = rest.index(":") if rest and rest[0] in _WITH_WHOM and ":" in rest else 0
    entry = rest[ends : ends + 2]  # "Contact: none", "contact with the van: none"
    said |= {"denied"} if entry[:1] == [":"] and {*entry[1:]} & {*word_list("none")} else set()
    for event in events:
        held = event.name not in _DONE and any(c.i <= k < c.j for c in event.nouns())
        between = text.tokens[k + 1 : event.i]
        own = bool(rest) and rest[0] in _WITH_WHOM  # "contact with the van shall be avoided"
        after = event.i > k and (own or not text.spoken_of(k, event.i))
        if held or (after and all(t.kind == "word" for t in between)):
            around = {t.low for t in between} - {"without"}  # "impact without braking is at 25 %"
            whole = text.tokens[event.i - 1].low == "which"  # "…, which ends in a crash"
            denied = (event.negated and not whole) if held else around & {*word_list("none")}
            said |= {"denied"} if denied else around
            kept = {event.name} & _KEEPING_OFF if after and not denied else set()
            said |= {"in_vain"} if kept and in_vain(event) else kept
    return said


def in_vain(event: Event) -> bool:
    """``cannot avoid hitting him``: it happens all the same."""
    above = event.parent
    failed = above is not None and above.name == "fail" and not above.negated
    return event.name in _KEEPING_OFF and (event.negated or failed)


def around_it(i: int, known: Entity | None, text: Telling) -> list[Entity]:
    """Who touches whom, by who is named around; empty if that are not two."""
    start, end = text.bounds(i)
    before, after = text.spoken_of(start, i), text.spoken_of(i, end)
    if not before and not after and known is None:
        before = text.spoken_of(0, len(text.tokens))
    chosen = [known] if known is not None else []
    main = (scene for scene in text.within(start, i) if not scene.event.embedded)
    acting = {e for scene in main for e in scene.actors}
    # "a van overtakes a bus, and we collide": with who does something
    doing, others = ([e for e in before if (e in acting) is does] for does in (True, False))
    for entity in (*reversed(doing), *reversed(others), *after):
        if entity not in chosen and not entity.parked and len(chosen) < _PAIR:
            chosen.append(entity)
    if len(chosen) == 1:
        # who stands beside the road last of all
        near = sorted(text.spoken_of(0, i), key=lambda e: not e.parked)
        other = text.counterpart(chosen[0], near)
        chosen += [other] if other is not None else []
    return chosen if len(chosen) == _PAIR else []
