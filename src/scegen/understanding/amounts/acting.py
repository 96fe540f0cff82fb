"""What somebody does as acts, in the order of the text."""

from dataclasses import replace
from itertools import product

from scegen.scenario.acts import SLOWING, ActKind
from scegen.scenario.vocabulary import HazardKind, Maneuver, Side
from scegen.understanding.amounts.aside import to_the_side
from scegen.understanding.amounts.letting_by import goes_after, let_by
from scegen.understanding.amounts.telling import CHANGING, Telling
from scegen.understanding.chunks import Place
from scegen.understanding.entity import Basis
from scegen.understanding.happenings import STILL, Amount, Doing
from scegen.understanding.semantics.context import Clause
from scegen.understanding.semantics.rows import say
from scegen.understanding.words.quantities import quantity_at

_GOING_OVER = frozenset({ActKind.CHANGE_LANE, ActKind.SWERVE})
_RESTING = frozenset({"stop", "wait", "unknown"})


def read_acts(text: Telling) -> None:
    """Everything that is done; of each participant once where it is only told again."""
    found = text.found.acts
    text.context.letting = [e for s in text.scenes if let_by(s, text) for e in s.actors]
    described = [s for s in text.scenes if s.event.premod_of is not None]
    told = [s for s in text.scenes if s.event.premod_of is None]
    for scene in told:
        for doing in _acts_of(scene, text):
            first_change = _moved(doing, scene, found)
            if first_change is not None:
                _go_back(doing, first_change, scene, found)
            elif not _continued(doing, found, text) and not _told_again(doing, found, text):
                found.append(doing)
    for scene in described:  # "the braking car ahead": unless the text tells of it
        for doing in _acts_of(scene, text):
            known = any(d.entity is doing.entity and d.kind is doing.kind for d in found)
            if doing.always and scene.event.form == "ing" and not known:
                found.append(doing)
    found.sort(key=lambda d: d.i)
    _out_to_pass(found, text)
    _back_from_there(found)
    _past_and_back(found, text)
    _come_to_rest(found, text)


def _come_to_rest(found: list[Doing], text: Telling) -> None:
    """``brakes hard. Once it stands …``: that is where the braking ends."""
    for entity in text.draft.entities:
        for basis in entity.rests:
            at = basis.i or 0
            slowed = [d for d in found if d.entity is entity and d.kind in SLOWING and d.i < at]
            for doing in slowed[-1:]:
                doing.told.append(at)
                if doing.kind is ActKind.BRAKE:
                    doing.amounts.setdefault("target_speed_mps", Amount(STILL, basis))


def _moved(doing: Doing, scene: Clause, found: list[Doing]) -> Doing | None:
    """The change of lane from which somebody goes back; of who overtakes both are one act."""
    moved = [d for d in found if d.entity is doing.entity and d.kind is ActKind.CHANGE_LANE]
    back = scene.event.name == "return" and doing.kind is ActKind.CHANGE_LANE
    passes = Maneuver.OVERTAKE in doing.entity.maneuvers
    return moved[-1] if moved and back and not passes else None


def _go_back(doing: Doing, first: Doing, scene: Clause, found: list[Doing]) -> None:
    """``changes lanes and a moment later goes back``: to the other side, after the first."""
    if first.side is None:  # to which side it goes back is not said
        first.told.append(doing.i)
        return
    lane = next((p.target for p in scene.event.pps if isinstance(p.target, Place)), None)
    doing.side = first.side.opposite
    doing.side_basis = Basis(lane.i, lane.j) if lane is not None else doing.basis
    doing.into = None
    found.append(doing)


def _out_to_pass(found: list[Doing], text: Telling) -> None:
    """``changes to the left lane and overtakes it``: going over is how the passing begins.

    Also "overtakes it by changing to the left lane", "swings out and passes it". Who has changed
    lanes to do so stays there, unless it is said to come back.
    """
    strays, merged = text.draft.causing(HazardKind.ONCOMING_LANE), []
    for doing in [d for d in found if d.kind is ActKind.OVERTAKE]:
        own = [d for d in found if d.entity is doing.entity]
        n = own.index(doing)
        means = [d for d in own[n + 1 : n + 2] if text.tokens[d.i - 1].low == "by"]
        for out in [*own[max(n - 1, 0) : n], *means]:
            goes_over = out.kind in _GOING_OVER and out.into is None
            if goes_over and doing.side in {None, out.side}:
                found.remove(out)
                doing.side, doing.side_basis = out.side, out.side_basis
                doing.told += [out.i, *out.told]
                merged.append(doing.entity)
    back = [*strays, *(d.entity for d in found if d.kind is ActKind.CHANGE_LANE)]
    for entity in text.draft.entities:
        if entity not in back and Maneuver.LANE_CHANGE in entity.maneuvers:
            entity.maneuvers.discard(Maneuver.OVERTAKE)
        elif entity in merged:
            entity.maneuvers.discard(Maneuver.LANE_CHANGE)


