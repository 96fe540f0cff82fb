"""When something begins on a trace: braking, setting off, leaving the lane, stepping out.

Whoever reads a recording sees it the same way: nothing here knows what was planned.
"""

import numpy as np

from scegen.claims.arms import arms_of
from scegen.claims.boxes import Boxes, boxes, gap_m, same_way
from scegen.claims.runs import Run, greatest_runs
from scegen.claims.series import at, first
from scegen.claims.sideways import sideways_begin
from scegen.claims.told import Told
from scegen.claims.view import View, kept
from scegen.motion.batch.arrays import SPEED, Bools, Ints
from scegen.scenario.acts import ENTERING, GAINING, LEAVING, SLOWING, Act, ActKind
from scegen.scenario.concrete import door_of
from scegen.scenario.logical import Drive

CHANGES_MPS2 = 0.3
"""Speed that changes faster than this is braking or accelerating."""
_OTHERS = 3
"""Changes of speed that are looked at where the text tells of one, and by how much."""
STANDS_MPS = 0.05
TURNS_RAD = 0.1


@kept
def speed_runs(view: View, name: str, sense: int, count: int = 1) -> list[Run]:
    """The greatest runs in which speed falls (-1) or grows (+1), in the order of time."""
    least = CHANGES_MPS2 * view.dt_s
    # A body that is taken off its feet where its way ends does not brake.
    most = 3.0 * view.body(name).max_deceleration_mps2 * view.dt_s + 1.0
    return greatest_runs(view.speed_mps(name), sense, least, most, count)


def sets_off(view: View, name: str, number: int = 0) -> Ints:
    """The last step of rest before somebody moves, the first time or a later one; else all steps.

    One who moves from the start sets off only after it has come to rest.
    """
    stands = view.speed_mps(name) <= STANDS_MPS
    leaves = stands & ~np.append(stands[:, 1:], np.ones((view.count, 1), dtype=np.bool_), axis=1)
    return first(leaves & (np.cumsum(leaves, axis=1) > number))


def along_whose(ego: str, one: str, other: str, act: Act | None) -> tuple[str, str]:
    """Along whose heading a length between two lies as something is done, and who is there.

    The ego's, if it is one of them; not of an ego that comes in from another road by that.
    """
    comes = act is not None and act.kind in ENTERING and act.participant == ego
    return (one, other) if (one == ego) != comes else (other, one)


def turned(box: Boxes) -> Bools:
    """Where along the last axis, time or way, the heading has left that of the start."""
    cos, sin = box.cos, box.sin
    aside = np.abs(sin * cos[..., :1] - cos * sin[..., :1])
    return (aside > TURNS_RAD) | (cos * cos[..., :1] + sin * sin[..., :1] < 0.0)


def act_begins(told: Told, act: Act, view: View) -> Ints:
    """The step in which an act begins; the number of steps where it does not happen (c,)."""
    return view.once(("begins", act.id), lambda: _begins(told, act, view))


def comes_to_rest(told: Told, act: Act, other: str, view: View) -> Ints:
    """The step in which who acts stands, the other too if it stops before that one goes on."""
    since = np.arange(view.steps) >= act_begins(told, act, view)[:, None]
    stands = since & (view.speed_mps(act.participant) <= STANDS_MPS)
    rests = first(stands)
    goes_on = first(since & ~stands & (np.arange(view.steps) > rests[:, None]))
    both = first(stands & (view.speed_mps(other) <= STANDS_MPS))
    return np.where(both < goes_on, both, rests)


def rest(told: Told, act: Act, view: View) -> tuple[Ints, Ints]:
    """The first and the last step of the rest after which one goes on (c,) each."""
    leaves = sets_off(view, act.participant, _rests_before(told, act))
    moves = view.speed_mps(act.participant) > STANDS_MPS
    steps = np.arange(view.steps)
    before = np.where(moves & (steps < leaves[:, None]), steps + 1, 0).max(axis=1)
    return np.where(leaves < view.steps, before, view.steps), leaves


def _rests_before(told: Told, act: Act) -> int:
    """How often one has gone on after a rest before; who waits and then sets off does so once."""
    own = told.acts_of(act.participant)
    number = 0 if told.crossing(act.participant) else -1  # who goes across stood first
    for n, each in enumerate(own):
        after_wait = n > 0 and own[n - 1].kind is ActKind.WAIT
        number += each.kind is ActKind.WAIT
        number += each.kind is ActKind.SET_OFF and not after_wait
        if each.id == act.id:
            break
    return number


def act_run(told: Told, act: Act, view: View) -> Run:
    """The change of speed that an act is: the one of its number among the greatest."""
    # To come to rest for a while is a change of speed, too, and so is to go on.
    slows = act.kind in SLOWING or act.kind is ActKind.WAIT
    kinds = (SLOWING if slows else GAINING) | {ActKind.WAIT}
    same = [a for a in told.acts_of(act.participant) if a.kind in kinds]
    sense = -1 if slows else 1
    if len(same) == 1 and act.rate_mps2 is not None:
        return _alike(speed_runs(view, act.participant, sense, _OTHERS), act.rate_mps2.middle, view)
    number = next(n for n, a in enumerate(same) if a.id == act.id)
    runs = speed_runs(view, act.participant, sense, len(same))
    chosen = runs[0]
    for run in runs[1 : number + 1]:
        # Two acts that follow on without a break are one run: both are then that one.
        chosen = run.instead_of(chosen, run.happens)
    return _to_rest(chosen, view, act.participant) if act.kind is ActKind.STOP else chosen


