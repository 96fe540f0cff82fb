"""Reads all numbers of a text, what is done, when, and how it ends."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.scenario.model import Interval
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach, HazardKind
from scegen.understanding.amounts.acting import acts_in
from scegen.understanding.amounts.doings import FIELDS, Filler
from scegen.understanding.amounts.items import items_in
from scegen.understanding.amounts.outcomes import Judge
from scegen.understanding.amounts.placed import MEASURES, Spacer
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.amounts.timing import Clock
from scegen.understanding.amounts.whom import counterpart, ego_of
from scegen.understanding.chunks import Chunk
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured, Numbers, words
from scegen.understanding.happenings import Amount, Doing, Happenings
from scegen.understanding.meaning.context import Context, Scene
from scegen.understanding.words.quantities import Quantity

_PAIR = 2
_RUNNING_MPS = 8.0
_HARD_MPS2 = 3.5
"""Below this nobody calls braking hard (UN R152: 5 m/s² in an emergency)."""


def read_amounts(
    numbers: Numbers, chunks: list[Chunk], scenes: list[Scene], context: Context
) -> Happenings:
    """Acts, spacings and the outcome; every number in its field or reported.

    Args:
        numbers: the numbers of the text.
        chunks: its chunks.
        scenes: what happens, in the order of the text.
        context: the scenario in the making; speeds are filled in, notes are added.
    """
    text = Sentences(context.tokens, chunks, scenes)
    found = Happenings(acts=acts_in(text, context))
    judge = Judge(text, context, found)
    judge.read()
    measured = [_measured(q, numbers, text) for q in numbers.quantities]
    held = [n for n in measured if n.frame.role == "speed"]
    for number in held:
        if not _speed(number, text, context, found):
            _note(number, context)
    _joined(text)
    _alike(text, context)
    _followed(text, context)
    _in_one_lane(text, context)
    found.items = items_in(text, context)
    filler, clock = Filler(text, found), Clock(text, found)
    spacer = Spacer(text, context, found)
    for number in (n for n in measured if n.frame.role in FIELDS):
        if not filler.read(number):
            _note(number, context)
    for number in measured:
        role = number.frame.role
        if role in MEASURES:
            done = spacer.read(number)
        elif role == "delay":
            done = clock.delay(number)
        elif role == "impact":
            done = judge.impact(number)
        elif role == "relative_speed":
            done = _relative(number, text, context)
        else:
            done = role in FIELDS or role == "speed"
        if not done:
            _note(number, context)
    clock.order()
    _kept_apart(found, context)
    found.acts = _kept(found)
    _gently(found, context)
    return found


def _measured(quantity: Quantity, numbers: Numbers, text: Sentences) -> Measured:
    event = text.verb_at(quantity.i, quantity.j)
    if event is None:
        return numbers.measured(quantity)
    return numbers.measured(quantity, event.name, None if event.perfect else event.i)


def _note(number: Measured, context: Context) -> None:
    instead = number.frame.instead or "a measure that no rule could attach; left out"
    context.draft.note(number.i, number.j, instead)


def _gently(found: Happenings, context: Context) -> None:
    """Braking with a rate is hard, or it is not, by the rate."""
    for doing in found.acts:
        rate = doing.amounts.get("rate_mps2")
        known = any(
            d.kind is HazardKind.HARD_BRAKING and doing.entity in d.by
            for d in context.draft.dangers
        )
        hard = rate is not None and rate.value.low >= _HARD_MPS2
        leads = context.placed(doing.entity, Approach.AHEAD) and not doing.entity.ego
        if doing.kind is ActKind.BRAKE and hard and leads and not known and rate is not None:
            context.draft.hazard(HazardKind.HARD_BRAKING, rate.basis, [doing.entity])
    for danger in [d for d in context.draft.dangers if d.kind is HazardKind.HARD_BRAKING]:
        brakes = [a for a in found.acts if a.kind is ActKind.BRAKE and a.entity in danger.by]
        rates = [a.amounts["rate_mps2"].value for a in brakes if "rate_mps2" in a.amounts]
        if rates and len(rates) == len(brakes) and all(r.high < _HARD_MPS2 for r in rates):
            context.draft.dangers.remove(danger)


def _kept(found: Happenings) -> list[Doing]:
    """Acts that are ones by themselves, or that a number or another act makes ones."""
    acts = found.acts
    named = [d.when.act for d in acts if d.when is not None and d.when.act is not None]
    named += [s.at for s in found.spacings if isinstance(s.at, Doing)]
    kept = [d for d in acts if d.always or d.amounts or d.when is not None or d in named]
    counts: dict[ActKind, int] = {}
    for doing in kept:
        counts[doing.kind] = counts.get(doing.kind, 0) + 1
        doing.name = f"{doing.kind.value}_{counts[doing.kind]}"
    return kept


def _speed(number: Measured, text: Sentences, context: Context, found: Happenings) -> bool:
    """A speed that somebody holds: of whom the rules of the clause have not given it to."""
    span = (number.i, number.j)
    quantity = number.quantity
    change = _from_to(number, text, found)
    taken = [e for e in context.draft.entities if _at(e.speed_basis, span)]
    for entity in [e for e in taken if e.stands is not None and not e.ego and e.sets_off < 0]:
        entity.speed = entity.speed_basis = None  # "all at 70 km/h": not the stationary one
    if change is not None:
        for entity in taken or [change.entity]:
            entity.speed, entity.speed_basis = quantity.parts[0], Basis(*span)
        return True
    if taken:
        return True
    whose = _whose(number, text, context)
    whose = [e for e in whose if e.is_vehicle or quantity.value.low <= _RUNNING_MPS]
    ego = ego_of(context)
    if not whose and ego is not None and ego.speed is None:
        whose = [ego]
    if whose and all(e.speed not in (None, quantity.value) for e in whose):
        whose = _without_speed(number, text) or whose
    for entity in whose:
        if entity.speed is None:
            entity.speed, entity.speed_basis = quantity.value, Basis(*span, quantity.note)
        elif entity.speed != quantity.value:
            return False
        else:
            found.further.append(("speed_mps", entity, Basis(*span)))
        taken.append(entity)
    return bool(taken)


def _from_to(number: Measured, text: Sentences, found: Happenings) -> Doing | None:
    """``brakes from 50 to 20 km/h``: what it drove before, and what it comes to."""
    quantity = number.quantity
    if len(quantity.parts) != _PAIR or not number.around.preceded("from"):
        return None
    start, end = text.bounds(number.i)
    first, last = quantity.parts
    kind = ActKind.BRAKE if last.low < first.low else ActKind.ACCELERATE
    here = [a for a in found.acts if start <= a.i < end and a.kind in {kind, ActKind.STOP}]
    who = text.subject_before(number.i)
    if not here and kind is ActKind.BRAKE and who:  # "slowing of the van from 90 to 36 km/h"
        event = text.verb_at(number.i, number.j)
        told = [event.i] if event is not None else []
        here = [Doing(kind, who[0], Basis(number.i, number.j), number.i, told=told)]
        found.acts = sorted([*found.acts, *here], key=lambda a: a.i)
    if not here:
        return None
    doing = [*[a for a in here if a.i < number.i], *here][-1 if here[-1].i < number.i else 0]
    doing.amounts.setdefault("target_speed_mps", Amount(last, Basis(number.i, number.j)))
    return doing


def _whose(number: Measured, text: Sentences, context: Context) -> list[Entity]:
    """Who drives or walks so fast."""
    tokens = text.tokens
    own = text.holder(number.i, number.j)
    if own:
        return own
    start, _ = text.bounds(number.i)
    before = {t.low for t in tokens[max(start, number.i - 3) : number.i]}
    if before & {*words()["each"]}:
        named = [e for m in text.mentions if start <= m.i < number.i for e in m.entities]
        named = named or [e for m in text.mentions if m.i < number.i for e in m.entities][-_PAIR:]
        pair = list(dict.fromkeys([e for e in reversed(named) if not e.still]))
        ego = ego_of(context)
        pair += [ego] if ego is not None and ego not in pair and len(pair) < _PAIR else []
        return pair if "all" in before or "each" in before else pair[:_PAIR]
    scene = text.scene_at(number.i, number.j)
    adjacent = text.adjacent(number.i)
    if adjacent:
        return adjacent
    inside = text.own_subject(number.i)
    if inside:
        return inside
    movers = [e for e in (scene.actors if scene is not None else []) if not e.parked]
    owned = text.tokens[start].low in words()["whose"]
    later = scene is not None and scene.event.i > number.i and owned
    if movers and not later:
        return movers
    return text.subject_before(number.i)


def _without_speed(number: Measured, text: Sentences) -> list[Entity]:
    """Whoever is named last before a number that cannot be the speed of who acts there."""
    start, _ = text.bounds(number.i)
    named = [e for m in text.mentions if start <= m.i < number.i for e in m.entities]
    free = [e for e in reversed(named) if e.speed is None and not e.still]
    return free[:1]


def _at(basis: Basis | None, span: tuple[int, int]) -> bool:
    return basis is not None and (basis.i, basis.j) == span


def _alike(text: Sentences, context: Context) -> None:
    """``equally fast``, ``at the same speed``: as fast as the other."""
    lows = [t.low for t in text.tokens]
    for phrase in words()["alike"]:
        wanted = phrase.split()
        for k in range(len(lows) - len(wanted) + 1):
            if lows[k : k + len(wanted)] != wanted:
                continue
            start, end = text.bounds(k)
            named = [e for m in text.mentions if start <= m.i < end for e in m.entities]
            near = [e for m in text.mentions if m.i < k for e in m.entities]
            who = list(dict.fromkeys(e for e in reversed(named) if not e.parked))
            for entity in list(who):
                other = counterpart(entity, context, near) if len(who) < _PAIR else None
                who += [other] if other is not None and other not in who else []
            known = [e for e in who if e.speed is not None]
            for entity in who if known else []:
                if entity.speed is None and entity.is_vehicle and not entity.still:
                    entity.speed = known[0].speed
                    entity.speed_basis = Basis(k, k + len(wanted), "as fast as the other")


def _joined(text: Sentences) -> None:
    """``ego and lead at 80 km/h``: both, where the text gives the first no other speed."""
    for mention in text.mentions:
        own = [m for m in mention.mods if m.cat == "quantity" and m.value == "speed"]
        first = mention.joined
        if not own or first is None or not mention.entities:
            continue
        last = mention.entities[0]
        for entity in first.entities:
            if entity.speed is None and entity.is_vehicle and not entity.still:
                basis = last.speed_basis or Basis(own[0].i, own[0].j)
                entity.speed = last.speed
                entity.speed_basis = Basis(basis.i, basis.j, "said of both")


def _followed(text: Sentences, context: Context) -> None:
    """``the ego follows a car at 100 km/h``: one drives as fast as the other."""
    slow = [e for d in context.draft.dangers if d.kind is HazardKind.SLOW_DRIVING for e in d.by]
    for scene in text.scenes:
        pair = [*scene.actors[:1], *scene.targets[:1]]
        if scene.event.name != "follow" or len(pair) != _PAIR or scene.event.negated:
            continue
        known = [e for e in pair if e.speed is not None]
        if len(known) != 1 or any(e in slow or e.still or not e.is_vehicle for e in pair):
            continue
        other = next(e for e in pair if e is not known[0])
        other.speed = known[0].speed
        basis = known[0].speed_basis or scene.words
        other.speed_basis = Basis(basis.i, basis.j, "who follows drives as fast as the other")


def _in_one_lane(text: Sentences, context: Context) -> None:
    """``ego 50 km/h, target 20 km/h, same lane``: whom the faster one comes up to is ahead."""
    lows = [t.low for t in text.tokens]
    k = next((k for k in range(len(lows) - 1) if lows[k : k + 2] == ["same", "lane"]), None)
    ego = ego_of(context)
    others = [e for e in context.draft.entities if e is not ego and e.is_vehicle]
    if k is None or ego is None or ego.speed is None or len(others) != 1:
        return
    other = others[0]
    free = other.speed is not None and not (other.maneuvers or other.parked or other.heading)
    placed = any(other in (p.entity, p.reference) for p in context.draft.placements)
    if other.speed is None or not free or placed or other.speed == ego.speed:
        return
    where = Approach.AHEAD if other.speed.high < ego.speed.high else Approach.BEHIND
    basis = Basis(k, k + 2, "in one lane, the slower one is in front")
    context.draft.place(other, None, {where}, basis)


def _kept_apart(found: Happenings, context: Context) -> None:
    """``3 s behind the lead at 120 km/h; the lead brakes``: until then one is as fast."""
    slow = [e for d in context.draft.dangers if d.kind is HazardKind.SLOW_DRIVING for e in d.by]
    for apart in found.spacings:
        pair = [apart.entity, apart.reference]
        if apart.measure not in {Measure.GAP_M, Measure.HEADWAY_S} or not isinstance(
            apart.at, Doing
        ):
            continue
        if apart.at.kind not in {ActKind.BRAKE, ActKind.STOP}:
            continue
        known = [e for e in pair if isinstance(e, Entity) and e.speed is not None]
        other = next((e for e in pair if isinstance(e, Entity) and e.speed is None), None)
        if len(known) != 1 or other is None or other.still or other in slow or not other.is_vehicle:
            continue
        basis = known[0].speed_basis or apart.amount.basis
        other.speed = known[0].speed
        reason = "until it brakes, the distance is kept"
        other.speed_basis = Basis(basis.i, basis.j, reason)


def _relative(number: Measured, text: Sentences, context: Context) -> bool:
    """``20 km/h slower than the ego``: from the speed of the other."""
    tokens = text.tokens
    word = tokens[number.j].low if number.j < len(tokens) else ""
    if word not in {"slower", "faster"}:
        return False
    who = text.subject_before(number.i)
    near = [e for m in text.mentions if m.i < number.i for e in m.entities]
    other = counterpart(who[0], context, near) if who else None
    if not who or other is None or other.speed is None or who[0].speed is not None:
        return False
    sign, by = (1 if word == "faster" else -1), number.quantity.exact
    low, high = sorted((other.speed.low + sign * by.low, other.speed.high + sign * by.high))
    if low < 0:
        return False
    who[0].speed = Interval(low=low, high=high)
    who[0].speed_basis = Basis(number.i, number.j, f"so much {word} than the other")
    return True
