"""What somebody does as acts, in the order of the text."""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import Control, JunctionKind, Maneuver
from scegen.understanding.amounts.leading_aside import OTHER, to_the_side
from scegen.understanding.amounts.letting_by import arrives_first, goes_first, let_by
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.chunks import Event
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import ActFrame, acts
from scegen.understanding.happenings import STILL, Amount, Doing
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.words.quantities import quantity_at

_BEGINNING = frozenset({"start", "begin", "commence", "set"})
_TURNS = frozenset({Maneuver.LEFT, Maneuver.RIGHT, Maneuver.U_TURN})
_PASSING = frozenset({"overtake", "bypass", "pass", "undertake"})
_WISHING = frozenset({"want", "intend", "plan", "hope", "wish", "aim"})
_PREVENTED = frozenset({"fail", "avoid", "prevent", "delay", "encounter"})
_CHANGING = frozenset({ActKind.BRAKE, ActKind.ACCELERATE})
_SLOWING = frozenset({ActKind.BRAKE, ActKind.STOP})
_DRIVEN = frozenset({ActKind.BRAKE, ActKind.ACCELERATE, ActKind.CHANGE_LANE, ActKind.SWERVE,
                     ActKind.REVERSE, ActKind.TURN, ActKind.GIVE_WAY,
                     ActKind.OVERTAKE})  # fmt: skip
_BY_THE_RULES = "the ego gives way as the rules of the junction say; this is not judged by itself"
_RESTING = frozenset({"stop", "wait", "unknown"})


def acts_in(text: Sentences, context: Context) -> list[Doing]:
    """Everything that is done; of each participant once where it is only told again.

    Args:
        text: the text with its clauses.
        context: the scenario in the making, everything else understood.
    """
    found: list[Doing] = []
    described = [s for s in text.scenes if s.event.premod_of is not None]
    told = [s for s in text.scenes if s.event.premod_of is None]
    for scene in told:
        first = (
            goes_first(scene, text.tokens, context.draft.entities)
            if context.junction.crossing
            else []
        )
        first += arrives_first(scene, text, context)
        for doing in [*_acts_of(scene, text, context), *first]:
            if not _continued(doing, found, text) and not _told_again(doing, found, text):
                found.append(doing)
    for scene in described:  # "the braking car ahead": unless the text tells of it
        for doing in _acts_of(scene, text, context):
            known = any(d.entity is doing.entity and d.kind is doing.kind for d in found)
            if doing.always and scene.event.form == "ing" and not known:
                found.append(doing)
    found.sort(key=lambda d: d.i)
    _back_from_there(found)
    _come_to_rest(found)
    return found


def _come_to_rest(found: list[Doing]) -> None:
    """``brakes hard. Once it stands …``: that is where the braking ends."""
    resting = {id(d.entity): d.entity for d in found if d.entity.rests}
    for entity in resting.values():
        for basis in entity.rests:
            at = basis.i or 0
            slowed = [d for d in found if d.entity is entity and d.kind in _SLOWING and d.i < at]
            for doing in slowed[-1:]:
                doing.told.append(at)
                if doing.kind is ActKind.BRAKE:
                    doing.amounts.setdefault("target_speed_mps", Amount(STILL, basis))


def _back_from_there(found: list[Doing]) -> None:
    """``overtakes on the right and then cuts in``: back to the side it did not pass on."""
    for doing in found:
        passed = [d for d in found if d.kind is ActKind.OVERTAKE and d.i < doing.i and d.side]
        own = [d for d in passed if d.entity is doing.entity]
        if doing.kind is ActKind.CHANGE_LANE and own and own[-1].side is not None:
            doing.side = OTHER[own[-1].side]


