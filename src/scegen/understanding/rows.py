"""Vehicles in a row: each drives behind the one named before it."""

from __future__ import annotations

from itertools import combinations

from scegen.scenario.vocabulary import Approach
from scegen.understanding.chunks import Chunk, Event, Mention
from scegen.understanding.dependents import chain
from scegen.understanding.draft import Basis, Draft, Entity
from scegen.understanding.terms import Term

_FEWEST = 2
_ORDERS = {"row": Approach.AHEAD, "abreast": Approach.ADJACENT}


def line_up(chunks: list[Chunk], events: list[Event], draft: Draft) -> None:
    """``three cars in a row``, ``two vans drive one behind the other``.

    Args:
        chunks: the chunks of the text, mentions resolved.
        events: its events.
        draft: the scenario in the making.
    """
    for chunk in chunks:
        if isinstance(chunk, Mention):
            members = [e for m in chain(chunk) for e in m.entities]
            _behind_each_other(chunk.mods, members, draft)
    for event in events:
        _behind_each_other(event.mods, [e for m in event.subject for e in m.entities], draft)


def _behind_each_other(mods: list[Term], entities: list[Entity], draft: Draft) -> None:
    said = next((m for m in mods if m.cat == "manner" and m.value in _ORDERS), None)
    drivers = [e for e in entities if e.moving_vehicle]
    if said is None or len(drivers) < _FEWEST:
        return
    for leader, follower in combinations(drivers, 2):
        draft.place(leader, follower, {_ORDERS[said.value]}, Basis(said.i, said.j))
