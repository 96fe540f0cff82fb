"""The player in a browser: where cars are, keys, clicks, before and after, hostile words."""

import json
import re

import pytest
from axe_playwright_python.sync_playwright import Axe
from by_hand import by_hand
from scenes import EVIL, concrete, scene

from scegen.report.player.bundle import player_css, player_js
from scegen.report.theme import css
from scegen.scenario.concrete import ConcreteParticipant, DriveMotion

pytestmark = pytest.mark.browser
PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><title>player</title>
<style>{css}</style><main><h1>player</h1><div id="here"></div></main>
<script type="application/json" id="scenes">{scenes}</script>
<script type="module">
{js}
const [scene, before] = JSON.parse(document.getElementById("scenes").textContent);
window.player = mount(document.getElementById("here"), scene, {{ before }});
</script></html>"""


def document(*scenes):
    data = json.dumps([*scenes, None][:2]).replace("<", "\\u003c")
    return PAGE.format(css=css() + player_css(), js=player_js(), scenes=data)


@pytest.fixture(scope="module")
def made():
    return scene()


@pytest.fixture
def page(open_page, made):
    return open_page(document(made[0]))


def time_of(page):
    return page.evaluate("player.time")


def test_scrubbing_puts_everybody_where_the_simulation_has_them(page, made):
    _, traces = made
    for name, trace in traces.items():
        for step in range(0, len(trace.time_s), 101):
            where = page.evaluate(
                "([id, t]) => { player.seek(t); return player.pose(id) }",
                [name, float(trace.time_s[step])],
            )
            assert abs(where["x"] - trace.x_m[step]) <= 0.05
            assert abs(where["y"] - trace.y_m[step]) <= 0.05
            assert where["speed"] == pytest.approx(trace.speed_mps[step], abs=0.05)


def test_the_slider_scrubs(page):
    slider = page.get_by_role("slider", name="Time")
    slider.fill("7.5")
    assert time_of(page) == pytest.approx(7.5)
    assert "7.50 of 20.00 seconds" in slider.get_attribute("aria-valuetext")


def test_keys_do_as_in_video_players(page):
    page.locator(".stage canvas").last.focus()
    page.evaluate("player.seek(5)")
    for key, after in (
        ("ArrowRight", 5.5),
        ("ArrowLeft", 5.0),
        ("l", 7.0),
        ("j", 5.0),
        (".", 5.05),
        (",", 5.0),
        ("End", 20.0),
        ("Home", 0.0),
        ("n", 1.25),
        ("n", 4.0),
        ("p", 1.25),
    ):
        page.keyboard.press(key)
        assert time_of(page) == pytest.approx(after), key
    page.keyboard.press(">")
    assert page.get_by_label("Speed of playing").input_value() == "2"
    page.keyboard.press("?")
    assert page.locator("dialog.keys").is_visible()
    page.keyboard.press("Escape")
    assert not page.locator("dialog.keys").is_visible()


def test_playing_moves_on_stops_and_loops(page):
    page.locator(".stage canvas").last.focus()
    page.evaluate("player.seek(1)")
    page.keyboard.press("Space")
    page.wait_for_function("player.time > 1.3")
    page.keyboard.press("k")
    stopped = time_of(page)
    page.wait_for_timeout(120)
    assert time_of(page) == stopped
    low, high = page.evaluate("player.clock.window")
    page.keyboard.press("r")
    page.evaluate(f"player.seek({high - 0.1}); player.clock.setRate(4); player.play()")
    page.wait_for_function(f"player.time < {high - 0.5}")
    assert low <= time_of(page) < high


def test_a_statement_a_moment_and_a_participant_lead_there(page):
    page.evaluate("window.told = []; void player.on('claim', (id) => told.push(id))")
    page.get_by_role("button", name="car_1 drives 9 m/s").last.click()
    assert time_of(page) == pytest.approx(1.25)
    assert page.evaluate("told") == ["car_1.drives 9"]
    assert page.locator(".people button", has_text="car_1").get_attribute("aria-pressed") == "true"
    page.get_by_role("button", name=re.compile("6.50 s: failure to yield")).click()
    assert time_of(page) == pytest.approx(6.5)


def test_before_and_after_stand_side_by_side(open_page, made):
    slower = concrete()
    ego = slower.ego.model_copy(update={"speed_mps": 6.0})
    others = slower.participants[1:]
    before, traces = scene(slower.model_copy(update={"participants": (ego, *others)}), proof=None)
    page = open_page(document(made[0], before))
    assert page.locator(".stage:visible").count() == 1
    page.get_by_role("button", name="Before and after").click()
    stages = page.locator(".stage:visible")
    assert stages.all_inner_texts() == ["First timing", "Found"]
    boxes = [stages.nth(k).bounding_box() for k in (0, 1)]
    assert boxes[0]["y"] == boxes[1]["y"]
    page.evaluate("player.seek(8)")
    earlier = page.evaluate("player.earlier.pose('ego', player.time)")
    assert earlier["x"] == pytest.approx(traces["ego"].x_m[800], abs=0.05)
    assert page.evaluate("player.pose('ego').x") != pytest.approx(earlier["x"], abs=1.0)


def test_pictures_are_turned_moved_and_enlarged(page):
    canvas = page.locator(".stage canvas").last
    scale = "player.stages[0].camera.scale"
    before = page.evaluate(scale)
    page.get_by_role("button", name="Larger (+)").click()
    assert page.evaluate(scale) > before
    canvas.click(position={"x": 5, "y": 5})
    page.mouse.wheel(0, 400)
    page.wait_for_function(f"{scale} < {before * 1.25}")
    x = page.evaluate("player.stages[0].camera.x")
    canvas.drag_to(
        canvas, source_position={"x": 300, "y": 200}, target_position={"x": 200, "y": 200}
    )
    assert page.evaluate("player.stages[0].camera.x") > x
    page.get_by_label("Follow").select_option("car_1")
    page.evaluate("player.seek(9)")
    camera = page.evaluate("player.stages[0].camera")
    middle = page.evaluate("player.recording.middle('car_1', 9)")
    assert camera["x"] == pytest.approx(middle["x"])


def test_a_straight_road_fills_the_picture(open_page):
    drive = {"entry": 0, "entry_lane": 1, "exit": 1, "exit_lane": 1}
    motion = DriveMotion(**drive, start_m=10.0, turning_starts_m=200.0, turning_ends_m=200.0)
    people = [
        ConcreteParticipant(
            id=name,
            kind="car",
            role=role,
            speed_mps=speed,
            motion=motion.model_copy(update={"start_m": at}),
        )
        for name, role, speed, at in (("ego", "ego", 20.0, 10.0), ("slow", "other", 8.0, 120.0))
    ]
    page = open_page(document(scene(by_hand(*people, duration_s=14.0), proof=None)[0]))
    assert page.get_by_label("Follow").input_value() == "pair"
    for time_s in (0, 5, 9, 14):
        edges = page.evaluate(
            "(t) => { player.seek(t); const { camera } = player.stages[0];"
            " return [0, camera.width].map((u) => camera.toWorld(u, camera.height / 2)) }",
            time_s,
        )
        assert all(abs(x) <= 200.01 and abs(y) <= 5.5 for x, y in edges), (time_s, edges)


def test_an_ego_alone_is_played_as_well(open_page):
    people = concrete().model_dump(mode="json")["participants"][:1]
    only = concrete(objects=[], hazards=[], participants=people)
    page = open_page(document(scene(only, proof=None)[0]))
    page.evaluate("player.play()")
    page.wait_for_function("player.time > 0.2")
    assert page.locator(".plot").count() == 2


def test_clicking_a_body_chooses_it(page):
    page.evaluate("player.seek(12)")
    box = page.locator(".stage canvas").last.bounding_box()
    u, v = page.evaluate(
        "(() => { const m = player.recording.middle('ego', 12);"
        " return player.stages[0].camera.toScreen(m.x, m.y) })()"
    )
    page.mouse.click(box["x"] + u, box["y"] + v)
    assert page.evaluate("player.shared.selected") == "ego"


def test_names_do_not_cover_one_another(page):
    boxes = page.evaluate(
        "[0, 5, 10, 14].flatMap((t) => { player.seek(t); const s = player.stages[0];"
        " return [[...s.placed.values()].map(({ box }) => box)] })"
    )
    for placed in boxes:
        for n, (a0, b0, a1, b1) in enumerate(placed):
            for c0, d0, c1, d1 in placed[:n]:
                assert a1 <= c0 or c1 <= a0 or b1 <= d0 or d1 <= b0


def test_hostile_words_stay_words(page):
    assert page.title() == "player"
    assert page.locator("img").count() == 0
    assert EVIL in page.locator(".claims").inner_text()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_serious_for_those_who_see_or_move_otherwise(open_page, made, scheme):
    page = open_page(document(made[0]), color_scheme=scheme)
    found = Axe().run(page).response["violations"]
    serious = [v for v in found if v["impact"] in {"serious", "critical"}]
    assert serious == [], [(v["id"], v["nodes"][0]["html"]) for v in serious]


def test_names_in_the_modules_are_unique():
    names = re.findall(
        r"^(?:export )?(?:const|let|function|class) (\w+)", player_js(), re.MULTILINE
    )
    assert len(names) == len(set(names))
    assert "import " not in re.sub(r"//.*|/\*.*?\*/", "", player_js(), flags=re.DOTALL)
