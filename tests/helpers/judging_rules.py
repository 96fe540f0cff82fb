"""Rules of the road judged on a player's recording and the files alone.

Shares nothing with the program but the logical scenario's answer to who yields: lines and lights
are read from the files, bodies and movements from esmini's log.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from math import cos, sin

import numpy as np
import shapely
from lxml import etree

STANDS_MPS, STANDS_S = 0.1, 1.0
BEFORE_LINE_M, OVER_LINE_M = 3.0, 0.3
CLEAR_S, TOGETHER_S, TOLERANCE_S = 2.0, 0.5, 0.15
RED_FOR_S = 0.5
ALONG_M, ALONG_RAD, MERGED_FOR_M = 0.5, 0.2, 5.0
RED = "on;off;off"


@dataclass
class Mover:
    """One vehicle of a recording: times, places, headings, speeds, and its box."""

    t: np.ndarray
    x: np.ndarray
    y: np.ndarray
    h: np.ndarray
    v: np.ndarray
    length: float
    width: float
    ahead: float

    def boxes(self):
        """Its outline at every step."""
        along = np.array([1, 1, -1, -1]) * self.length / 2 + self.ahead
        aside = np.array([1, -1, -1, 1]) * self.width / 2
        c, s = np.cos(self.h)[:, None], np.sin(self.h)[:, None]
        x = self.x[:, None] + along * c - aside * s
        y = self.y[:, None] + along * s + aside * c
        return shapely.polygons(np.stack((x, y), axis=2))

    def past(self, line):
        """How far its front is past a line (x, y, heading) at every step."""
        reach = self.ahead + self.length / 2
        dx = self.x + reach * np.cos(self.h) - line[0]
        dy = self.y + reach * np.sin(self.h) - line[1]
        return dx * cos(line[2]) + dy * sin(line[2])


def movers(text):
    """Everybody of esmini's log, by name."""
    rows = [[cell.strip() for cell in row] for row in csv.reader(text.splitlines())]
    at = next(n for n, row in enumerate(rows) if row and row[0].startswith("Index"))
    head, rows = rows[at], rows[at + 1 :]
    time = np.array([float(row[1]) for row in rows])
    found = {}
    for start in (n for n, name in enumerate(head) if "Entity_Name" in name and n < len(rows[0])):
        mark = head[start].split(" ")[0]

        def column(name, mark=mark):
            n = next(i for i, cell in enumerate(head) if cell.startswith(f"{mark} {name} "))
            return np.array([float(row[n]) for row in rows])

        found[rows[0][start]] = Mover(
            time,
            column("World_Position_X"),
            column("World_Position_Y"),
            column("World_Heading_Angle"),
            np.abs(column("Current_Speed")),
            column("bb_length")[0],
            column("bb_width")[0],
            column("bb_x")[0],
        )
    return found


def lines(road):
    """Where the sign or light of each arm stands: (x, y, heading of who enters), by arm."""
    found = {}
    for element in etree.fromstring(road).iter("road"):
        signal = element.find("signals/signal")
        if signal is None:
            continue
        s = float(signal.get("s"))
        piece = [g for g in element.iter("geometry") if float(g.get("s")) <= s][-1]
        x, y, h, begin = (float(piece.get(name)) for name in ("x", "y", "hdg", "s"))
        arc = piece.find("arc")
        bend = 0.0 if arc is None else float(arc.get("curvature"))
        for _ in range(200):
            step = (s - begin) / 200
            x, y = x + step * cos(h + bend * step / 2), y + step * sin(h + bend * step / 2)
            h += bend * step
        found[int(element.get("id")) - 1] = (x, y, h)
    return found


def red_times(scenario):
    """(cycle, [(from, to) of red within it]) of each arm, as the standard's controllers say."""
    found = {}
    for controller in etree.fromstring(scenario).iter("TrafficSignalController"):
        at = 0.0
        for phase in controller.iter("Phase"):
            ends = at + float(phase.get("duration"))
            for state in phase.iter("TrafficSignalState"):
                arm = int(state.get("trafficSignalId")) - 1
                spans = found.setdefault(arm, [])
                if state.get("state") == RED:
                    spans.append((at, ends))
            at = ends
        for state in controller[0]:
            arm = int(state.get("trafficSignalId")) - 1
            found[arm] = (at, found[arm])
    return found


def red_for_s(lights, arm, time_s):
    """For how long a light has been red at a time; None where it is not."""
    cycle, spans = lights[arm]
    for begins, ends in spans:
        now = time_s % cycle
        if begins <= now < ends:
            before = any(abs(e - cycle) < 1e-3 for _, e in spans) and begins == 0.0
            earlier = next((cycle - b for b, e in spans if abs(e - cycle) < 1e-3), 0.0)
            return now - begins + (earlier if before else 0.0)
    return None


def over_at(mover, line):
    """The step at which its front goes over a line; None if it never does."""
    over = mover.past(line) > 0.0
    return int(over.argmax()) if over.any() else None


