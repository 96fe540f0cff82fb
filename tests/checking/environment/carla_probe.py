"""Loads OpenDRIVE files named as arguments in carla.Map; run by the interop environment's python.

Prints one line of JSON per file; the caller runs it in a process of its own, since carla.Map
can end in a segmentation fault.
"""

import json
import sys
from pathlib import Path

import carla

for name in sys.argv[1:]:
    world_map = carla.Map(Path(name).stem, Path(name).read_text(encoding="utf-8"))
    topology = world_map.get_topology()
    starts = world_map.get_spawn_points()
    waypoints = world_map.generate_waypoints(2.0)
    stuck = [w for w in waypoints if not w.next(1.0) and w.is_junction]
    found = {
        "topology": len(topology),
        "waypoints": len(waypoints),
        "roads": sorted({w.road_id for w in waypoints}),
        "stuck_in_junction": len(stuck),
        "spawn_points": len(starts),
    }
    sys.stdout.write(json.dumps(found) + "\n")
