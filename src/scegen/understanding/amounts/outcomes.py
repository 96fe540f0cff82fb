"""How it ends: who touches whom, nearly or not at all, and where on the ego."""

from scegen.scenario.acts import ActKind
from scegen.scenario.model import Interval
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.spacings import CONTACT, Measure
from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.amounts.contact_nouns import (
    around_it,
    bare,
    in_vain,
    of_nouns,
    of_phrases,
)
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.struck import fully_told
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Amount, Apart, Ending
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.conditions import holds
from scegen.understanding.semantics.context import Clause
from scegen.understanding.semantics.met import goal_of_contact, lies_there, touched
from scegen.understanding.words.quantities import ends_a_quantity
from scegen.understanding.words.terms import Term

_BEFORE, _PAIR = 4, 2
_WHOLE, _HALF = 100.0, 50.0
_BODY = frozenset({"side", "middle", "front", "portion", "flank"})
_STRIPS = frozenset({"sidewalk", "centerline", "shoulder"})
_NOBODY = frozenset({"neither", "nobody"})


def read_outcome(text: Telling) -> None:
    """The outcome, as verbs and nouns tell it."""
    # first what tells of two: "Rear-ended: a van …", "cannot stop in time and hits the ego"
    told = sorted(text.scenes, key=lambda s: (s.event.negated, not (s.actors or s.targets)))
    endings = [e for s in told if (e := _of_verb(s, text)) is not None]
    endings += [*of_nouns(text), *of_phrases(text)]
    for kind in (OutcomeKind.COLLISION, OutcomeKind.NEAR_MISS, OutcomeKind.AVOIDED):
        text.found.ending = text.found.ending or next((e for e in endings if e.kind is kind), None)
    ending = text.found.ending
    if ending is not None and ending.kind is not OutcomeKind.AVOIDED:
        text.found.ending = ending = fully_told(ending, endings, text)
    if ending is not None and len(ending.between) == _PAIR:
        met = dict.fromkeys(_still_there(e, text) for e in ending.between)
        ending.between[:] = met if len(met) == _PAIR else [text.ego, *met]
    _from_the_front(ending, text)
    span = text.find("full_overlap", 0, len(text.tokens))
    other = ending.other if ending is not None else text.counterpart(text.ego, [])
    if span is not None and other is not None:  # the share that no number tells
        amount = Amount(Interval(low=_WHOLE, high=_WHOLE), Basis(*span))
        text.found.spacings.append(Apart(Measure.OVERLAP_PERCENT, other, text.ego, amount, CONTACT))


def _still_there(entity: Entity, text: Telling) -> Entity:
    """``cuts out in front of a van; the ego cannot avoid it``: who is met once another has left."""
    own = (a for a in text.found.acts if a.entity is entity and a.into is None)
    gone = [a.i for a in own if a.kind is ActKind.CHANGE_LANE]
    named = [m.i for m in text.mentions if entity in m.entities and m.pronoun is None]
    ahead = (p for p in text.draft.placements if p.reference is entity)
    met = [p.entity for p in ahead if p.approaches == {Approach.AHEAD} and not p.entity.ego]
    return met[0] if met and gone and named[-1:] < gone[-1:] else entity


def _from_the_front(ending: Ending | None, text: Telling) -> None:
    """``a head-on collision``, ``head-on: …``: they come towards one another."""
    other = text.counterpart(text.ego, [])
    between = ending.between if ending is not None else [other] if other is not None else []
    marks = [m for c in text.chunks for m in ([c] if isinstance(c, Term) else c.mods)]
    placed = {p.entity.index for p in text.draft.placements}
    for mark in [m for m in marks if (m.cat, m.value) == ("manner", "head_on")][:1]:
        for entity in [e for e in between if not e.ego and e.index not in placed]:
            text.draft.place(entity, None, {Approach.OPPOSITE}, Basis(mark.i, mark.j))


def _of_verb(scene: Clause, text: Telling) -> Ending | None:
    event, parent = scene.event, scene.event.parent
    noun = bare(event, text) and not event.doers  # "…; contact is avoided"
    stops = _in_time(scene, text)
    if stops is not None:
        return stops
    clear = holds("kept_clear", scene, text.context) or _stops_first(scene, text)
    if event.premod_of is not None or noun or not (clear or _meets(scene, text)):
        return None
    if _only_things(scene, text):
        return None
    start = max(text.bounds(event.i)[0], event.i - _BEFORE)
    nearly = _narrowly(event, start, text)
    lemma = parent.lemma if parent is not None else ""
    missed = in_vain(event)  # "cannot avoid it"
    vain = parent is not None and (in_vain(parent) or lemma in word_list("coming_about"))
    vain = vain or missed
    end = max([event.j, *(p.word.j for p in event.pps if clear and p.value == "ahead")])
    part, into = event.object, any(p.value in {"into", "in", "against"} for p in event.pps)
    if into and isinstance(part, Place) and part.has("possessive", "its") and "front" in part.dirs:
        end = max(end, part.j)  # "puts its nose into the van"
    basis = Basis(parent.i if vain and parent is not None else event.i, end)
    held_off = parent is not None and parent.name in {"avoid", "prevent", "fail"} and not vain
    held_off = (held_off or event.negated) and not missed
    by_so_much = event.lemma == "miss" and event.name == "avoid"  # "misses it by 1 m"
    if nearly is not None or (by_so_much and clear):
        kind = OutcomeKind.NEAR_MISS
        said = nearly or (event.i, event.j)
        basis = Basis(min(said[0], event.i), max(said[1], event.j))
    elif held_off or clear or _before_it(event, text) or _of_nobody(event, text):
        kind = OutcomeKind.AVOIDED
    elif not holds("aimed", scene, text.context) and (
        _open(event, text) or (not vain and _supposed(_of_it(event, start, text)))
    ):
        return None
    else:
        kind = OutcomeKind.COLLISION
    return Ending(kind, basis, _between(scene, text))


