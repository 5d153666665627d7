"""The option `--sense`: the program loads senses of a user's own, and nothing else makes it load code.

MIMO_OWN_SENSE is the path of own_sense.cpp as a shared library, MIMO_OTHER_SENSE with another version of the interface.
"""
import json
import os
import shutil
import unittest

from program import BENCH, Case, needs_hdf5

SENSE, OTHER_VERSION = os.environ["MIMO_OWN_SENSE"], os.environ["MIMO_OTHER_SENSE"]
BLIND = ("--vision", "off", "--touch", "off")


class Sense(Case):
    def fields(self, *arguments):
        return [field["name"] for field in json.loads(self.mimo("info", "--json", *arguments))["observation_fields"]]

    def highest(self, *arguments):
        """What the sense gave at most in 10 steps of 2 physics steps."""
        rows = self.mimo("run", "--sense", SENSE, "--seconds", "0.1", *BLIND, *arguments).splitlines()
        return [float(row.split()[-1]) for row in rows if row.split()[:1] == ["ticks"]]

    def test_a_world_has_the_sense(self):
        self.assertEqual(self.highest(), [20])
        self.assertEqual(self.highest("--parameter", "ticks/gain=0.5"), [10])
        self.assertIn("ticks", self.fields("--sense", SENSE, *BLIND))
        self.assertNotIn("ticks", self.fields(*BLIND))

    def test_each_infant_has_it(self):
        names = self.fields("--scene", "playdate", "--sense", SENSE, *BLIND)
        self.assertEqual(len([name for name in names if name.endswith("/ticks")]), 2)

    def test_a_model_without_infants_has_it(self):
        self.write("arm.xml", '<mujoco><worldbody><body name="arm"><joint/><geom size="0.1"/></body></worldbody></mujoco>')
        self.assertIn("ticks", self.fields("--scene", "arm.xml", "--sense", SENSE))

    def test_paths_are_as_they_are_written(self):
        folder = self.folder / "my senses"
        folder.mkdir()
        shutil.copy(SENSE, folder / "ticks=1.so")
        self.assertIn("ticks", self.fields("--sense", "my senses/ticks=1.so", *BLIND))

    def test_parameters_of_tasks_are_set_as_well(self):
        self.mimo("run", "--scene", "reach", "--parameter", "reach/success_reward=3", "--seconds", "0.05", *BLIND)

    def test_parameters_that_there_are_not(self):
        def refused(setting, *words, code=1):
            said = self.mimo("info", "--sense", SENSE, "--parameter", setting, *BLIND, code=code)
            for word in words:
                self.assertIn(word, said)

        refused("ticks/grain=1", 'no parameter named "ticks/grain"', 'did you mean "ticks/gain"?', "reach/success_reward")
        refused("ticks/gain=6", "ticks/gain is 6, expected 0 to 5")
        refused("ticks/gain", "expected NAME=VALUE with a number, not 'ticks/gain'", code=2)
        refused("ticks/gain=much", "expected NAME=VALUE with a number", code=2)
        refused("=1", "expected NAME=VALUE", code=2)

    def test_what_is_no_sense_is_named(self):
        self.write("text.so", "no library")
        libraries = (("none.so", 'path is "none.so", expected a shared library with a sense'),
                     ("text.so", 'path is "text.so", expected a shared library with a sense'),
                     ("", 'path is "", expected that of a shared library'),
                     (OTHER_VERSION, OTHER_VERSION + ": sense: interface_version is 7, but this library knows 1"))
        for library, said in libraries:
            for command in (("run", "--seconds", "0.1"), ("info",), ("record", "--out", "run.h5"),
                            ("replay", "--motion", self.write("motion.csv", "time,hip_bend1\n0,0\n1,0.1\n"))):
                with self.subTest(library=library, command=command):
                    self.assertIn(said, self.mimo(*command, "--sense", library, code=1))
        self.assertIn("has a sense \"ticks\" already", self.mimo("info", "--sense", SENSE, "--sense", SENSE, code=1))
        self.assertEqual(self.files(), ["motion.csv", "text.so"])

    def test_a_sense_that_fails_ends_the_run(self):
        said = self.mimo("run", "--sense", SENSE, "--parameter", "ticks/last=10", "--seconds", "0.1", *BLIND, code=1)
        self.assertIn("the sense \"ticks\"'s function advance", said)
        self.assertIn("no more ticks", said)

    def test_steps_with_the_sense_are_measured(self):
        result = json.loads(self.run_program(BENCH, "--json", "--sense", SENSE, "--steps", "20", *BLIND))
        self.assertIn(result["allocations_per_step"], (0, None))

    @needs_hdf5
    def test_a_recording_is_replayed_with_the_sense_and_never_loads_it(self):
        self.mimo("record", "--scene", "free", "--sense", SENSE, "--parameter", "ticks/gain=3", "--keep", "all", "--touch",
                  "off", "--seconds", "0.5", "--out", "run.h5")
        said = self.mimo("replay", "run.h5", code=1)
        self.assertIn(f'the recording needs the sense "ticks" (of {SENSE})', said)
        self.assertIn("--sense", said)
        for start in (0, 0.3):
            report = json.loads(self.mimo("replay", "run.h5", "--json", "--from", start, "--sense", SENSE))
            self.assertIs(report["identical"], True)
        self.mimo("replay", "run.h5", "--sense", SENSE, "--keep", "ticks", "--out", "again.h5")
        self.assertIs(json.loads(self.mimo("replay", "again.h5", "--json", "--sense", SENSE))["identical"], True)
        self.assertIn("--parameter: run.h5 holds its world itself",
                      self.mimo("replay", "run.h5", "--sense", SENSE, "--parameter", "ticks/gain=1", code=1))
        self.write("page.html", "<!-- recording -->")
        said = self.mimo("export", "--html", "run.html", "--page", "page.html", "run.h5", code=1)
        self.assertIn("run.h5 has a sense of its own, 'ticks', whose library a browser cannot load", said)
        self.assertNotIn("run.html", self.files())
        self.mimo("record", "--scene", "free", "--touch", "off", "--seconds", "0.1", "--out", "plain.h5")
        self.assertIn('no sense "ticks" of its own; it has: none', self.mimo("replay", "plain.h5", "--sense", SENSE, code=1))


if __name__ == "__main__":
    unittest.main(verbosity=2)
