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
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import ParticipantKind


def story_of(functional: FunctionalScenario, logical: LogicalScenario) -> Story:
    """Everybody with its speed and lane, and what is done; no places and no moments yet.

    Raises:
        MotionInfeasibleError: what is said of lanes cannot all be had.
    """
    story = Story(as_meant(functional, logical), logical, ())
    cast(story)
    cast_doors(story)
    story.things = tuple(_things(story))
    for thing in story.things:
        blocked = story.runners[thing.in_way_of or ""]
        body = shape_of(thing).body
        story.runners[thing.id] = Runner(
            thing.id, ParticipantKind.CAR, body, blocked.forward, -1, 0.0,
            thing=True, keeps_left=blocked.keeps_left, inner_m=blocked.inner_m,
            lane_width_m=blocked.lane_width_m,
        )  # fmt: skip
    story.acts = all_acts(story)
    choose_lanes(story)
    put_on_strips(story)
    hang_doors(story)
    for thing in story.things:
        story.runners[thing.id].lane = story.runners[thing.in_way_of or ""].lane
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


def _things(story: Story) -> list[Thing]:
    """What lies in somebody's lane: what is said, and what a danger needs that nobody causes."""
    functional, runners = story.functional, story.runners
    needed = [thing for _, thing in lying_in_the_way(functional, story.logical, runners)]
    known = {thing.id for thing in needed}
    said = [t for t in functional.objects if t.in_way_of in runners and t.id not in known]
    return [*said, *needed]
