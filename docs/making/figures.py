"""The drawings of the explanations: by the program's own drawing layer, from its own words.

    python docs/making/figures.py FOLDER    # to look at

Every figure is a function in ``FIGURES``; pages find it as ``pictures/NAME.svg``.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from gallery import preview

from scegen.enumeration import enumerate_scenarios, plain_crossing
from scegen.motion import build_paths, simulate
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.report.bodies import body
from scegen.report.drawing import area, box, circle, document, letters, line
from scegen.report.gallery import gallery_svg
from scegen.report.raster import png_of
from scegen.report.theme import LIGHT
from scegen.report.world import View, placed
from scegen.road import build_network
from scegen.scenario.bodies import BODIES
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load
from scegen.scenario.vocabulary import ArmsMode, ParticipantKind, Reduction
from scegen.understanding import read

CAR, VAN, WALKER = ParticipantKind.CAR, ParticipantKind.VAN, ParticipantKind.PEDESTRIAN
EGO, OTHER, THIRD = LIGHT.ego, LIGHT.participants[0], LIGHT.participants[1]
TUTORIAL = (
    "The ego turns left at a four-way intersection while another car approaches from the right or "
    "from ahead."
)
FOLLOWING = (
    "The ego follows a car at 50 km/h. When the gap is 20 m, the car brakes with 4 m/s2 to 10 km/h."
)
Point = tuple[float, float]


class Sketch:
    """A few bodies on a road, in metres, with words and arrows on it."""

    def __init__(self, title: str, width_m: float = 60.0, height_m: float = 16.0) -> None:
        self.title = title
        self.view = View(0.0, 0.0, width_m, 0.0, 0.0, 720.0, 720.0 * height_m / width_m)
        self.world: list[str] = []
        self.over: list[str] = []

    def road(self, start: Point, end: Point, width_m: float = 7.0) -> None:
        """A straight road from one end to the other, with its centre line."""
        (x, y), (u, v) = start, end
        ahead = np.array([u - x, v - y]) / np.hypot(u - x, v - y)
        left = np.array([-ahead[1], ahead[0]]) * width_m / 2
        corners = [np.array(start) + left, np.array(end) + left, np.array(end) - left]
        self.world.append(area([tuple(c) for c in [*corners, np.array(start) - left]], LIGHT.road))
        self.world.append(line([start, end], LIGHT.mark, 0.15, stroke_dasharray="3 4.5"))

    def put(self, kind: ParticipantKind, at: Point, turn: float, colour: str, **how: bool) -> None:
        """Somebody whose box has its middle there, heading ``turn`` rad."""
        ahead = BODIES[kind].centre_ahead_m
        x, y = at[0] - ahead * np.cos(turn), at[1] - ahead * np.sin(turn)
        ego = colour == EGO
        braking = how.get("braking", False)
        drawn = body(kind, BODIES[kind], colour, LIGHT, self.view.scale, ego=ego, braking=braking)
        self.world.append(placed(drawn, x, y, turn))

    def ground(self, points: Sequence[Point], colour: str, opacity: float = 0.35) -> None:
        """An area that matters."""
        self.world.append(area(points, colour, fill_opacity=opacity))

    def arrow(self, start: Point, end: Point, colour: str, *, both: bool = False) -> None:
        """An arrow, or with ``both`` a dimension."""
        a, b = (self.view.seen(np.array(p)) for p in (start, end))
        self.over.append(line([tuple(a), tuple(b)], colour, 2.2))
        ends = [(b, a)] + ([(a, b)] if both else [])
        for tip, tail in ends:
            back = (tail - tip) / np.hypot(*(tail - tip)) * 9
            side = np.array([-back[1], back[0]]) * 0.45
            self.over.append(area([tuple(tip), tuple(tip + back + side), tuple(tip + back - side)],
                                  colour))  # fmt: skip

    def dashes(self, points: Sequence[Point], colour: str) -> None:
        """A line that nobody drives."""
        self.world.append(line(points, colour, 0.2, stroke_dasharray="1 0.8"))

    def say(self, words: str, at: Point, colour: str = LIGHT.text, *, bold: bool = False) -> None:
        """Words around a place."""
        x, y = self.view.seen(np.array(at)).tolist()
        self.over.append(
            letters(words, x, y, 14, colour, bold=bold, halo=LIGHT.halo, text_anchor="middle")
        )

    def drawn(self) -> str:
        """The picture."""
        view = self.view
        picture = view.picture("".join(self.world), LIGHT.ground, "sketch")
        return document(view.width, view.height, picture + "".join(self.over), title=self.title)


def _following(title: str, gap_m: float = 16.0) -> tuple[Sketch, float, float]:
    """One car behind another; where the gap between them begins and ends (m)."""
    sketch = Sketch(title)
    sketch.road((-30, 0), (30, 0))
    half = BODIES[CAR].length_m / 2
    sketch.put(CAR, (-12, -1.75), 0, EGO)
    sketch.put(CAR, (-12 + gap_m + 2 * half, -1.75), 0, OTHER)
    return sketch, -12 + half, -12 + half + gap_m


def _crossing(title: str) -> Sketch:
    sketch = Sketch(title, 60, 30)
    sketch.road((-30, 0), (30, 0))
    sketch.road((0, -15), (0, 15))
    return sketch


def distance() -> str:
    """The shortest line between two boxes."""
    sketch = _crossing("Distance: the shortest way between two bodies")
    sketch.put(CAR, (-9, -1.75), 0, EGO)
    sketch.put(CAR, (1.75, 2.0), np.pi / 2, OTHER)
    sketch.arrow((-6.6, -0.67), (0.67, -0.39), LIGHT.failed, both=True)
    sketch.say("distance", (-3, 0.6), LIGHT.failed, bold=True)
    return sketch.drawn()


def contact() -> str:
    """Two boxes that touch."""
    sketch = _crossing("Contact: the first moment at which two bodies touch")
    sketch.put(CAR, (-1.6, -1.75), 0, EGO)
    sketch.put(CAR, (1.9, -4.1), np.pi / 2, OTHER)
    x, y = sketch.view.seen(np.array([0.8, -1.9])).tolist()
    sketch.over.append(circle(x, y, 12, "none", stroke=LIGHT.failed, stroke_width=3))
    sketch.say("first shared point: contact_time", (0, 2), LIGHT.failed, bold=True)
    return sketch.drawn()


def ttc() -> str:
    """Both go on as they are: where would they touch?"""
    sketch = _crossing("TTC: when the bodies would touch if both kept their velocity")
    sketch.put(CAR, (-20, -1.75), 0, EGO)
    sketch.put(CAR, (1.75, -12), np.pi / 2, OTHER)
    sketch.arrow((-17.4, -1.75), (-9, -1.75), EGO)
    sketch.arrow((1.75, -9.4), (1.75, -5), OTHER)
    half = BODIES[CAR].length_m / 2
    for x, y, along in ((-1.75, -1.75, True), (1.75, -3.9, False)):
        dx, dy = (half, 1.08) if along else (1.08, half)
        corners = [(x - dx, y - dy), (x + dx, y - dy), (x + dx, y + dy), (x - dx, y + dy)]
        sketch.dashes([*corners, corners[0]], LIGHT.outline)
    sketch.say("now", (-20, 1.2))
    sketch.say("velocity kept for TTC seconds", (-12, 3.2))
    sketch.say("they touch", (7.5, 1.5), LIGHT.failed, bold=True)
    return sketch.drawn()


def pet() -> str:
    """One leaves the common ground, then the other comes."""
    sketch = _crossing("PET: from the first leaving the common ground to the second entering it")
    sketch.ground([(0.6, -2.9), (2.9, -2.9), (2.9, -0.6), (0.6, -0.6)], LIGHT.conflict, 0.8)
    sketch.put(CAR, (1.75, 1.9), np.pi / 2, OTHER)
    sketch.put(CAR, (-9, -1.75), 0, EGO)
    sketch.arrow((-6.4, -1.75), (0.4, -1.75), EGO)
    sketch.say("it has just left", (10, 3), OTHER, bold=True)
    sketch.say("enters PET seconds later", (-12, 1.2), EGO, bold=True)
    sketch.say("common ground", (10, -5.5))
    sketch.arrow((6.5, -4.8), (3.1, -2.6), LIGHT.outline)
    return sketch.drawn()


def headway() -> str:
    """The time until the rear of the other is reached."""
    sketch, begin, end = _following("Headway: gap divided by the speed of the one behind")
    sketch.arrow((begin, -1.75), (end, -1.75), EGO)
    sketch.say("gap ÷ own speed = headway", ((begin + end) / 2, 0.6), EGO, bold=True)
    sketch.dashes([(end, -4), (end, 1)], LIGHT.outline)
    return sketch.drawn()


def drac() -> str:
    """How hard to brake so as not to hit the slower one."""
    sketch, begin, end = _following("DRAC: braking that just avoids hitting the slower leader")
    sketch.put(CAR, (-12, -1.75), 0, EGO, braking=True)
    sketch.arrow((-12, 1.4), (2, 1.4), EGO)
    sketch.say("own speed", (-5, 2.4), EGO)
    sketch.arrow((end + 2.4, 1.4), (end + 7, 1.4), OTHER)
    sketch.say("its speed", (end + 5, 2.4), OTHER)
    sketch.arrow((begin, -1.75), (end, -1.75), LIGHT.failed, both=True)
    sketch.say("(difference of speeds)² ÷ (2 gap)", ((begin + end) / 2, -5.5), LIGHT.failed,
               bold=True)  # fmt: skip
    return sketch.drawn()


def required_braking() -> str:
    """Arrive when the other has gone."""
    sketch = _crossing("Required braking: the least deceleration that keeps clear of the other")
    sketch.ground([(0.6, -2.9), (2.9, -2.9), (2.9, -0.6), (0.6, -0.6)], LIGHT.conflict, 0.8)
    sketch.put(CAR, (-16, -1.75), 0, EGO, braking=True)
    sketch.put(CAR, (1.75, -9), np.pi / 2, OTHER)
    sketch.arrow((1.75, -6.4), (1.75, 4), OTHER)
    sketch.arrow((-13.4, -1.75), (0.4, -1.75), EGO)
    sketch.say("arrives when the other has left", (-12, 1.2), EGO, bold=True)
    sketch.say("÷ what brakes and friction allow = brake threat", (-14, -6.5))
    return sketch.drawn()


def impact_speed() -> str:
    """Velocities as arrows, and their difference."""
    sketch = _crossing("Impact speed and delta-v: the difference of the velocities at the contact")
    sketch.put(CAR, (-1.6, -1.75), 0, EGO)
    sketch.put(CAR, (1.9, -4.1), np.pi / 2, OTHER)
    sketch.arrow((-26, 6), (-16, 6), EGO)
    sketch.arrow((-26, 6), (-26, 12), OTHER)
    sketch.arrow((-26, 12), (-16, 6), LIGHT.failed)
    sketch.say("ego", (-21, 4.6), EGO)
    sketch.say("other", (-28, 9), OTHER)
    sketch.say("impact speed", (-17, 10), LIGHT.failed, bold=True)
    sketch.say("delta-v: each one's share, by the masses", (15, 9), LIGHT.text)
    return sketch.drawn()


def occlusion() -> str:
    """Lines of sight that a van cuts."""
    sketch = Sketch("Occlusion: the time for which a body cuts every line of sight", 60, 18)
    sketch.road((-30, 0), (30, 0))
    sketch.put(CAR, (-22, -1.75), 0, EGO)
    sketch.put(VAN, (6, -4.6), 0, THIRD)
    sketch.put(WALKER, (11, -5.6), np.pi / 2, OTHER)
    for y in (-5.8, -5.4):
        sketch.dashes([(-22, -1.75), (11, y)], LIGHT.failed)
    sketch.dashes([(-22, -1.75), (11, -1.4)], LIGHT.held)
    sketch.arrow((11, -5.1), (11, -1.4), OTHER)
    sketch.say("hidden", (-3, -5.8), LIGHT.failed, bold=True)
    sketch.say("in sight from here on: sight_time", (15, 0.4), LIGHT.held, bold=True)
    return sketch.drawn()


def injury() -> str:
    """The two curves."""
    plot = Plot(
        "Injury: chance of a serious injury", "speed, km/h", "probability", (0, 120), (0, 1)
    )
    speeds = np.linspace(0, 120, 121)
    occupants = 1 / (1 + np.exp(6.9540 - 0.1637 * speeds / 1.609344))
    unprotected = 1 / (1 + np.exp(4.6 - 0.078 * speeds))
    plot.curve(speeds, occupants, EGO)
    plot.curve(speeds, unprotected, OTHER)
    plot.say("occupants, by delta-v", (98, 0.78), EGO)
    plot.say("riders and pedestrians, by impact speed", (55, 0.93), OTHER)
    return plot.drawn()


class Plot:
    """Curves over an axis, by the same drawing layer."""

    def __init__(
        self, title: str, x: str, y: str, xs: Point, ys: Point, height: float = 260
    ) -> None:
        self.title, self.height = title, height
        self.xs, self.ys = xs, ys
        self.parts = [box(0, 0, 720, height, LIGHT.panel)]
        for part in range(6):
            share = part / 5
            a, b = xs[0] + share * (xs[1] - xs[0]), ys[0] + share * (ys[1] - ys[0])
            self.parts.append(line([self.at(a, ys[0]), self.at(a, ys[1])], LIGHT.line, 1))
            self.parts.append(line([self.at(xs[0], b), self.at(xs[1], b)], LIGHT.line, 1))
            u, v = self.at(a, ys[0])
            self.parts.append(letters(f"{a:g}", u, v + 16, 12, LIGHT.text_soft,
                                      text_anchor="middle"))  # fmt: skip
            u, v = self.at(xs[0], b)
            self.parts.append(letters(f"{b:g}", u - 6, v + 4, 12, LIGHT.text_soft,
                                      text_anchor="end"))  # fmt: skip
        self.parts.append(letters(x, 384, height - 6, 13, LIGHT.text, text_anchor="middle"))
        self.parts.append(letters(y, 8, 16, 13, LIGHT.text, bold=True))

    def at(self, x: float, y: float) -> Point:
        """Where a point of the plot lies on the picture."""
        (a, b), (c, d) = self.xs, self.ys
        return (
            58 + (x - a) / (b - a) * 645,
            28 + (1 - (y - c) / (d - c)) * (self.height - 28 - 40),
        )

    def curve(self, x: np.ndarray, y: np.ndarray, colour: str) -> None:
        """A curve."""
        points = [self.at(float(a), float(b)) for a, b in zip(x, y, strict=True)]
        self.parts.append(line(points, colour, 2.4))

    def band(self, x: Point, y: Point, colour: str) -> None:
        """A tolerance: from x to x, between two values."""
        (a, b), (c, d) = self.at(x[0], y[1]), self.at(x[1], y[0])
        self.parts.append(box(a, b, c - a, max(d - b, 8), colour, fill_opacity=0.45))

    def mark(self, x: float, words: str) -> None:
        """A moment."""
        top = self.at(x, self.ys[1])
        self.parts.append(
            line([top, self.at(x, self.ys[0])], LIGHT.outline, 1.2, stroke_dasharray="4 3")
        )
        self.parts.append(letters(words, top[0] + 5, top[1] - 4, 13, LIGHT.text))

    def say(self, words: str, at: Point, colour: str) -> None:
        """Words around a place."""
        x, y = self.at(*at)
        self.parts.append(letters(words, x, y, 13, colour, bold=True, halo=LIGHT.halo,
                                  text_anchor="middle"))  # fmt: skip

    def drawn(self) -> str:
        """The picture."""
        return document(720, self.height, "".join(self.parts), title=self.title)


def _made(text: str, **how: str) -> ConcreteScenario:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name, "out")
        generate(read(text), folder, Options(depth=CheckDepth.NONE, **how))
        (file,) = folder.glob("scenarios/*/concrete.yaml")
        return load(file, ConcreteScenario)


def tutorial_ways() -> str:
    """All logical scenarios of the tutorial's sentence."""
    return gallery_svg(enumerate_scenarios(read(TUTORIAL)))


