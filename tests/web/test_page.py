"""The page from a sentence to files, and back from files."""

import shlex
import subprocess
import sys

import pytest
import yaml
from axe_playwright_python.sync_playwright import Axe

pytestmark = pytest.mark.browser
CROSSING = (
    "The ego goes straight at a four-way intersection at 50 km/h; a van comes from the right."
)
RING = "A van enters the roundabout ahead of the ego and a car that circulates cuts it off."
MANY = "Four cars meet at an uncontrolled four-way intersection."


def scegen(*arguments, **options):
    command = [sys.executable, "-m", "scegen", *map(str, arguments)]
    return subprocess.run(command, check=False, capture_output=True, text=True, **options)


def made_again(visitor, folder):
    """What the page's command makes is what was taken away, byte for byte."""
    command = shlex.split(visitor.page.inner_text("#again"))
    assert scegen(*command[1:], cwd=folder).returncode == 0
    again = {p.relative_to(folder / "again"): p for p in (folder / "again").rglob("*.*")}
    assert {str(name) for name in again} >= {"report.html", "summary.json"}
    for name, path in again.items():
        assert path.read_bytes() == (folder / name).read_bytes(), name


def test_a_sentence_becomes_a_zip_that_passes_every_check(server, visit, tmp_path):
    visitor = visit(server.url)
    visitor.understood(CROSSING)
    visitor.go("Choose")
    visitor.page.wait_for_selector(".tile svg")
    visitor.search()
    assert "statements hold" in visitor.page.inner_text(".card")
    visitor.go("Watch")
    visitor.page.wait_for_selector(".player .claims li")
    visitor.page.wait_for_selector(".seat canvas")
    folder = visitor.download(tmp_path)
    assert (folder / "README.md").read_text().count(visitor.page.inner_text("#again")) == 1
    assert scegen("check", folder).returncode == 0
    made_again(visitor, folder)


def test_work_lies_where_the_command_line_reads_it_and_the_other_way_round(server, visit, tmp_path):
    made = scegen(
        "generate",
        CROSSING,
        "-o",
        server.project / "by-hand",
        "--check",
        "none",
        "--target",
        "none",
        "--count",
        "2",
        "--osc",
        "1.2",
    )
    assert made.returncode == 0
    visitor = visit(server.url)
    visitor.page.get_by_role("button", name="Open").click()
    visitor.page.locator(".sheet").get_by_role("button", name="by-hand").click()
    visitor.page.wait_for_selector(".player")
    visitor.go("Describe")
    assert visitor.page.input_value("textarea") == CROSSING
    made_again(visitor, visitor.download(tmp_path))


def test_numbers_from_a_file_are_made_and_made_again(server, visit, tmp_path):
    made = scegen("generate", CROSSING, "-o", tmp_path / "made", "--check", "none")
    assert made.returncode == 0
    visitor = visit(server.url)
    visitor.page.get_by_role("button", name="Open").click()
    visitor.page.wait_for_selector(".sheet")
    visitor.page.set_input_files(
        "input[type=file]", next((tmp_path / "made").glob("scenarios/*/concrete.yaml"))
    )
    visitor.page.wait_for_selector("text=Given numbers")
    visitor.search()
    folder = visitor.download(tmp_path)
    made_again(visitor, folder)


