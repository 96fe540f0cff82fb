"""Debian's Chromium for tests that look at pages."""

from __future__ import annotations

import shutil
from contextlib import contextmanager
from time import monotonic

HINT = "no chromium on PATH; install it: apt-get install chromium"


def chromium() -> str | None:
    """Where the browser is."""
    names = ("chromium", "chromium-browser", "google-chrome")
    return next((found for name in names if (found := shutil.which(name))), None)


@contextmanager
def a_browser():
    """A headless browser; it draws in three dimensions without a graphics card."""
    from playwright.sync_api import sync_playwright  # noqa: PLC0415

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium(),
            args=["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"],
        )
        yield browser
        browser.close()


def until(page, expression, seconds=10.0):
    """Wait until an expression holds, also where the page forbids evaluating strings by itself."""
    end = monotonic() + seconds
    while not page.evaluate(expression):
        assert monotonic() < end, f"not within {seconds} s: {expression}"
        page.wait_for_timeout(20)
