"""Junctions of every kind, size, side and shape: made whole, and clean by our own checks."""

from hypothesis import HealthCheck, event, given, settings
from hypothesis import strategies as st

from scegen.checking import check_folder
from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.errors import MotionInfeasibleError, RoadInfeasibleError
from scegen.export.opendrive import write_opendrive
from scegen.export.openscenario import write_openscenario
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.files import to_yaml
from scegen.scenario.functional import FunctionalScenario, Participant
from scegen.scenario.junction import ARM_COUNTS, Junction
from scegen.scenario.vocabulary import DrivingSide, JunctionKind, ParticipantKind

OWN = ("opendrive", "openscenario")
WHEELS = [ParticipantKind.CAR, ParticipantKind.TRUCK, ParticipantKind.MOTORCYCLE]


@st.composite
def junctions(draw, kind):
    arms = draw(st.integers(*ARM_COUNTS[kind]))
    angles = ()
    if kind is not JunctionKind.STRAIGHT and draw(st.booleans()):
        weights = draw(st.lists(st.integers(2, 5), min_size=arms, max_size=arms))
        angles = tuple(round(360 * sum(weights[:i]) / sum(weights), 2) for i in range(arms))
    lanes = st.integers(1, 3)
    counts = [draw(lanes)] * 2 if arms == 2 else [draw(lanes) for _ in range(arms)]
    return Junction(
        kind=kind,
        arms=arms,
        arm_angles_deg=angles,
        lanes=tuple(counts),
        ring_lanes=draw(st.integers(1, 2)) if kind is JunctionKind.ROUNDABOUT else None,
        driving_side=draw(st.sampled_from(DrivingSide)),
        speed_limit_mps=draw(st.sampled_from([None, 8.0, 13.9, 22.0])),
    )


@st.composite
def functionals(draw):
    kind = draw(st.sampled_from(JunctionKind))
    others = [
        Participant(id=f"other_{i}", kind=draw(st.sampled_from(WHEELS)))
        for i in range(draw(st.integers(0, 3)))
    ]
    if draw(st.booleans()):
        others.append(Participant(id="pedestrian_1", kind="pedestrian", maneuvers={"cross"}))
    return FunctionalScenario(
        description="Vehicles meet.",
        junction=draw(junctions(kind)),
        participants=(Participant(id="ego", role="ego"), *others),
    )


@settings(
    max_examples=100,
    derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(functionals(), st.integers(0, 2**32 - 1))
def test_whatever_can_be_made_is_clean(tmp_path, functional, seed):
    event(functional.junction.kind)
    scenarios = enumerate_scenarios(functional, limit=50).scenarios
    scenario = scenarios[seed % len(scenarios)]
    try:
        concrete = concretize(functional, scenario, seed=seed)
    except (RoadInfeasibleError, MotionInfeasibleError) as refusal:
        event(f"refused: {type(refusal).__name__}")
        assert any(character.isdigit() for character in refusal.message)  # noqa: PT017
        return
    network = build_network(concrete.road)
    paths = build_paths(concrete, network)
    road = write_opendrive(network, controlled_arms=concrete.road.controlled_arms)
    (tmp_path / "road.xodr").write_text(road)
    (tmp_path / "scenario.xosc").write_bytes(write_openscenario(concrete, paths))
    (tmp_path / "concrete.yaml").write_text(to_yaml(concrete))
    report = check_folder(tmp_path, OWN)
    assert [result.status for result in report.results] == ["passed", "passed"], [
        finding for result in report.results for finding in result.findings
    ]