def _back_from_there(found: list[Doing]) -> None:
    """``overtakes on the right and then cuts in``: back to the side it did not pass on."""
    for doing in [d for d in found if d.kind is ActKind.CHANGE_LANE]:
        own = [d for d in found if d.entity is doing.entity and d.i < doing.i]
        sides = [d.side for d in own if d.kind is ActKind.OVERTAKE and d.side is not None]
        doing.side = sides[-1].opposite if sides else doing.side


def _past_and_back(found: list[Doing], text: Telling) -> None:
    """``overtakes a tractor and returns ahead of it``: that belongs to passing it."""
    dangers = text.draft.dangers
    passing = (d for d in dangers if d.kind is HazardKind.OVERTAKING)
    pairs = (pair for d in passing for pair in product(d.by, d.to))
    passed = [(by, to) for by, to in pairs if not to.ego]
    for doing in found:
        if doing.kind is ActKind.CHANGE_LANE and (doing.entity, doing.into) in passed:
            doing.into = None
            doing.side = doing.side or Side(text.context.across).opposite
    dangers[:] = [
        d
        for d in dangers
        if d.kind is not HazardKind.CUT_IN
        or not all(any((by, to) in passed for to in d.to or text.draft.entities) for by in d.by)
    ]  # fmt: skip


def _acts_of(clause: Clause, text: Telling) -> list[Doing]:
    scene, event, context = clause, clause.event, text.context
    whom = let_by(scene, text)
    context.acts = []
    say("acts.first", scene, context)
    first, context.acts = context.acts, []
    if whom and event.name not in {"stop", "wait"}:
        scene = replace(scene, event=replace(event, name="yield"))
    said = say("acts.done", scene, context) and context.acts
    if said and whom and goes_after(clause):  # "crosses 5 m behind the ego" is two acts
        say("acts.done", clause, context)
    if not said or say("acts.owed", scene, context):
        return first
    made = []
    for doing in [d for d in context.acts if whom or d.kind is not ActKind.GIVE_WAY]:
        to_the_side(doing, scene, text)
        doing.forced = doing.entity.ego and event.modal
        # "must brake or swerve", "must go round it, giving way": not what it does as an answer.
        either = [t.low for t in context.tokens[event.j : event.j + 1]] == ["or"]
        if doing.forced and (either or doing.kind is ActKind.GIVE_WAY):
            doing.always = doing.forced = False
        if whom and doing.kind in {ActKind.STOP, ActKind.GIVE_WAY}:
            words = (
                Basis(p.word.i, p.who.j) for p in event.pps if p.who and whom[0] in p.who.entities
            )
            doing.into, doing.into_basis = whom[0], next(words, doing.basis)
        if doing.kind is ActKind.STOP and "halts" in doing.entity.told:
            doing.kind, doing.into = ActKind.CROSS, None  # as far as the kerb
            doing.amounts["distance_m"] = Amount(STILL, doing.basis)
        again = _then_again(doing, text)
        _to_standstill(doing, text, again.i if again is not None else None)
        made += [doing] if again is None else [doing, again]
        further = whom[1:] if doing.kind is ActKind.GIVE_WAY else []
        made += [replace(doing, into=other) for other in further]
    return [*made, *first]


def _then_again(doing: Doing, text: Telling) -> Doing | None:
    """``brakes at 3 m/s² to 60 km/h, then at 8 m/s²``: the same once more, without its verb."""
    then = text.find("then", doing.i + 1, text.bounds(doing.i)[1])
    if doing.kind not in CHANGING or then is None or text.within(doing.i + 1, then[1] + 1):
        return None
    if text.tokens[then[1] - 1].low == "again":
        return None  # "slows to 42 km/h, again at 1 m/s²"
    if not (_changed(text, doing.i, then[0]) and _changed(text, then[1] + 1, then[1] + 2)):
        return None  # "brakes 1.2 s later with 7 m/s²"
    again = Doing(doing.kind, doing.entity, Basis(*then), then[1], always=True)
    _to_standstill(again, text)
    return again


