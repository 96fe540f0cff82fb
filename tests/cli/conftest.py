"""Running the command line as a process, as a user does."""

import os
import subprocess
import sys

import pytest


@pytest.fixture
def scegen(tmp_path):
    """Run scegen with these arguments in an empty folder."""

    def run(*arguments, path=None):
        environment = os.environ | ({"PATH": path} if path is not None else {})
        return subprocess.run(
            [sys.executable, "-c", "from scegen.cli import main; main()", *map(str, arguments)],
            capture_output=True,
            text=True,
            cwd=tmp_path,
            env=environment,
            timeout=300,
            check=False,
        )

    return run
