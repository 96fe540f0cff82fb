"""How fast the page answers: the first page, and every click with many logical scenarios.

    python benchmarks/page.py [--text "Four cars meet …"]

A time is from the click to what it was for being seen, in headless Chromium; best and worst of
so many tries. Long work (listing, covering, searching) is not part of it.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter

from playwright.sync_api import Page, sync_playwright

TRIES = 5
TEXT = "Four cars meet at an uncontrolled four-way intersection."
SEEN = """([selector, test]) => {
  const found = [...document.querySelectorAll(selector)];
  return new Function("found", "return " + test)(found);
}"""


def timed(page: Page, what: str, click, selector: str, test: str = "found.length > 0") -> None:
    """The time from a click until ``test`` holds of what the selector finds."""
    took = []
    for turn in range(TRIES):
        filled = test.replace("TURN", str(turn))
        begin = perf_counter()
        click(turn)
        page.wait_for_function(SEEN, arg=[selector, filled], polling="raf")
        took.append(1000 * (perf_counter() - begin))
        page.wait_for_timeout(300)
    print(f"{what:<42} {min(took):7.0f} {sorted(took)[TRIES // 2]:7.0f} {max(took):7.0f}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--text", default=TEXT)
    text = parser.parse_args().text
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        command = [sys.executable, "-m", "scegen", "serve", str(Path(folder, "p")), "--port", "0"]
        server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        try:
            measure(playwright, server.stdout.readline().strip(), text)
        finally:
            server.terminate()
            server.wait()


def measure(playwright, url: str, text: str) -> None:
    """All figures of one visit."""
    browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=["--no-sandbox"])
    print(f"{'':<42} {'best':>7} {'median':>7} {'worst':>7}  ms")
    page = browser.new_page(viewport={"width": 1440, "height": 900})

    def open_page(_: int) -> None:
        page.goto(url)

    timed(page, "first page", open_page, "textarea")
    page.fill("textarea", text)
    page.click("text=Understand")
    page.wait_for_selector(".plan .tally")
    page.wait_for_timeout(1000)
    page.wait_for_function(
        "() => !document.querySelector('.spinner')?.checkVisibility()", timeout=120_000
    )
    steps = page.get_by_role("navigation")
    steps.get_by_role("button", name="Choose").click()
    page.wait_for_selector(".tile svg")
    title = page.inner_text(".tiles h1")
    print(f"— {title}")

    def go(turn: int) -> None:
        steps.get_by_role("button", name="Describe" if turn % 2 == 0 else "Choose").click()

    timed(
        page,
        "another step",
        go,
        ".describe, .choose",
        "found[0].classList.contains(TURN % 2 ? 'choose' : 'describe')",
    )
    steps.get_by_role("button", name="Choose").click()
    page.wait_for_selector(".tile svg")
    timed(
        page,
        "choose a tile",
        lambda _: page.locator(".tile:not(.picked)").nth(1).click(),
        ".tiles .lead .button",
        "found.some((b) => b.textContent === `Chosen (${TURN + 2})`)",  # one was suggested
    )
    chips = page.locator(".facet").first.get_by_role("button")
    timed(
        page,
        "filter",
        lambda _: chips.first.click(),
        ".tiles h1",
        "found[0].textContent.includes('shown') === (TURN % 2 === 0)",
    )
    chips.first.click()
    page.wait_for_timeout(500)
    timed(
        page,
        "choose all shown",
        lambda turn: page.get_by_role(
            "button", name="All shown" if turn % 2 == 0 else "None", exact=True
        ).click(),
        ".lead .primary",
        "found[0].disabled === (TURN % 2 === 1)",
    )
    timed(
        page,
        "scroll to other tiles",
        lambda turn: page.evaluate(
            "(y) => document.querySelector('.gallery').scrollTo(0, y)", 3000 * (turn + 1)
        ),
        ".tile",
        "found.length && found.every((t) => t.querySelector('svg'))",
    )
    browser.close()


if __name__ == "__main__":
    main()
