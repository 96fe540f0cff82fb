"""Numbers that say how an act is done: how hard, how fast at the end, how long, how far aside."""

from __future__ import annotations

from scegen.scenario.acts import FAR, LASTING, ActKind
from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import Side
from scegen.understanding.amounts.teller import Teller
from scegen.understanding.chunks import Event
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import Measured
from scegen.understanding.frames import acts as frames
from scegen.understanding.happenings import STILL, Amount, Doing, Trigger, amount_of, exactly
from scegen.understanding.lexicon import word_list

_ALONG = frozenset({ActKind.BRAKE, ActKind.ACCELERATE, ActKind.STOP, ActKind.SET_OFF})
_ASIDE = frozenset({ActKind.CHANGE_LANE, ActKind.SWERVE})
_GAINING = frozenset({ActKind.ACCELERATE, ActKind.SET_OFF})
FIELDS: dict[str, tuple[str, frozenset[ActKind]]] = {
    "rate": ("rate_mps2", _ALONG),
    "speed_after": ("target_speed_mps", _ALONG),
    "speed_change": ("target_speed_mps", _ALONG),
    "duration": ("duration_s", LASTING),
    "distance": ("distance_m", FAR),
    "lateral_speed": ("lateral_mps", _ASIDE),
    "lateral_move": ("lateral_m", _ASIDE),
}
"""Role of a number -> field of an act, and which acts have it."""


