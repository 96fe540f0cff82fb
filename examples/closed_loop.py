"""A driver of your own against a dangerous scenario, step by step, and what it makes of the danger.

    python examples/closed_loop.py ["a description"] [--simulator esmini|own]

The description is made into files that leave the ego to the outside. Then the careful driver of
UN R157 drives it: through esmini's library where it is installed, else through our own simulation.
A driver is any function of time, step and everybody's state that gives the ego's next state; put
yours in place of ``CarefulDriver``. The danger is judged afterwards by the measures and predicates
that judge every scenario of this program.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from scegen.closed_loop import (
    CarefulDriver,
    Movement,
    OwnSimulation,
    PlayerSimulation,
    Simulation,
    State,
    drive,
    esmini_library,
    judged,
)
from scegen.errors import ScegenError
from scegen.motion import build_paths, simulate
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, EgoMode, Options
from scegen.pipeline.source import resolve_source
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load

TEXT = (
    "At a four-way intersection the ego drives straight on and a truck from the right runs the red "
    "light; they collide."
)


def main() -> int:
    """Print how near the ego comes to everybody, with the driver and as the scenario has it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("text", nargs="?", default=TEXT)
    parser.add_argument("--simulator", choices=("esmini", "own"))
    asked = parser.parse_args()
    simulator = asked.simulator or ("esmini" if esmini_library() else "own")
    try:
        with tempfile.TemporaryDirectory() as folder:
            files = made(asked.text, Path(folder, "out"))
            concrete = load(files / "concrete.yaml", ConcreteScenario)
            tell("as the scenario drives it", concrete, scripted(concrete))
            simulation: Simulation
            if simulator == "esmini":
                simulation = PlayerSimulation(files / "scenario.xosc", concrete.ego.id)
            else:
                simulation = OwnSimulation(concrete)
            driver = CarefulDriver(concrete)
            movements = drive(simulation, driver, concrete.duration_s)
    except ScegenError as error:
        print(f"error: {error.render()}", file=sys.stderr)
        return error.exit_code
    tell(f"with the careful driver, in {simulator}", concrete, movements)
    if driver.brakes_s is not None:
        print(f"  it brakes for {driver.danger} at {driver.brakes_s:.2f} s")
    return 0


def made(text: str, folder: Path) -> Path:
    """The scenario folder of a description; the ego is left to the outside."""
    generate(resolve_source(text), folder, Options(ego=EgoMode.EXTERNAL, depth=CheckDepth.NONE))
    return next((folder / "scenarios").iterdir())


def scripted(concrete: ConcreteScenario) -> list[Movement]:
    """What everybody does if the ego keeps to its own program."""
    paths = build_paths(concrete, build_network(concrete.road, concrete.name))
    traces = simulate(concrete, paths)
    ego = traces[concrete.ego.id]

    def as_planned(time_s: float, dt_s: float, _: Mapping[str, State]) -> State:
        step = round(time_s / dt_s) + 1
        return State(
            float(ego.x_m[step]),
            float(ego.y_m[step]),
            float(ego.heading_rad[step]),
            float(ego.speed_mps[step]),
        )

    return drive(OwnSimulation(concrete), as_planned, concrete.duration_s)


def tell(how: str, concrete: ConcreteScenario, movements: Sequence[Movement]) -> None:
    """Print the judgement of one drive."""
    dangers, hazards = judged(concrete, movements)
    print(how)
    for danger in dangers:
        contact = "" if danger.contact_s is None else f", contact at {danger.contact_s:.2f} s"
        print(f"  {danger.other}: {danger.distance_m:.2f} m at the nearest{contact}")
    for hazard in hazards:
        print(f"  {hazard.kind}: {'happens' if hazard.happened else 'does not happen'}")


if __name__ == "__main__":
    sys.exit(main())
