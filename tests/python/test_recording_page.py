"""The page of `mimo export --html`, in a headless browser: opened from a disk, it plays a recording and compares it."""

import contextlib
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from browser import page
from recorded import program, record, recorder_or_skip

import mimo

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "build/web/recording.html"
pytestmark = pytest.mark.skipif(not PAGE.is_file(), reason="there is no page; ./dev web makes it")
MOST_BYTES = 10_000_000  # of a page, besides its recording
STEPS = 200


def export(recording, path, warning=""):
    command = [program(), "export", "--html", str(path), "--page", str(PAGE), str(recording)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stderr == (warning and f"mimo: warning: the page may not find all of {recording} the same: {warning}\n")
    return path


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("pages")


@pytest.fixture(scope="module")
def recording(folder):
    """Two seconds of an infant that stands up."""
    return record(folder / "stand up.h5", "--scene", "standup", "--seconds", "2", "--seed", "3")


@pytest.fixture(scope="module")
def exported(folder, recording):
    return export(recording, folder / "run.html")


@contextlib.contextmanager
def opened(file, width=1000, height=700):
    """The page, at the start of its recording; it asks for nothing but its own file."""
    with page(width, height) as (shown, wrong):
        asked = []
        shown.on("request", lambda request: asked.append(request.url))
        shown.goto(file.as_uri())
        shown.wait_for_function("() => globalThis.mimoPage || !document.querySelector('#message').hidden")
        shown.evaluate("globalThis.mimoPage?.pause(true); globalThis.mimoPage?.goTo(0)")
        yield shown
        assert [url for url in asked if url != file.as_uri() and not url.startswith("data:")] == []
        assert wrong == []


def play(shown, steps):
    """Plays so many steps; how many there were."""
    done = shown.evaluate(
        "most => { let done = 0; while (done < most && mimoPage.advance()) done++; return done; }", steps
    )
    shown.evaluate("mimoPage.tick(performance.now())")
    return done


def compared(shown):
    """Rows of the table: of each dataset how many steps are the same, how many were compared, and what differs."""
    shown.evaluate("document.querySelector('#compared').open = true")
    rows = [row.split("\t") for row in shown.inner_text("#rows").splitlines()]
    return {name: (*map(int, same.split(" of ")), differs) for name, same, differs in rows}


def test_every_step_is_the_same_to_the_last_bit(exported):
    with opened(exported) as shown:
        assert play(shown, STEPS + 1) == STEPS
        told = f"Verified: all {STEPS} steps are the same as in the file, to the last bit."
        assert shown.inner_text("#verdict") == told
        found = compared(shown)
        assert {"joints/position", "joints/velocity", "rewards", "fields/proprioception/position"} <= set(found)
        assert all(row[:2] == (STEPS, STEPS) for row in found.values())
        assert shown.inner_text("#title") == "stand up.h5"
        assert shown.inner_text("#clock") == "2.00 of 2.00 s, paused"


def test_a_recording_of_python_is_the_same_with_all_senses(folder):
    file = folder / "senses.h5"
    random = np.random.default_rng(5)
    senses = {"touch": "force", "vision_width": 32, "vision_height": 32}
    with mimo.World("playdate", **senses) as world, recorder_or_skip(world, file, keep="all"):
        world.reset(seed=5)
        for _ in range(100):
            world.step(random.uniform(-1, 1, len(world.layout.actions)).astype(np.float32))
    with opened(export(file, folder / "senses.html"), 600, 500) as shown:
        assert play(shown, 101) == 100
        assert shown.inner_text("#verdict").startswith("Verified: all 100 steps")
        assert {"fields/ben/vision/eye_left", "fields/anna/touch/force"} <= set(compared(shown))


def test_the_run_parts_without_the_c_library_s_rounding(folder, exported):
    other = folder / "other.html"
    text, count = re.subn(r'(id="rounding"[^>]*>)[^<]+', r"\1", exported.read_text(encoding="utf-8"))
    assert count == 1
    other.write_text(text, encoding="utf-8")
    with opened(other) as shown:
        assert play(shown, STEPS + 1) == STEPS
        assert re.match(rf"\d+ of {STEPS} steps are the same", shown.inner_text("#verdict"))


def test_a_movement_that_was_followed_is_shown_by_its_joints(folder):
    file, movement = folder / "followed.h5", folder / "movement.csv"
    movement.write_text("time,left_elbow\n0,0\n0.2,-1\n")
    record(file, "--motion", str(movement), "--scene", "free", "--touch", "off", command="replay")
    why = f"{file.name}: its steps from 0 on follow a known movement; a replay by joints plays them"
    with opened(export(file, folder / "followed.html", f"{file.parent}/{why}"), 600, 500) as shown:
        assert play(shown, 21) == 20
        told = f"Joints are where the file has them, and nothing can be compared: {why}."
        assert shown.inner_text("#verdict") == told


def test_a_number_that_was_changed_is_found(folder, recording):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    changed = folder / "changed.h5"
    changed.write_bytes(recording.read_bytes())
    with h5py.File(changed, "r+") as file:
        row = file["joints/velocity"][41]
        row[7] = np.nextafter(row[7], np.inf)
        file["joints/velocity"][41] = row
    warning = "it comes out otherwise on this system from 0.42 s on"
    with opened(export(changed, folder / "changed.html", warning)) as shown:
        play(shown, 60)
        found = compared(shown)
        assert found["joints/velocity"][:2] == (59, 60)
        assert found["joints/velocity"][2].startswith("from step 42 on, by ")
        assert all(row[:2] == (60, 60) for name, row in found.items() if name != "joints/velocity")
        assert shown.inner_text("#verdict").startswith(
            "59 of 60 steps are the same as in the file, to the last bit. "
            "joints/velocity differs first in step 42, at 0.42 s"
        )


def test_what_differed_is_named_also_after_senses_were_added(folder, recording):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    changed = folder / "field.h5"
    changed.write_bytes(recording.read_bytes())
    with h5py.File(changed, "r+") as file:
        file["fields/proprioception/position"][4, 0] += 1
    with opened(export(changed, folder / "field.html")) as shown:
        play(shown, 10)
        shown.click("#add")
        play(shown, 1)
        assert "fields/proprioception/position differs first in step 5, at 0.05 s" in shown.inner_text("#verdict")


def test_the_python_package_writes_it_too(folder, recording):
    out = folder / "python.html"
    if subprocess.run([program(), "export", "--html", str(out), str(recording)], capture_output=True).returncode != 0:
        pytest.skip("the page is not beside the program")
    made = out.read_bytes()
    out.unlink()
    command = [sys.executable, "-m", "mimo.export", "--html", str(out), str(recording)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.stdout == f"wrote {out}\n", done.stderr
    assert out.read_bytes() == made


def test_a_page_has_all_inside_and_reaches_nothing(exported, recording):
    assert exported.stat().st_size < MOST_BYTES + 1.4 * recording.stat().st_size  # in base 64, which is 4/3
    with opened(exported) as shown:
        shown.click("#licences summary")
        shown.wait_for_function("() => document.querySelector('#texts').textContent.includes('three.js')")
    with page() as (shown, wrong):
        shown.goto(exported.as_uri())
        told = shown.evaluate("fetch('http://127.0.0.1:9/').then(() => 'fetched', error => error.name)")
        assert told == "TypeError"
        assert "Content Security Policy" in wrong[0]


def test_the_reader_takes_over_and_goes_back(exported):
    with opened(exported) as shown:
        play(shown, 30)
        assert shown.is_hidden("#does")
        shown.click("#own")
        shown.select_option("#behaviour", "rest")
        shown.evaluate("mimoPage.pause(true)")
        moved = shown.evaluate(
            """() => {
              const { player, pull, stage } = mimoPage;
              const body = stage.bodies.findIndex((_, i) => player.world.name(1, i) === "head");
              const place = () => stage.bodies[body].position.clone();
              const from = place();
              Object.assign(pull, { body, at: from.clone().set(0, 0, 0), target: from.clone().setY(from.y + 0.4) });
              for (let i = 0; i < 30; i++) mimoPage.advance();
              return place().distanceTo(from);
            }"""
        )
        assert moved > 0.05
        shown.evaluate("mimoPage.tick(performance.now())")
        assert "yours" in shown.inner_text("#clock")
        assert shown.input_value("#at") == "30"
        shown.click("#own")
        shown.evaluate("mimoPage.pause(true)")
        assert play(shown, 1000) == STEPS - 30
        assert shown.inner_text("#verdict").startswith("Verified: all")


def test_a_limb_that_is_pulled_is_the_reader_s(exported):
    with opened(exported) as shown:
        box = shown.locator("#scene").bounding_box()
        middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        shown.mouse.move(*middle)
        shown.mouse.down()
        shown.mouse.move(middle[0] + 80, middle[1])
        assert shown.evaluate("mimoPage.own && mimoPage.running")
        shown.mouse.up()
        assert shown.inner_text("#own") == "Back to the recording"


def test_any_step_is_reached_and_senses_are_added(exported):
    with opened(exported) as shown:
        shown.evaluate("document.querySelector('#at').value = 120; document.querySelector('#at').oninput()")
        assert shown.evaluate("mimoPage.player.next") == 120
        positions = shown.evaluate("Array.from(mimoPage.player.world.get(513))")  # MIMO_JOINT_POSITION
        kept = shown.evaluate("Array.from(mimoPage.player.recording.read('joints/position', 'f64', 119, 1))")
        np.testing.assert_array_equal(positions, kept)
        assert shown.is_hidden("#seen")
        shown.click("#add")
        assert shown.is_visible("#seen")
        assert shown.is_visible("#heard")
        assert shown.evaluate("mimoPage.player.next") == 120
        play(shown, 5)
        assert not any(name.startswith("fields/") for name in compared(shown))


def test_infants_become_younger_where_the_recording_has_it(folder):
    file = folder / "two.h5"
    with mimo.World("playdate", vision=False, touch=False) as world, recorder_or_skip(world, file):
        for age in (18, 6):
            world.reset(seed=1, age=age)
            for _ in range(5):
                world.step()
    with opened(export(file, folder / "two.html"), 600, 500) as shown:
        before = shown.evaluate("mimoPage.player.world.agent(0).height")
        assert play(shown, 20) == 10
        assert shown.evaluate("mimoPage.player.world.agent(0).height") < before - 0.1
        assert shown.evaluate("mimoPage.height") < before - 0.1


class Counting(mimo.WorldTask):
    """A task that no file holds."""

    def evaluate(self, world, moment):
        return mimo.Judgement(float(moment.step))


def test_rewards_of_a_task_of_one_s_own_are_not_compared(folder):
    file = folder / "own.h5"
    scene = mimo.Scene("free")
    scene.add_agents(vision=0, touch=0)
    scene.set_task(Counting())
    with mimo.World(scene) as world, recorder_or_skip(world, file):
        for _ in range(3):
            world.step()
    with opened(export(file, folder / "own.html"), 600, 500) as shown:
        assert play(shown, 20) == 3
        assert set(compared(shown)) >= {"joints/position", "joints/velocity"}
        assert not {"rewards", "terms", "outcome"} & set(compared(shown))


def test_phone_shows_everything_in_its_width(exported):
    with opened(exported, 390, 800) as shown:
        assert shown.evaluate("document.documentElement.scrollWidth") <= 390


NO_SIMD = "This browser has no WebAssembly with SIMD; browsers of 2023 and later have it."
NO_UNPACKING = "This browser cannot unpack what the page holds; browsers of 2023 and later can."


@pytest.mark.parametrize(
    ("script", "told"),
    [
        ("WebAssembly.validate = () => false", NO_SIMD),
        ("delete globalThis.WebAssembly", NO_SIMD),
        ("delete globalThis.DecompressionStream", NO_UNPACKING),
    ],
)
def test_older_browser_is_told_so(exported, script, told):
    with page() as (shown, wrong):
        shown.add_init_script(script)
        shown.goto(exported.as_uri())
        shown.wait_for_function("() => !document.querySelector('#message').hidden")
        assert shown.inner_text("#message") == told
        assert wrong == []


def test_page_without_a_recording_or_with_a_damaged_one_says_so(folder, exported, recording):
    with opened(PAGE) as shown:
        assert "mimo export --html run.html run.h5" in shown.inner_text("#message")
    text = exported.read_text(encoding="utf-8")
    start = text.index('data-name="stand up.h5">') + len('data-name="stand up.h5">')
    damaged = folder / "damaged.html"
    damaged.write_text(text[: start + 4000] + text[text.index("</script>", start) :], encoding="utf-8")
    with opened(damaged) as shown:
        assert "stand up.h5 is not a recording, or is truncated" in shown.inner_text("#message").lower()
