"""How well tyres hold, by road surface and weather.

Typical coefficients of sliding friction after Treiber and Kesting, Traffic Flow Dynamics (2013),
and Wong, Theory of Ground Vehicles (2008): dry 0.8-1.0, wet 0.5-0.7, snow 0.2-0.3, ice 0.1-0.2;
the upper ends are taken.
"""

from __future__ import annotations

from scegen.scenario.functional import Environment
from scegen.scenario.vocabulary import RoadSurface, Weather

_SURFACE = {
    RoadSurface.DRY: 1.0,
    RoadSurface.WET: 0.7,
    RoadSurface.SNOWY: 0.3,
    RoadSurface.ICY: 0.2,
}
_WEATHER = {Weather.RAIN: 0.7, Weather.HEAVY_RAIN: 0.6, Weather.SNOW: 0.3}


def friction_of(environment: Environment) -> float:
    """The coefficient of friction; what the text says of the road goes before the weather."""
    if environment.road_surface is not None:
        return _SURFACE[environment.road_surface]
    if environment.weather is not None:
        return _WEATHER.get(environment.weather, 1.0)
    return 1.0
