"""A campaign at size, from its plan to an open report; and what a second worker brings.

    python benchmarks/campaign_at_size.py FILE.jsonl … [--count 20] [--each 17] [-o DIR]
    python benchmarks/campaign_at_size.py FILE.jsonl … --compare [--count 4] [--each 2]

The first makes all of it with ``--workers`` and goes on where DIR holds a part of it: throughput,
resident memory of driver and workers together by tenths of the way (from /proc), verification,
suite and report with their times, and how long the report takes in headless Chromium until it is
drawn. ``--compare`` makes the same twice, with one worker and with two, and holds the rows of one
against the other's: scenarios per second of the wall clock, which tells something on a quiet
machine only. Beside it stands what a second process brings that shares nothing: more no engine
gets out of the machine. Ends with 1 if something is missing or the second worker brings less than
it should.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
from dataclasses import asdict, dataclass, field
from multiprocessing import get_context
from pathlib import Path
from time import perf_counter

from playwright.sync_api import sync_playwright

from scegen.campaign.choosing import select
from scegen.campaign.claiming import Finished
from scegen.campaign.engines import Engine, Workforce
from scegen.campaign.order import Campaign, load_campaign
from scegen.campaign.report.write import write_report
from scegen.campaign.running import run_campaign
from scegen.campaign.store import Store
from scegen.campaign.verifying import verify

GOAL_TIMES = 1.8
SUITE = 100_000
"""More than any suite needs."""
_MIB = 2**20
_LOOPS = 20_000_000


@dataclass
class Memory:
    """Resident memory of this process and all below it, by tenths of the way, MiB."""

    peaks_mib: dict[int, float] = field(default_factory=dict)

    def planning(self, done: int, total: int) -> None:
        """Nothing is measured yet."""

    def making(self, done: int, failed: int, total: int) -> None:
        """Keep the most of this tenth; what failed is in the rows."""
        del failed
        tenth = 10 * done // max(total, 1)
        self.peaks_mib[tenth] = max(self.peaks_mib.get(tenth, 0.0), resident_mib(os.getpid()))

    def note(self, text: str) -> None:
        """Say it."""
        print(text, file=sys.stderr)


def resident_mib(pid: int) -> float:
    """What a process and those that it started hold; 0 for one that has ended meanwhile."""
    try:
        pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
        tasks = [path.read_text() for path in Path(f"/proc/{pid}/task").glob("*/children")]
    except OSError:
        return 0.0
    below = sum(resident_mib(int(child)) for task in tasks for child in task.split())
    return pages * os.sysconf("SC_PAGE_SIZE") / _MIB + below


def made(campaign: Campaign, folder: Path, workers: int, watch: Memory) -> Finished:
    return run_campaign(campaign, folder, Workforce(Engine.JOBLIB, workers), watch)


def opening_s(page_file: Path) -> float:
    """Until the page is loaded and its first picture is on the screen; best of three."""
    took = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path="/usr/bin/chromium", args=["--no-sandbox"]
        )
        for _ in range(3):
            page = browser.new_page(viewport={"width": 1440, "height": 900})
            begin = perf_counter()
            page.goto(page_file.resolve().as_uri(), wait_until="load")
            page.evaluate("() => new Promise(done => requestAnimationFrame(() => done()))")
            took.append(perf_counter() - begin)
            page.close()
        browser.close()
    return min(took)


def at_size(campaign: Campaign, folder: Path, workers: int) -> dict[str, object]:
    watch = Memory()
    finished = made(campaign, folder, workers, watch)
    begin = perf_counter()
    found, problems = verify(folder)
    verified_s = perf_counter() - begin
    store = Store(folder)
    begin = perf_counter()
    suite = select(store, SUITE).to_data()
    needed = suite["needed_to_cover"]
    selected_s = perf_counter() - begin
    begin = perf_counter()
    page = write_report(store, folder / "report", 10, lambda _: None)
    written_s = perf_counter() - begin
    size = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
    return {
        **asdict(finished),
        "workers": workers,
        "per_s": finished.fresh / finished.seconds,
        "memory_mib": {f"{10 * tenth} %": m for tenth, m in sorted(watch.peaks_mib.items())},
        "folder_mib": size / _MIB,
        "whole": not found.bad and not problems,
        "verified_s": verified_s,
        "suite": {
            "scenarios": needed,
            "proved_fewest": suite["proved_fewest"],
            "covered": suite["covered"],
            "coverable": suite["coverable"],
            "cannot_be_covered": suite["cannot_be_covered"],
        },
        "selected_s": selected_s,
        "report_written_s": written_s,
        "report_mib": page.stat().st_size / _MIB,
        "report_opens_s": opening_s(page),
    }


def spin(_: int) -> float:
    """The wall clock of a loop that touches nothing but itself, s."""
    begin = perf_counter()
    sum(n * n % 7 for n in range(_LOOPS))
    return perf_counter() - begin


def plain_times() -> float:
    """How much more two processes do than one that have nothing in common; each at its best."""
    with get_context("spawn").Pool(2) as pool:
        pool.map(spin, range(2), chunksize=1)
        one_s = min(pool.apply(spin, (0,)) for _ in range(5))
        two_s = min(max(pool.map(spin, range(2), chunksize=1)) for _ in range(5))
    return 2 * one_s / two_s


def compared(campaign: Campaign) -> dict[str, object]:
    with tempfile.TemporaryDirectory() as place:
        # Whoever comes first would compile kernels for the other.
        one_only = campaign.model_copy(update={"descriptions": campaign.descriptions[:1]})
        made(one_only, Path(place, "0"), 1, Memory())
        one, two = (made(campaign, Path(place, str(n)), n, Memory()) for n in (1, 2))
    return {
        "rows": one.counted.rows,
        "same": one.digest == two.digest,
        "one_per_s": one.counted.rows / one.seconds,
        "two_per_s": two.counted.rows / two.seconds,
        "times": one.seconds / two.seconds,
        "goal_times": GOAL_TIMES,
        "plain_times": plain_times(),
        "load": os.getloadavg()[0],
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("files", type=Path, nargs="+")
    parser.add_argument("-o", "--output", type=Path)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--each", type=int, default=17)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--compare", action="store_true")
    parser.add_argument("--json", action="store_true", help="what is printed in any case")
    asked = parser.parse_args()
    changes = {"count": asked.count, "concretizations": asked.each}
    orders = [load_campaign(path, changes) for path in asked.files]
    every = tuple(described for order in orders for described in order.descriptions)
    campaign = orders[0].model_copy(update={"descriptions": every})
    if asked.compare:
        found = compared(campaign)
        good = bool(found["same"]) and float(str(found["times"])) >= GOAL_TIMES
    elif asked.output is not None:
        found = at_size(campaign, asked.output, asked.workers)
        good = bool(found["whole"])
    else:
        with tempfile.TemporaryDirectory() as place:
            found = at_size(campaign, Path(place, "campaign"), asked.workers)
            good = bool(found["whole"])
    print(json.dumps(found, indent=2))
    return int(not good)


if __name__ == "__main__":
    sys.exit(main())
