"""Builds the junction: its shape, arms, lanes and control, as said or as implied."""

from dataclasses import dataclass

from scegen.scenario.bends import Bend
from scegen.scenario.junction import ARM_COUNTS, Junction
from scegen.scenario.roadway import AuxiliaryLane, Carriageway
from scegen.scenario.vocabulary import (
    Approach,
    Control,
    DrivingSide,
    HazardKind,
    JunctionKind,
    Maneuver,
)
from scegen.understanding.building.beside import AT_JUNCTIONS, Used, auxiliary_lane, strips_beside
from scegen.understanding.building.in_lane import lanes_of_road
from scegen.understanding.building.writing import Proofs
from scegen.understanding.draft import Draft
from scegen.understanding.entity import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.road.junctions import JunctionReading
from scegen.understanding.road.lengthwise import Lengthwise
from scegen.understanding.road.surroundings import Surroundings

_ROUNDABOUT_ARMS = 4
_NO_LIGHT_HERE = "lights stand at intersections only: this is read as one, with four ways"
_DRIVEN_OVER = "no median, or one way, is built where somebody comes the other way or has one lane"
_NO_RAMP_HERE = "no ramp, or lane that ends, is built in a bend or at a junction; here is none"
_NO_LANE_SO_LONG = "no such lane is built here, so it has no length"
_AT_ARMS_END = "at a junction, crosswalks lie at the ends of the arms that somebody crosses"
_NOT_AT_RAMPS = "no crosswalk is built beside a ramp or a lane that ends"
_ALONG_LANES = frozenset({HazardKind.CUT_IN, HazardKind.OVERTAKING, HazardKind.MERGING_CONFLICT,
                          HazardKind.SWERVING, HazardKind.TAILGATING})  # fmt: skip


