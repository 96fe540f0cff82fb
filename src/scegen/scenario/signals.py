"""The lights of a junction over time: which arms have green together, and when."""

from collections.abc import Iterator
from enum import StrEnum

from pydantic import Field

from scegen.scenario.definitions import Word
from scegen.scenario.model import ArmSet, FrozenModel

_TICK_S = 1e-3
"""Changes are told to the millisecond: one so near to time 0 is at time 0."""


class AtLight(Word):
    """What the light shows as one goes over its stop line, on foot as one steps off the kerb."""

    GREEN = (
        "green",
        "goes while its light is green",
        "`waits`, which comes to it at red; what the text leaves open",
        "has green; crosses on green for pedestrians",
    )
    AMBER = (
        "amber",
        "drives over the line after green and before red",
        "a light that flashes amber (control `signals_off`)",
        "crosses on amber; enters just before the light turns red",
    )
    RED = (
        "red",
        "goes although its light is red; who drives also has the hazard `red_light_running`",
        "`waits`, `stops`",
        "a pedestrian crosses at red",
    )
    WAITS = (
        "waits",
        "stands at the line at red, and goes when its light has turned green",
        "`stops`, which does not go on; who stands there to the end (maneuver `stay`)",
        "when the light turns green it sets off; enters 2 s after its light has turned green",
    )
    STOPS = (
        "stops",
        "its light turns from green to amber and red as it comes; it comes to rest at the line",
        "`waits`, which goes on",
        "the light turns red and it stops",
    )


class SignalState(StrEnum):
    """What a light shows."""

    GREEN = "green"
    AMBER = "amber"
    RED = "red"
    OFF = "off"


class SignalGroup(FrozenModel):
    """Arms whose lights show the same; green begins ``green_from_s`` into every cycle.

    ``afoot``: those of people who cross these arms, which know no amber.
    """

    id: int = Field(ge=1)
    arms: ArmSet
    green_from_s: float = Field(ge=0)
    green_s: float = Field(gt=0)
    afoot: bool = False


class SignalPlan(FrozenModel):
    """Lights with a fixed cycle, which has gone on before time 0 and goes on for ever.

    Every group has its green, then ``amber_s`` of amber (nobody on foot has), then red. Lights
    that are not ``working`` are dark all the time.
    """

    cycle_s: float = Field(gt=0, le=300)
    amber_s: float = Field(gt=0, le=10)
    groups: tuple[SignalGroup, ...] = Field(min_length=1)
    working: bool = True

    def group_of(self, arm: int, *, afoot: bool = False) -> SignalGroup | None:
        """The group of those who enter by an arm, or cross it; None where no light stands."""
        return next((g for g in self.groups if arm in g.arms and g.afoot is afoot), None)

    def free_s(self, group: SignalGroup) -> float:
        """How long after the beginning of green red begins."""
        return group.green_s + (0.0 if group.afoot else self.amber_s)

    def window_s(self, group: SignalGroup, light: AtLight | None) -> tuple[float, float]:
        """From when to when after the beginning of its green one who meets it so goes.

        Whose light is not told goes at any time but red.
        """
        free_s = self.free_s(group)
        if light is None:
            return 0.0, free_s
        if light in {AtLight.GREEN, AtLight.WAITS}:
            return 0.0, group.green_s
        return (free_s, self.cycle_s) if light is AtLight.RED else (group.green_s, free_s)

    def state(self, group: SignalGroup, time_s: float) -> SignalState:
        """What the lights of a group show at a time."""
        if not self.working:
            return SignalState.OFF
        since = (time_s - group.green_from_s) % self.cycle_s
        if since < group.green_s:
            return SignalState.GREEN
        return SignalState.AMBER if since < self.free_s(group) else SignalState.RED

    def changes(self, group: SignalGroup, until_s: float) -> Iterator[tuple[float, SignalState]]:
        """(time, state) at time 0 and at every change after it, up to a time."""
        yield 0.0, self.state(group, _TICK_S / 2)
        if not self.working:
            return
        edges = [(0.0, SignalState.GREEN), (self.free_s(group), SignalState.RED)]
        if not group.afoot:
            edges.insert(1, (group.green_s, SignalState.AMBER))
        first = group.green_from_s - self.cycle_s
        for cycle in range(int(until_s / self.cycle_s) + 3):
            for edge, state in edges:
                time_s = round(first + cycle * self.cycle_s + edge, 3)
                if 0.0 < time_s <= until_s:
                    yield time_s, state
