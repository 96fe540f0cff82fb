"""The command line that makes the same files again."""

import shlex

from typer.testing import CliRunner

from scegen.cli.app import app
from scegen.pipeline.command import command_line, options_told
from scegen.pipeline.options import CheckDepth, EgoMode, Options, OscVersion
from scegen.scenario.rule_file import RuleFile
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
    rules=RuleFile(":- deadlock.", "mine.lp"),
)


def test_defaults_are_left_out():
    told = {"source": "f.yaml", "options": options_told(Options(force=True))}
    assert command_line(told, "out") == "scegen generate f.yaml -o out"


def test_a_folder_that_does_not_tell_has_no_command():
    assert command_line({}, "out") is None


def test_every_option_is_one_of_the_command(tmp_path):
    told = {"source": "no such.yaml", "options": options_told(EVERY)}
    words = shlex.split(command_line(told, str(tmp_path / "out")))
    assert words[:3] == ["scegen", "generate", "no such.yaml"]
    assert words[words.index("--where") + 1] == "ego.turn == left"
    assert words[words.index("--rules") + 1] == "rules.lp"
    outcome = CliRunner().invoke(app, words[1:])
    assert "No such option" not in outcome.output
    assert "Invalid value" not in outcome.output
