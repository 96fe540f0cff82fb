"""Campaigns that are made once and looked at often."""

import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from campaigns import TEXTS, campaign, make
from command import PROGRAM, SOURCE

from scegen.campaign.store import Store


@pytest.fixture(scope="session")
def first(tmp_path_factory):
    """A small campaign with a description that is none; nobody changes it."""
    folder = tmp_path_factory.mktemp("campaigns") / "first"
    return folder, make(campaign(), folder)


@pytest.fixture
def copied(first, tmp_path):
    """A campaign of one's own, to be broken."""
    folder = tmp_path / "campaign"
    shutil.copytree(first[0], folder)
    return Store(folder)


@pytest.fixture
def started(tmp_path):
    """Start the command line, in a group of its own that nobody else's signals reach."""
    running = []

    def start(*arguments):
        process = subprocess.Popen(
            [sys.executable, "-c", PROGRAM, "campaign", *map(str, arguments)],
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": SOURCE},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
            # Whoever starts the tests in the background has Ctrl-C ignored by all below.
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),  # noqa: PLW1509
        )
        running.append(process)
        return process

    yield start
    for process in running:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()


@pytest.fixture
def order_file(tmp_path):
    """RUN.yaml with some dozens of scenarios."""
    told = {
        "level": "campaign",
        "descriptions": [{"id": name, "text": text} for name, text in TEXTS.items()],
        "pick": "all",
        "concretizations": 6,
    }
    place = Path(tmp_path, "run.json")
    place.write_text(json.dumps(told), encoding="utf-8")
    return place
