"""The page that ./dev web makes, in a headless browser: on a server of files, and without what it needs."""

import contextlib
import functools
import http.server
import re
import shutil
import threading
from pathlib import Path

import pytest
from browser import page

PAGE = Path(__file__).resolve().parents[2] / "build/web"
pytestmark = pytest.mark.skipif(not (PAGE / "index.html").is_file(), reason="there is no page; ./dev web makes it")


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@contextlib.contextmanager
def served(folder):
    """The address of a server of a folder's files, and what was asked for."""
    handler = functools.partial(Quiet, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}/"
        server.shutdown()


@contextlib.contextmanager
def opened(width=1000, height=700):
    with served(PAGE) as address, page(width, height) as (shown, wrong):
        asked = []
        shown.on("request", lambda request: asked.append(request.url))
        shown.goto(address)
        shown.wait_for_function("globalThis.mimoPage?.world?.time() > 0")
        yield shown, wrong
        assert [url for url in asked if not url.startswith((address, "data:", "blob:"))] == []


def message(shown):
    shown.wait_for_function("!document.querySelector('#message').hidden")
    return shown.inner_text("#message")


def kilograms(shown):
    return float(re.match(r"[\d.]+", shown.inner_text("#body"))[0])


def varied(shown, canvas):
    """How many colours a canvas has."""
    return shown.evaluate(
        """name => {
          const canvas = document.getElementById(name);
          const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
          return new Set(new Uint32Array(pixels.buffer)).size;
        }""",
        canvas,
    )


def test_infant_lives_and_visitors_change_it():
    with opened() as (shown, wrong):
        assert varied(shown, "left") > 50
        assert varied(shown, "right") > 50
        assert shown.input_value("#behaviour") == "learned"

        shown.click("#run")
        shown.evaluate("mimoPage.begin(1)")  # so that the step is not by chance the last of an episode
        shown.click("#step")
        step = shown.evaluate("mimoPage.world.layout.stepSeconds")
        assert shown.evaluate("mimoPage.world.time()") == pytest.approx(step, abs=1e-9)

        # WHO's medians of weight, mean of girls and boys: 3.29 kg at birth, 10.53 kg at 18 months.
        assert kilograms(shown) == pytest.approx(10.53, rel=0.05)
        seen = shown.evaluate("Array.from(mimoPage.world.observation['vision/eye_left'])")
        shown.evaluate("document.querySelector('#age').value = 0; mimoPage.grow()")
        assert kilograms(shown) == pytest.approx(3.29, rel=0.05)
        assert shown.inner_text("#months") == "birth"
        assert shown.evaluate("Array.from(mimoPage.world.observation['vision/eye_left'])") != seen

        shown.select_option("#faces", "surprise")
        assert shown.inner_text("#message") == ""

        shown.set_input_files("#load", {"name": "x.txt", "mimeType": "text/plain", "buffer": b"no state"})
        assert "state" in message(shown)
        assert wrong == []


def test_pull_moves_a_hand_and_the_skin_lights_up():
    with opened() as (shown, wrong):
        shown.click("#run")
        shown.select_option("#behaviour", "rest")
        moved = shown.evaluate(
            """() => {
              const { world, pull, stage } = mimoPage;
              mimoPage.begin(1);
              stage.move();
              const body = stage.bodies.findIndex((_, i) => world.name(1, i) === "right_hand");
              const place = () => stage.bodies[body].position.clone();
              const from = place();
              Object.assign(pull, { body, at: from.clone().set(0, 0, 0), target: from.clone().setY(from.y + 0.3) });
              let highest = from.y;
              for (let i = 0; i < 40; i++) {
                mimoPage.advance();
                highest = Math.max(highest, place().y);
              }
              pull.release();
              return highest - from.y;
            }"""
        )
        assert moved > 0.05
        assert shown.evaluate("mimoPage.stage.skin.reduce((sum, { count }) => sum + count, 0)") == 5685
        assert wrong == []


