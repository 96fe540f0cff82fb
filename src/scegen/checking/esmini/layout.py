"""Our own simulation in the layout of esmini's CSV log, for readers of either."""

from math import cos, pi, sin

from scegen.motion import build_paths, simulate
from scegen.motion.model import Trace
from scegen.motion.standing import object_paths
from scegen.motion.trigger_steps import STEP_S
from scegen.road import build_network
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import ConcreteParticipant, ConcreteScenario
from scegen.scenario.objects import StaticObject

_COLUMNS = (
    "Entity_Name [-]",
    "Entity_ID [-]",
    "Current_Speed [m/s]",
    "bb_x [m]",
    "bb_y [m]",
    "bb_z [m]",
    "bb_length [m]",
    "bb_width [m]",
    "bb_height [m]",
    "World_Position_X [m]",
    "World_Position_Y [m]",
    "World_Position_Z [m]",
    "Vel_X [m/s]",
    "Vel_Y [m/s]",
    "World_Heading_Angle [rad]",
)
"""Of esmini's, in its order, those that a simulation without roads underneath can fill."""


def simulated_csv(concrete: ConcreteScenario) -> str:
    """What our simulator makes of a scenario, step by step as esmini would log it.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    paths = build_paths(concrete, build_network(concrete.road))
    traces = simulate(concrete, paths, dt_s=STEP_S)
    still = object_paths(concrete)
    entities: list[ConcreteParticipant | StaticObject] = [*concrete.ego_first, *concrete.objects]
    header = [f"#{n} {name}" for n in range(1, len(entities) + 1) for name in _COLUMNS]
    lines = [", ".join(["Index [-]", "TimeStamp [s]", *header])]
    for step in range(round(concrete.duration_s / STEP_S) + 1):
        cells = [f"{step}", f"{step * STEP_S:.6f}"]
        for number, entity in enumerate(entities):
            if entity.id in traces:
                state = _state(traces[entity.id], step)
            else:
                pose = still[entity.id].start
                state = (0.0, pose.x_m, pose.y_m, pose.heading_rad)
            cells += [entity.id, f"{number}", *_block(entity.body, *state)]
        lines.append(", ".join(cells) + ", ")
    return "\n".join(lines) + "\n"


def _state(trace: Trace, step: int) -> tuple[float, float, float, float]:
    rows = (trace.speed_mps, trace.x_m, trace.y_m, trace.heading_rad)
    speed, x, y, heading = (float(row[min(step, len(row) - 1)]) for row in rows)
    return speed, x, y, heading


def _block(body: Body, speed: float, x: float, y: float, heading: float) -> list[str]:
    """The cells of one entity behind its name and number."""
    box = (body.centre_ahead_m, 0.0, body.height_m / 2)
    size = (body.length_m, body.width_m, body.height_m)
    velocity = (speed * cos(heading), speed * sin(heading))
    values = (speed, *box, *size, x, y, 0.0, *velocity, heading % (2 * pi))
    return [f"{value + 0.0:.6f}" for value in values]
