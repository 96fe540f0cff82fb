"""How smoothly the player plays ten cars in headless Chromium, all layers on; goal: 50 pictures/s.

Counts the frames that the browser asks for while it plays, beside those of a page at rest: what is
missing at rest already is the machine's load, not the player's.
"""

from __future__ import annotations

import json
import shutil
import sys
import tempfile
from pathlib import Path

from playwright.sync_api import sync_playwright

from scegen.concretization import concretize
from scegen.enumeration import enumerate_scenarios
from scegen.report.contents import ConcreteEntry, ReportInput
from scegen.report.html import report_html
from scegen.report.player.scene import scene_of
from scegen.understanding import read

GOAL = 50.0
TEXT = "Ten cars drive at 30 km/h towards a junction of four roads."
FRAMES = """async ([plays, compares]) => {
  const player = players[0];
  if (compares !== player.comparing) player.compare();
  Object.keys(player.shared.show).forEach((layer) => { player.shared.show[layer] = true });
  player.seek(1);
  if (plays) player.play();
  const times = await new Promise((done) => {
    const seen = [];
    const look = (now) => { seen.push(now); seen.length < 240 ? requestAnimationFrame(look) : done(seen) };
    requestAnimationFrame(look);
  });
  player.pause();
  return 1000 * (times.length - 1) / (times.at(-1) - times[0]);
}"""  # noqa: E501


def main() -> int:
    """Print pictures per second: at rest, playing, playing two side by side."""
    functional = read(TEXT)
    logical = enumerate_scenarios(functional, limit=1).scenarios[0]
    concrete = concretize(functional, logical, seed=0)
    played = scene_of(concrete)
    entry = ConcreteEntry(concrete, "scenarios/ten", played, played)
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        path = Path(folder, "report.html")
        path.write_text(report_html(ReportInput(functional, None, (entry,))), encoding="utf-8")
        browser = playwright.chromium.launch(
            executable_path=shutil.which("chromium"), args=["--no-sandbox", "--disable-gpu"]
        )
        page = browser.new_page(viewport={"width": 1400, "height": 1000})
        page.goto(path.as_uri())
        kinds = {"at rest": (False, False), "playing": (True, False), "side by side": (True, True)}
        found = {
            name: max(page.evaluate(FRAMES, list(how)) for _ in range(3))
            for name, how in kinds.items()
        }
        browser.close()
    found = {name: round(value, 1) for name, value in found.items()}
    if "--json" in sys.argv:
        print(json.dumps({"cars": len(concrete.participants), "pictures_per_s": found}))
    else:
        for name, value in found.items():
            print(f"{len(concrete.participants)} cars, {name}: {value} pictures/s")
    return int(found["playing"] < GOAL)


if __name__ == "__main__":
    sys.exit(main())
