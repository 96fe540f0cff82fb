"""The movements of a scenario, by our own simulation or by esmini, as a file for other tools."""

from pathlib import Path

from scegen.checking.environment import ESMINI_HINT, esmini
from scegen.checking.recording import record, traces_of
from scegen.checking.subject import SCENARIO_FILE
from scegen.errors import InputError, MissingToolError
from scegen.motion import build_paths, simulate
from scegen.motion.model import Trace
from scegen.motion.traces import traces_csv
from scegen.motion.trigger_steps import STEP_S
from scegen.report.mcap_file import mcap_of
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario


def trace_file(
    concrete: ConcreteScenario, *, folder: Path, mcap: bool, esmini_plays: bool, dt_s: float
) -> bytes:
    """The content of a file with everybody's movements, as a table or as MCAP.

    ``folder`` is where its scenario file lies, for esmini to play; ``dt_s`` is the step of our own
    simulation, s, while esmini is played at ``STEP_S``.

    Raises:
        MissingToolError: esmini or the extra ``exchange`` is asked for and not there.
        InputError: esmini is asked for another step, or does not play the file.
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    network = build_network(concrete.road, concrete.name)
    if esmini_plays:
        traces = _played(concrete, folder / SCENARIO_FILE, dt_s)
    else:
        traces = simulate(concrete, build_paths(concrete, network), dt_s=dt_s)
    if mcap:
        return mcap_of(concrete, network, traces)
    return traces_csv(traces).encode()


def _played(concrete: ConcreteScenario, scenario: Path, dt_s: float) -> dict[str, Trace]:
    if dt_s != STEP_S:
        raise InputError(f"esmini is played at {STEP_S:g} s", where="--dt", hint="leave it out")
    if not scenario.is_file():
        raise InputError("does not exist", where=str(scenario), hint="name a scenario folder")
    if esmini() is None:
        raise MissingToolError(f"esmini is not on PATH; {ESMINI_HINT}", where="--player")
    return traces_of(record(scenario, concrete), concrete)
