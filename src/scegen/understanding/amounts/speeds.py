"""Speeds in numbers: of whom they are said."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.scenario.bodies import BODIES
from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import ON_FOOT, ParticipantKind
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.amounts.whom import counterpart, ego_of
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured, words
from scegen.understanding.happenings import Amount, Doing, Happenings
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Context

_PAIR = 2
_RUNNING_MPS = 8.0
_BY_MUSCLE = ON_FOOT | {ParticipantKind.BICYCLE}


def held(number: Measured, text: Sentences, context: Context, found: Happenings) -> bool:
    """A speed that somebody holds: of whom the rules of the clause have not given it to.

    Args:
        number: the number.
        text: the text with its clauses.
        context: the scenario in the making.
        found: what the text tells of.
    """
    span = (number.i, number.j)
    quantity = number.quantity
    change = _from_to(number, text, found)
    taken = [e for e in context.draft.entities if _at(e.speed_basis, span)]
    for entity in [e for e in taken if _stays(e, quantity.value)]:
        entity.speed = entity.speed_basis = None  # "all at 70 km/h": not the stationary one
    taken = [e for e in taken if e.speed is not None]
    if change is not None:
        for entity in taken or [change.entity]:
            entity.speed, entity.speed_basis = quantity.parts[0], Basis(*span)
        return True
    shared = {t.low for t in text.tokens[number.j : number.j + 1]} & {"each", "both"}
    if taken and not shared:
        return True
    whose = _able(number, [e for e in _whose(number, text) if e not in taken], text)
    ego = ego_of(context)
    if not whose and ego is not None and ego.speed is None:
        whose = [ego]
    start, _ = text.bounds(number.i)
    again = [e for e in whose if e.speed_basis is not None and start <= (e.speed_basis.i or 0)]
    if whose and all(e.speed not in (None, quantity.value) or e in again for e in whose):
        whose = _without_speed(number, text) or whose  # "beside a truck, also 100 km/h"
    for entity in whose:
        if entity.speed is not None and entity.speed != quantity.value:
            _hand_on(entity, text)
        if entity.speed is None:
            entity.speed, entity.speed_basis = quantity.value, Basis(*span, quantity.note)
        elif entity.speed != quantity.value:
            return False
        else:
            found.further.append(("speed_mps", entity, Basis(*span)))
        taken.append(entity)
    return bool(taken)


def _able(number: Measured, whose: list[Entity], text: Sentences) -> list[Entity]:
    """Those who can be so fast; if all of them stand, who comes to them."""
    speed = number.quantity.value
    near = text.adjacent(number.i - 1)  # "runs across in front of the ego at 50 km/h"
    able = [e for e in whose if speed.low <= _fastest_mps(e, near)]
    stand = bool(able) and all(_stays(e, speed) for e in able)
    return _who_comes(able, number, text) if stand else able


def _stays(entity: Entity, speed: Interval) -> bool:
    """Whether it stands all the time, so that no speed can be its own."""
    stands = entity.still or entity.held is not None
    return stands and not entity.ego and entity.sets_off < 0 and speed.high > 0


def _who_comes(standing: list[Entity], number: Measured, text: Sentences) -> list[Entity]:
    """``ran into a car parked there, at 30 km/h``: who does something to those who stand."""
    start, _ = text.bounds(number.i)
    before = [s for s in text.within(start, number.i) if any(not e.still for e in s.actors)]
    to_them = [s for s in before if set(standing) & set(s.targets)] or before
    return [e for s in to_them[-1:] for e in s.actors if e.speed is None and not e.still]


def _fastest_mps(entity: Entity, near: list[Entity]) -> float:
    """What it can do; if somebody else stands nearer, what one does by muscle in traffic."""
    top = BODIES[entity.kind].top_speed_mps
    own = not near or entity in near or entity.kind not in _BY_MUSCLE
    return top if own else min(top, _RUNNING_MPS)


def _from_to(number: Measured, text: Sentences, found: Happenings) -> Doing | None:
    """``brakes from 50 to 20 km/h``: what it drove before, and what it comes to."""
    quantity = number.quantity
    if len(quantity.parts) != _PAIR:
        return None
    # "brakes, 100 to 60 km/h": no range goes down
    joined = any(t.low in word_list("up_to") for t in text.tokens[number.i : number.j])
    falls = joined and quantity.parts[0].low > quantity.parts[1].low
    if not falls and not number.around.preceded("from"):
        return None
    start, end = text.bounds(number.i)
    first, last = quantity.parts
    kind = ActKind.BRAKE if last.low < first.low else ActKind.ACCELERATE
    here = [a for a in found.acts if start <= a.i < end and a.kind in {kind, ActKind.STOP}]
    who = text.subject_before(number.i)
    if not here and who:  # "slowing of the van from 90 to 36 km/h", "goes from 60 to 100 km/h"
        event = text.verb_at(number.i, number.j)
        told = [event.i] if event is not None else []
        here = [Doing(kind, who[0], Basis(number.i, number.j), number.i, told=told)]
        found.acts = sorted([*found.acts, *here], key=lambda a: a.i)
    if not here:
        return None
    doing = next((a for a in reversed(here) if a.i < number.i), here[0])
    doing.amounts.setdefault("target_speed_mps", Amount(last, Basis(number.i, number.j)))
    return doing


def _whose(number: Measured, text: Sentences) -> list[Entity]:
    """Who drives or walks so fast."""
    start, _ = text.bounds(number.i)
    scene = text.scene_at(number.i, number.j)
    adjacent = text.adjacent(number.i)
    if adjacent:
        return adjacent
    inside = text.own_subject(number.i)
    if inside:
        return inside
    movers = [e for e in (scene.actors if scene is not None else []) if not e.parked]
    owned = text.tokens[start].low in words()["whose"]
    return text.subject_before(number.i) if owned or not movers else movers


def _without_speed(number: Measured, text: Sentences) -> list[Entity]:
    """Whoever is named last before a number that cannot be the speed of who acts there."""
    start, _ = text.bounds(number.i)
    named = [e for m in text.mentions if start <= m.i < number.i for e in m.entities]
    free = [e for e in reversed(named) if e.speed is None and not e.still]
    return free[:1]


def _hand_on(entity: Entity, text: Sentences) -> None:
    """``overtakes a tractor at 25 km/h; the ego drives 70 km/h``: the first was the tractor's."""
    basis = entity.speed_basis
    if basis is None or basis.i is None:
        return  # nobody said it
    start, _ = text.bounds(basis.i)
    named = [m.entities for m in text.mentions if start <= m.i < basis.i]
    if not named or len(named[-1]) != 1:
        return
    (other,) = named[-1]
    if other is not entity and other.speed is None and not other.still:
        other.speed, other.speed_basis = entity.speed, basis
        entity.speed = entity.speed_basis = None


def _at(basis: Basis | None, span: tuple[int, int]) -> bool:
    return basis is not None and (basis.i, basis.j) == span


def relative(number: Measured, text: Sentences, context: Context) -> bool:
    """``20 km/h slower than the ego``: from the speed of the other.

    Args:
        number: the number.
        text: the text with its clauses.
        context: the scenario in the making.
    """
    tokens = text.tokens
    word = tokens[number.j].low if number.j < len(tokens) else ""
    if word not in {"slower", "faster"}:
        return False
    scene = text.scene_at(number.i, number.j)
    who = [e for e in (scene.actors if scene else []) if e.speed is None]
    near = [e for m in text.mentions if m.i < number.i for e in m.entities]
    other = counterpart(who[0], context, near) if who else None
    if not who or other is None or other.speed is None or who[0].speed is not None:
        return False
    sign, by = (1 if word == "faster" else -1), number.quantity.exact
    low, high = sorted((other.speed.low + sign * by.low, other.speed.high + sign * by.high))
    who[0].speed = Interval(low=low, high=high)
    who[0].speed_basis = Basis(number.i, number.j, f"so much {word} than the other")
    return True
