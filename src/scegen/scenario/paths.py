"""What stands where the path of a field leads, such as ``participants.car_1.speed_mps``."""

from typing import Any

NOWHERE = object()
"""What stands at a path that leads nowhere."""


def value_at(data: Any, path: str) -> Any:  # noqa: ANN401 - JSON-able data
    """What stands at the path in the data of a functional scenario; :data:`NOWHERE` if nothing.

    Items of a list are named by their id or by their number. Hazards are named by kind: the value
    is all of that kind.
    """
    head, _, rest = path.partition(".")
    if head == "hazards" and rest:
        kind, _, part = rest.partition(".")
        alike = [h for h in data["hazards"] if h["kind"] == kind]
        if not alike:
            return NOWHERE
        return [h.get(part) for h in alike] if part else alike
    here = data
    for part in path.split("."):
        if isinstance(here, dict):
            here = here.get(part, NOWHERE)
        elif isinstance(here, list):
            named = [x for x in here if isinstance(x, dict) and x.get("id") == part]
            index = int(part) if part.isdigit() else len(here)
            here = named[0] if named else here[index] if index < len(here) else NOWHERE
        else:
            return NOWHERE
    return here