def _acts_of(scene: Clause, text: Sentences, context: Context) -> list[Doing]:
    event = scene.event
    parent = event.parent
    changed = [e for e in scene.actors if _changes_lane(e, event)]
    frame = ActFrame(ActKind.CHANGE_LANE, always=True) if changed else acts().get(event.name)
    if frame is None and _starts(event):
        frame = ActFrame(ActKind.SET_OFF, always=False)  # "the van starts 0.7 s after the car"
    whom = let_by(scene, text.scenes)
    if whom and event.name != "stop":
        frame = ActFrame(ActKind.GIVE_WAY, always=True)
    if frame is None or event.negated or event.unable:
        return []
    if parent is not None and (parent.name in _PREVENTED or parent.negated):
        return []
    if parent is not None and parent.lemma in _WISHING:
        return []  # "wants to pass a truck"
    basis = Basis(event.i, event.j)
    made = []
    for entity in scene.actors:
        kind = _kind(frame.kind, entity, event)
        if kind is None or _stands_then(entity, event) or _rules_say(entity, event, context):
            continue
        if kind is ActKind.STOP and not whom and _by_the_rule(scene, text, context):
            continue
        across = event.name == "cut_in" and text.tokens[event.j - 1].low == "across"
        if across and (entity.maneuvers & _TURNS or _round(context)):
            continue  # "turns right and cuts across a cyclist"
        if kind is ActKind.OVERTAKE and scene.targets and all(t.parked for t in scene.targets):
            continue  # past one who is parked beside the lanes leads no move aside
        always = frame.always or kind is ActKind.CHANGE_LANE
        always = always and not (kind is ActKind.STOP and not entity.is_vehicle)
        forced = _forced(entity, event)
        # "must brake or swerve", "must go round it, giving way": not what it does as an answer.
        either = [t.low for t in context.tokens[event.j : event.j + 1]] == ["or"]
        loosely = forced and (either or kind is ActKind.GIVE_WAY)
        always = always and not loosely
        doing = Doing(kind, entity, basis, event.i, always=always, nominal=event.nominal)
        doing.forced = forced and not loosely
        if whom and kind in {ActKind.STOP, ActKind.GIVE_WAY}:
            doing.into, doing.into_basis = whom[0], basis
        to_the_side(doing, scene, text, context)
        again = _then_again(doing, text)
        _to_standstill(doing, text, again.i if again is not None else None)
        made += [doing] if again is None else [doing, again]
        further = whom[1:] if doing.kind is ActKind.GIVE_WAY else []
        made += [replace(doing, into=other) for other in further]
    return made


def _round(context: Context) -> bool:
    """At a roundabout who cuts across goes on round it."""
    return context.junction.kind is JunctionKind.ROUNDABOUT


def _starts(event: Event) -> bool:
    """``the van starts``: nothing says what, so it sets off."""
    told = event.finite and event.form in {"s", "ed"} and not (event.reduced or event.passive)
    return told and event.lemma == "start" and not (event.children or event.object)


def _changes_lane(entity: Entity, event: Event) -> bool:
    """Whether it is this verb that says that somebody changes lanes."""
    basis = entity.maneuver_basis
    moved = Maneuver.LANE_CHANGE in entity.maneuvers
    told = basis is not None and (basis.i == event.i or basis.j == event.j)
    return moved and told and event.name not in _PASSING


def _kind(kind: ActKind, entity: Entity, event: Event) -> ActKind | None:
    """``starts to walk``: crosses; ``veers into the left lane``: changes lanes."""
    afoot = not entity.is_vehicle
    if (kind in _DRIVEN and afoot) or (kind is ActKind.OPEN_DOOR and not entity.parked):
        return None
    if kind is ActKind.ACCELERATE and entity.stands is not None and entity.sets_off >= event.i:
        return ActKind.SET_OFF  # "accelerates from standstill"
    if kind is ActKind.OVERTAKE and Maneuver.OVERTAKE not in entity.maneuvers:
        return None
    along = entity.maneuvers == {Maneuver.STRAIGHT}  # on foot: along the road
    if kind is ActKind.CROSS and (along or not afoot) and Maneuver.CROSS not in entity.maneuvers:
        return None
    if kind is ActKind.CHANGE_LANE and _changes_lane(entity, event):
        return kind
    if event.name == "move":
        begins = bool({event.lemma, event.parent.lemma if event.parent else ""} & _BEGINNING)
        crosses = Maneuver.CROSS in entity.maneuvers
        return (ActKind.CROSS if crosses else ActKind.SET_OFF) if begins else None
    if event.name == "pull_out" and Maneuver.OVERTAKE in entity.maneuvers:
        return ActKind.OVERTAKE
    if (
        kind is ActKind.SET_OFF
        and not _starts(event)
        and not (entity.pulls_out or entity.was_parked or entity.stands)
    ):
        return None
    if event.name in {"merge", "cut_off"} and Maneuver.LANE_CHANGE not in entity.maneuvers:
        return None
    if event.name == "return" and Maneuver.OVERTAKE not in entity.maneuvers:
        return None
    return kind


def _by_the_rule(scene: Clause, text: Sentences, context: Context) -> bool:
    """``stops at the stop sign``, ``at the line``: there everybody on that road does."""
    signed = context.junction.control in {Control.STOP, Control.ALL_WAY_STOP}
    letting = any(s.actors == scene.actors and let_by(s, text.scenes) for s in text.scenes)
    minor = bool(scene.actors) and all(e.on_minor and e.on_minor[0] for e in scene.actors)
    elsewhere = any(p.kind not in {"access", "road", "junction"} for p in scene.places())
    if signed and not letting and minor and not elsewhere:
        return True  # "stops, then sets off"
    return (
        signed
        and not letting
        and any(
            p.kind in {"stop_sign", "stop_line"} or context.tokens[p.j - 1].low == "line"
            for p in scene.places()
        )
    )


