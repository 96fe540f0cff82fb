"""Conditions around the traffic: weather, light, the road's surface, how far one sees."""

from pydantic import Field

from scegen.scenario.definitions import Word
from scegen.scenario.model import FrozenModel


class Weather(Word):
    """Sky and precipitation."""

    CLEAR = (
        "clear",
        "no clouds and no precipitation",
        "good visibility, which is not weather",
        "sunny",
    )
    CLOUDY = "cloudy", "a covered sky without precipitation", "`fog`", "overcast"
    RAIN = "rain", "it rains", "`heavy_rain`; a wet road after rain", "in the rain"
    HEAVY_RAIN = "heavy_rain", "it rains strongly", "`rain`", "a downpour"
    SNOW = "snow", "it snows", "a snowy road without snowfall", "in a snowstorm"
    FOG = "fog", "fog or mist", "smoke, dust (visibility)", "in dense fog"


class TimeOfDay(Word):
    """Light conditions by the position of the sun."""

    DAY = "day", "the sun is up", "", "at noon"
    DAWN = "dawn", "the sun rises", "`dusk`", "at sunrise"
    DUSK = "dusk", "the sun sets", "`dawn`", "at twilight"
    NIGHT = "night", "the sun is down", "a dark place by day", "in darkness"


class RoadSurface(Word):
    """Condition of the road surface."""

    DRY = "dry", "the road is dry", "", "on dry asphalt"
    WET = (
        "wet",
        "there is water on the road",
        "rain alone, which leaves this field empty",
        "on a wet road",
    )
    ICY = "icy", "there is ice on the road", "`snowy`", "black ice"
    SNOWY = "snowy", "there is snow on the road", "`icy`; snowfall alone", "on packed snow"


class Visibility(Word):
    """How far one sees."""

    GOOD = "good", "one is said to see far", "", "with good visibility"
    REDUCED = (
        "reduced",
        "one is said to see less than usual",
        "`poor`; somebody hidden (`occlusion`); fog or night alone",
        "reduced visibility; glare",
    )
    POOR = (
        "poor",
        "one is said to see badly",
        "`reduced`; fog or night alone, which leave this field empty",
        "one can hardly see",
    )


class Environment(FrozenModel):
    """Conditions around the traffic; None = not said.

    ``friction`` is the coefficient between tyre and road (1 on dry asphalt), ``visual_range_m``
    how far one sees; either goes before what the words for surface, weather and sight stand for.
    """

    weather: Weather | None = None
    time_of_day: TimeOfDay | None = None
    road_surface: RoadSurface | None = None
    visibility: Visibility | None = None
    friction: float | None = Field(default=None, gt=0, le=1.2)
    visual_range_m: float | None = Field(default=None, gt=0, le=100_000)