def stops(mover, line):
    """(how long it stands at a line before it goes over it, when it begins to)."""
    past = mover.past(line)
    over = past > OVER_LINE_M
    end = int(over.argmax()) if over.any() else len(past)
    longest, since, first = 0.0, None, np.inf
    for n in range(end):
        if mover.v[n] < STANDS_MPS and past[n] > -BEFORE_LINE_M:
            since = n if since is None else since
            first = min(first, mover.t[n])
            longest = max(longest, mover.t[n] - mover.t[since])
        else:
            since = None
    return longest, first


def takes_way(one, two):
    """Whether one comes onto ground of both before two has left it, and too soon before it.

    Where their ways become one, the ground is a line across the lane where one comes onto it.
    """
    a, b = one.boxes(), two.boxes()
    shared = shapely.union_all(a).intersection(shapely.union_all(b)).buffer(0.0)
    for part in getattr(shared, "geoms", [shared]):
        if part.area < 0.5:
            continue
        merged = _merges(one, two, np.flatnonzero(shapely.intersects(a, part)))
        if merged is not None:
            if merged > 0 and _before(one, two, a, b, _across(one, merged)):
                return True
            continue
        if _before(one, two, a, b, part):
            return True
    return False


def _before(one, two, a, b, ground):
    """Whether one is on a ground before two has left it, and is not gone long before it comes."""
    mine, theirs = shapely.intersects(a, ground), shapely.intersects(b, ground)
    if not mine.any() or not theirs.any():
        return False
    comes, they_come = one.t[mine.argmax()], two.t[theirs.argmax()]
    goes, they_go = one.t[np.flatnonzero(mine)[-1]], two.t[np.flatnonzero(theirs)[-1]]
    return bool(comes < they_go - TOLERANCE_S and they_come - goes < CLEAR_S - TOLERANCE_S)


def _merges(one, two, steps):
    """The first of the steps from which on one goes along two's way; None if it never does."""
    x, y = _middle(two)
    mine = np.column_stack(_middle(one))
    since = None
    for n in steps:
        nearest = int(np.hypot(x - mine[n, 0], y - mine[n, 1]).argmin())
        aside = np.hypot(x[nearest] - mine[n, 0], y[nearest] - mine[n, 1])
        turn = (one.h[n] - two.h[nearest] + np.pi) % (2 * np.pi) - np.pi
        if aside > ALONG_M or abs(turn) > ALONG_RAD:
            since = None
            continue
        since = n if since is None else since
        if np.hypot(*(mine[n] - mine[since])) > MERGED_FOR_M:
            return int(since)
    return None


def _across(one, step):
    """A line across the lane where one's middle is at a step."""
    x, y = (value[step] for value in _middle(one))
    aside = ALONG_M * np.array([-sin(one.h[step]), cos(one.h[step])])
    return shapely.LineString([np.array([x, y]) - aside, np.array([x, y]) + aside])


def _middle(mover):
    return mover.x + mover.ahead * np.cos(mover.h), mover.y + mover.ahead * np.sin(mover.h)


def broken(rule, logical, files, log, by=()):
    """The rules that are broken: ("stop" | "red" | "way" | "stuck", who, before whom).

    ``by`` are those who are said to break theirs; what they do is told as what others do.
    """
    people, signs = movers(log), lines(files["road.xodr"])
    drives = {d.participant: d for d in logical.drives}
    lights = red_times(files["scenario.xosc"]) if rule == "signals" else {}
    found = set()
    for name, drive in drives.items():
        mover, line = people[name], signs.get(drive.entry)
        way = np.hypot(np.diff(mover.x), np.diff(mover.y)).sum()
        step = None if line is None else over_at(mover, line)
        if mover.v[-1] < STANDS_MPS or way < 20.0 or (line is not None and step is None):
            found.add(("stuck", name, None))
        if step is not None:
            least_s = 0.0 if name not in by else RED_FOR_S
            kinds = _at_line(rule, mover, drive, line, lights, least_s)
            found |= {(kind, name, None) for kind in kinds}
    out_of_turn = set(_out_of_turn(rule, logical, people, drives, signs))
    # Before one who comes at red nobody has to give way.
    at_red = {who for kind, who, _ in found if kind == "red"}
    return found | {("way", *pair) for pair in out_of_turn if pair[1] not in at_red}


def _at_line(rule, mover, drive, line, lights, least_s):
    """What somebody breaks at its line: a stop, or a light that has been red for so long."""
    if rule in {"stop", "all_way_stop"} and stops(mover, line)[0] < STANDS_S:
        yield "stop"
    if rule == "signals":
        red = red_for_s(lights, drive.entry, mover.t[over_at(mover, line)])
        if red is not None and red >= least_s:
            yield "red"


def _out_of_turn(rule, logical, people, drives, signs):
    """(who takes the way, whose)."""
    for conflict in logical.conflicts:
        if conflict.kind.value not in {"crossing", "merging"} or conflict.yields is None:
            continue
        if conflict.rule.value in {"ahead", "lane_change", "no_crosswalk"}:
            continue
        name = conflict.yields
        other = conflict.second if name == conflict.first else conflict.first
        if rule == "all_way_stop":
            first, second = (stops(people[n], signs[drives[n].entry])[1] for n in (name, other))
            if first < second - TOGETHER_S:
                name, other = other, name
        if takes_way(people[name], people[other]):
            yield name, other
