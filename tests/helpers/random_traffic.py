"""Random traffic at a junction under one rule: nobody is said to do anything wrong, or one is."""

from __future__ import annotations

from random import Random

from saying import person, said

KINDS = ["four_way", "four_way", "t", "y", "skewed"]
RULES = {
    "all_way_stop": KINDS,
    "stop": KINDS,
    "yield": KINDS,
    "priority_to_right": KINDS,
    "signals": KINDS,
    "roundabout": ["roundabout"],
}
BODIES = ["car", "car", "car", "van", "truck", "bus", "motorcycle"]
BREACHES = {"signals": "red_light_running", "priority_to_right": "failure_to_yield"}
PLACES = ["left", "right", "opposite"]


def traffic(rule, seed, *, breach=False):
    """Two to four drivers at a junction; with a breach, one of them breaks its rule."""
    rng = Random(f"{rule}-{seed}-{breach}")  # noqa: S311 - the same each time is wanted
    kind = rng.choice(RULES[rule])
    arms = {"t": 3, "y": 3, "four_way": 4, "skewed": 4}.get(kind) or rng.randint(3, 5)
    turns = [[], ["straight"], ["left"], ["right"]] if arms > 3 else [[]]
    ego = person("ego", maneuvers=rng.choice(turns))
    if kind == "roundabout":
        ego = person("ego")
    others = [
        person(f"other_{n}", rng.choice(BODIES), approaches=[place] if kind != "roundabout" else [])
        for n, place in enumerate(rng.sample(PLACES[: arms - 1], rng.randint(1, min(3, arms - 1))))
    ]
    fields = {}
    if breach:
        by = rng.choice([p["id"] for p in others])
        danger = BREACHES.get(rule, "failure_to_yield")
        fields["hazards"] = [{"kind": danger, "by": [by], "to": ["ego"]}]
    else:
        fields["outcome"] = {"kind": "avoided", "between": []}
    control = "uncontrolled" if rule == "roundabout" else rule
    side = rng.choice(["right", "right", "left"])
    junction = {"arms": arms, "control": control, "driving_side": side, "lanes": [1] * arms}
    if rng.random() < 0.2:
        junction.pop("lanes")
    return said(kind, ego, *others, junction=junction, **fields)


def contradicts(rule, functional, logical):
    """Whether one who is said to break the rule has right of way before whom it endangers.

    At an all-way stop who comes first decides, at a light the light.
    """
    return rule not in {"all_way_stop", "signals"} and any(
        conflict.yields in hazard.to
        and {conflict.first, conflict.second} == {*hazard.by, *hazard.to}
        for conflict in logical.conflicts
        for hazard in functional.hazards
    )
