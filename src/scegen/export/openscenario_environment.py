"""Weather, light and friction, in the one form that esmini and scenario_runner both read.

scenario_runner takes the sun's intensity as 1 − cloudiness (0 to 1) and rain as a share of the
heaviest; from version 1.2 on the standard has lux and mm/h, which the 1.2 file follows.
"""

from dataclasses import dataclass
from math import radians

from scegen.export.library import xosc
from scegen.motion.friction import friction_of
from scegen.scenario.environment import Environment, TimeOfDay, Visibility, Weather


@dataclass(frozen=True, slots=True)
class _Sky:
    clouds: str
    oktas: str
    cloudiness: float
    precipitation: str = "dry"
    share: float = 0.0
    mm_per_h: float = 0.0
    visual_range_m: float = 100_000.0


_SKIES: dict[Weather, _Sky] = {
    Weather.CLEAR: _Sky("free", "zeroOktas", 0.1),
    Weather.CLOUDY: _Sky("cloudy", "sixOktas", 0.8),
    Weather.RAIN: _Sky("rainy", "eightOktas", 0.9, "rain", 0.4, 4.0, 10_000.0),
    Weather.HEAVY_RAIN: _Sky("rainy", "eightOktas", 1.0, "rain", 0.9, 20.0, 3_000.0),
    Weather.SNOW: _Sky("overcast", "eightOktas", 0.9, "snow", 0.4, 2.0, 2_000.0),
    Weather.FOG: _Sky("overcast", "eightOktas", 0.8, visual_range_m=150.0),
}
_SUN: dict[TimeOfDay, tuple[int, float, float, float]] = {
    TimeOfDay.DAY: (12, 60.0, 180.0, 50_000.0),
    TimeOfDay.DAWN: (6, 5.0, 80.0, 400.0),
    TimeOfDay.DUSK: (20, 5.0, 280.0, 400.0),
    TimeOfDay.NIGHT: (0, -30.0, 0.0, 1.0),
}
"""Hour of the day, elevation and azimuth of the sun (deg), illuminance (lux)."""
_VISUAL_RANGE_M: dict[Visibility, float] = {Visibility.REDUCED: 400.0, Visibility.POOR: 120.0}


def environment_action(environment: Environment, minor: int) -> xosc.EnvironmentAction:
    """The conditions of the whole scenario; what is not said is a clear, dry day."""
    sky = _SKIES[environment.weather or Weather.CLEAR]
    hour, elevation_deg, azimuth_deg, lux = _SUN[environment.time_of_day or TimeOfDay.DAY]
    said = environment.visibility
    visual_range = environment.visual_range_m or min(
        sky.visual_range_m, _VISUAL_RANGE_M.get(said, sky.visual_range_m) if said else 1e6
    )
    standard = minor >= 2
    # Far-off fog bounds would be read as fog by nobody: the range is what counts.
    weather = xosc.Weather(
        getattr(xosc.FractionalCloudCover, sky.oktas)
        if standard
        else getattr(xosc.CloudState, sky.clouds),
        sun=xosc.Sun(
            round(lux * (1 - 0.8 * sky.cloudiness), 2)
            if standard
            else round(1 - sky.cloudiness, 2),
            round(radians(azimuth_deg), 4),
            round(radians(elevation_deg), 4),
        ),
        fog=xosc.Fog(visual_range),
        precipitation=xosc.Precipitation(
            getattr(xosc.PrecipitationType, sky.precipitation),
            sky.mm_per_h if standard else sky.share,
        ),
    )
    return xosc.EnvironmentAction(
        xosc.Environment(
            "environment",
            xosc.TimeOfDay(False, 2024, 6, 21, hour, 0, 0),
            weather,
            xosc.RoadCondition(friction_of(environment)),
        )
    )
