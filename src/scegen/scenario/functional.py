"""Functional scenario (PEGASUS level 1): what a description says, in words and sets.

A set holds every value that the text allows; an empty set leaves the choice to enumeration.
"""

from collections import Counter
from collections.abc import Collection, Iterator
from typing import Annotated, Literal

from pydantic import Field

from scegen.scenario.acts import Act, ActKind, AfterAct
from scegen.scenario.bodies import BODIES, LENGTHS_M, WIDTHS_M, Body
from scegen.scenario.environment import Environment
from scegen.scenario.evidence import Evidence, Unsupported
from scegen.scenario.junction import Junction
from scegen.scenario.model import (
    ArmSet,
    CheckedModel,
    FrozenModel,
    Identifier,
    Interval,
    Magnitude,
    VocabularySet,
    between,
    middles,
)
from scegen.scenario.outcome import Outcome
from scegen.scenario.roadway import Strip
from scegen.scenario.signals import AtLight
from scegen.scenario.spacings import CONTACT, START, Spacing
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import (
    ON_FOOT,
    Approach,
    Control,
    CrossedArm,
    HazardKind,
    JunctionKind,
    Maneuver,
    ParticipantKind,
    Role,
)

MOST_GREEN_DELAY_S = 10.0
_SHOWN = 4
"""Phrases that a line names."""
_OF_PARKED = {Maneuver.STAY, Maneuver.STRAIGHT, Maneuver.LANE_CHANGE, Maneuver.U_TURN}


class Participant(CheckedModel):
    """Somebody or something in traffic.

    ``approaches`` are relative to the ego, ``adjacent`` with ``left`` or ``right`` is the lane
    beside on that side; ``entries`` are arm numbers; ``lanes`` the lanes in which it may start,
    counted from 1 at the centre line (or the island) outwards, empty = free; ``speed_mps`` is the
    range that the text gives until the first act that concerns it, None if it gives none. One who
    is ``parked`` stands beside the travelled lanes; with ``maneuvers`` other than to stay it pulls
    out. One who stands in the lane is not parked and has the maneuver ``stay``. ``circulating``: it
    is in the roundabout already. ``strip`` is one of the junction's ``strips`` beside the lanes, on
    which it stands, drives or walks at first; None where that is not said. A pedestrian whose
    maneuver is ``straight`` walks along the road. ``crosses`` tells which arm one crosses, by the
    way of whom it meets, None if either; the ``approaches`` of who crosses are the sides as that
    one sees them on its course where they meet. ``light`` is what the light that stands for it
    shows as it goes, and how it meets that, None if not said; people on foot only go at ``green``
    or ``red``. An emergency vehicle ``on_call`` has its siren and its lights on: everybody gives
    way to it where their ways cross or join, and it need not wait for signs and lights. One who is
    ``unresponsive`` brakes for nobody: apart from its own acts it drives on as it did.
    One that waits sets off ``green_delay_s`` after its light has turned green, None if not said.
    ``length_m`` and ``width_m`` are its size, None where it is as large as its kind usually is.
    """

    id: Identifier
    kind: ParticipantKind = ParticipantKind.CAR
    role: Role = Role.OTHER
    parked: bool = False
    approaches: VocabularySet[Approach] = frozenset()
    maneuvers: VocabularySet[Maneuver] = frozenset()
    entries: ArmSet = frozenset()
    lanes: ArmSet = frozenset()
    circulating: bool = False
    on_call: bool = False
    unresponsive: bool = False
    strip: Strip | None = None
    crosses: CrossedArm | None = None
    light: AtLight | None = None
    green_delay_s: Annotated[Interval, between(0.0, MOST_GREEN_DELAY_S)] | None = None
    speed_mps: Magnitude | None = None
    length_m: Annotated[Interval, between(*LENGTHS_M)] | None = None
    width_m: Annotated[Interval, between(*WIDTHS_M)] | None = None

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        if self.kind is ParticipantKind.DOOR:
            yield f"{self.id}: a door is no participant; its vehicle has the act open_door"
        if self.green_delay_s is not None and self.light is not AtLight.WAITS:
            yield f"{self.id}: green_delay_s is of one who waits for green, with `light: waits`"
        if self.on_call and self.kind is not ParticipantKind.EMERGENCY_VEHICLE:
            yield f"{self.id}: only an emergency_vehicle is on call, not a {self.kind}"
        if self.parked and not self.maneuvers <= _OF_PARKED:
            yield f"{self.id} is parked: its maneuvers are of {', '.join(sorted(_OF_PARKED))}"

    @property
    def body(self) -> Body:
        """Its size and its limits."""
        return BODIES[self.kind].sized(*middles(self.length_m, self.width_m))

    @property
    def pulls_out(self) -> bool:
        """Whether it is parked at first and then drives."""
        return self.parked and bool(self.maneuvers - {Maneuver.STAY, Maneuver.CROSS})


