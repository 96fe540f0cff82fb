"""What happens, in order: the acts of the text, and those that its dangers and manoeuvres imply."""

from collections.abc import Collection, Iterator

from scegen.concretization.along.story import Story
from scegen.concretization.amounts import implied, spelled_out
from scegen.scenario.acts import GAINING, LEAVING, SLOWING, Act, ActKind, AfterAct, WhenMeasure
from scegen.scenario.functional import Hazard
from scegen.scenario.hazards import FROM_BESIDE, HAZARDS
from scegen.scenario.logical import Drive
from scegen.scenario.model import Interval
from scegen.scenario.spacings import LENGTHWISE, START
from scegen.scenario.vocabulary import ON_FOOT, HazardKind, Maneuver

ROLLS_S = 2.0
"""How long one who has stood drives before it moves aside: nobody does so on the spot."""
_ALONG = SLOWING | GAINING | LEAVING | {ActKind.OPEN_DOOR}
_OF_THE_DRIVER = frozenset({HazardKind.DELAYED_BRAKING})
"""Who brakes late answers somebody: it is a reaction, no act of its own."""


def all_acts(story: Story) -> list[Act]:
    """The acts of those along the road; implied ones come after those that are said."""
    told = [_when_so_near(story, a) for a in spelled_out(story.functional.acts, story.runners)]
    # Where there is no junction, one who turns swerves.
    own = (act for act in told if act.participant in story.runners)
    acts = [a.but(kind=ActKind.SWERVE) if a.kind is ActKind.TURN else a for a in own]
    acts = [act for act in acts if act.kind in _ALONG]
    for hazard in story.functional.hazards:
        if hazard.kind is HazardKind.OVERTAKING:
            acts = _passing_first(story, hazard, acts)
        for act in list(_implied(story, hazard, acts)):
            # A move aside before its doer stops, as nobody moves aside who stands.
            its_stop = act.participant, ActKind.STOP
            stops = [n for n, each in enumerate(acts) if (each.participant, each.kind) == its_stop]
            acts.insert(stops[0] if stops and act.kind in LEAVING else len(acts), act)
    for drive in story.logical.drives:
        acts += _manoeuvre(story, drive, acts)
    for name in story.in_bays:
        acts = _out_of_its_bay(story, name, acts)
    # Who passes another and stays out passes on the side to which it changes lanes.
    stay = (d for d in story.logical.drives if d.participant not in story.exiting)
    sides = {d.participant: d.changes_to for d in stay}
    unsaid = {a.id for a in acts if a.kind is ActKind.OVERTAKE and a.side is None}
    acts = [a.but(side=sides.get(a.participant)) if a.id in unsaid else a
            for a in acts]  # fmt: skip
    return list(_from_rest(acts))


def _when_so_near(story: Story, act: Act) -> Act:
    """``30 m ahead … brakes at a headway of 1.2 s``: what is told of two places is when it begins.

    Where one spacing alone is told, the start follows from it.
    """
    spacings = [s for s in story.functional.spacings if s.measure in LENGTHWISE]
    tied = {frozenset({s.participant, s.reference}) for s in spacings if s.at == START}
    for one in spacings if act.when is None else ():
        begins = one.at == act.id and one.since == "begin"
        if begins and frozenset({one.participant, one.reference}) in tied:
            told = {n: getattr(one, n) for n in ("measure", "participant", "reference", "value")}
            return act.but(when=WhenMeasure(**told))
    return act


def _out_of_its_bay(story: Story, name: str, acts: list[Act]) -> list[Act]:
    """Who stands in a bay beside the lanes sets off, rolls a little and moves into the lane."""
    own = [act for act in acts if act.participant == name]
    aside = next((act for act in own if act.kind in LEAVING), None)
    on = next((act for act in own if act.kind is ActKind.SET_OFF), None)
    if on is None:
        on = implied("on", name, name, ActKind.SET_OFF)
        on = on.but(when=aside.when if aside is not None else None)
    out = aside or implied("out", name, name, ActKind.CHANGE_LANE, side=story.inwards)
    rolls = Interval(low=ROLLS_S, high=ROLLS_S)
    then = AfterAct(act=on.id, since="begin", delay_s=rolls)
    out = out.but(kind=ActKind.CHANGE_LANE, when=then)
    first = acts.index(own[0]) if own else 0
    before, after = acts[:first], acts[first:]
    return [*before, on, out, *(act for act in after if act.id not in {on.id, out.id})]