def _only_things(scene: Clause, text: Telling) -> bool:
    """``hits a guardrail``, ``crashes into a tree``: nobody is touched, nothing in the way."""
    event = scene.event
    met = [event.object, *(p.target for p in event.pps if p.value in {"into", "with", "against"})]
    things = [n for n in met if isinstance(n, Thing) and n.kind == "object"]
    strips = [n for n in met if isinstance(n, Place) and n.kind in _STRIPS and n.owner is None]
    said = bool(things or strips) and not event.passive and not scene.targets
    acting = [m for s in text.scenes for m in s.event.subject]
    rest = [m for m in text.mentions if event.j <= m.i < text.bounds(event.i)[1] and m.entities]
    said = said and all(m in acting for m in rest)  # "clips a mailbox and then the ego"
    for strip in strips if said else []:
        text.draft.note(strip.i, strip.j, "a contact with the edge of the road is not looked for")
    return said and not any(lies_there(n, text.context) for n in things)


def _meets(scene: Clause, text: Telling) -> bool:
    """Verbs of contact; "just misses"; "slides into it"; "its front catches him"."""
    event = scene.event
    if event.name == "overlook" and event.lemma == "miss":
        return _narrowly(event, max(0, event.i - _BEFORE), text) is not None
    part = event.lemma in {"catch", "meet"} and _by_a_part(event, text)
    return part or holds("contact", scene, text.context)


def _narrowly(event: Event, start: int, text: Telling) -> tuple[int, int] | None:
    """``narrowly misses it``, ``they miss each other narrowly``."""
    end = event.j + _BEFORE if event.lemma == "miss" else event.i
    return text.find("nearly", start, min(end, text.bounds(event.i)[1]))


def _by_a_part(event: Event, text: Telling) -> bool:
    """``its front catches him``, ``is met by the middle of the ego's front``."""
    by = [p.target for p in event.pps if p.value in {"by", "of"}] if event.passive else []
    helped = event.i > 0 and text.tokens[event.i - 1].low in word_list("required")
    first = event.i - helped  # "its front shall meet the bicycle"
    parts = (c for c in text.chunks if first in {c.j, getattr(getattr(c, "owner", None), "j", -1)})
    places = (n for n in (*by, *parts) if isinstance(n, Place) and n.kind in _BODY)
    return any(n.opening in {"", "by", "of"} for n in places)  # no "car on the left meets …"


def _in_time(scene: Clause, text: Telling) -> Ending | None:
    """``is able to stop in time``, ``brakes in time``; "cannot stop in time": they touch."""
    event, above = scene.event, scene.event.parent
    end = text.bounds(event.i)[1]
    end = min([s.event.i for s in text.within(event.j, end)], default=end)
    span = text.find("in_time", event.i, end)
    stands = event.modal or any(e.parked for e in scene.actors)
    if event.name not in {"stop", "brake"} or stands or span is None:
        return None
    kind = OutcomeKind.COLLISION if event.negated else OutcomeKind.AVOIDED
    aim = event.link == "inf" and (above is None or above.lemma != "manage")
    if event.negated:  # "does not stop in time at the light"
        aim = event.name == "brake" or any(isinstance(n, Place) for n in event.nouns())
    return None if aim else Ending(kind, Basis(event.i, span[1]), _between(scene, text))


def _stops_first(scene: Clause, text: Telling) -> bool:
    """``stops before it touches him``, unlike "stops before a truck hits it"."""
    event = scene.event
    for last in text.within(0, event.i)[-1:]:
        before = "before" in text.context.lows(last.event.j, event.i) and bool(scene.targets)
        own = all(e in (*last.actors, *last.targets) for e in scene.actors)
        stops = last.event.name == "stop" and event.name == "collide" and own
        brakes = last.event.name in {"stop", "brake"} and event.lemma == "reach"
        return before and (stops or brakes)
    return False


