"""What somebody does as acts, in the order of the text."""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, Side
from scegen.understanding.amounts.letting_by import let_by
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.chunks import Event, Mention, Place
from scegen.understanding.draft import Basis, Entity
from scegen.understanding.frames import ActFrame, acts, words
from scegen.understanding.happenings import STILL, Amount, Doing
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context

_SIDES = {"left": Side.LEFT, "right": Side.RIGHT}
_OTHER = {Side.LEFT: Side.RIGHT, Side.RIGHT: Side.LEFT}
_BEFORE = 4
_BEGINNING = frozenset({"start", "begin", "commence", "set"})
_PASSING = frozenset({"overtake", "bypass", "pass", "undertake"})
_WISHING = frozenset({"want", "intend", "plan", "hope", "wish", "aim"})
_PREVENTED = frozenset({"fail", "avoid", "prevent", "delay", "encounter"})
_SLOWING = frozenset({ActKind.BRAKE, ActKind.STOP})
_DRIVEN = frozenset({ActKind.BRAKE, ActKind.ACCELERATE, ActKind.CHANGE_LANE, ActKind.SWERVE,
                     ActKind.REVERSE, ActKind.TURN, ActKind.GIVE_WAY,
                     ActKind.OVERTAKE})  # fmt: skip
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
        for doing in _acts_of(scene, text, context):
            if not _continued(doing, found, text) and not _told_again(doing, found, text):
                found.append(doing)
    for scene in described:  # "the braking car ahead": unless the text tells of it
        for doing in _acts_of(scene, text, context):
            known = any(d.entity is doing.entity and d.kind is doing.kind for d in found)
            if doing.always and scene.event.form == "ing" and not known:
                found.append(doing)
    found.sort(key=lambda d: d.i)
    _back_from_there(found)
    return found


def _back_from_there(found: list[Doing]) -> None:
    """``overtakes on the right and then cuts in``: back to the side it did not pass on."""
    for doing in found:
        passed = [d for d in found if d.kind is ActKind.OVERTAKE and d.i < doing.i and d.side]
        own = [d for d in passed if d.entity is doing.entity]
        if doing.kind is ActKind.CHANGE_LANE and own and own[-1].side is not None:
            doing.side = _OTHER[own[-1].side]


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
        if kind is None or _stands_then(entity, event):
            continue
        if kind is ActKind.OVERTAKE and scene.targets and all(t.parked for t in scene.targets):
            continue  # past one who is parked beside the lanes leads no move aside
        always = frame.always or kind is ActKind.CHANGE_LANE
        always = always and not (entity.ego and _forced(event)) and not _owed(event, context)
        always = always and not (kind is ActKind.STOP and not entity.is_vehicle)
        doing = Doing(kind, entity, basis, event.i, always=always, nominal=event.nominal)
        if whom and kind in {ActKind.STOP, ActKind.GIVE_WAY}:
            doing.into, doing.into_basis = whom[0], basis
        _aside(doing, scene, text, context)
        _to_standstill(doing, text)
        made.append(doing)
        further = whom[1:] if doing.kind is ActKind.GIVE_WAY else []
        made += [replace(doing, into=other) for other in further]
    return made


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
    if kind is ActKind.SET_OFF and afoot and event.name != "move":
        return ActKind.CROSS if Maneuver.CROSS in entity.maneuvers else None
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


def _forced(event: Event) -> bool:
    """``forces the ego to brake``: what the one under test has to do, not what it is made to do.

    Others have no test to pass: who has to brake brakes.
    """
    parent = event.parent
    return event.modal or (parent is not None and parent.name in {"cause", "prevent"})


def _owed(event: Event, context: Context) -> bool:
    """``ought to wait for us``: what it should do, whatever it does."""
    before = {t.low for t in context.tokens[max(0, event.i - _BEFORE) : event.i]}
    return event.modal and bool(before & word_list("expected"))


def _stands_then(entity: Entity, event: Event) -> bool:
    """``has stopped in the lane``: where it is, nothing that it does."""
    own = any(said is not None and said.i == event.i for said in (entity.stands, entity.held))
    return (own or entity.parked or (entity.stands is not None and entity.sets_off < 0)) and (
        event.name in {"stop", "wait"}
    )