def _forced(entity: Entity, event: Event) -> bool:
    """``the ego has to brake``, ``forces the ego to brake``: it does, as an answer."""
    parent = event.parent
    return entity.ego and (event.modal or (parent is not None and parent.name == "cause"))


def _rules_say(entity: Entity, event: Event, context: Context) -> bool:
    """Whether the ego has to where roads meet, and nothing that is told endangers it."""
    draft = context.draft
    meeting = context.junction.crossing or draft.access is not None
    meeting = meeting or draft.crossing_implied is not None
    owed = _forced(entity, event) and meeting and not draft.dangers
    if owed:
        draft.note(event.i, event.j, _BY_THE_RULES)
    return owed


def _stands_then(entity: Entity, event: Event) -> bool:
    """``has stopped in the lane``: where it is, nothing that it does."""
    said = [b for b in (entity.stands, entity.held, *entity.rests) if b is not None]
    own = any(b.i == event.i for b in said)
    return (own or entity.parked or (entity.stands is not None and entity.sets_off < 0)) and (
        event.name in {"stop", "wait"}
    )


def _then_again(doing: Doing, text: Sentences) -> Doing | None:
    """``brakes at 3 m/s² to 60 km/h, then at 8 m/s²``: the same once more, without its verb."""
    then = text.find("then", doing.i + 1, text.bounds(doing.i)[1])
    if doing.kind not in _CHANGING or then is None or text.within(doing.i + 1, then[1]):
        return None
    if text.tokens[then[1] - 1].low == "again":
        return None  # "slows to 42 km/h, again at 1 m/s²"
    if not (_changed(text, doing.i, then[0]) and _changed(text, then[1] + 1, then[1] + 2)):
        return None  # "brakes 1.2 s later with 7 m/s²"
    again = Doing(doing.kind, doing.entity, Basis(*then), then[1], always=True)
    _to_standstill(again, text)
    return again


def _changed(text: Sentences, start: int, end: int) -> bool:
    """Whether a speed, or how quickly one changes, is given there."""
    found = (quantity_at(text.tokens, k) for k in range(start, min(end, len(text.tokens))))
    return any(q is not None and q.dimension in {"acceleration", "speed"} for q in found)


def _to_standstill(doing: Doing, text: Sentences, upto: int | None = None) -> None:
    """``brakes to a stop``, ``an emergency stop``."""
    if doing.kind is not ActKind.BRAKE:
        return
    end = text.bounds(doing.i)[1] if upto is None else upto
    later = [s.event.i for s in text.within(doing.i + 1, end) if s.event.name not in _RESTING]
    span = text.find("standstill", doing.i, min([end, *later]))
    if span is not None:
        doing.amounts["target_speed_mps"] = Amount(STILL, Basis(*span))


def _continued(doing: Doing, found: list[Doing], text: Sentences) -> bool:
    """``brakes and stops``: one act that ends at standstill."""
    before = next((d for d in reversed(found) if d.entity is doing.entity), None)
    if doing.kind is not ActKind.STOP or before is None or before.kind is not ActKind.BRAKE:
        return False
    same = text.bounds(before.i) == text.bounds(doing.i)
    if not same or "target_speed_mps" in before.amounts:
        if same:
            before.told.append(doing.i)
        return same
    before.amounts["target_speed_mps"] = Amount(STILL, doing.basis)
    before.told.append(doing.i)
    return True


def _told_again(doing: Doing, found: list[Doing], text: Sentences) -> bool:
    """Whether the same is only told another time: no words of order, and no other sentence part."""
    before = next((d for d in reversed(found) if d.entity is doing.entity), None)
    if before is None or before.kind is not doing.kind:
        if before is None or not {before.kind, doing.kind} <= _SLOWING:
            return False
        if before.kind is ActKind.STOP:  # "stops with a deceleration of 3 m/s²"
            same = text.bounds(before.i) == text.bounds(doing.i) and doing.nominal
            before.told += [doing.i] if same else []
            return same
        return not doing.always
    if before.i == doing.i:
        return doing.kind is not ActKind.GIVE_WAY or before.into is doing.into
    before.told.append(doing.i)
    ordered = text.says("then", before.basis.j or before.i, doing.i)
    if ordered is not None:
        before.told.pop()
        return False
    before.side = before.side or doing.side
    before.side_basis = before.side_basis or doing.side_basis
    before.into = before.into or doing.into
    before.into_basis = before.into_basis or doing.into_basis
    before.always = before.always or doing.always
    before.amounts = {**doing.amounts, **before.amounts}
    return True
