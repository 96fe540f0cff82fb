"""Running the command line as a user does."""

import os

import pytest
from command import as_process, in_process


@pytest.fixture
def scegen(tmp_path, capfd):
    """Run scegen with these arguments in an empty folder."""

    def run(*arguments, path=None, process=False, stdin=b"", **environment):
        environment = os.environ | ({"PATH": path} if path is not None else {}) | environment
        if process:
            return as_process(arguments, tmp_path, environment, stdin=stdin)
        return in_process(arguments, tmp_path, environment, capfd, stdin)

    return run