class Filler(Teller):
    """Gives numbers to acts."""

    def read(self, number: Measured) -> bool:
        """One number; whether an act takes it.

        Args:
            number: the number.
        """
        role = number.frame.role
        name, kinds = FIELDS[role]
        event = self._text.verb_at(number.i, number.j)
        keeps = role == "duration" and event is not None and event.name == "match"
        if keeps:  # "brakes to 60 km/h and holds that speed for 4 s": no longer braking
            return self._before_the_next(number)
        rests = role == "duration" and self._rests(number, event)
        doing = rests or self.likewise(number, kinds) or self._act(number, kinds, name, event)
        if doing is None and role == "duration":
            taken = any(number.around.preceded(w) for w in word_list("taking_time"))
            return not taken and self._before_the_next(number)
        doing = doing or self._made(number, role, event)
        return doing is not None and self._give(doing, number, name)

    def _rests(self, number: Measured, event: Event | None) -> Doing | None:
        """``stops and stands there for 8 s``: how long one is at rest, not how it gets there."""
        taken = any(number.around.preceded(w) for w in ("in", "within", "over", "takes", "lasts"))
        if taken or event is None or event.name not in {"wait", "stop"}:
            return None
        clause = self._text.scene_at(number.i, number.j)
        who = [e for e in (clause.actors if clause is not None else []) if e.is_vehicle]
        who = who or [e for e in self._text.subject_before(number.i) if e.is_vehicle]
        if not who:
            return None
        entity = who[0]
        start, _ = self._text.bounds(number.i)
        own = [a for a in self._happenings.acts if a.entity is entity and start <= a.i <= event.i]
        if own and own[-1].kind is ActKind.STOP and not own[-1].amounts:
            own[-1].kind, own[-1].always = ActKind.WAIT, True
            own[-1].told.append(event.i)
            return own[-1]
        return self.add(Doing(ActKind.WAIT, entity, Basis(event.i, event.j), event.i))

    def _give(self, doing: Doing, number: Measured, name: str) -> bool:
        """Gives a number to a field of an act."""
        role = number.frame.role
        plain = role.startswith("lateral") or role in {"duration", "distance"}
        plain = plain or number.around.before.endswith(" up to ")  # where it ends, no bound
        amount = exactly(number) if plain else amount_of(number)
        if role == "rate" and doing.kind is ActKind.STOP:
            doing.kind = ActKind.BRAKE
            doing.amounts.setdefault("target_speed_mps", Amount(STILL, doing.basis))
        if role == "speed_change":
            changed = self._changed(doing, number)
            if changed is None:
                return False
            amount = changed
        if role == "lateral_move":
            doing = self._further(doing) if name in doing.amounts else doing
            self._side(doing, number)
        for same in self._alike(doing):
            same.amounts.setdefault(name, amount)
        return True

    def _alike(self, doing: Doing) -> list[Doing]:
        """``both brake with 6 m/s²``: each of them."""
        return [a for a in self._happenings.acts if a.i == doing.i and a.kind is doing.kind]

    def _act(
        self, number: Measured, kinds: frozenset[ActKind], name: str, event: Event | None
    ) -> Doing | None:
        """The act of a number: the last before it in its sentence, else the next, else the last."""
        start, end = self._text.bounds(number.i)
        fitting = [a for a in self._happenings.acts if a.kind in kinds]
        here = [a for a in fitting if start <= a.i < end]
        if number.frame.role == "duration" and event is not None:
            near = {
                e.i for e in (event, *event.children, *([event.parent] if event.parent else []))
            }
            own = [a for a in here if near & {a.i, *a.told}]
            own = own or self.named_by(event, fitting)
            moves = [a for a in here if a.i < number.i and a.kind is not ActKind.STOP]
            own = own or [a for a in moves if self._of(a, event)]  # "changes lanes, needing 5 s"
            return own[-1] if own else None
        if event is not None and self._unread(event, number, kinds):
            return None
        before = [a for a in here if a.i < number.i]
        free = [a for a in before if name not in a.amounts]
        if number.frame.role == "lateral_move" and before:
            return before[-1]
        if free and before and free[-1].i == before[-1].i:
            return free[-1]
        after = [a for a in here if a.i > number.i and name not in a.amounts]
        if after and not before:
            return after[0]
        if before:
            return before[-1]
        earlier = [a for a in fitting if a.i < start and name not in a.amounts]
        spoken = any(m.entities for m in self._text.mentions if start <= m.i < number.i)
        same = [a for a in earlier if not spoken or a.entity in self._text.subject_before(number.i)]
        return same[-1] if same and (not here) else None

    def _of(self, doing: Doing, event: Event) -> bool:
        """``the lane change of the truck takes 4.5 s``: whether a verb tells of the same one."""
        return any(doing.entity in c.actors for c in self._text.scenes if c.event is event)

    def _unread(self, event: Event, number: Measured, kinds: frozenset[ActKind]) -> bool:
        """``pulls away at 1 m/s² and then stops``: said of a doing that is no act yet."""
        kind = frames().get(event.name)
        known = any(event.i in (a.i, *a.told) for a in self._happenings.acts)
        own = kind in kinds and event.i < number.i
        own = own and event.name != "move"
        return own and not known and not event.nominal

    def _made(self, number: Measured, role: str, event: Event | None) -> Doing | None:
        """``lead car, deceleration 6 m/s²``: an act that only its amount tells of."""
        who = self._text.subject_before(number.i)
        kind = ActKind.SWERVE if role == "lateral_move" else None
        gains = event is not None and event.name != "move" and frames().get(event.name) in _GAINING
        if role == "rate":
            around = f"{number.around.before}{' '.join(number.around.after.split()[:1])}"
            gains = gains or any(w in around for w in ("accelerat", " start", " sets "))
            kind = ActKind.ACCELERATE if gains else ActKind.BRAKE
        if kind is None or not who:
            return None
        doing = Doing(kind, who[0], amount_of(number).basis, number.i)
        doing.told += [event.i] if event is not None and event.i < number.i else []
        return self.add(doing)

    def _changed(self, doing: Doing, number: Measured) -> Amount | None:
        """``slows by 20 km/h``: from the speed that it had."""
        speed = doing.entity.speed
        if speed is None:
            return None
        sign = 1 if doing.kind is ActKind.ACCELERATE else -1
        by = number.quantity.value
        low, high = sorted((speed.low + sign * by.low, speed.high + sign * by.high))
        reason = "its speed before, changed by so much"
        return Amount(Interval(low=low, high=high), Basis(number.i, number.j, reason))

    def _further(self, doing: Doing) -> Doing:
        """``1 m to the left and 1 m to the right``: one after the other."""
        second = Doing(doing.kind, doing.entity, doing.basis, doing.i + 1)
        second.when = Trigger("after", doing.basis, act=doing)
        at = self._happenings.acts.index(doing)
        self._happenings.acts.insert(at + 1, second)
        return second

    def _side(self, doing: Doing, number: Measured) -> None:
        for k in range(number.j, min(number.j + 4, len(self._text.tokens))):
            low = self._text.tokens[k].low
            if low in {"left", "right"}:
                doing.side, doing.side_basis = Side(low), Basis(k, k + 1)
                return

    def _before_the_next(self, number: Measured) -> bool:
        """``holds it for 5 s and then slows``: how long until the next act."""
        later = [a for a in self._happenings.acts if a.i > number.i]
        who: list[Entity] = self._text.subject_before(number.i)
        own = [a for a in later if a.entity in who]
        if not own or own[0].when is not None:
            return False
        before = [a for a in self._happenings.acts if a.i < number.i and a.entity in who]
        doing, amount = own[0], amount_of(number)
        doing.when = Trigger("after" if before else "start", amount.basis, amount)
        doing.when.act = before[-1] if before else None
        return True