def tutorial_left() -> str:
    """The one that the tutorial makes."""
    return preview(_made(TUTORIAL, pick="4"))


def assignments() -> str:
    """Three cars at three arms, every assignment."""
    functional = plain_crossing([0, 1, 2], 3)
    return gallery_svg(
        enumerate_scenarios(functional, reduction=Reduction.NONE, arms=ArmsMode.EQUAL)
    )


def classes() -> str:
    """The same, what is equal up to a turn counted once."""
    functional = plain_crossing([0, 1, 2], 3)
    return gallery_svg(enumerate_scenarios(functional, arms=ArmsMode.EQUAL))


def claims() -> str:
    """Speed and gap of a braking leader, with what is said of them as bands."""
    concrete = _made(FOLLOWING)
    paths = build_paths(concrete, build_network(concrete.road, concrete.name))
    traces = simulate(concrete, paths)
    lead, ego = traces["car_1"], traces["ego"]
    time_s, kph = lead.time_s, 3.6 * lead.speed_mps
    begin = float(time_s[np.argmax(kph < kph[0] - 0.5)])
    end = float(time_s[np.argmax(kph < 10.5)])
    gap = np.hypot(lead.x_m - ego.x_m, lead.y_m - ego.y_m) - BODIES[CAR].length_m
    last = 5 * float(np.ceil(time_s[-1] / 5))
    plot = Plot("Claims as bands of speed and gap", "time, s", "speed of car_1 (km/h), gap (m)",
                (0, last), (0, 60), 320)  # fmt: skip
    plot.band((0, begin), (49.5, 50.5), LIGHT.held)
    plot.band((end, end + 2), (9.5, 10.5), LIGHT.held)
    plot.band((begin - 0.1, begin + 0.1), (19.5, 20.5), LIGHT.failed)
    plot.curve(time_s, kph, OTHER)
    plot.curve(time_s, np.maximum(gap, 0), EGO)
    plot.mark(begin, "the act begins: read off the trace")
    plot.say("speed", (begin / 4, 45), OTHER)
    plot.say("gap", (begin / 4, 15), EGO)
    plot.say("“at 50 km/h”", (begin / 2, 53), LIGHT.held)
    plot.say("“with 4 m/s2”: the slope", ((begin + end) / 2 + 1.6, 36), OTHER)
    plot.say("“to 10 km/h”", (end + 1, 13), LIGHT.held)
    plot.say("“when the gap is 20 m”", (begin - 1.4, 23), LIGHT.failed)
    return plot.drawn()


SKETCHES: dict[str, Callable[[], str]] = {
    "distance": distance,
    "contact": contact,
    "time_to_collision": ttc,
    "post_encroachment": pet,
    "headway": headway,
    "drac": drac,
    "required_braking": required_braking,
    "impact": impact_speed,
    "injury": injury,
    "occlusion": occlusion,
}
"""A drawing for every module that defines a measure."""
FIGURES: dict[str, Callable[[], str]] = {
    "tutorial-ways": tutorial_ways,
    "tutorial-left": tutorial_left,
    "assignments": assignments,
    "classes": classes,
    "claims": claims,
    **{f"measure-{name}": draw for name, draw in SKETCHES.items()},
}


def main() -> None:
    """Write the drawings into a folder, as SVG and PNG."""
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in FIGURES.items():
        svg = draw()
        (folder / f"{name}.svg").write_text(svg, encoding="utf-8")
        (folder / f"{name}.png").write_bytes(png_of(svg))


if __name__ == "__main__":
    main()
