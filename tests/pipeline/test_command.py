"""The command line that makes the same files again."""

import shlex

from typer.testing import CliRunner

from scegen.cli.app import app
from scegen.pipeline.command import command_line
from scegen.pipeline.options import CheckDepth, EgoMode, Options, OscVersion
from scegen.scenario.vocabulary import ArmsMode, Reduction

EVERY = Options(
    pick="0,3",
    count=2,
    seed=7,
    reduction=Reduction.NONE,
    arms=ArmsMode.EQUAL,
    osc=OscVersion.V1_2,
    depth=CheckDepth.NONE,
    ego=EgoMode.EXTERNAL,
    target="pet=0.3..1",
    solutions=3,
    where="ego.turn == left",
)


def test_defaults_are_left_out():
    assert command_line(Options(force=True), "f.yaml", "out") == "scegen generate f.yaml -o out"


def test_every_option_is_one_of_the_command(tmp_path):
    words = shlex.split(command_line(EVERY, "no such.yaml", str(tmp_path / "out")))
    assert words[:3] == ["scegen", "generate", "no such.yaml"]
    assert words[words.index("--where") + 1] == "ego.turn == left"
    outcome = CliRunner().invoke(app, words[1:])
    assert "No such option" not in outcome.output
    assert "Invalid value" not in outcome.output
