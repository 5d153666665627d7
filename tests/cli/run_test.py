"""`mimo run`: an infant's random movements, and pictures of them."""
import array
import json
import re
import signal
import subprocess
import time
import unittest
import wave

from program import PROGRAM, Case, needs_renderer, read_png


class Run(Case):
    PICTURES = ["pictures/%s%s.png" % (when, what) for when in ("", "start_")
                for what in ("anaglyph", "left", "outside", "right", "touch", "touch_map")]

    @needs_renderer
    def test_writes_pictures_and_a_report(self):
        text = self.mimo("run", "--seconds", "0.1", "--vision", "32", "--out", "pictures")
        self.assertEqual(self.files(), sorted(self.PICTURES))
        for path in self.PICTURES:
            self.assertIn(path, text)
            self.assertEqual(read_png(self.folder / path)[:2], (32, 32) if re.search("left|right|anaglyph", path) else (640, 480))
        for word in ("vision/eye_left", "proprioception/position", "real time", "physics"):
            self.assertIn(word, text)

    @needs_renderer
    def test_each_infant_sees(self):
        text = self.mimo("run", "--scene", "playdate", "--seconds", "0.1", "--vision", "32", "--touch", "0.3", "--out", "p")
        eyes = ["p/%s%s_%s.png" % (when, infant, what) for when in ("", "start_") for infant in ("anna", "ben")
                for what in ("anaglyph", "left", "right", "touch_map")]
        others = ["p/%s%s.png" % (when, what) for when in ("", "start_") for what in ("outside", "touch")]
        self.assertEqual(self.files(), sorted(eyes + others))
        self.assertIn("ben/touch/force", text)
        anna, ben = ((self.folder / "p" / ("start_%s_left.png" % infant)).read_bytes() for infant in ("anna", "ben"))
        self.assertNotEqual(anna, ben)

    @needs_renderer
    def test_anaglyph_is_made_of_both_eyes(self):
        self.mimo("run", "--seconds", "0.05", "--vision", "16", "--out", "p")
        left, right, both = (b"".join(read_png(self.folder / "p" / name)[4])
                             for name in ("left.png", "right.png", "anaglyph.png"))
        self.assertEqual(both[0::3], left[0::3])
        self.assertEqual(both[1::3], right[1::3])
        self.assertEqual(both[2::3], right[2::3])

    @needs_renderer
    def test_same_seed_same_pictures(self):
        for out, seed in (("a", 1), ("b", 1), ("c", 2)):
            self.mimo("run", "--seconds", "0.3", "--vision", "16", "--seed", seed, "--out", out)
        a, b, c = ((self.folder / out / "left.png").read_bytes() for out in "abc")
        self.assertEqual(a, b)
        self.assertNotEqual(a, c)

    def heard(self, *arguments):
        """A second of both ears: numbers of 16 bits, left and right in turns; and the report."""
        text = self.mimo("run", "--scene", "showroom", "--seconds", "1", "--vision", "off", "--touch", "off", "--out", "p",
                         "--sound", "ears.wav", *arguments)
        with wave.open(str(self.folder / "ears.wav")) as file:
            self.assertEqual(file.getparams()[:4], (2, 2, 16000, 16000))
            return array.array("h", file.readframes(16000)), text

    @needs_renderer
    def test_sound_is_written(self):
        whole, text = self.heard("--full-scale", "20")
        self.assertIn("full scale is 20 Pa\n", text)
        peak = float(re.search(r"peak ([\d.e-]+) Pa", text).group(1))
        self.assertAlmostEqual(max(abs(value) for value in whole) / 32767 * 20, peak, delta=0.005 * peak)
        self.assertNotEqual(whole[0::2], whole[1::2])
        cut, text = self.heard()
        self.assertIn("full scale is 1 Pa, louder sound is clipped: see --full-scale", text)
        self.assertTrue(all(abs(large) == 32767 or abs(large - 20 * small) <= 20 for large, small in zip(cut, whole)))

    @needs_renderer
    def test_a_voice_is_heard(self):
        self.assertNotEqual(self.heard("--voice")[0], self.heard()[0])

    def interrupted(self, *arguments, times):
        """Runs until pictures of the start are there, then sends interrupts."""
        done = subprocess.Popen([PROGRAM, "run", "--seconds", "1e6", "--vision", "off", "--out", "p", *arguments],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, cwd=self.folder,
                                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        self.addCleanup(done.kill)
        deadline = time.monotonic() + 60
        while not (self.folder / "p/start_touch.png").exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        for _ in range(times):
            time.sleep(0.3)
            done.send_signal(signal.SIGINT)
        return done, *done.communicate(timeout=60)

    @needs_renderer
    def test_an_interrupt_keeps_the_report(self):
        done, text, errors = self.interrupted(times=1)
        self.assertEqual((done.returncode, errors), (-signal.SIGINT, ""))
        self.assertRegex(text, r"\Ainterrupted after [0-9.]+ of 1e\+06 s\n")
        for word in ("real time", "proprioception/position", "p/touch.png"):
            self.assertIn(word, text)
        self.assertIn("p/outside.png", self.files())

    @needs_renderer
    def test_touch_is_seen_through_the_floor(self):
        """A box on a green floor feels it from below: there the floor is not drawn, from outside it is."""
        self.write("floor.xml", """<mujoco><worldbody><light pos="0 0 3"/><light pos="0 0 -3" dir="0 0 1"/>
            <geom type="plane" size="3 3 .1" rgba="0 1 0 1"/><body pos="0 0 .099"><freejoint/>
            <geom type="box" size=".1 .1 .1" rgba=".5 .5 .5 1"/></body></worldbody></mujoco>""")
        self.mimo("run", "--scene", "floor.xml", "--seconds", "0.5", "--out", "p")
        share = {}
        for name in ("outside", "touch", "touch_map"):
            pixels = b"".join(read_png(self.folder / "p" / (name + ".png"))[4][:400])  # without the scale
            colours = list(zip(pixels[0::3], pixels[1::3], pixels[2::3]))
            share[name] = [sum(map(like, colours)) / len(colours) for like in (
                lambda c: c[1] > 2 * c[0] + 20 and c[1] > 2 * c[2] + 20,  # the floor
                lambda c: c[0] > 1.5 * c[2] + 40)]  # what is felt
        four_dots = 4 * 32 / (400 * 640)
        self.assertGreater(share["outside"][0], 0.2)
        self.assertEqual(share["touch"][0], 0)
        self.assertGreater(share["touch"][1], four_dots)  # beside the scale
        self.assertGreater(share["touch_map"][1], four_dots)
        self.assertLess(share["outside"][1], 0.0001)

    @needs_renderer
    def test_sensors_that_feel_nothing_are_seen_in_print(self):
        """Grey of at most 60 % of white, for hundreds of sensors; printers draw nothing lighter as a fine dot."""
        self.mimo("run", "--scene", "free", "--vision", "off", "--seconds", "0.1", "--out", "p")
        pixels = b"".join(read_png(self.folder / "p" / "touch_map.png")[4][:400])  # without the scale
        grey = [red for red, green, blue in zip(pixels[0::3], pixels[1::3], pixels[2::3]) if red == green == blue]
        self.assertGreater(sum(tone <= 153 for tone in grey), 1000)

    def test_a_run_goes_on_where_interrupts_are_ignored(self):
        done = subprocess.Popen([PROGRAM, "run", "--seconds", "2", "--vision", "off", "--touch", "off", "--out", "p"],
                                stdout=subprocess.PIPE, universal_newlines=True, cwd=self.folder,
                                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
        done.send_signal(signal.SIGINT)
        text = done.communicate(timeout=60)[0]
        self.assertEqual(done.returncode, 0)
        self.assertIn("2.00 s of scene", text)

    def test_vision_off_writes_no_pictures_of_eyes(self):
        text = self.mimo("run", "--seconds", "0.1", "--vision", "off", "--out", "p")
        self.assertNotIn("vision/", text)
        self.assertNotIn("p/left.png", self.files())

    def test_what_a_behaviour_measured_is_printed(self):
        options = ("--scene", "sit", "--vision", "off", "--json")
        told = json.loads(self.mimo("run", *options, "--parameter", "behaviour/episode_seconds=0.2"))
        self.assertEqual((told["task"], told["steps"], told["over"], told["outcome"]), ("behaviour", 20, True, "none"))
        measure = told["measure"]
        self.assertEqual((measure["name"], measure["unit"], measure["threshold"]), ("tilt upper_body z", "deg", 45))
        self.assertEqual(measure["value"], told["achieved"][0])
        self.assertIsNone(told["policy"])
        spontaneous = json.loads(self.mimo("run", *options, "--spontaneous", "--seconds", "0.2"))
        self.assertNotEqual(spontaneous["achieved"], told["achieved"])
        without = json.loads(self.mimo("run", *options, "--task", "none", "--seconds", "0.1"))
        self.assertEqual((without["task"], without["measure"], without["goal"]), ("none", None, []))

    def test_a_behaviour_of_ones_own(self):
        self.write("crouch.xml", """
          <mujoco>
            <include file="mimo/parts/room.xml"/>
            <custom>
              <numeric name="mimo:place" data="0 0 0.36 1 0 0 0"/>
              <text name="mimo:task" data="behaviour"/>
              <text name="mimo:behaviour" data="crouches"/>
              <text name="mimo:reached" data="height head at most 0.3 from 0.6 m"/>
            </custom>
          </mujoco>""")
        options = ("run", "--scene", "crouch.xml", "--vision", "off", "--seconds", "0.1", "--json")
        told = json.loads(self.mimo(*options, "--body", "mitten"))
        self.assertEqual((told["measure"]["name"], told["measure"]["threshold"]), ("height head", 0.3))
        self.assertIn('no body named "head"', self.mimo(*options, code=1))  # everything in the room is one agent

    def test_room_without_infant(self):
        self.write("room.xml", '<mujoco><worldbody><body><freejoint/><geom size=".1"/></body></worldbody></mujoco>')
        self.assertIn("real time", self.mimo("run", "--scene", "room.xml", "--seconds", "0.1", "--out", "p"))

    def test_folder_that_cannot_be_made(self):
        self.write("file", "")
        self.mimo("run", "--seconds", "0.1", "--vision", "off", "--out", "file/p", code=1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
