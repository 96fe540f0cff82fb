"""A server of its own, and browsers that look at its page."""

import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

pytest.importorskip("nicegui", reason="the page needs the extra web")

WAIT_MS = 300_000
"""Nobody waits for less than it takes on a machine under load."""


class Server:
    """A running `scegen serve`."""

    def __init__(self, project, *options):
        command = [sys.executable, "-m", "scegen", "serve", str(project), "--port", "0", *options]
        self.project = project
        self._log = (project.parent / f"{project.name}.log").open("w+")
        self._process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=self._log, text=True
        )
        self.url = self._process.stdout.readline().strip()
        assert self.url.startswith("http://"), self.log

    @property
    def log(self):
        return Path(self._log.name).read_text()

    def stop(self):
        self._process.terminate()
        self._process.wait(30)
        self._process.stdout.close()
        self._log.close()


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    running = Server(tmp_path_factory.mktemp("served") / "project")
    yield running
    running.stop()


@pytest.fixture
def serve(tmp_path):
    """Starts servers with options of their own."""
    running = []

    def start(*options):
        running.append(Server(tmp_path / f"project-{len(running)}", *options))
        return running[-1]

    yield start
    for server in running:
        server.stop()


class Visitor:
    """Somebody at the page, in a browser session of their own."""

    def __init__(self, browser, url):
        self.context = browser.new_context(viewport={"width": 1440, "height": 900})
        self.context.set_default_timeout(WAIT_MS)
        self.faults, self.requested = [], []
        self.page = self.context.new_page()
        self.page.on("pageerror", lambda error: self.faults.append(str(error)))
        self.page.on("console", lambda m: m.type == "error" and self.faults.append(m.text))
        self.page.on("request", lambda r: self.requested.append(r.url))
        self.page.on("dialog", lambda d: (self.faults.append(d.message), d.dismiss()))
        self.page.goto(url)
        self.page.wait_for_selector("textarea")

    def say(self, text):
        self.page.fill("textarea", text)
        self.page.get_by_role("button", name="Understand").click()

    def understood(self, text):
        """Say something, and wait until its scenarios are counted."""
        self.say(text)
        self.page.wait_for_selector(".plan .tally")
        self.page.wait_for_function("() => !document.querySelector('.spinner')?.checkVisibility()")

    def count(self):
        return int(self.page.inner_text(".plan .tally .figure").replace(",", ""))

    def go(self, step):
        self.page.get_by_role("navigation").get_by_role("button", name=step).click()

    def search(self):
        """Make what is chosen, to the end."""
        self.go("Make dangerous")
        self.page.locator(".results .lead").get_by_role("button", name="Search").click()
        self.page.wait_for_selector(".card")

    def download(self, folder):
        """Take the zip away; the folder in it."""
        self.go("Take away")
        with self.page.expect_download() as waiting:
            self.page.get_by_role("link", name="Download").click()
        path = folder / waiting.value.suggested_filename
        waiting.value.save_as(path)
        with zipfile.ZipFile(path) as archive:
            archive.extractall(folder)
        return folder / path.stem


@pytest.fixture
def visit(browser):
    """Opens the page of a server; what goes wrong in it fails the test."""
    visitors = []

    def come(url):
        visitors.append(Visitor(browser, url))
        return visitors[-1]

    yield come
    for visitor in visitors:
        visitor.context.close()
    assert [fault for visitor in visitors for fault in visitor.faults] == []
