"""What is said of a finished scenario: the careful driver's verdict, reactivity."""

from dataclasses import asdict, dataclass
from math import isfinite
from typing import Any

from scegen.criticality.careful_driver import Verdict, careful_driver_verdict
from scegen.criticality.reactivity.sensitivity import Sensitivity, ego_start_sensitivity
from scegen.motion import build_paths
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.proof import Proof

_DIGITS = 3


@dataclass(frozen=True, slots=True)
class Judged:
    """The judgement of one scenario; ``sensitivity`` is None where the ego is alone."""

    verdict: Verdict
    sensitivity: Sensitivity | None

    def to_data(self) -> dict[str, Any]:
        """Verdict and sensitivity as JSON-able data; what is infinite is None."""
        starts: dict[str, Any] | None = None
        if self.sensitivity is not None:
            starts = asdict(self.sensitivity) | {"reactive": self.sensitivity.reactive}
        data: dict[str, Any] = _plain({"verdict": asdict(self.verdict), "ego_start": starts})
        return data


def judge(concrete: ConcreteScenario, proof: Proof | None = None) -> Judged:
    """Judge a scenario.

    If a search was about a pair with the ego, the event is that pair's.

    Raises:
        RoadInfeasibleError, MotionInfeasibleError: the numbers cannot be built.
    """
    paths = build_paths(concrete, build_network(concrete.road))
    ego = concrete.ego.id
    pair = proof.pair if proof is not None and ego in proof.pair else ()
    partner = next((name for name in pair if name != ego), None)
    return Judged(
        careful_driver_verdict(concrete, paths),
        ego_start_sensitivity(concrete, paths, partner=partner),
    )


def _plain(value: Any) -> Any:  # noqa: ANN401 - JSON-able data of any shape
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, float):
        return round(value, _DIGITS) if isfinite(value) else None
    return list(value) if isinstance(value, tuple) else value