def test_editing_changes_what_is_enumerated_and_made(server, visit, tmp_path):
    visitor = visit(server.url)
    visitor.understood(CROSSING)
    before = visitor.count()
    form = visitor.page.locator(".s-participants")
    form.get_by_role("button", name="add").click()
    visitor.page.wait_for_function(
        f"() => +document.querySelector('.plan .tally .figure')?.textContent > {before}"
    )
    form.get_by_role("button", name="Remove").last.click()
    visitor.page.wait_for_function(
        f"() => +document.querySelector('.plan .tally .figure')?.textContent === {before}"
    )
    speed = form.get_by_role("spinbutton", name="speed").first
    speed.fill("36")
    speed.press("Tab")
    visitor.page.wait_for_function("() => document.querySelector('.plan .tally')")
    visitor.search()
    folder = visitor.download(tmp_path)
    ego = next(
        p
        for p in yaml.safe_load((folder / "functional.yaml").read_text())["participants"]
        if p["role"] == "ego"
    )
    assert ego["speed_mps"] == {"low": 10.0, "high": 10.0}
    concrete = next((folder / "scenarios").iterdir()) / "concrete.yaml"
    driver = next(
        p for p in yaml.safe_load(concrete.read_text())["participants"] if p["role"] == "ego"
    )
    assert driver["speed_mps"] == pytest.approx(10.0)


def test_an_assumption_is_confirmed_with_a_click(server, visit):
    visitor = visit(server.url)
    visitor.understood(CROSSING)
    button = visitor.page.get_by_role("button", name="Confirm junction.driving_side")
    button.click()
    visitor.page.wait_for_function(
        "() => ![...document.querySelectorAll('.assumptions button')]"
        ".some((b) => b.getAttribute('aria-label')?.includes('driving_side'))"
    )


def test_filters_narrow_and_say_what_is_wrong(server, visit):
    visitor = visit(server.url)
    visitor.understood(CROSSING)
    every = visitor.count()
    visitor.go("Choose")
    visitor.page.wait_for_selector(".tile svg")
    visitor.page.locator(".facet").first.get_by_role("button").first.click()
    visitor.page.wait_for_function(
        "() => document.querySelector('.tiles h1').textContent.includes('shown of')"
    )
    shown = int(visitor.page.inner_text(".tiles h1").split()[0])
    assert 0 < shown < every
    where = visitor.page.get_by_label("where")
    where.fill("conflicts(crosing) >= 1")
    where.press("Enter")
    visitor.page.wait_for_selector(".expression .problem >> text=crossing")
    where.fill("")
    where.press("Enter")
    visitor.page.wait_for_function(
        f"() => document.querySelector('.tiles h1').textContent.startsWith('{every}')"
    )
    visitor.page.get_by_role("button", name="Pick for coverage").click()
    visitor.page.wait_for_selector(".coverage .note >> text=cover every meeting")
    covered, _, possible, *_ = visitor.page.inner_text(".coverage .tally").split()
    assert covered == possible


def test_rules_of_ones_own_narrow_the_list_and_go_along(server, visit, tmp_path):
    visitor = visit(server.url)
    visitor.understood(MANY)
    every = visitor.count()
    visitor.go("Choose")
    visitor.page.wait_for_selector(".tile svg")
    visitor.page.get_by_text("Rules of your own").click()
    rules = visitor.page.get_by_label("Rules in answer set programming")
    rules.fill("% nobody turns\n:- turnz(V,left).")
    visitor.page.get_by_role("button", name="Keep them").click()
    visitor.page.wait_for_selector(".tiles .problem >> text=rules.lp, line 2")
    rules.fill(":- turns(V,T), T != straight.")
    visitor.page.get_by_role("button", name="Keep them").click()
    visitor.page.wait_for_function(
        f"() => parseInt(document.querySelector('.tiles h1').textContent) < {every}"
    )
    visitor.page.wait_for_selector(".tile svg")
    visitor.search()
    folder = visitor.download(tmp_path)
    assert (folder / "rules.lp").read_text() == ":- turns(V,T), T != straight.\n"
    made_again(visitor, folder)


def test_somebody_gets_another_name_everywhere(server, visit):
    visitor = visit(server.url)
    visitor.understood(CROSSING)
    name = visitor.page.get_by_label("Name of van_1")
    name.fill("Delivery van")
    name.press("Enter")
    visitor.page.wait_for_selector("[aria-label='Name of delivery_van']")
    name = visitor.page.get_by_label("Name of delivery_van")
    name.fill("ego")
    name.press("Enter")
    visitor.page.wait_for_selector(".fields .problem:visible")
    assert name.input_value() == "delivery_van"


