"""Descriptions per second and core of the offline reader, and a fuzz run.

    python benchmarks/reader.py [--json] [--fuzz N] [--seed N]

The speed is that of the best of many rounds over the source paper's sentences, after a first one:
a shared host takes away and never adds. A round is a few hundredths of a second of processor time;
with --fuzz so many random texts are read as well: words of the lexicon in any order, letters of
every script, marks and control characters, and now and then a text as long as the reader takes,
or a megabyte. Every text must give a scenario or a clear error, and soon. Exit code 1 if the goal
is missed, or a text breaks the reader or holds it up.
"""

from __future__ import annotations

import argparse
import json
import random
import sys
import traceback
from collections import Counter
from time import process_time

from scegen.errors import ScegenError
from scegen.understanding import MAX_CHARACTERS, paper_cases, read
from scegen.understanding.lexicon import load

GOAL_PER_S = 300
SECONDS = 3.0
LONG = 1_000_000
STALL_S = 10.0
"""Many times what the longest text takes."""
STRANGE = "\x00\x07\t\n\r\u200b\u202e\ud800é日🚗 carturns left.-'’"


def speed() -> dict[str, float]:
    """Descriptions and characters per second of processor time, of the best of many rounds."""
    texts = [case.text for case in paper_cases()]
    for text in texts:
        read(text)
    best = SECONDS
    begin = process_time()
    while process_time() - begin < SECONDS:
        start = process_time()
        for text in texts:
            read(text)
        best = min(best, process_time() - start)
    return {"per_s": len(texts) / best, "characters_per_s": sum(map(len, texts)) / best}


def random_text(rng: random.Random, words: list[str]) -> str:
    """A text of one of five kinds."""
    kind = rng.random()
    length = int(rng.expovariate(1 / 25)) + 1
    if kind < 0.7:
        mark = [*words, ".", ",", ";", ":", "(", ")", "'s", "n't"]
        return " ".join(rng.choices(mark, k=length))
    if kind < 0.8:
        return "".join(chr(rng.randrange(0x20, 0x250)) for _ in range(4 * length))
    if kind < 0.9:
        return "car " + "".join(chr(rng.randrange(sys.maxunicode + 1)) for _ in range(4 * length))
    if kind < 0.999:
        return "".join(rng.choices(STRANGE, k=4 * length))
    if rng.random() < 0.5:
        return " ".join(rng.choices(words, k=LONG // 5))
    return " ".join(rng.choices(words, k=LONG // 5))[:MAX_CHARACTERS]


def fuzz(count: int, seed: int) -> dict[str, object]:
    """Outcomes of random texts, the slowest one, and the texts that broke or held up the reader."""
    rng = random.Random(seed)  # noqa: S311 - test texts, not secrets
    words = [*sorted(load().words), "A", "B", "V1", "70", "km/h", "2"]
    outcomes: Counter[str] = Counter()
    broken: list[str] = []
    slowest = 0.0
    longest = 0
    for _ in range(count):
        text = random_text(rng, words)
        longest = max(longest, len(text))
        begin = process_time()
        try:
            read(text)
            outcomes["scenario"] += 1
        except ScegenError as error:
            outcomes[type(error).__name__] += 1
        except Exception:  # noqa: BLE001 - the point is to find any
            outcomes["BROKEN"] += 1
            broken.append(f"{text[:500]!r}\n{traceback.format_exc()}")
        spent = process_time() - begin
        slowest = max(slowest, spent)
        if spent > STALL_S:
            outcomes["STALLED"] += 1
            broken.append(f"{text[:500]!r}\n{len(text)} characters took {spent:.1f} s")
    return {
        "texts": count,
        "outcomes": dict(outcomes),
        "longest_characters": longest,
        "slowest_s": slowest,
        "broken": broken,
    }


def main() -> int:
    """Print the figures; exit code 1 if the goal is missed or something breaks."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--fuzz", type=int, default=0, metavar="N")
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    report: dict[str, object] = {"speed": speed(), "goal_per_s": GOAL_PER_S}
    if args.fuzz:
        report["fuzz"] = fuzz(args.fuzz, args.seed)
    if args.json:
        print(json.dumps(report, indent=2))
    else:
        for name, value in report.items():
            print(f"{name}: {value}")
    bad = args.fuzz and report["fuzz"]["broken"]
    return int(report["speed"]["per_s"] < GOAL_PER_S or bool(bad))


if __name__ == "__main__":
    sys.exit(main())
