"""How well tyres hold, by road surface and weather.

Upper ends of what is published for cars, because they bound what a search may ask of a driver, not
what is typical: asphalt dry 0.65-1.0, wet 0.4-0.65, in heavy rain 0.4-0.55, snow 0.2-0.35, ice
0.05-0.2 (Noon, Engineering Analysis of Vehicular Accidents, 1994, and tables of makers and
teachers for about 50 km/h; all as quoted in secondary sources).
"""

from scegen.scenario.environment import Environment, RoadSurface, Weather

GRAVITY_MPS2 = 9.81
"""Standard gravity, rounded as in UN R157."""

_SURFACE = {
    RoadSurface.DRY: 1.0,
    RoadSurface.WET: 0.65,
    RoadSurface.SNOWY: 0.3,
    RoadSurface.ICY: 0.2,
}
_WEATHER = {Weather.RAIN: 0.65, Weather.HEAVY_RAIN: 0.55, Weather.SNOW: 0.3}


def friction_of(environment: Environment) -> float:
    """The coefficient of friction: as said, else of the road's surface, else of the weather."""
    if environment.friction is not None:
        return environment.friction
    if environment.road_surface is not None:
        return _SURFACE[environment.road_surface]
    if environment.weather is not None:
        return _WEATHER.get(environment.weather, 1.0)
    return 1.0
