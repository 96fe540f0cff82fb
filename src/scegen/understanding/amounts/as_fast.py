"""Speeds without a number: as fast as somebody else, in front of who is faster."""

from __future__ import annotations

from scegen.scenario.acts import ActKind
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach, HazardKind
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.amounts.whom import ego_of
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.happenings import Doing, Happenings
from scegen.understanding.semantics.context import Context

_PAIR = 2


def as_fast(text: Sentences, context: Context) -> None:
    """Speeds that follow from those in numbers.

    Args:
        text: the text with its clauses.
        context: the scenario in the making; speeds are filled in.
    """
    _joined(text)
    _alike(text)
    _followed(text, context)
    _in_one_lane(text, context)


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


def _alike(text: Sentences) -> None:
    """``equally fast``, ``at the same speed``: as fast as the other."""
    span = text.find("alike", 0, len(text.tokens))
    if span is None:
        return
    start, end = text.bounds(span[0])
    named = [e for m in text.mentions if start <= m.i < end for e in m.entities]
    who = list(dict.fromkeys(e for e in reversed(named) if not e.parked))
    known = [e for e in who if e.speed is not None]
    for entity in who if known else []:
        if entity.speed is None and entity.is_vehicle and not entity.still:
            entity.speed = known[0].speed
            entity.speed_basis = Basis(*span, "as fast as the other")


def _followed(text: Sentences, context: Context) -> None:
    """``the ego follows a car at 100 km/h``: one drives as fast as the other."""
    slow = [e for d in context.draft.dangers if d.kind is HazardKind.SLOW_DRIVING for e in d.by]
    for scene in text.scenes:
        pair = [*scene.actors[:1], *scene.targets[:1]]
        follows = scene.event.name in {"follow", "tailgate"}
        if not follows or len(pair) != _PAIR or scene.event.negated:
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
    span = text.find("same_lane", 0, len(text.tokens))
    ego = ego_of(context)
    others = [e for e in context.draft.entities if e is not ego and e.is_vehicle]
    if span is None or ego is None or ego.speed is None or len(others) != 1:
        return
    other = others[0]
    placed = any(other in (p.entity, p.reference) for p in context.draft.placements)
    if other.speed is None or other.maneuvers or placed:
        return
    where = Approach.AHEAD if other.speed.high < ego.speed.high else Approach.BEHIND
    basis = Basis(*span, "in one lane, the slower one is in front")
    context.draft.place(other, None, {where}, basis)


def kept_apart(found: Happenings) -> None:
    """``3 s behind the lead at 120 km/h; the lead brakes``: until then one is as fast.

    Args:
        found: what the text tells of.
    """
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
        if len(known) != 1 or other is None or other.still:
            continue
        basis = known[0].speed_basis or apart.amount.basis
        other.speed = known[0].speed
        reason = "until it brakes, the distance is kept"
        other.speed_basis = Basis(basis.i, basis.j, reason)
