"""From the two levels above to a story: who is cast, what lies in the way, which acts."""

from __future__ import annotations

from scegen.concretization.along.acts import all_acts
from scegen.concretization.along.casting import cast
from scegen.concretization.along.doors import cast_doors, hang_doors
from scegen.concretization.along.lanes import choose_lanes
from scegen.concretization.along.runner import Runner
from scegen.concretization.along.story import Story
from scegen.concretization.along.strips import put_on_strips
from scegen.concretization.asked import as_meant
from scegen.concretization.objects import lying_in_the_way, shape_of
from scegen.errors import MotionInfeasibleError
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalScenario
from scegen.scenario.speed_limits import implied_limit_mps
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import ParticipantKind


def story_of(functional: FunctionalScenario, logical: LogicalScenario) -> Story:
    """Everybody with its speed and lane, and what is done; no places and no moments yet.

    Raises:
        MotionInfeasibleError: what is said of lanes cannot all be had.
    """
    functional = as_meant(functional, logical)
    limit = implied_limit_mps(functional)
    runners = cast(functional, logical)
    cast_doors(functional, logical, runners)
    things = _things(functional, logical, runners)
    for thing in things:
        blocked = runners[thing.in_way_of or ""]
        runners[thing.id] = Runner(
            thing.id,
            ParticipantKind.CAR,
            shape_of(thing).body,
            blocked.forward,
            -1,
            0.0,
            thing=True,
            keeps_left=blocked.keeps_left,
            inner_m=blocked.inner_m,
            lane_width_m=blocked.lane_width_m,
        )
    acts = all_acts(functional, logical, runners)
    people = {name: runner for name, runner in runners.items() if not runner.thing}
    count = choose_lanes(functional, logical, people, acts)
    put_on_strips(functional, logical, people, count)
    hang_doors(functional, logical, runners, count)
    for thing in things:
        runners[thing.id].lane = runners[thing.in_way_of or ""].lane
    story = Story(functional, logical, acts, runners, count, limit, tuple(things))
    _keep_on_the_road(story)
    return story


def _keep_on_the_road(story: Story) -> None:
    """Nobody is so fast in a bend that no tyre would hold.

    Raises:
        MotionInfeasibleError: somebody is said to be.
    """
    bend = story.functional.junction.bend
    if bend is None:
        return
    radius = bend.radius_at_m(story.limit_mps)
    for runner in story.runners.values():
        asked = runner.fastest_mps**2 / radius
        if asked > story.grip_mps2:
            raise MotionInfeasibleError(
                f"at {runner.fastest_mps * 3.6:.0f} km/h a bend of {radius:g} m radius needs "
                f"{asked:.1f} m/s2 sideways, and tyres give {story.grip_mps2:.1f} on this road",
                where=runner.id,
                hint="Let it drive more slowly, or widen the bend.",
            )


def _things(
    functional: FunctionalScenario, logical: LogicalScenario, runners: dict[str, Runner]
) -> list[Thing]:
    """What lies in somebody's lane: what is said, and what a danger needs that nobody causes."""
    needed = [thing for _, thing in lying_in_the_way(functional, logical, runners)]
    known = {thing.id for thing in needed}
    said = [t for t in functional.objects if t.in_way_of in runners and t.id not in known]
    return [*said, *needed]