def test_all_scenes_run_with_their_tasks():
    with opened(500, 400) as (shown, wrong):
        for scene in shown.eval_on_selector_all("#scenes option", "all => all.map(one => one.value)"):
            shown.select_option("#scenes", scene)
            assert shown.inner_text("#message") == "", scene
            shown.evaluate("mimoPage.advance()")
        shown.select_option("#scenes", "benchmark")
        shown.select_option("#tasks", "catch")
        assert "catch" in message(shown)
        assert wrong == []


def test_policy_reaches_the_ball():
    with opened(400, 400) as (shown, wrong):
        reached = shown.evaluate(
            """() => {
              mimoPage.pause(true);
              mimoPage.episodes = mimoPage.reached = 0;
              while (mimoPage.episodes < 8) mimoPage.advance();
              return mimoPage.reached;
            }"""
        )
        assert reached >= 6  # random actions reach the ball in one of twenty episodes: docs/learning.md
        assert wrong == []


@pytest.mark.parametrize(("scene", "age"), [("sit", 6), ("stand-with-support", 12)])
def test_policies_act_in_their_scenes_at_their_age(scene, age):
    with opened(400, 400) as (shown, wrong):
        shown.click("#run")
        shown.select_option("#scenes", scene)
        assert shown.input_value("#behaviour") == "learned"
        assert shown.input_value("#age") == str(age)
        reached = shown.evaluate(
            """() => {
              mimoPage.episodes = mimoPage.reached = 0;
              while (mimoPage.episodes < 1) mimoPage.advance();
              return mimoPage.reached;
            }"""
        )
        assert reached == 1  # ten seconds; at rest it falls within one
        shown.select_option("#scenes", "reach")  # whose policy says no age
        assert shown.input_value("#age") == "18"
        shown.select_option("#scenes", "walk")  # nobody has learned there
        assert shown.input_value("#behaviour") == "babble"
        assert shown.is_disabled("#behaviour option[value=learned]")
        assert wrong == []


def test_nerves_are_as_old_as_a_policy_has_learned_with():
    with opened(400, 400) as (shown, wrong):
        shown.click("#run")
        latest = "Math.max(...mimoPage.world.layout.delays('proprioception/position'))"
        for delays in (True, False):
            shown.evaluate(
                "delays => { mimoPage.policies.find(({ scene }) => scene === 'sit').delays = delays; }", delays
            )
            shown.select_option("#scenes", "reach")
            shown.select_option("#scenes", "sit")
            assert (shown.evaluate(latest) > 0) == delays
        assert wrong == []


def test_phone_shows_everything_in_its_width():
    with opened(390, 800) as (shown, _):
        assert shown.evaluate("document.documentElement.scrollWidth") <= 390
        assert shown.evaluate("document.querySelector('#scene').clientWidth") > 340


def test_page_without_its_module_says_so(tmp_path):
    shutil.copytree(PAGE, tmp_path / "web", ignore=shutil.ignore_patterns("mimo.wasm", "docs"))
    with served(tmp_path / "web") as address, page() as (shown, _):
        shown.goto(address)
        assert re.match(r"Mimo\.wasm cannot be read from http://.*: the server answers 404\.", message(shown))


def test_other_file_in_place_of_the_module_is_refused(tmp_path):
    shutil.copytree(PAGE, tmp_path / "web", ignore=shutil.ignore_patterns("docs"))
    (tmp_path / "web/mimo.wasm").write_text("<html>not found</html>")
    with served(tmp_path / "web") as address, page() as (shown, _):
        shown.goto(address)
        assert message(shown).startswith("Mimo.wasm cannot be used here: ")


def test_browser_without_simd_is_told_so():
    with served(PAGE) as address, page() as (shown, wrong):
        shown.add_init_script("WebAssembly.validate = () => false")
        shown.goto(address)
        assert message(shown) == "This browser has no WebAssembly with SIMD; browsers of 2023 and later have it."
        assert wrong == []


def test_page_opened_from_a_disk_says_how_to_serve_it():
    with page() as (shown, _):
        shown.goto(f"file://{PAGE}/index.html")
        assert "python3 -m http.server" in message(shown)
