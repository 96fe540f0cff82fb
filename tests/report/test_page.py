"""The report in a browser: the moving picture, phrases that lead to moments, pages of tiles."""

import re

import pytest
from axe_playwright_python.sync_playwright import Axe
from browsing import until
from scenes import CLAIMS, EVIL, PROOF, concrete, scene
from whole import FUNCTIONAL, LOGICAL

from scegen.report.contents import ConcreteEntry, ReportInput
from scegen.report.html import report_html
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import LogicalSet

pytestmark = pytest.mark.browser
TEXT = f"A car comes slowly and does not yield. {EVIL}"


def functional():
    def basis(field, words):
        start = TEXT.index(words)
        end = start + len(words)
        return {"field": field, "source": "stated", "text": words, "start": start, "end": end}

    evidence = [
        basis("participants.car_1.speed_mps", "slowly"),
        basis("participants.ego.speed_mps", "does not"),
        basis("hazards.failure_to_yield", "yield"),
    ]
    return FunctionalScenario.model_validate(
        FUNCTIONAL | {"description": TEXT, "evidence": evidence, "unsupported": []}
    )


def entry(name="000-ego-straight"):
    scenario = concrete(name=name, description=TEXT)
    before = concrete(duration_s=15.0)
    played, earlier = scene(scenario)[0], scene(before, proof=None)[0]
    return ConcreteEntry(scenario, f"scenarios/{name}", played, earlier, proof=PROOF)


def document(scenarios=45, entries=("000-ego-straight",)):
    one = LOGICAL["scenarios"][0]
    many = [one | {"index": n, "slug": f"s-{n}", "pattern": [2, n % 2]} for n in range(scenarios)]
    listed = LogicalSet.model_validate(
        LOGICAL | {"functional": functional().model_dump(mode="json"), "scenarios": many}
    )
    made = tuple(entry(name) for name in entries)
    return report_html(ReportInput(functional(), listed, made, ((EVIL, EVIL),)))


@pytest.fixture(scope="module")
def text():
    return document()


def test_a_phrase_shows_what_it_became_and_plays_that_moment(open_page, text):
    page = open_page(text)
    slowly = page.get_by_role("button", name=re.compile("^slowly"))
    assert re.search(r"\bheld\b", slowly.get_attribute("class"))
    assert re.search(
        r"\bfailed\b", page.locator("mark", has_text="does not").get_attribute("class")
    )
    slowly.click()
    until(page, "players[0].clock.playing && players[0].time > 0")
    assert page.evaluate("players[0].time") < 1.25
    until(page, "!players[0].clock.playing")
    assert page.evaluate("players[0].time") == pytest.approx(2.25, abs=0.3)
    assert CLAIMS[0].statement in page.locator(".became").inner_text()
    assert "now" in slowly.get_attribute("class")
    assert page.locator(".claims .meant").inner_text().startswith("✓")


def test_who_wants_no_motion_sees_the_moment(open_page, text):
    page = open_page(text, reduced_motion="reduce")
    page.get_by_role("button", name=re.compile("^slowly")).press("Enter")
    assert page.evaluate("players[0].time") == pytest.approx(1.25)
    assert not page.evaluate("players[0].clock.playing")


def test_words_are_words_and_no_other_script_runs(open_page, text):
    page = open_page(text)
    assert page.title() == "Scenario report"
    assert EVIL in page.locator(".text").inner_text()
    assert page.locator("img").count() == 0
    ran = page.evaluate(
        "() => { const s = document.createElement('script'); s.textContent = 'window.evil = 1';"
        " document.body.append(s); return window.evil ?? null }"
    )
    assert ran is None
    (refused,) = open_page.faults
    assert "Content Security Policy" in refused
    open_page.faults.clear()


def test_the_gallery_is_folded_and_paged(open_page, text):
    page = open_page(text)
    assert page.locator(".tiles[data-paged] li:visible").count() == 0
    made = page.locator("#logical .made li:visible")
    assert made.count() == 1
    for fold in page.locator("#logical details > summary").all():
        fold.click()
    shown = page.locator(".tiles[data-paged] li:visible")
    assert shown.count() == 40
    assert page.get_by_text("1 to 20 of 23").is_visible()
    page.get_by_role("button", name="Next").first.click()
    assert page.get_by_text("21 to 23 of 23").is_visible()
    assert shown.count() == 23
    assert open_page(document(scenarios=3, entries=())).locator(".scenario").count() == 0


def test_further_scenarios_open_when_asked_for(open_page):
    page = open_page(document(3, ("000-ego-straight", "001-other")))
    assert page.evaluate("players.length") == 1
    page.locator("details.panel > summary", has_text="001-other").click()
    until(page, "players.length === 2")
    page.evaluate("players[0].play()")
    page.evaluate("players[1].play()")
    assert not page.evaluate("players[0].clock.playing")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_everybody_can_use_it(open_page, text, scheme):
    page = open_page(text, color_scheme=scheme)
    page.evaluate("document.querySelectorAll('details').forEach((one) => { one.open = true })")
    found = Axe().run(page).response["violations"]
    serious = [v for v in found if v["impact"] in {"serious", "critical"}]
    assert serious == [], [(v["id"], v["nodes"][0]["html"]) for v in serious]


def test_it_is_small_and_of_a_sensible_height(open_page, text):
    assert len(text.encode()) < 1_500_000
    page = open_page(text)
    assert page.evaluate("document.documentElement.scrollHeight") < 3000
    assert page.evaluate("document.documentElement.scrollWidth") <= 1280
    assert text == document()