class Relation(FrozenModel):
    """Where ``participant`` comes from, seen from a ``reference`` that is not the ego."""

    participant: Identifier
    reference: Identifier
    approaches: VocabularySet[Approach] = Field(min_length=1)


class Hazard(FrozenModel):
    """A danger: its kind, who causes it, who suffers it (ids; empty = not said)."""

    kind: HazardKind
    by: tuple[Identifier, ...] = ()
    to: tuple[Identifier, ...] = ()


class Group(CheckedModel):
    """So many of the ``members``, no matter which, do one of these maneuvers; the others do not.

    What a text says of some of several alike ("three of the ten turn left") stands here and not
    with any one of them, so they stay interchangeable.
    """

    members: tuple[Identifier, ...] = Field(min_length=2)
    number: int = Field(ge=0)
    maneuvers: VocabularySet[Maneuver] = Field(min_length=1)

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        if self.number > len(self.members):
            yield f"{self.number} of {len(self.members)} members are more than there are"


def _twice(names: Collection[str]) -> str | None:
    """The first name that stands there more than once."""
    return next((name for name, times in Counter(names).items() if times > 1), None)


class FunctionalScenario(CheckedModel):
    """A description, understood. Exactly one participant is the ego."""

    level: Literal["functional"] = "functional"
    description: str = ""
    junction: Junction
    participants: tuple[Participant, ...] = Field(min_length=1)
    relations: tuple[Relation, ...] = ()
    groups: tuple[Group, ...] = ()
    hazards: tuple[Hazard, ...] = ()
    objects: tuple[Thing, ...] = ()
    spacings: tuple[Spacing, ...] = ()
    acts: tuple[Act, ...] = ()
    outcome: Outcome | None = None
    environment: Environment = Environment()
    evidence: tuple[Evidence, ...] = ()
    unsupported: tuple[Unsupported, ...] = ()

    @property
    def unjudged(self) -> str | None:
        """What of the text no field expresses, so that no statement is made of it, in words."""
        phrases = [f'"{u.text}"' for u in self.unsupported]
        if not phrases:
            return None
        shown = ", ".join(phrases[:_SHOWN]) + (", …" if len(phrases) > _SHOWN else "")
        counted = "1 phrase is" if len(phrases) == 1 else f"{len(phrases)} phrases are"
        return f"{counted} not expressed and not judged: {shown}"

    def misfits(self) -> Iterator[str]:
        """See CheckedModel."""
        ids = [*(p.id for p in self.participants), *(thing.id for thing in self.objects)]
        if doubled := _twice(ids):
            yield f"two participants or objects are called {doubled!r}"
        egos = [p.id for p in self.participants if p.role is Role.EGO]
        if len(egos) != 1:
            named = ", ".join(egos) or "none"
            yield f"exactly one participant must have the role ego, found {named}"
        for participant in self.participants:
            if any(not 0 <= arm < self.junction.arms for arm in participant.entries):
                yield (
                    f"{participant.id} enters at an arm outside 0..{self.junction.arms - 1}: "
                    f"{sorted(participant.entries)}"
                )
            if participant.strip is not None and participant.strip not in self.junction.strips:
                yield (
                    f"{participant.id} is on the strip {participant.strip}, which is not one of "
                    "junction.strips"
                )
            if participant.circulating and self.junction.kind is not JunctionKind.ROUNDABOUT:
                yield f"{participant.id} is circulating, but junction.kind is not roundabout"
            if participant.crosses is not None and participant not in self.crossers:
                yield f"{participant.id} has `crosses`, but it does not cross"
            yield from self._has_a_light(participant)
        yield from self._names_known(ids)

    def _has_a_light(self, participant: Participant) -> Iterator[str]:
        """Whoever meets a light in some way has one that can show it."""
        if participant.light is None:
            return
        if self.junction.control is not Control.SIGNALS:
            yield f"{participant.id} has a light, but junction.control is not signals"
        if participant in self.crossers and participant.light not in {AtLight.GREEN, AtLight.RED}:
            yield f"{participant.id} crosses: its light is green or red, not {participant.light}"
        if participant.light is AtLight.WAITS and participant.maneuvers == {Maneuver.STAY}:
            yield (
                f"{participant.id} waits at its light, so it goes on at green: it does not `stay`. "
                "Leave the maneuver out; who stands there at first has speed_mps 0"
            )

    def _names_known(self, known: Collection[str]) -> Iterator[str]:
        """Whoever is named takes part (or is an object), and every act that is named happens."""
        named = [
            (name, "relations") for r in self.relations for name in (r.participant, r.reference)
        ]
        named += [(name, "groups") for g in self.groups for name in g.members]
        named += [(name, f"hazards.{h.kind}") for h in self.hazards for name in (*h.by, *h.to)]
        named += [(name, f"objects.{o.id}") for o in self.objects for name in o.hides]
        named += [(o.in_way_of, f"objects.{o.id}") for o in self.objects if o.in_way_of]
        named += [
            (name, "spacings") for s in self.spacings for name in (s.participant, s.reference)
        ]
        named += [(act.participant, f"acts.{act.id}") for act in self.acts]
        named += [(act.into, f"acts.{act.id}.into") for act in self.acts if act.into]
        named += [(name, "outcome") for name in (self.outcome.between if self.outcome else ())]
        moments = [s.at for s in self.spacings if s.at not in {START, CONTACT}]
        for act in self.acts:
            if isinstance(act.when, AfterAct):
                moments.append(act.when.act)
            watched = (getattr(act.when, role, None) for role in ("participant", "reference"))
            named += [(name, f"acts.{act.id}.when") for name in watched if name]
        for name, place in named:
            if name not in known:
                msg = f"{place} names the unknown participant {name!r}; "
                msg += f"known: {', '.join(sorted(known))}"
                yield msg
        yield from self._moments_known(moments)

    def _moments_known(self, moments: Collection[str]) -> Iterator[str]:
        """Every act that is named as a moment is told of, and has one."""
        acts = [act.id for act in self.acts]
        if doubled := _twice(acts):
            yield f"two acts are called {doubled!r}"
        for moment in moments:
            if moment not in acts:
                yield f"the unknown act {moment!r} is named; known: {', '.join(acts) or 'none'}"
        for act in self.acts:
            if act.kind is ActKind.GIVE_WAY and act.into is None:
                yield f"acts.{act.id} gives way to nobody: say in `into` to whom"
            if act.kind is ActKind.GIVE_WAY and act.id in moments:
                msg = f"acts.{act.id} gives way, which has no moment of its own: "
                msg += "leave out the trigger or spacing that names it, or let it `wait`"
                yield msg

    @property
    def ego(self) -> Participant:
        """The vehicle under test."""
        return next(p for p in self.participants if p.role is Role.EGO)

    def participant(self, name: str) -> Participant:
        """The participant with this id; KeyError if there is none."""
        return {p.id: p for p in self.participants}[name]

    @property
    def sayings(self) -> tuple[tuple[str, str, frozenset[Approach]], ...]:
        """Who comes from where: (who, seen from whom, in which words), as far as it is said."""
        ego = self.ego.id
        seen = [(p.id, ego, p.approaches) for p in self.participants if p.approaches]
        return (*seen, *((r.participant, r.reference, r.approaches) for r in self.relations))

    def overtaken(self, name: str) -> tuple[str, ...]:
        """Whom somebody is said to pass, by an act or as a danger."""
        kind = ActKind.OVERTAKE
        whom = [a.into for a in self.acts if (a.participant, a.kind) == (name, kind) and a.into]
        for hazard in self.hazards:
            if hazard.kind is HazardKind.OVERTAKING and name in hazard.by:
                whom += hazard.to
        return tuple(dict.fromkeys(whom))

    @property
    def vehicles(self) -> tuple[Participant, ...]:
        """Participants that drive from an entry to an exit: not parked, walking or crossing."""
        return tuple(
            p
            for p in self.participants
            if not p.parked and p.kind not in ON_FOOT and p.maneuvers != frozenset({Maneuver.CROSS})
        )

    @property
    def on_call(self) -> frozenset[str]:
        """The emergency vehicles to which everybody gives way."""
        return frozenset(p.id for p in self.participants if p.on_call)

    @property
    def crossers(self) -> tuple[Participant, ...]:
        """Pedestrians, animals, and cyclists whose maneuver is to cross."""
        return tuple(p for p in self.participants if not p.parked and p not in self.vehicles)