def _from_rest(acts: list[Act]) -> Iterator[Act]:
    """Who stands sets off before it moves aside: ``stops and then changes lanes``."""
    rests: dict[str, Act] = {}
    for act in acts:
        stopped, when = rests.pop(act.participant, None), act.when
        if act.kind in SLOWING:
            target = act.target_speed_mps
            if act.kind is ActKind.STOP or (target is not None and target.high == 0.0):
                rests[act.participant] = act
        elif act.kind in LEAVING and stopped is not None:
            rolls = Interval(low=ROLLS_S, high=ROLLS_S)
            on = implied("on", stopped.id, act.participant, ActKind.SET_OFF)
            later = AfterAct(act=stopped.id, since="end")
            if isinstance(when, AfterAct) and when.later_s.low > ROLLS_S:
                # So that it moves aside when it is said to.
                early = when.later_s.low - ROLLS_S
                sooner = Interval(low=early, high=early)
                yield on.but(when=when.but(delay_s=sooner))
            else:
                yield on.but(when=when or later)
                then = AfterAct(act=on.id, since="begin", delay_s=rolls)
                act = act.but(when=then)  # noqa: PLW2901
        yield act


def _passing_first(story: Story, hazard: Hazard, acts: list[Act]) -> list[Act]:
    """Who comes in front of the one it overtakes, or brakes there, has passed it before."""
    runners = story.runners
    passed = next((name for name in hazard.to if name in runners), None)
    for n, act in enumerate(acts):
        back = act.kind is ActKind.CHANGE_LANE and act.into in hazard.to and act.into in runners
        slows = act.kind in SLOWING and act.when is None
        if act.participant not in hazard.by or not (back or slows):
            continue
        if passed is None or does(acts, act.participant, frozenset({ActKind.OVERTAKE})):
            continue
        who, into = act.participant, act.into if back else passed
        before = implied("pass", who, who, ActKind.OVERTAKE, into=into)
        if slows:
            then = AfterAct(act=before.id, since="end")
            act = act.but(when=then)  # noqa: PLW2901
        return [*acts[:n], before, act, *acts[n + 1 :]]
    return acts


def does(acts: list[Act], name: str, kinds: Collection[ActKind]) -> bool:
    """Whether somebody does one of these already."""
    return any(act.participant == name and act.kind in kinds for act in acts)


def _implied(story: Story, hazard: Hazard, acts: list[Act]) -> Iterator[Act]:
    """The acts that a danger consists of, where who causes it has none of the sort."""
    functional, runners = story.functional, story.runners
    on_foot = hazard.to and all(functional.participant(to).kind in ON_FOOT for to in hazard.to)
    if hazard.kind in _OF_THE_DRIVER or (hazard.kind in FROM_BESIDE and on_foot):
        return  # who does not yield to people drives on
    for by in (name for name in hazard.by if name in runners):
        if hazard.kind is HazardKind.SWERVING and story.does(by, Maneuver.OVERTAKE):
            continue  # on its way round another
        # Where there is no junction, joining and turning are moves aside.
        joins = hazard.kind in FROM_BESIDE
        for kind in (ActKind.CHANGE_LANE,) if joins else HAZARDS[hazard.kind].acts:
            kind = ActKind.SWERVE if kind is ActKind.TURN else kind  # noqa: PLW2901
            alike = next((s for s in (SLOWING, LEAVING) if kind in s), frozenset({kind}))
            own = does(acts, by, alike)
            stands = runners[by].stands or runners[by].speed_mps == 0.0
            answers = by == story.ego.id and kind in SLOWING and len(runners) > 1
            if kind in _ALONG and not own and not stands and not answers:
                into = next((to for to in hazard.to if to in runners and to != by), None)
                yield implied(hazard.kind, by, by, kind, into=into if kind in LEAVING else None)


def _manoeuvre(story: Story, drive: Drive, acts: list[Act]) -> Iterator[Act]:
    name = drive.participant
    exits = name in story.exiting  # as its last change of lane
    if name not in story.runners or does(acts, name, {ActKind.CHANGE_LANE} if exits else LEAVING):
        return
    if drive.maneuver is Maneuver.LANE_CHANGE:
        yield implied("change", name, name, ActKind.CHANGE_LANE, side=drive.changes_to)
    elif drive.maneuver is Maneuver.OVERTAKE:
        yield implied("pass", name, name, ActKind.OVERTAKE)
