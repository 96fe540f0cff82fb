"""Movements as a tidy table: one row for each time and participant."""

from collections.abc import Mapping

from scegen.motion.model import Trace

COLUMNS = ("time_s", "id", "x_m", "y_m", "heading_rad", "speed_mps")


def traces_csv(traces: Mapping[str, Trace]) -> str:
    """All traces as CSV: by time, then in the scenario's order; the same input, the same text.

    ``x_m``, ``y_m`` (world) and ``heading_rad`` (counter-clockwise from east, unwrapped) are those
    of the reference point: the middle of the rear axle, a pedestrian's centre.

    Args:
        traces: by participant, at the same times.
    """
    lines = [",".join(COLUMNS)]
    movers = [
        (name, t.x_m.tolist(), t.y_m.tolist(), t.heading_rad.tolist(), t.speed_mps.tolist())
        for name, t in traces.items()
    ]
    times = next(iter(traces.values())).time_s.tolist() if traces else []
    for step, time in enumerate(times):
        for name, x, y, heading, speed in movers:
            # Adding zero turns -0.0 into 0.0.
            values = (round(v[step], 6) + 0.0 for v in (x, y, heading, speed))
            lines.append(f"{time:.3f},{name}," + ",".join(f"{value:.6f}" for value in values))
    return "\n".join(lines) + "\n"
