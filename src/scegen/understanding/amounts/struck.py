"""Where on the ego somebody touches it: which side, which half of its front, its middle."""

from __future__ import annotations

from scegen.scenario.model import Interval
from scegen.scenario.spacings import CONTACT, Measure
from scegen.scenario.vocabulary import BodySide, HazardKind, ParticipantKind, Side
from scegen.understanding.amounts.teller import Teller
from scegen.understanding.amounts.whom import ego_of
from scegen.understanding.chunks import NounPhrase, Place, Thing
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import words
from scegen.understanding.happenings import Amount, Apart, Ending

_WHOLE, _HALF, _LITTLE = 100.0, 50.0, 10.0
_PARTS = {"front": BodySide.FRONT, "rear": BodySide.REAR, "left": BodySide.LEFT,
          "right": BodySide.RIGHT}  # fmt: skip
_OPPOSED = {BodySide.FRONT: BodySide.REAR, BodySide.REAR: BodySide.FRONT}
_REACH = 7


class Struck(Teller):
    """Reads which part of the ego is touched."""

    def read(self, ending: Ending) -> None:
        """``the middle of the ego's front``, ``hits its rear``: which side, and where on it."""
        i = ending.basis.i or 0
        start, end = self._text.bounds(i)
        ego = ego_of(self._context)
        for place in self._text.places(start, end, {"side", "front", "flank"}):
            if self._text.tokens[place.i - 2].low == "overlap":
                continue
            corner = "front" in place.dirs and bool({"left", "right"} & set(place.dirs))
            part = next((_PARTS[d] for d in place.dirs if d in _PARTS), None)
            part = BodySide.FRONT if corner else part
            whose = self._owner(place, i, ending)
            flank = part is not None and part not in _OPPOSED
            hit_by = place.prep is not None and place.prep.value in {"by", "with"}
            on = place.prep is not None and place.prep.value == "in"
            on = on and (place.head is not None or any("of_body" in m.data for m in place.mods))
            hit_by = hit_by or (on and ego is not None and self._is_hit(ego, i))
            into = place.prep is not None and place.prep.value in {"in", "into"}
            told = place.owner is not None or any(m.cat == "possessive" for m in place.mods)
            hit_by = hit_by or (into and told and whose is ego)
            direct = any(s.event.i == i and s.event.object is place for s in self._text.scenes)
            hit_by = hit_by or (direct and whose is ego)
            if part is None or whose is None or (flank and not (hit_by and whose is ego)):
                continue
            basis = Basis(place.i, place.j)
            half = self._portion(place) or (place if corner else None)
            half = half if whose is ego and part is BodySide.FRONT else None
            if half is not None:
                ending.half = Side.LEFT if "left" in half.dirs else Side.RIGHT
                ending.half_basis = basis = Basis(half.i, place.j)
            if whose is ego and ending.struck is None:
                ending.struck, ending.struck_basis = part, basis
                self._middle(ending, place, start)
            elif (
                ending.struck is None
                and not flank
                and ego in ending.between
                and part is BodySide.REAR
            ):
                backs = any(
                    d.kind is HazardKind.REVERSING and ego in d.by
                    for d in self._context.draft.dangers
                )
                ending.struck = BodySide.REAR if backs else BodySide.FRONT
                ending.struck_basis = basis

    def _portion(self, place: Place) -> NounPhrase | None:
        """``the left half`` of its front, ``the right corner`` of the ego's front."""
        of = (place.i if place.owner is None else place.owner.i) - 1
        if self._text.tokens[of].low != "of":
            return None
        named = [c for c in self._text.chunks if isinstance(c, Place | Thing) and c.i < of]
        ends = (p for p in named if p.j in {of - 1, of} and {"left", "right"} & set(p.dirs))
        return next(ends, None)

    def settle(self) -> None:
        """What half of the front is touched, by the numbers if any: by whom it is narrow, where."""
        ending, ego = self._happenings.ending, ego_of(self._context)
        if ending is None or ending.half is None or ending.impact is not None:
            return
        basis, left = ending.half_basis or ending.basis, ending.half is Side.LEFT
        other = next((e for e in ending.between if e is not ego), None)
        told = [s for s in self._happenings.spacings if s.measure is Measure.OVERLAP_PERCENT]
        for overlap in told:
            known = overlap.amount.basis
            begins, ends = min(known.i or 0, basis.i or 0), max(known.j or 0, basis.j or 0)
            overlap.amount = Amount(overlap.amount.value, Basis(begins, ends, known.reason))
            overlap.side = overlap.side or ending.half
        if told:
            return
        if other is not None and other.is_vehicle and other.kind is not ParticipantKind.BICYCLE:
            amount = Amount(Interval(low=_LITTLE, high=_HALF), basis)
            apart = Apart(Measure.OVERLAP_PERCENT, other, ego, amount, CONTACT, ending.half)
            self._happenings.spacings.append(apart)
        else:
            value = Interval(low=0.0 if left else _HALF, high=_HALF if left else _WHOLE)
            ending.impact = Amount(value, basis)

    def _is_hit(self, ego: Entity, i: int) -> bool:
        return any(
            ego in s.targets and ego not in s.actors for s in self._text.scenes if s.event.i == i
        )

    def _owner(self, place: Place, i: int, ending: Ending) -> Entity | None:
        """Whose part it is: "the ego's front", "the rear of the car", "its rear"."""
        if place.owner is not None and place.owner.entities:
            owner: Entity = place.owner.entities[0]
            does = any(owner in s.actors for s in self._text.scenes if s.event.i == i)
            others = [e for e in ending.between if e is not owner]
            # "it crashes into the back of it" is into another's.
            return others[0] if does and place.owner.pronoun and len(others) == 1 else owner
        if any((m.cat, m.value) == ("possessive", "first_person") for m in place.mods):
            return ego_of(self._context)
        own = any(m.cat == "possessive" and m.value == "its" for m in place.mods)
        done = [s for s in self._text.scenes if s.event.object is place]
        scene = next((s for s in (*done, *self._text.scenes) if s in done or s.event.i == i), None)
        if scene is None:
            return None
        direct = scene.event.object is place
        flank = bool({"left", "right"} & set(place.dirs))
        at = place.prep is not None and place.prep.value == "in"
        if at and scene.event.name == "collide" and scene.targets:
            return scene.targets[0]  # "hits us in the side", "is hit on its right side"
        into = place.prep is not None and place.prep.value == "into"
        met = direct or (into and (flank or not scene.event.passive))
        if met and own and scene.actors:  # "a car behind hits its rear"
            ego = ego_of(self._context)
            return (
                next((e for e in ending.between if not e.ego), None) if scene.actors[0].ego else ego
            )
        if own or not direct:
            doer = scene.actors[0] if scene.actors else None
            hit_by = scene.event.passive and place.prep is not None and place.prep.value == "by"
            return ego_of(self._context) if hit_by or doer is None else doer
        return None

    def _middle(self, ending: Ending, place: NounPhrase, start: int) -> None:
        """``with the middle of its front``."""
        tokens = self._text.tokens
        for k in range(max(start, place.i - _REACH), place.i):
            part = k + 1 == place.i or tokens[k + 1].low in {"of", "front"}
            if part and tokens[k].low in words()["middle"]:
                value = Interval(low=_HALF, high=_HALF)
                ending.impact = Amount(value, Basis(k, place.j))