def _changed(text: Telling, start: int, end: int) -> bool:
    """Whether a speed, or how quickly one changes, is given there."""
    found = (quantity_at(text.tokens, k) for k in range(start, min(end, len(text.tokens))))
    return any(q is not None and q.dimension in {"acceleration", "speed"} for q in found)


def _to_standstill(doing: Doing, text: Telling, upto: int | None = None) -> None:
    """``brakes to a stop``, ``an emergency stop``."""
    if doing.kind is not ActKind.BRAKE:
        return
    end = text.bounds(doing.i)[1] if upto is None else upto
    within, own = text.within(doing.i + 1, end), [doing.entity]
    later = [s.event.i for s in within if s.event.name not in _RESTING or s.actors not in ([], own)]
    span = text.find("standstill", doing.i, min([end, *later]))
    if span is not None:
        doing.amounts["target_speed_mps"] = Amount(STILL, Basis(*span))


def _continued(doing: Doing, found: list[Doing], text: Telling) -> bool:
    """``brakes and stops``: one act that ends at standstill; ``sets off and accelerates``.

    Who ``crosses, stops, then walks on`` goes on crossing.
    """
    before = next((d for d in reversed(found) if d.entity is doing.entity), None)
    if before is None:
        return False
    pair, joined = (before.kind, doing.kind), text.bounds(before.i) == text.bounds(doing.i)
    if pair == (ActKind.SET_OFF, ActKind.ACCELERATE):
        joined = joined and text.find("then", before.i, doing.i) is None
        before.told += [doing.i] if joined else []
        return joined
    if pair == (ActKind.STOP, ActKind.CROSS):
        return any(d.kind is ActKind.CROSS and d.entity is doing.entity for d in found)
    over = any(scene.event.perfect for scene in text.within(doing.i, doing.i + 1))
    if pair != (ActKind.BRAKE, ActKind.STOP) or not (joined or over):
        return False  # "brakes and stops", "brakes … once it has stopped"
    slower = [k for k in range(before.i, doing.i) if text.tokens[k].low == "to"]
    slower = [k for k in slower if _changed(text, k + 1, k + 2) and text.tokens[k + 1].low != "0"]
    if slower or text.find("holding_at", before.i, doing.i) is not None:
        return False  # "brakes to 30 km/h and stops", "brakes, keeps 20 km/h for 4 s and stops"
    before.amounts.setdefault("target_speed_mps", Amount(STILL, doing.basis))
    before.told.append(doing.i)
    return True


def _told_again(doing: Doing, found: list[Doing], text: Telling) -> bool:
    """Whether the same is only told another time: no words of order, and no other sentence part."""
    known = doing.nominal and text.tokens[doing.i].low == "the"  # "after the lane change"
    own = [d for d in found if d.entity is doing.entity]
    before = next((d for d in reversed(own) if d.kind is doing.kind or not known), None)
    titled = [d for d in found if d.nominal and (d.entity, d.kind) == (doing.entity, doing.kind)]
    if titled and titled[0] is not before and " : " in text.low(titled[0].i, doing.i):
        found.remove(titled[0])  # "Brake check: a van cuts in … and brakes": that braking
        doing.told.append(titled[0].i)
    if before is None or before.kind is not doing.kind:
        if before is None or not {before.kind, doing.kind} <= SLOWING:
            return False
        if before.kind is ActKind.STOP:  # "stops with a deceleration of 3 m/s²"
            same = text.bounds(before.i) == text.bounds(doing.i) and doing.nominal
            before.told += [doing.i] if same else []
            return same
        return not doing.always
    gives_way = doing.kind is ActKind.GIVE_WAY
    if gives_way and before.into is not doing.into:
        return False
    if gives_way or before.i == doing.i:
        return True
    if None not in {before.side, doing.side} and before.side is not doing.side:
        # "changes to the left lane … changes back to the right one": out of whose lane it came
        doing.into = None if doing.into is before.into else doing.into
        return False
    named = before.nominal and before.side in {None, doing.side}
    # "Cut-in followed by braking: the van cuts in …": what the heading names
    heading = named and " : " in text.low(before.i, doing.i)
    if not (heading or known) and text.find("then", before.basis.j or before.i, doing.i):
        return False
    before.told.append(doing.i)
    for name in ("side", "side_basis", "into", "into_basis", "always"):
        setattr(before, name, getattr(before, name) or getattr(doing, name))
    before.amounts = {**doing.amounts, **before.amounts}
    return True