def _open(event: Event, text: Telling) -> bool:
    """``should it hit the van``; what "shall be hit" is hit."""
    said = text.find("required", text.bounds(event.i)[0], event.i)
    return event.modal and said is None


def _of_it(event: Event, start: int, text: Telling) -> str:
    """``could not stop and hit it``: what is said of the verb itself."""
    before = text.low(start, event.i)
    return before if event.form == "ing" else f" {before.rpartition(' and ')[2]}"


def _supposed(before: str) -> bool:
    """``could hit``, ``to avoid hitting``: not that it happens."""
    said = any(f" {w} " in before for w in word_list("supposed") if w != "to")
    return said or before.endswith(" to ")


def _of_nobody(event: Event, text: Telling) -> bool:
    """``nobody is hit``, ``touches neither``, ``hits no car``: who is named is not touched.

    Not so "nobody reacts, and its front hits the van": there nobody has a verb already.
    """
    before = [s.event for s in text.scenes if s.event.i < event.i and s.event is not event.parent]
    done = [m for e in before for m in e.subject]
    joined = text.tokens[event.i - 1].low in {"or", "nor"}  # "nobody is hurt or touched"
    own = [m for m in event.subject if joined or all(m is not other for other in done)]
    named = [m for m in (*own, *event.nouns()) if isinstance(m, Mention)]
    return any(m.denied or m.pronoun in _NOBODY or _none(m, text) for m in named)


def _none(mention: Mention, text: Telling) -> bool:
    """``no car``: not one of those who are only left out of what is shown."""
    first = {token.low for token in text.tokens[max(0, mention.i - 1) : mention.i + 1]}
    return mention.negated and bool(first & word_list("none"))


def _before_it(event: Event, text: Telling) -> bool:
    """``stops just before hitting it``, ``without it being hit``; "brakes 1 s before contact"."""
    told = [s.event.j for s in text.scenes if s.event.j <= event.i and s.event is not event]
    start = max([text.bounds(event.i)[0], event.i - _BEFORE, *told[-1:]])
    timed = ends_a_quantity(text.tokens, event.i - 1) or _supposed(text.low(start, event.i))
    passive = event.form == "ed" and text.tokens[event.i - 1].low == "being"
    said = event.form == "ing" or passive or (event.form == "base" and not timed)
    return said and text.find("held_off", start - 1, event.i) is not None


def _between(scene: Clause, text: Telling) -> list[Entity]:
    """Who touches whom: by the verb, by whose part is named, by who is named around."""
    nobody = any(m.pronoun in _NOBODY for m in scene.event.subject)
    if nobody and len(text.draft.entities) > _PAIR:
        return []  # none of them touches any other
    met = (n for n in scene.event.nouns("with") if isinstance(n, NounPhrase))
    into = goal_of_contact(scene, text.context) or next(met, None)  # "hits the rear of his van"
    if any(isinstance(n, Thing) and lies_there(n, text.context) for n in scene.event.nouns()):
        return []  # "avoids the pallet" that a lorry has lost
    who = [*scene.actors, *(scene.targets or touched(into, scene, text.context))]
    sides = (scene.actors, scene.targets), (scene.targets, scene.actors)
    if any(len(a) > 1 and len({e.kind for e in a}) == 1 and text.ego in b for a, b in sides):
        return []  # "drives into the tail of a queue", "neither touched us": whichever of them
    causing = [e for e in text.draft.causing() if e.moving_vehicle and e not in who]
    if scene.event.passive and who == scene.targets and len(who) == len(causing) == 1:
        return [*who, *causing]  # "turns left, a van passes and a bus is nearly hit"
    return who if len(who) == _PAIR else around_it(scene.event.i, who[0] if who else None, text)


def impact(figure: Figure) -> bool:
    """``at 25 % of its width counted from its right side``."""
    text = figure.text
    value, basis, ending = figure.quantity.exact, figure.amount.basis, figure.text.found.ending
    if ending is None:
        ending = Ending(OutcomeKind.COLLISION, basis, around_it(figure.i, text.ego, text))
        text.found.ending = ending
    if figure.role == "overlap" and ending.half is not None:  # "by the left 25 % of its front"
        ending.share = value.high
        return True
    left = text.find("left_edge", figure.j, figure.end)
    edge = left or text.find("right_edge", figure.j, figure.end)
    mirrored = edge is not None and left is None
    if edge is not None:
        basis = Basis(basis.i, edge[1], basis.reason)
    else:
        who = ending.other
        crosses = who is not None and (Maneuver.CROSS in who.maneuvers or not who.is_vehicle)
        mirrored = crosses and who is not None and text.context.placed(who, Approach.RIGHT)
        if value.low != _HALF:
            side = "right" if mirrored else "left"
            reason = f"counted from the {side}, from where the other comes"
            basis = basis.because(reason)
    if mirrored:
        value = Interval(low=_WHOLE - value.high, high=_WHOLE - value.low)
    if ending.impact is None or basis.reason is None:
        ending.impact = Amount(value, basis)
    return True
