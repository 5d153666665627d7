"""`mimo-bench`: how fast the worlds step."""
import json
import unittest

from program import BENCH, Case, needs_renderer


class Bench(Case):
    KEYS = {"steps", "wall_s", "realtime_factor", "ms_per_step", "split_ms", "touch_sensors", "mean_contacts",
            "raw_physics_us", "reference_us", "allocations_per_step", "step_vs_raw"}

    def mimo_bench(self, *arguments, code=0):
        return self.run_program(BENCH, *arguments, code=code)

    def bench(self, *arguments):
        return json.loads(self.mimo_bench("--json", *arguments))

    def test_numbers_fit_together(self):
        result = self.bench("--vision", "off", "--steps", "60")
        self.assertLessEqual(self.KEYS, set(result))
        self.assertEqual(set(result["split_ms"]),
                         {"physics", "touch", "vision", "proprioception", "vestibular", "other"})
        self.assertEqual(result["steps"], 60)
        self.assertEqual(result["split_ms"]["vision"], 0)
        self.assertAlmostEqual(sum(result["split_ms"].values()), result["ms_per_step"], places=9)
        self.assertAlmostEqual(result["wall_s"] * 1000 / 60, result["ms_per_step"], places=9)
        self.assertAlmostEqual(60 * 0.01 / result["wall_s"], result["realtime_factor"], places=6)
        self.assertGreater(result["raw_physics_us"], 0)
        self.assertGreater(result["reference_us"], 0)
        self.assertGreaterEqual(result["split_ms"]["physics"], 0)
        self.assertEqual(result["touch_sensors"], 5685)
        self.assertGreater(result["split_ms"]["touch"], 0)

    def test_touch_off_has_no_time_for_touch(self):
        result = self.bench("--vision", "off", "--touch", "off", "--steps", "3")
        self.assertEqual((result["touch_sensors"], result["split_ms"]["touch"]), (0, 0))

    def test_a_step_allocates_nothing(self):
        allocations = self.bench("--vision", "off", "--steps", "200")["allocations_per_step"]
        if allocations is None:
            self.skipTest("allocations cannot be counted in this build")
        self.assertEqual(allocations, 0)

    @needs_renderer
    def test_vision_has_its_share_of_the_time(self):
        self.assertGreater(self.bench("--vision", "32", "--steps", "5")["split_ms"]["vision"], 0)

    def test_many_worlds_are_measured_together(self):
        result = self.bench("--scene", "reach", "--vision", "off", "--steps", "12", "--worlds", "4", "--threads", "2")
        self.assertLessEqual(self.KEYS, set(result))
        self.assertEqual((result["steps"], result["worlds"], result["threads"]), (12, 4, 2))
        self.assertAlmostEqual(sum(result["split_ms"].values()), result["ms_per_step"], places=9)
        self.assertAlmostEqual(12 * 4 * 0.01 / result["wall_s"], result["realtime_factor"], places=6)
        self.assertGreater(result["scaling"], 0)
        self.assertGreater(result["raw_scaling"], 0)
        self.assertIn(result["allocations_per_step"], (0, None))
        one_thread = self.bench("--scene", "reach", "--vision", "off", "--steps", "3", "--worlds", "2")
        self.assertNotIn("scaling", one_thread)

    def test_every_kind_of_actuation_is_measured_without_allocating(self):
        # A warning would say that the twin without senses went another way.
        for actuation in ("position", "muscle", "mujoco-muscle"):
            result = self.bench("--vision", "off", "--steps", "120", "--actuation", actuation)
            self.assertGreater(result["raw_physics_us"], 0)
            self.assertIn(result["allocations_per_step"], (0, None))

    def test_what_a_cost_depends_on(self):
        result = self.bench("--vision", "off", "--steps", "2", "--scene", "playdate")
        # Two infants, and no ball: 2 x (6 + 44), see test_several_infants for joints that do not act.
        self.assertEqual((result["agents"], result["frame_skip"], result["pixels"]), (2, 2, 0))
        self.assertEqual(self.bench("--vision", "off", "--steps", "2")["degrees_of_freedom"], 65)

    def test_more_threads_than_worlds(self):
        self.assertIn("--threads", self.mimo_bench("--worlds", "2", "--threads", "3", code=1))

    def test_other_scenes_can_be_measured(self):
        self.assertEqual(self.bench("--scene", "free", "--vision", "off", "--steps", "3")["steps"], 3)

    def test_wrong_usage(self):
        self.assertIn("mimo-bench --paper", self.mimo_bench("--help"))
        self.assertRegex(self.mimo_bench("--version"), r"^mimo-bench \d+\.\d+\.\d+")
        for arguments in (["--steps", "0"], ["--worlds", "0"], ["--threads", "0"], ["bench"]):
            with self.subTest(arguments=arguments):
                self.assertIn("--help", self.mimo_bench(*arguments, code=2))
        for option, unknown in (("--scene", "moon"), ("--body", "octopus")):
            self.assertIn(unknown, self.mimo_bench("--vision", "off", option, unknown, code=1))
        self.assertIn("no folder", self.mimo_bench("--paper", "--csv", "no/a.csv", code=1))

    def test_without_json_it_prints_a_table(self):
        self.assertRegex(self.mimo_bench("--vision", "off", "--steps", "3"), r"ms_per_step +\d")
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
