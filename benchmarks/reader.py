"""Descriptions per second and core of the offline reader, and a fuzz run.

    python benchmarks/reader.py [--json] [--fuzz N] [--seed N]

The speed is measured on the source paper's sentences, read over and over after a first round;
with --fuzz so many random texts are read as well: words of the lexicon in any order, random
letters, marks and control characters, and now and then a very long text. Every text must give a
scenario or a clear error. Exit code 1 if the goal is missed or a text breaks the reader.
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
from scegen.understanding import paper_cases, read
from scegen.understanding.lexicon import load

GOAL_PER_S = 200
SECONDS = 3.0
LONG = 1_000_000


def speed() -> dict[str, float]:
    """Descriptions and characters per second of processor time."""
    texts = [case.text for case in paper_cases()]
    for text in texts:
        read(text)
    done = characters = 0
    begin = process_time()
    while process_time() - begin < SECONDS:
        for text in texts:
            read(text)
            done += 1
            characters += len(text)
    spent = process_time() - begin
    return {"per_s": done / spent, "characters_per_s": characters / spent}


def random_text(rng: random.Random, words: list[str]) -> str:
    """A text of one of four kinds."""
    kind = rng.random()
    length = int(rng.expovariate(1 / 25)) + 1
    if kind < 0.7:
        mark = [*words, ".", ",", ";", ":", "(", ")", "'s", "n't"]
        return " ".join(rng.choices(mark, k=length))
    if kind < 0.9:
        return "".join(chr(rng.randrange(0x20, 0x250)) for _ in range(4 * length))
    if kind < 0.999:
        alphabet = "\x00\x07\t\n\r\u200b\u202e\ud800é日🚗 carturns left.-'’"
        return "".join(rng.choices(alphabet, k=4 * length))
    return " ".join(rng.choices(words, k=rng.choice((2_500, LONG // 6))))


def fuzz(count: int, seed: int) -> dict[str, object]:
    """Outcomes of random texts, the slowest one, and the texts that broke the reader."""
    rng = random.Random(seed)  # noqa: S311 - test texts, not secrets
    words = [*sorted(load().words), "A", "B", "V1", "70", "km/h", "2"]
    outcomes: Counter[str] = Counter()
    broken: list[str] = []
    slowest = 0.0
    for _ in range(count):
        text = random_text(rng, words)
        begin = process_time()
        try:
            read(text)
            outcomes["scenario"] += 1
        except ScegenError as error:
            outcomes[type(error).__name__] += 1
        except Exception:  # noqa: BLE001 - the point is to find any
            outcomes["BROKEN"] += 1
            broken.append(f"{text[:500]!r}\n{traceback.format_exc()}")
        slowest = max(slowest, process_time() - begin)
    return {"texts": count, "outcomes": dict(outcomes), "slowest_s": slowest, "broken": broken}


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
