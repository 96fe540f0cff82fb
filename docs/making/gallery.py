"""The gallery: a picture for each road and each rule of the road, made as every scenario is made.

    python docs/making/gallery.py FOLDER    # the pictures alone, to look at

``gallery.yaml`` beside this file has a line for each. The pictures are made anew whenever the
documentation is built, so they are never older than the program.
"""

from __future__ import annotations

import re
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import yaml

from scegen.errors import ScegenError
from scegen.motion import build_paths
from scegen.pipeline.generate import generate
from scegen.pipeline.options import CheckDepth, Options
from scegen.pipeline.source import resolve_source
from scegen.report.preview import preview_svg
from scegen.report.raster import png_of
from scegen.road import build_network
from scegen.scenario.concrete import ConcreteScenario
from scegen.scenario.files import load

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
EXAMPLES = "examples/"


@dataclass(frozen=True)
class Entry:
    """What is to be shown: a description, or a file of one."""

    section: str
    title: str
    text: str

    @property
    def file(self) -> str:
        """Name of the picture."""
        return re.sub(r"\W+", "-", self.title.lower()).strip("-") + ".svg"


@dataclass(frozen=True)
class Picture:
    """What came of it; ``missed`` are statements that do not hold."""

    entry: Entry
    said: str
    svg: str
    statements: int
    missed: tuple[str, ...]


def entries() -> list[Entry]:
    """Every line of the table, in its order."""
    table = yaml.safe_load((HERE / "gallery.yaml").read_text(encoding="utf-8"))
    return [
        Entry(part, title, text) for part, rows in table.items() for title, text in rows.items()
    ]


def draw(entry: Entry) -> Picture:
    """Make the scenario, and its picture; where nothing can be made there is none, but a reason."""
    try:
        return _made(entry)
    except ScegenError as problem:
        return Picture(entry, entry.text, "", 0, (problem.render(),))


def _made(entry: Entry) -> Picture:
    from_file = entry.text.startswith(EXAMPLES)
    source = resolve_source(str(ROOT / entry.text) if from_file else entry.text)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name, "out")
        done = generate(source, folder, Options(depth=CheckDepth.NONE))
        (file,) = folder.glob("scenarios/*/concrete.yaml")
        concrete = load(file, ConcreteScenario)
    (proof,) = done.proofs.values()
    missed = [f"{claim.statement}: {claim.found}" for claim in proof.missed]
    said = done.functional.description if done.functional else ""
    return Picture(entry, said or entry.text, preview(concrete), len(proof.claims), tuple(missed))


def preview(concrete: ConcreteScenario) -> str:
    """The picture of a concrete scenario that lies in its folder, as SVG."""
    network = build_network(concrete.road, concrete.name)
    return preview_svg(concrete, network, build_paths(concrete, network))


def pictures() -> Iterator[Picture]:
    """All of them, made side by side, in their order."""
    with ProcessPoolExecutor() as pool:
        yield from pool.map(draw, entries())


def page(drawn: list[Picture]) -> str:
    """The page of the gallery; the pictures lie in ``gallery/`` beside it."""
    parts = [
        "# Gallery",
        "A picture for each road and each rule of the road, made from the sentence above it like "
        "any scenario: `scegen generate` draws the same one. Dashed boxes are where everybody is "
        "at the closest approach.",
    ]
    section = ""
    for picture in drawn:
        entry = picture.entry
        if entry.section != section:
            section = entry.section
            parts.append(f"## {section}")
        from_file = f" (`{entry.text}`)" if entry.text.startswith(EXAMPLES) else ""
        parts += [
            f"### {entry.title}",
            f"> {picture.said}{from_file}",
            f"![{entry.title}](gallery/{entry.file})",
            f"All {picture.statements} statements hold.",
        ]
    return "\n\n".join(parts) + "\n"


def main() -> None:
    """Write the pictures into a folder, as SVG and PNG, and tell what does not hold."""
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for picture in pictures():
        file = folder / picture.entry.file
        print(file, f"{picture.statements} statements", *picture.missed, sep="\n  ", flush=True)
        if picture.svg:
            file.write_text(picture.svg, encoding="utf-8")
            file.with_suffix(".png").write_bytes(png_of(picture.svg))


if __name__ == "__main__":
    main()
