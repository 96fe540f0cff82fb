"""Two-vehicle scenarios in commonroad-crime: values and seconds, as JSON from stdin to stdout.

Run by players.py with the python of an environment that has commonroad-crime (make bench); it
imports nothing of the package. Lanelets are built from the vehicles' own ways. For ways that
cross or merge: PET and the smallest distance, once over the whole run; at the contact, delta-v.
For one behind the other: THW, TTC and required longitudinal acceleration at every step, the worst.
"""

import json
import logging
import math
import sys
import time
import traceback
import warnings

import numpy as np
from commonroad.geometry.shape import Rectangle
from commonroad.prediction.prediction import TrajectoryPrediction
from commonroad.scenario.intersection import Intersection, IntersectionIncomingElement
from commonroad.scenario.lanelet import Lanelet, LaneletNetwork, LaneletType
from commonroad.scenario.obstacle import DynamicObstacle, ObstacleType
from commonroad.scenario.scenario import Scenario, ScenarioID, Tag
from commonroad.scenario.state import CustomState, InitialState
from commonroad.scenario.trajectory import Trajectory
from commonroad_crime.data_structure.configuration import CriMeConfiguration
from commonroad_crime.measure import DCE, PET, THW, TTC, ALongReq, DeltaV

EGO, OTHER = 100, 200


def lanelet(way, begin, end, width, number, before=(), after=(), *, inside=False):
    """The part of a way from one of its points to another, as a lane of this width."""
    points = np.array([way["x"], way["y"]]).T[begin : end + 1]
    heading = np.array(way["heading"])[begin : end + 1]
    aside = np.array([-np.sin(heading), np.cos(heading)]).T * width / 2
    kinds = {LaneletType.INTERSECTION} if inside else {LaneletType.URBAN}
    return Lanelet(
        points + aside,
        points,
        points - aside,
        number,
        predecessor=list(before),
        successor=list(after),
        lanelet_type=kinds,
    )


def network_of(pair, width):
    """Three lanes for every way (into, through and out of the junction), or one for both."""
    if pair["kind"] == "following":
        way = pair["vehicles"][0]["way"]
        return LaneletNetwork.create_from_lanelet_list([lanelet(way, 0, len(way["x"]), width, 1)])
    lanes, incomings = [], []
    for n, vehicle in enumerate(pair["vehicles"]):
        way, first = vehicle["way"], 10 * (n + 1)
        enters, leaves = way["inside"]
        last = len(way["x"]) - 1
        lanes.append(lanelet(way, 0, enters, width, first, (), (first + 1,)))
        middle = lanelet(way, enters, leaves, width, first + 1, (first,), (first + 2,), inside=True)
        lanes += [middle, lanelet(way, leaves, last, width, first + 2, (first + 1,), ())]
        incomings.append(
            IntersectionIncomingElement(50 + n, {first}, successors_straight={first + 1})
        )
    network = LaneletNetwork.create_from_lanelet_list(lanes)
    network.add_intersection(Intersection(60, incomings))
    return network


def obstacle(number, vehicle, network):
    """A vehicle with its states; positions are box centres."""
    shape = Rectangle(length=vehicle["length"], width=vehicle["width"])
    states = [
        {
            "time_step": t,
            "position": np.array([vehicle["x"][t], vehicle["y"][t]]),
            "orientation": math.remainder(vehicle["heading"][t], 2 * math.pi),
            "velocity": vehicle["speed"][t],
        }
        for t in range(len(vehicle["x"]))
    ]
    found = network.find_lanelet_by_position([s["position"] for s in states])
    start = InitialState(acceleration=0.0, yaw_rate=0.0, slip_angle=0.0, **states[0])
    lanes = {t: set(ids) for t, ids in enumerate(found)}
    trajectory = Trajectory(1, [CustomState(**state) for state in states[1:]])
    prediction = TrajectoryPrediction(trajectory, shape, center_lanelet_assignment=lanes)
    return DynamicObstacle(number, ObstacleType.CAR, shape, start, prediction)


def configuration(pair, dt, width):
    scenario = Scenario(dt, ScenarioID())
    network = network_of(pair, width)
    scenario.replace_lanelet_network(network)
    scenario.tags = {Tag.INTERSECTION}
    for number, vehicle in zip((EGO, OTHER), pair["vehicles"], strict=True):
        scenario.add_objects(obstacle(number, vehicle, network))
    config = CriMeConfiguration()
    config.update(ego_id=EGO, sce=scenario)
    return config


def value(measure, step):
    found = measure.compute(vehicle_id=OTHER, time_step=step, verbose=False)
    return math.nan if found is None else float(found)


def crossing(pair, dt):
    """Values at body width, and PET on lanes of the road's width; seconds of PET and distance."""
    config = configuration(pair, dt, pair["vehicles"][0]["width"])
    begin = time.perf_counter()
    result = {"pet": value(PET(config), 0), "distance": value(DCE(config), 0)}
    seconds = time.perf_counter() - begin
    result["pet_lanes"] = value(PET(configuration(pair, dt, pair["lane_m"])), 0)
    if pair["contact_step"] is not None:
        result["delta_v"] = value(DeltaV(config), pair["contact_step"])
    return result, seconds


def following(pair, dt):
    config = configuration(pair, dt, pair["lane_m"])
    steps = len(pair["vehicles"][0]["x"]) - 2
    begin = time.perf_counter()
    made = {"headway": THW(config), "ttc": TTC(config), "required": ALongReq(config)}
    result = {}
    for name, measure in made.items():
        values = [value(measure, step) for step in range(steps)]
        finite = [v for v in values if not math.isnan(v)]
        result[name] = min(finite, default=math.nan)
    return result, time.perf_counter() - begin


def main():
    asked = json.load(sys.stdin)
    warnings.simplefilter("ignore")
    logging.disable(logging.CRITICAL)
    stdout, sys.stdout = sys.stdout, sys.stderr
    rows = []
    for pair in asked["pairs"]:
        compute = following if pair["kind"] == "following" else crossing
        try:
            found, seconds = compute(pair, asked["dt"])
            rows.append({"values": found, "seconds": seconds})
        except Exception as failure:  # noqa: BLE001 - one that it cannot do is a result, too
            last = traceback.extract_tb(failure.__traceback__)[-1]
            told = f"{type(failure).__name__} {failure} in {last.name}: {last.line}"
            rows.append({"failure": told})
    # JSON knows no infinity; as text it survives the way.
    for row in rows:
        row["values"] = {k: str(v) for k, v in row.get("values", {}).items()}
    stdout.write(json.dumps(rows))


if __name__ == "__main__":
    main()