@dataclass(frozen=True, slots=True)
class Layout:
    """Decides what the road looks like, by what the `Builder` has at hand."""

    draft: Draft
    reading: JunctionReading
    around: Surroundings
    along: Lengthwise
    proofs: Proofs

    def build(self) -> Junction:
        """The junction; each of its fields is proved."""
        named = self.along.auxiliary
        drops = named is not None and named[0] is AuxiliaryLane.LANE_DROP
        used = auxiliary_lane(self.draft, drops=drops)
        kind, kind_basis = self._kind()
        self._of_a_ramp(kind, used)
        arms, arms_basis = self._arms(kind, kind_basis)
        control = self.reading.control or Control.UNCONTROLLED
        self.proofs.add("junction.kind", kind_basis, "no junction is named: a straight road")
        self.proofs.add("junction.arms", arms_basis)
        self.proofs.add("junction.control", self.reading.control_basis, "no control is named")
        self._dark_lights(control)
        lanes, ring, lanes_basis = lanes_of_road(self.draft, self.around, self.along, kind, arms)
        self.proofs.add(
            "junction.lanes", lanes_basis, "one lane per direction unless more are said"
        )
        if ring is not None:
            self.proofs.add("junction.ring_lanes", lanes_basis)
        said: dict[str, float] = {}
        for name in ("speed_limit_mps", "lane_width_m"):
            if name in self.around.road:
                said[name], basis = self.around.road[name]
                self.proofs.add(f"junction.{name}", basis)
        self.proofs.add("junction.driving_side", self.around.side_basis, "right-hand traffic")
        carriageway = self._carriageway(kind, lanes)
        auxiliary = self._auxiliary(kind, used)
        strips = strips_beside(self.draft, self.along, self.proofs, kind, carriageway, auxiliary)
        return Junction(
            carriageway=carriageway,
            strips=strips,
            bend=self._bend(kind),
            auxiliary=auxiliary,
            auxiliary_length_m=self._auxiliary_length_m(auxiliary),
            crosswalks=self._crosswalks(kind, auxiliary),
            kind=kind,
            arms=arms,
            lanes=lanes,
            ring_lanes=ring,
            driving_side=self.around.side or DrivingSide.RIGHT,
            control=control,
            **said,
        )

    def _of_a_ramp(self, kind: JunctionKind, used: Used) -> None:
        """A median parts the directions of a road with ramps, where nothing else is said."""
        built = kind is JunctionKind.STRAIGHT and self.along.bend is None
        ramp = built and used is not None and used[0] is not AuxiliaryLane.LANE_DROP
        if ramp and used is not None and self.along.carriageway is None:
            self.along.carriageway, self.along.carriageway_basis = Carriageway.DIVIDED, used[1]
            self.along.presumed = True
            self.around.highway = self.around.highway or used[1]

    def _dark_lights(self, control: Control) -> None:
        """What of lights that flash or do not work the road does not show."""
        draft, dark, basis = self.draft, self.reading.dark, self.reading.control_basis
        if control is Control.ALL_WAY_STOP and self._flashes(basis):
            draft.note_at(basis, "flashing red tells everybody to stop: stop signs stand for it")
        if dark is None or dark.i is None:
            return
        begins, ends = dark.i, dark.j or dark.i
        # The control rests on these words: "do not work" is no deed left out.
        draft.notes = [n for n in draft.notes if not begins <= n.i < n.j <= ends]
        if control is not Control.SIGNALS_OFF:
            draft.note_at(dark, f"the rule of the junction is {control}; the lights are left out")
        elif self._flashes(dark):
            draft.note_at(dark, "lights that do not regulate are shown dark, not flashing")

    def _flashes(self, basis: Basis | None) -> bool:
        words = self.draft.tokens[basis.i : basis.j] if basis is not None else []
        return not word_list("flashing").isdisjoint(t.low for t in words)

    def _carriageway(self, kind: JunctionKind, lanes: tuple[int, ...]) -> Carriageway:
        """As the words have it; at junctions, and where the other lanes are used, undivided."""
        said, basis = self.along.carriageway, self.along.carriageway_basis
        if said is None or basis is None:
            return Carriageway.UNDIVIDED
        if kind is not JunctionKind.STRAIGHT:
            if self.along.median or not self.along.presumed:
                self.draft.note_at(basis, AT_JUNCTIONS)
            return Carriageway.UNDIVIDED
        narrow = lanes[:1] == (1,) or self.around.two_lane is not None
        against, one_way = self._meets_the_oncoming(), said is Carriageway.ONE_WAY
        if (self.along.presumed and narrow) or (against and (self.along.presumed or one_way)):
            told = any(note.i == basis.i for note in self.draft.notes)
            if (self.along.median or one_way) and not told:
                self.draft.note_at(basis, _DRIVEN_OVER)
            return Carriageway.UNDIVIDED
        self.proofs.add("junction.carriageway", basis)
        return said

    def _meets_the_oncoming(self) -> bool:
        """Whether somebody comes towards another, or turns back, so that no median can be there."""
        known = self.draft.entities
        meets = any(d.kind is HazardKind.ONCOMING_LANE for d in self.draft.dangers)
        turns = any(Maneuver.U_TURN in entity.maneuvers for entity in known)
        return meets or turns or any(Approach.OPPOSITE in entity.approaches for entity in known)

    def _auxiliary(self, kind: JunctionKind, used: Used) -> AuxiliaryLane | None:
        """The lane for a part of the road that somebody uses; none in a bend or at junctions."""
        if used is None:
            return None
        if kind is not JunctionKind.STRAIGHT or self.along.bend is not None:
            self.draft.note_at(used[1], _NO_RAMP_HERE)
            return None
        self.proofs.add("junction.auxiliary", used[1])
        return used[0]

    def _auxiliary_length_m(self, auxiliary: AuxiliaryLane | None) -> float | None:
        length, basis = self.around.road.get("auxiliary_length_m", (None, None))
        if auxiliary is not None and length is not None:
            self.proofs.add("junction.auxiliary_length_m", basis)
            return length
        self.draft.note_at(basis, _NO_LANE_SO_LONG)
        return None

    def _crosswalks(self, kind: JunctionKind, auxiliary: AuxiliaryLane | None) -> frozenset[int]:
        """One over a road without a junction; at junctions they are wherever somebody crosses."""
        basis = self.along.crosswalk_basis
        if basis is None:
            return frozenset()
        if kind is not JunctionKind.STRAIGHT:
            if self.draft.tokens[(basis.i or 0) - 1].low in word_list("mid_block"):
                self.draft.note_at(basis, _AT_ARMS_END)
            return frozenset()
        if auxiliary is not None:
            self.draft.note_at(basis, _NOT_AT_RAMPS)
            return frozenset()
        self.proofs.add("junction.crosswalks", basis)
        return frozenset({0})

    def _bend(self, kind: JunctionKind) -> Bend | None:
        if self.along.bend is None:
            return None
        bend, basis = self.along.bend
        if kind is not JunctionKind.STRAIGHT:
            self.draft.note_at(basis, AT_JUNCTIONS)
            return None
        self.proofs.add("junction.bend", basis)
        return bend

    def _kind(self) -> tuple[JunctionKind, Basis | None]:
        reading = self.reading
        if reading.kind is not None:
            return reading.kind, reading.kind_basis
        if reading.named is not None:
            reason = "an intersection without a shape is read as four-way"
            return JunctionKind.FOUR_WAY, reading.named.because(reason)
        access = self.draft.implied.get("access")
        if access is not None and reading.straight is None and not self._backs_alone():
            if (across := self._across_the_main_road()) is not None:
                return JunctionKind.FOUR_WAY, across
            reason = "a side road or driveway meets the road like the stem of a T"
            return JunctionKind.T, access.because(reason)
        implied = self.draft.implied.get("crossing") or self._lateral()
        control = reading.control_basis if reading.control is not Control.UNCONTROLLED else None
        if implied is None and control is not None:
            implied = control.because("priority is regulated")
            self._lit_crosswalk(implied)
        implied = implied or self._side_road()
        if implied is not None:
            reason = f"{implied.reason}: there must be an intersection, read as four-way"
            return JunctionKind.FOUR_WAY, implied.because(reason)
        return JunctionKind.STRAIGHT, reading.straight or reading.road

    def _backs_alone(self) -> bool:
        """``backs out of a driveway; a child crosses behind it``: of roads, only that is needed."""
        backing = self.draft.causing(HazardKind.REVERSING)
        over = {Maneuver.CROSS}  # a cyclist
        moving = [e for e in self.draft.entities if e.moving_vehicle and e.maneuvers != over]
        return bool(moving) and all(e in backing for e in moving)

    def _lit_crosswalk(self, regulated: Basis) -> None:
        """``a pelican crossing``, ``a signalised mid-block crossing``: no road is built for it."""
        words = {t.low for t in self.draft.tokens}
        marked, light = self.along.crosswalk_basis, self.reading.control_basis
        if (marked is not None and marked == light) or words & word_list("mid_block"):
            self.draft.note_at(regulated, _NO_LIGHT_HERE)

    def _lateral(self) -> Basis | None:
        lateral, over = {Approach.LEFT, Approach.RIGHT}, {Maneuver.CROSS}  # a cyclist
        vehicles = [e for e in self.draft.entities if e.moving_vehicle and e.maneuvers != over]
        for placement in self.draft.placements:
            if placement.approaches == lateral and placement.entity in vehicles:
                return placement.basis.because("a vehicle comes across")
        for entity in vehicles:
            if entity.by_heading is not None and entity.approaches & lateral:
                basis = entity.heading_basis or entity.by_heading
                return basis.because("the ways of two vehicles cross")
        return None

    def _across_the_main_road(self) -> Basis | None:
        """``goes straight on from a minor road``: it goes on beyond the main one."""
        for entity in self.draft.entities:
            minor, basis = entity.on_minor or (False, None)
            straight = entity.maneuvers - {Maneuver.CROSS} == {Maneuver.STRAIGHT}
            if minor and basis is not None and straight:
                return basis.because("who comes from the side road goes straight across")
        return None

    def _side_road(self) -> Basis | None:
        """``a bus comes from the left``: not on a highway, and not one that changes lanes."""
        along = self.reading.straight is not None or self.around.highway is not None
        lanes = any(d.kind in _ALONG_LANES for d in self.draft.dangers)
        none = along or lanes or "from_kerb" in self.draft.implied
        return None if none else self.draft.implied.get("side_road")

    def _arms(self, kind: JunctionKind, basis: Basis | None) -> tuple[int, Basis]:
        reading = self.reading
        if reading.arms is not None:
            return reading.arms, reading.arms_basis or Basis(reason="from the words")
        if kind is JunctionKind.ROUNDABOUT:
            reason = f"the number of exits is not said; {_ROUNDABOUT_ARMS} are assumed"
            return _ROUNDABOUT_ARMS, Basis(reason=reason)
        arms = max(ARM_COUNTS[kind][0], 2)
        if basis is not None and basis.reason is None:
            return arms, Basis(basis.i, basis.j)
        return arms, Basis(reason=f"follows from the shape {kind.value}")
