"""Vehicles in a row: each drives behind the one named before it."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations, product

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Chunk, Event, Mention
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term

_FEWEST = 2
_NUMBERS = ("first", "second", "third", "fourth", "fifth", "sixth")
_BRAKING = frozenset({"brake", "hard_brake", "stop", "slow"})
_ORDERS = {"row": Approach.AHEAD, "abreast": Approach.ADJACENT}


def line_up(chunks: list[Chunk], events: list[Event], draft: Draft) -> None:
    """``three cars in a row``, ``two vans drive one behind the other``."""
    for chunk in chunks:
        if isinstance(chunk, Mention):
            members = [e for m in chain(chunk) for e in m.entities]
            _behind_each_other(chunk.mods, members, draft)
            _at_its_end(chunk, draft)
    for event in events:
        _behind_each_other(event.mods, event.doers, draft)
    _queue_of_the_numbered(chunks, events, draft)


def _at_its_end(mention: Mention, draft: Draft) -> None:
    """``the rear one`` of two: behind the other."""
    for which in [m for m in mention.mods if "in_file" in m.data]:
        place = {Approach.AHEAD if which.value == "first" else Approach.BEHIND}
        for entity, other in product(mention.entities, draft.entities):
            if other.basis == entity.basis:
                draft.place(entity, draft.ego and other, place, Basis(which.i, which.j))


def _queue_of_the_numbered(chunks: list[Chunk], events: list[Event], draft: Draft) -> None:
    """``first van brakes, second stops, third (the ego) is late``: one behind the other."""
    numbered = {id(c): c for c in chunks if isinstance(c, Mention) and _ordinal(c) is not None}
    braking = [m for e in events if e.name in _BRAKING for m in e.subject if id(m) in numbered]
    if not braking:
        return
    by_number: dict[int, Entity] = {}
    for mention in numbered.values():
        for entity in mention.entities[:1]:
            by_number.setdefault(_ordinal(mention) or 0, entity)
    order = [by_number[n] for n in sorted(by_number)]
    apart = len(set(map(id, order))) == len(order) and all(e.moving_vehicle for e in order)
    basis = Basis(braking[0].i, braking[0].j, "they brake one after the other")
    for leader, follower in combinations(order, 2) if apart else []:
        draft.place(leader, follower, {Approach.AHEAD}, basis)


def _ordinal(mention: Mention) -> int | None:
    return next((_NUMBERS.index(m.value) for m in mention.mods if m.value in _NUMBERS), None)


def _behind_each_other(mods: list[Term], entities: list[Entity], draft: Draft) -> None:
    said = next((m for m in mods if m.cat == "manner" and m.value in _ORDERS), None)
    said = said or _gathered(mods, draft)
    drivers = [e for e in entities if e.moving_vehicle]
    if said is None or len(drivers) < _FEWEST:
        return
    if [e.brakes_from is not None for e in drivers] == [False, True]:
        drivers.reverse()  # "V1 and V2 in line; V2 brakes": whoever follows has to answer
    for leader, follower in combinations(drivers, 2):
        draft.place(leader, follower, {_ORDERS[said.value]}, Basis(said.i, said.j))


def _gathered(mods: list[Term], draft: Draft) -> Term | None:
    """``a chain of three cars``: in a row."""
    for mod in mods:
        words = {t.low for t in draft.tokens[mod.i : mod.j]} if mod.cat == "quant" else set()
        if words & word_list("rows"):
            return replace(mod, value="row")
    return None
