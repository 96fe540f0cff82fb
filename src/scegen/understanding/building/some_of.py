"""So many of several alike, no matter which: "three of the ten turn left"."""

from __future__ import annotations

from collections import Counter

from scegen.scenario.functional import Group
from scegen.scenario.vocabulary import JunctionKind
from scegen.understanding.building.proving import Proofs
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Happenings


def some_of(
    draft: Draft, happenings: Happenings, kind: JunctionKind, proofs: Proofs
) -> tuple[Group, ...]:
    """What some of several alike do; they themselves are left free.

    On a plain road nobody has ways to choose from.
    """
    found: list[Group] = []
    for members in _alike(draft, happenings) if kind is not JunctionKind.STRAIGHT else []:
        told = [e for e in members if e.maneuvers]
        if len(members) < 2 or not told or not all(e.some for e in told):
            continue
        ways = Counter(frozenset(e.maneuvers) for e in told)
        if max(ways.values()) == len(members):
            continue  # all of them
        words = {frozenset(e.maneuvers): e.maneuver_basis or e.basis for e in told}
        for entity in members:
            entity.maneuvers, entity.maneuver_basis = set(), None
        names = tuple(e.name for e in members)
        for maneuvers, number in ways.items():
            proofs.add(f"groups.{len(found)}", words[maneuvers])
            found.append(Group(members=names, number=number, maneuvers=maneuvers))
    return tuple(found)


def _alike(draft: Draft, happenings: Happenings) -> list[list[Entity]]:
    """Those who came up together and of whom nothing else is said that tells them apart."""
    apart = {id(e) for p in draft.placements for e in (p.entity, p.reference)}
    apart |= {id(e) for d in draft.dangers for e in (*d.by, *d.to)}
    apart |= {id(a.entity) for a in happenings.acts}
    apart |= {id(e) for s in happenings.spacings for e in (s.entity, s.reference)}
    apart |= {id(e) for e in (happenings.ending.between if happenings.ending else ())}
    classes: dict[tuple[object, ...], list[Entity]] = {}
    for entity in draft.entities:
        if id(entity) not in apart:
            classes.setdefault(_signature(entity), []).append(entity)
    return list(classes.values())


def _signature(entity: Entity) -> tuple[object, ...]:
    """All that tells one from another beside the way that it takes."""
    basis: Basis = entity.basis
    sets = (entity.approaches, entity.entries, entity.labels, entity.excluded, entity.opposed)
    return (
        entity.kind, basis.i, basis.j, entity.parked, entity.heading, entity.speed,
        entity.stands, entity.beside, entity.circulates, entity.crosses, entity.start_lane,
        entity.light,
        *(frozenset(s) for s in sets),
    )  # fmt: skip