def _to_rest(run: Run, view: View, name: str) -> Run:
    """A stop, slower and slower: one who slows down for a bend on the way there goes on after."""
    speed = view.speed_mps(name)
    after = np.arange(view.steps) >= run.end[:, None]
    rests = first(after & (speed <= STANDS_MPS))
    gains = np.diff(speed, axis=1, append=speed[:, -1:]) > CHANGES_MPS2 * view.dt_s
    stops = (rests < view.steps) & (rests <= first(after & gains))
    return Run(
        run.begin,
        np.where(stops, rests, run.end),
        np.where(stops, at(speed, run.begin) - at(speed, rests), run.change_mps),
    )


def _alike(runs: list[Run], rate_mps2: float, view: View) -> Run:
    """The run whose rate comes nearest: one who slows down for a bend besides does it otherwise."""
    chosen, least = runs[0], np.full(view.count, np.inf)
    for run in runs:
        rate = run.change_mps / (np.maximum(run.end - run.begin, 1) * view.dt_s)
        off = np.where(run.happens, np.abs(rate - rate_mps2), np.inf)
        chosen = run.instead_of(chosen, off < least)
        least = np.minimum(off, least)
    return chosen


def _begins(told: Told, act: Act, view: View) -> Ints:
    name = act.participant
    never = np.full(view.count, view.steps, dtype=np.int64)
    if name not in view.index:
        return never
    if act.kind is ActKind.SET_OFF:
        return sets_off(view, name, _rests_before(told, act))
    if act.kind is ActKind.WAIT:
        return _waits(told, act, view)
    if act.kind in SLOWING | GAINING:
        run = act_run(told, act, view)
        return np.where(run.happens, run.begin, never)
    if act.kind is ActKind.ENTER:
        return _comes_in(view, name, told.drive(name))
    if act.kind in LEAVING:
        begins = sideways_begin(told, act, view)
        # Who passes another leaves its lane, or is beside that one, if that is sooner.
        others = passed(told, act, view) if act.kind is ActKind.OVERTAKE else []
        level = [first(is_level(view, name, other)) for other in others]
        return np.asarray(np.min([begins, *level], axis=0))
    if act.kind is ActKind.REVERSE:
        return first(view.row(name, SPEED) < -STANDS_MPS)
    if act.kind is ActKind.TURN:
        return first(turned(boxes(view, name)))
    if act.kind is ActKind.OPEN_DOOR:
        return sets_off(view, door_of(name)) if door_of(name) in view.index else never
    crossing, begins = told.crossing(name), np.zeros_like(never)
    if crossing is not None:
        # Who crosses and moves from the start begins where it leaves the kerb.
        on = arms_of(view)[crossing.arm].on_it(boxes(view, name))
        begins = np.maximum(first(on) - 1, 0)
    stands = view.speed_mps(name)[:, 0] <= STANDS_MPS
    return np.where(stands, sets_off(view, name), begins)


def _waits(told: Told, act: Act, view: View) -> Ints:
    """When one begins to stop that then waits; at once where it stands from the start.

    When it stands, where it is told before to brake.
    """
    own = told.acts_of(act.participant)
    if own[max(own.index(act) - 1, 0)].kind in SLOWING:
        return rest(told, act, view)[0]
    stands = view.speed_mps(act.participant)[:, 0] <= STANDS_MPS
    run = act_run(told, act, view)
    return np.where(stands, 0, np.where(run.happens, run.begin, view.steps))


def passed(told: Told, act: Act, view: View) -> list[str]:
    """Whom one who overtakes is said to pass; where nobody is named, anybody else.

    Also what lies in its way: "swerves to the left around a crate".
    """
    named = (act.into,) if act.into else told.functional.overtaken(act.participant)
    others = [p.id for p in told.people if p.id != act.participant]
    things = [o.id for o in told.functional.objects if o.in_way_of == act.participant]
    return [name for name in named or (*others, *things) if name in view.index]


def is_level(view: View, name: str, other: str) -> Bools:
    """Whether one is beside another that faces as it does (c, t)."""
    own, frame = boxes(view, name), boxes(view, other)
    return (same_way(frame, own) > 0.0) & (gap_m(frame, own) < 0.0)


def _comes_in(view: View, name: str, drive: Drive | None) -> Ints:
    """The step in which somebody's front passes the end of its arm; where it is in at once, 0."""
    if drive is None:
        return np.full(view.count, view.steps, dtype=np.int64)
    arm, box = arms_of(view)[drive.entry], boxes(view, name)
    return first(arm.place(box)[0] + box.half_length >= arm.length_m)
