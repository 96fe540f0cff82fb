"""Pages that are made when the documentation is built, from where their words stand already.

The front page is the README, the glossary comes from the definitions in the code, the command line
from its own help, the gallery from a table of sentences: nothing is written twice, and no picture
is older than the program. The folders of ``docs/`` are the sections; a new page
is in the navigation by itself.
"""

from __future__ import annotations

import logging
import os
import re
import sys
from collections.abc import Callable
from pathlib import Path

import typer.main
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from typer.cli import get_docs_for_click

sys.path.insert(0, str(Path(__file__).parent))

import figures
import gallery

import measures
from scegen.cli.app import app
from scegen.scenario.glossary import page as glossary

ROOT = Path(__file__).parents[2]
SECTIONS = {"How to": "how-to", "Explanation": "explanation", "Reference": "reference"}
FROM_ROOT = {
    "index.md": "README.md",
    "contributing.md": "CONTRIBUTING.md",
    "reference/measuring.md": "benchmarks/README.md",
}


def command_line() -> str:
    """Every command with its options, as its help has them."""
    command = typer.main.get_command(app)
    return get_docs_for_click(obj=command, ctx=typer.Context(command), title="Command line")


GALLERY = "reference/gallery.md"
log = logging.getLogger("mkdocs.hooks.scegen")
MADE: dict[str, Callable[[], str]] = {
    "reference/cli.md": command_line,
    "reference/glossary.md": glossary,
}
"""Pages that no file holds, and what writes them."""
LINK = re.compile(r"\]\(([^)#:]+)((?:#[^)]*)?)\)")


def from_root(page: str, source: str) -> str:
    """The page of a file beside ``docs/``; its links lead where they led."""
    places = {name: made for made, name in FROM_ROOT.items()}
    text = (ROOT / source).read_text(encoding="utf-8")

    def led(link: re.Match[str]) -> str:
        target = os.path.normpath(Path(source).parent / link[1])
        target = places.get(target, target.removeprefix("docs/"))
        return f"]({os.path.relpath(target, Path(page).parent)}{link[2]})"

    return LINK.sub(led, text)


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """List every page, section by section."""
    docs = Path(config.docs_dir)

    def pages(folder: str) -> list[str]:
        found = {f"{folder}/{path.name}" for path in (docs / folder).glob("*.md")}
        made = {name for name in (*MADE, *FROM_ROOT, GALLERY) if name.startswith(f"{folder}/")}
        return sorted(found | made)

    config.nav = [{"Home": "index.md"}, *sorted(path.name for path in docs.glob("*.md"))]
    config.nav += [{title: pages(folder)} for title, folder in SECTIONS.items()]
    config.nav += ["contributing.md"]
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the pages that are made."""
    made: dict[str, str] = {name: make() for name, make in MADE.items()}
    made |= {name: from_root(name, source) for name, source in FROM_ROOT.items()}
    drawn = list(gallery.pictures())
    for picture in drawn:
        for reason in picture.missed:  # with --strict the build ends here
            log.warning("gallery, %s: %s", picture.entry.title, reason)
        made[f"reference/gallery/{picture.entry.file}"] = picture.svg
    made[GALLERY] = gallery.page(drawn)
    made |= {f"pictures/{name}.svg": draw() for name, draw in figures.FIGURES.items()}
    for name, text in made.items():
        files.append(File.generated(config, name, content=text))
    return files


def on_page_markdown(markdown: str, **_: object) -> str:
    """Leave out remarks that are for the tests, and links to files that are no page."""
    remark = r"(?m)^<!-- (?:new|in|needs|not run|ends with)\b.*?-->\n"
    markdown = re.sub(remark, "", markdown, flags=re.DOTALL)
    for page, source in FROM_ROOT.items():
        markdown = markdown.replace(f"](../../{source}", f"](../{page}")
    if measures.HERE in markdown:
        markdown = markdown.replace(measures.HERE, measures.sections())
    return re.sub(r"\[([^]]+)\]\(\.\./\.\./[^)]+\)", r"\1", markdown)