def _aside(doing: Doing, scene: Clause, text: Sentences, context: Context) -> None:
    """To which side, and into whose lane."""
    if doing.kind not in {ActKind.CHANGE_LANE, ActKind.SWERVE, ActKind.TURN, ActKind.OVERTAKE}:
        return
    event, entity = scene.event, doing.entity
    goals = [event.object, *(p.target for p in event.pps if p.value in {"into", "to", "for", "in"})]
    sides = [(d.value, Basis(d.i, d.j)) for d in event.dirs]
    lanes = [c for c in text.chunks if isinstance(c, Place) and c.kind == "lane"]
    sources = [p.target for p in event.pps if p.value == "from" or p.outer == "from"]
    moved = [event.object, *sources]  # "moves one lane to the left", "leaves the lane to the left"
    lanes = [c for c in lanes if not any(c is m for m in moved)]
    for goal in [p for p in goals if isinstance(p, Place)]:
        within = any(c is not goal and c.i < goal.i <= c.j + 1 for c in lanes)
        named = [] if within else goal.dirs  # "from the lane to its right": from there
        sides += [(d, Basis(goal.i, goal.j)) for d in named]
    for value, basis in sides:
        if value in _SIDES and doing.side is None:
            doing.side, doing.side_basis = _SIDES[value], basis
    if doing.kind is ActKind.TURN:
        return
    for place in sources:
        named = [d for d in place.dirs if d in _SIDES] if isinstance(place, Place) else []
        if named and doing.side is None and place is not None:
            doing.side, doing.side_basis = _OTHER[_SIDES[named[0]]], Basis(place.i, place.j)
    _into(doing, scene, context)
    _homewards(doing, event.name == "return", context)
    if entity.by_ramp is not None and entity.beside and doing.kind is ActKind.CHANGE_LANE:
        doing.side = _OTHER[Side(entity.beside[0])]  # "into the right lane", off the ramp
    homeward = doing.into is None or doing.into.ego
    beside = entity.beside or _comes_from(entity, context)
    if homeward and doing.kind is ActKind.CHANGE_LANE and doing.side is None and beside:
        side, words = beside
        doing.side = _OTHER[_SIDES[side]] if side in _SIDES else None
        doing.side_basis = Basis(words.i, words.j, "into the lane beside its own")


def _comes_from(entity: Entity, context: Context) -> tuple[str, Basis] | None:
    """``target from the left``: along a road, from the lane on that side."""
    for placement in context.draft.placements:
        side = next(iter(placement.approaches)).value if len(placement.approaches) == 1 else ""
        if placement.entity is entity and side in _SIDES and not context.junction.crossing:
            return side, placement.basis
    return None


def _homewards(doing: Doing, returns: bool, context: Context) -> None:
    """Who comes from the front goes over the middle; who has overtaken comes back."""
    entity, words = doing.entity, doing.basis
    returns = returns and Maneuver.OVERTAKE in entity.maneuvers and context.oncoming(entity)
    across = Side(context.across)
    ego = next((e for e in context.draft.entities if e.ego), None)
    if doing.kind is ActKind.CHANGE_LANE and context.oncoming(entity) and not returns:
        doing.into, doing.into_basis = doing.into or ego, doing.into_basis or words
        if doing.side is None:
            doing.side = across
            reason = "who comes from the front crosses the middle of the road"
            doing.side_basis = Basis(words.i, words.j, reason)
    back = doing.into is not None and doing.into.ego and Maneuver.OVERTAKE in entity.maneuvers
    if (returns or back) and doing.side is None and entity.beside is None:
        doing.side = _OTHER[across]
        reason = "who has overtaken comes back to its lane"
        doing.side_basis = Basis(words.i, words.j, reason)


def _into(doing: Doing, scene: Clause, context: Context) -> None:
    if doing.kind is not ActKind.CHANGE_LANE:
        return
    event = scene.event
    goals = [event.object, *(p.target for p in event.pps if p.value in {"into", "to", "for"})]
    lanes = [g for g in goals if isinstance(g, Place) and g.kind in {"lane", "path"}]
    owners = [e for g in lanes if g.owner is not None for e in g.owner.entities]
    out = "out" in {t.low for t in context.tokens[event.i : event.j]}  # "cuts out in front of"
    ahead = [
        e
        for p in ([] if out else event.pps)
        if p.word.cat == "locus" and p.value == "ahead" and isinstance(p.target, Mention)
        for e in p.target.entities
    ]
    cut = [
        e
        for d in context.draft.dangers
        if d.kind is HazardKind.CUT_IN and doing.entity in d.by
        for e in (d.to or [x for x in context.draft.entities if x.ego])
    ]
    named = [e for e in (*owners, *scene.targets, *ahead, *cut) if e is not doing.entity]
    if named:
        doing.into, doing.into_basis = named[0], Basis(event.i, event.j)
    known = any(p.entity is doing.into or p.reference is doing.into
                for p in context.draft.placements)  # fmt: skip
    if ahead and named and doing.entity.ego and not known and not context.junction.crossing:
        # "changes to the right lane in front of a truck": that one is there
        words_ = next(p for p in event.pps if p.word.cat == "locus" and p.value == "ahead")
        basis = Basis(words_.word.i, named[0].basis.j)
        context.draft.place(named[0], None, {Approach.ADJACENT}, basis)
        if doing.side is not None:
            named[0].beside = named[0].beside or (doing.side.value, basis)


def _to_standstill(doing: Doing, text: Sentences) -> None:
    """``brakes to a stop``, ``an emergency stop``."""
    if doing.kind is not ActKind.BRAKE:
        return
    end = text.bounds(doing.i)[1]
    later = [s.event.i for s in text.within(doing.i + 1, end) if s.event.name not in _RESTING]
    span = text.find(words()["standstill"], doing.i, min([end, *later]))
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