def test_a_search_is_cancelled_and_survives_a_reload(server, visit):
    visitor = visit(server.url)
    visitor.understood(MANY)
    visitor.go("Choose")
    visitor.page.get_by_role("button", name="8 that differ").click()
    visitor.page.wait_for_selector("text=Make 8 dangerous")
    visitor.go("Make dangerous")
    visitor.page.locator(".results .lead").get_by_role("button", name="Search").click()
    visitor.page.wait_for_selector(".log li")
    visitor.page.reload()
    visitor.page.wait_for_selector(".log li")
    visitor.page.locator(".activity").get_by_role("button", name="Cancel").first.click()
    visitor.page.wait_for_function("() => !document.querySelector('.log li')")
    assert visitor.page.locator(".results .lead").get_by_role("button", name="Search").is_enabled()


def test_where_nobody_chooses_what_shows_best_is_made(server, visit, tmp_path):
    visitor = visit(server.url)
    visitor.understood(RING)
    visitor.search()
    assert visitor.page.locator(".card .dot.held").count() == 1
    passed_over = visitor.page.inner_text(".results .remark")
    assert "passed over" in passed_over
    visitor.go("Watch")
    visitor.page.wait_for_selector(".player .mark.closest")
    # every mark stands where its second is on the line
    marks = visitor.page.evaluate(
        """() => {
          const rail = document.querySelector(".player .marks").getBoundingClientRect();
          return [...document.querySelectorAll(".player .mark")].map((mark) => {
            const box = mark.getBoundingClientRect();
            const place = rail.left + (rail.width * parseFloat(mark.style.left)) / 100;
            return box.left + box.width / 2 - place;
          });
        }"""
    )
    assert marks == pytest.approx([0] * len(marks), abs=1)
    visitor.go("Choose")
    visitor.page.wait_for_selector(".tile.picked")
    made = next((visitor.download(tmp_path) / "scenarios").iterdir()).name
    assert made not in passed_over
    assert visitor.page.inner_text("#again") == "scegen generate functional.yaml -o again"


def test_two_sessions_know_nothing_of_each_other(server, visit):
    first, second = visit(server.url), visit(server.url)
    first.understood(CROSSING)
    second.understood(MANY)
    first.page.reload()
    first.page.wait_for_selector(".plan .tally")
    assert first.page.input_value("textarea") == CROSSING
    assert second.page.input_value("textarea") == MANY
    assert first.count() != second.count()


def test_on_a_narrow_page_steps_have_names_and_troubles_say_what_to_do(server, visit):
    page = visit(server.url).page
    page.set_viewport_size({"width": 380, "height": 720})
    for name in ("Choose", "Make dangerous", "Watch", "Take away"):
        assert page.get_by_role("button", name=name).count() == 1, name
    page.fill("textarea", " ")
    page.keyboard.press("Control+Enter")
    page.wait_for_selector(".problem:visible")
    told = page.inner_text(".problem:visible").splitlines()
    assert told[0] == "description: the description is empty"
    assert told[1].strip().startswith("Describe a traffic situation")


def test_axe_finds_nothing_serious(server, visit):
    visitor = visit(server.url)

    def look(step):
        found = Axe().run(visitor.page).response["violations"]
        bad = [v for v in found if v["impact"] in {"serious", "critical"}]
        told = [(v["id"], [n["html"][:160] for n in v["nodes"][:3]]) for v in bad]
        assert told == [], step

    look("blank")
    visitor.understood(CROSSING)
    look("describe")
    visitor.go("Choose")
    visitor.page.wait_for_selector(".tile svg")
    look("choose")
    visitor.search()
    look("danger")
    visitor.go("Watch")
    visitor.page.wait_for_selector(".player .claims li")
    look("watch")
    visitor.go("Take away")
    visitor.page.wait_for_selector(".file-list")
    look("take")
