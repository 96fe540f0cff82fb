"""Our own simulation in the layout of esmini's CSV log, for readers of either."""

from math import cos, pi, sin

from scegen.motion import build_paths
from scegen.motion.batch import compile_program, simulate_batch
from scegen.motion.batch.arrays import HEADING, SPEED, X, Y
from scegen.motion.trigger_steps import STEP_S
from scegen.road import build_network
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import ConcreteScenario

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
    program = compile_program(concrete, paths)
    run = simulate_batch(*program, duration_s=concrete.duration_s, dt_s=STEP_S)
    tracks = dict(zip((entity.id for entity in concrete.entities), run.tracks[0], strict=True))
    entities = sorted(concrete.entities, key=lambda entity: entity is not concrete.ego)
    header = [f"#{n} {name}" for n in range(1, len(entities) + 1) for name in _COLUMNS]
    lines = [", ".join(["Index [-]", "TimeStamp [s]", *header])]
    for step in range(run.tracks.shape[3]):
        cells = [f"{step}", f"{step * STEP_S:.6f}"]
        for number, entity in enumerate(entities):
            state = tracks[entity.id][[SPEED, X, Y, HEADING], step].tolist()
            cells += [entity.id, f"{number}", *_block(entity.body, *state)]
        lines.append(", ".join(cells) + ", ")
    return "\n".join(lines) + "\n"


def _block(body: Body, speed: float, x: float, y: float, heading: float) -> list[str]:
    """The cells of one entity behind its name and number; its speed is told without a sign."""
    speed = abs(speed)
    box = (body.centre_ahead_m, 0.0, body.height_m / 2)
    size = (body.length_m, body.width_m, body.height_m)
    velocity = (speed * cos(heading), speed * sin(heading))
    values = (speed, *box, *size, x, y, 0.0, *velocity, heading % (2 * pi))
    return [f"{value + 0.0:.6f}" for value in values]
