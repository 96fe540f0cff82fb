"""Movements as an MCAP file, which Foxglove and Lichtblick open: a 3D scene, frames and plots.

Topics: ``/road`` (lane edges, once) and ``/scene`` (boxes) as ``foxglove.SceneUpdate``, ``/tf``
(each reference point's frame in ``map``) as ``foxglove.FrameTransforms``, and
``/participants/<id>`` as JSON for plots. Times count from 0.
"""

import json
from collections.abc import Mapping
from importlib import import_module
from io import BytesIO
from math import cos, sin
from typing import Any

from scegen.errors import of_extra
from scegen.motion.model import Trace
from scegen.motion.standing import object_paths
from scegen.report.lane_shapes import road_shapes
from scegen.road.geometry import Pose
from scegen.road.model import RoadNetwork
from scegen.scenario.bodies import Body
from scegen.scenario.concrete import ConcreteScenario

_LIBRARIES = ("mcap", "mcap_protobuf", "foxglove_schemas_protobuf", "google")
_LIBRARY = "ML-SceGen"
_MAP = "map"
_EGO, _OTHER = (0.90, 0.35, 0.10, 0.9), (0.20, 0.45, 0.80, 0.9)
_THING, _MARK = (0.5, 0.5, 0.5, 0.9), (0.8, 0.8, 0.8, 1.0)
_MARK_M = 0.12
_SERIES = ("time_s", "x_m", "y_m", "heading_rad", "speed_mps")
"""What is plotted; so are the fields of a trace called."""


def mcap_of(concrete: ConcreteScenario, network: RoadNetwork, traces: Mapping[str, Trace]) -> bytes:
    """The file's content; the same input gives the same bytes.

    ``traces`` are by participant, at the same times, however they came about.

    Raises:
        MissingToolError: the extra ``exchange`` is not installed.
    """
    with of_extra("exchange", "MCAP", *_LIBRARIES, where="--mcap"):
        register = import_module("mcap_protobuf.schema").register_schema
        update, transforms = _message("SceneUpdate"), _message("FrameTransforms")
        stream = BytesIO()
        writer = import_module("mcap.writer").Writer(stream)
    writer.start(library=_LIBRARY)
    scene, road, frames = (
        writer.register_channel(
            topic=topic, message_encoding="protobuf", schema_id=int(register(writer, message))
        )
        for topic, message in (("/scene", update), ("/road", update), ("/tf", transforms))
    )
    plotted = {"type": "object", "properties": {name: {"type": "number"} for name in _SERIES}}
    state = writer.register_schema(
        name="State", encoding="jsonschema", data=json.dumps(plotted).encode()
    )
    plots = {
        name: writer.register_channel(
            topic=f"/participants/{name}", message_encoding="json", schema_id=state
        )
        for name in traces
    }

    def write(channel: int, time_ns: int, data: bytes) -> None:
        writer.add_message(channel, log_time=time_ns, publish_time=time_ns, data=data)

    write(road, 0, _bytes(_road(update(), network)))
    times = next(iter(traces.values())).time_s.tolist() if traces else []
    for step, time_s in enumerate(times):
        time_ns = round(time_s * 1e9)
        write(scene, time_ns, _bytes(_scene(update(), concrete, traces, step)))
        write(frames, time_ns, _bytes(_frames(transforms(), traces, step)))
        for name, trace in traces.items():
            write(plots[name], time_ns, json.dumps(_state(trace, step)).encode())
    writer.finish()
    return stream.getvalue()


def _bytes(message: Any) -> bytes:  # noqa: ANN401
    return bytes(message.SerializeToString(deterministic=True))


def _message(name: str) -> Any:  # noqa: ANN401 - an optional library's type
    return getattr(import_module(f"foxglove_schemas_protobuf.{name}_pb2"), name)


def _road(update: Any, network: RoadNetwork) -> Any:  # noqa: ANN401
    shapes = road_shapes(network)
    entity = update.entities.add(id="road", frame_id=_MAP)
    for points in (*shapes.edge_lines, *shapes.centre_lines, *shapes.lane_lines):
        line = entity.lines.add(type=0, thickness=_MARK_M)
        line.pose.orientation.w = 1.0
        _colour(line, _MARK)
        for x, y in points.tolist():
            line.points.add(x=x, y=y)
    return update


def _scene(
    update: Any,  # noqa: ANN401
    concrete: ConcreteScenario,
    traces: Mapping[str, Trace],
    step: int,
) -> Any:  # noqa: ANN401
    for participant in concrete.participants:
        if participant.id in traces:
            trace = traces[participant.id]
            at = Pose(*(float(v[step]) for v in (trace.x_m, trace.y_m, trace.heading_rad)))
            colour = _EGO if participant is concrete.ego else _OTHER
            _box(update, participant.id, participant.body, at, colour)
    still = object_paths(concrete)
    for thing in concrete.objects:
        _box(update, thing.id, thing.body, still[thing.id].start, _THING)
    return update


def _box(update: Any, name: str, body: Body, at: Pose, colour: tuple[float, ...]) -> None:  # noqa: ANN401
    """A box round the body of one whose reference point is ``at``."""
    x, y, heading = at.x_m, at.y_m, at.heading_rad
    cube = update.entities.add(id=name, frame_id=_MAP).cubes.add()
    cube.pose.position.x = x + body.centre_ahead_m * cos(heading)
    cube.pose.position.y = y + body.centre_ahead_m * sin(heading)
    cube.pose.position.z = body.height_m / 2
    cube.pose.orientation.z, cube.pose.orientation.w = sin(heading / 2), cos(heading / 2)
    cube.size.x, cube.size.y, cube.size.z = body.length_m, body.width_m, body.height_m
    _colour(cube, colour)


def _colour(primitive: Any, colour: tuple[float, ...]) -> None:  # noqa: ANN401
    primitive.color.r, primitive.color.g, primitive.color.b, primitive.color.a = colour


def _frames(update: Any, traces: Mapping[str, Trace], step: int) -> Any:  # noqa: ANN401
    for name, trace in traces.items():
        frame = update.transforms.add(parent_frame_id=_MAP, child_frame_id=name)
        frame.timestamp.FromNanoseconds(round(float(trace.time_s[step]) * 1e9))
        frame.translation.x, frame.translation.y = float(trace.x_m[step]), float(trace.y_m[step])
        half = float(trace.heading_rad[step]) / 2
        frame.rotation.z, frame.rotation.w = sin(half), cos(half)
    return update


def _state(trace: Trace, step: int) -> dict[str, float]:
    return {name: round(float(getattr(trace, name)[step]), 6) + 0.0 for name in _SERIES}
