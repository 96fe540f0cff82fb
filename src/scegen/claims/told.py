"""What claims are derived from: a functional scenario and one of its logical ones."""

from dataclasses import dataclass
from functools import cached_property

from scegen.scenario.acts import Act, ActKind
from scegen.scenario.concrete import door_of
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant
from scegen.scenario.hazards import HAZARDS, Arrangement, Case
from scegen.scenario.in_line import unconcerned
from scegen.scenario.logical import ConflictKind, Crossing, Drive, LogicalScenario
from scegen.scenario.model import Interval
from scegen.scenario.outcome import OutcomeKind
from scegen.scenario.vocabulary import JunctionKind

KPH = 3.6


@dataclass(frozen=True)
class Told:
    """Both levels, and who does what in them.

    ``open_end``: where the text tells of no outcome, nobody has asked for one either, so that
    those who meet may touch or not. ``brought_together`` are two whom somebody asked to meet so
    closely, whatever the text says.
    """

    functional: FunctionalScenario
    logical: LogicalScenario
    open_end: bool = False
    brought_together: tuple[str, ...] = ()

    @property
    def ego(self) -> str:
        """The id of the ego."""
        return self.functional.ego.id

    @property
    def people(self) -> tuple[Participant, ...]:
        """Everybody in traffic."""
        return self.functional.participants

    @property
    def plain_road(self) -> bool:
        """Whether the road has no junction."""
        return self.functional.junction.kind is JunctionKind.STRAIGHT

    def drive(self, name: str) -> Drive | None:
        """How somebody drives, None if it does not."""
        return next((d for d in self.logical.drives if d.participant == name), None)

    def crossing(self, name: str) -> Crossing | None:
        """Where somebody crosses, None if it does not."""
        return next((c for c in self.logical.crossings if c.participant == name), None)

    def way(self, name: str) -> Drive | Crossing | None:
        """How somebody drives or goes across, None if it does neither."""
        return self.drive(name) or self.crossing(name)

    def unresponsive(self, name: str) -> bool:
        """Whether it is said to brake for nobody."""
        return any(p.unresponsive for p in self.people if p.id == name)

    def reverses(self, name: str) -> bool:
        """Whether somebody drives backwards."""
        drive = self.drive(name)
        return (drive is not None and drive.reverses is not None) or any(
            act.kind is ActKind.REVERSE for act in self.acts_of(name)
        )

    def acts_of(self, name: str) -> tuple[Act, ...]:
        """What somebody does, in order."""
        return tuple(act for act in self.functional.acts if act.participant == name)

    @cached_property
    def hazards(self) -> tuple[Hazard, ...]:
        """The dangers, with everybody named who causes and who suffers them.

        What one alone causes and nobody is said to suffer, anybody else may who can; where there is
        nobody, what lies in its way, of who drives into that.
        """
        return tuple(
            hazard if hazard.to or len(hazard.by) != 1 else self._to_anybody(hazard)
            for hazard in self.logical.hazards or self.functional.hazards
        )

    def _to_anybody(self, hazard: Hazard) -> Hazard:
        out = unconcerned(self.functional, hazard.kind, hazard.by)
        others = tuple(p.id for p in self.people if p.id not in out and not p.parked)
        into = Arrangement.INTO in HAZARDS[hazard.kind].needs.get(Case.ANYWHERE, ())
        things = (t.id for t in self.functional.objects if into and t.in_way_of in hazard.by)
        return hazard.but(to=others or tuple(things))

    @property
    def collides(self) -> bool:
        """Whether it ends in a contact."""
        outcome = self.functional.outcome
        return outcome is not None and outcome.kind is OutcomeKind.COLLISION

    def concerned_by(self, name: str) -> set[str]:
        """Who endangers somebody, or whose way meets its own; not who only stands beside."""
        pairs: list[tuple[str, ...]] = [
            (by, to) for h in self.hazards for by in h.by for to in h.to
        ]
        pairs += [
            (c.first, c.second) for c in self.logical.conflicts if c.kind is not ConflictKind.NONE
        ]
        if self.functional.outcome is not None:
            pairs.append(self.functional.outcome.between)
        known = {p.id for p in self.people}
        return {other for pair in pairs if name in pair for other in pair} & known - {name}

    @cached_property
    def doors(self) -> dict[str, str]:
        """Whose the doors are that open."""
        acts = (act for act in self.functional.acts if act.kind is ActKind.OPEN_DOOR)
        return {door_of(act.participant): act.participant for act in acts}

    def may_touch(self, first: str, second: str) -> bool:
        """Whether a contact of two is what is said, or what nobody decided on.

        A door is a part of its vehicle.
        """
        outcome = self.functional.outcome
        if not (self.collides or (outcome is None and self.open_end)):
            return False
        first, second = (self.doors.get(name, name) for name in (first, second))
        if outcome is None:
            return second in self.concerned_by(first)
        between = set(outcome.between) or {self.ego}
        return between <= {first, second} if len(between) > 1 else bool(between & {first, second})

    def words(self, field: str) -> str | None:
        """The words that a field rests on, or those behind the field above it.

        What a whole (an act, an outcome) rests on is what its kind rests on.
        """
        said = {e.field: e.text for e in self.functional.evidence if e.text is not None}
        while field:
            for name in (field, f"{field}.kind"):
                if name in said:
                    return said[name]
            field = field.rpartition(".")[0]
        return None


def speed_words(wanted: Interval) -> str:
    """A speed as people say it."""
    return f"{amount(wanted, KPH)} km/h"


def amount(wanted: Interval, factor: float = 1.0) -> str:
    """A number or a range of numbers."""
    low, high = (
        f"{value * factor:.2f}".rstrip("0").rstrip(".") for value in (wanted.low, wanted.high)
    )
    return low if low == high else f"{low} to {high}"


def plain(word: str) -> str:
    """A word of the vocabulary as people write it."""
    return word.replace("_", " ")


def either(words: list[str]) -> str:
    """Alternatives in a row."""
    return " or ".join(words)
