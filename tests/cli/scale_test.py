"""`mimo bench`: how many steps a second the machine simulates, and what one thread predicts of many."""
import json
import os
import unittest

from program import Case


class Scale(Case):
    SHORT = ("--seconds", "0.01", "--worlds", "2")

    def rows(self, *arguments):
        return json.loads(self.mimo("bench", "--json", *self.SHORT, *arguments))

    def test_one_row_for_each_number_of_threads_and_kind_of_eyes(self):
        result = self.rows("--scale", "--threads", "3")
        self.assertEqual([(row["vision"], row["threads"], row["worlds"]) for row in result["rows"]],
                         [(vision, threads, 2 * threads) for vision in ("off", "64") for threads in (1, 2, 3)])
        self.assertEqual([row["threads"] for row in result["memory"]], [1, 2, 3])
        self.assertEqual((result["scene"], result["worlds_per_thread"]), ("benchmark", 2))
        if hasattr(os, "sched_getaffinity"):
            self.assertEqual(result["cores"], len(os.sched_getaffinity(0)))
        for row in result["rows"]:
            for key in ("steps_per_second", "predicted", "apart", "world_us"):
                self.assertGreater(row[key], 0, key)
            one = next(each for each in result["rows"] if each["vision"] == row["vision"])
            self.assertAlmostEqual(row["scaling"] * one["steps_per_second"], row["steps_per_second"], places=6)
        for row in result["memory"]:
            self.assertGreater(row["gb_per_second"], 0)

    @unittest.skipUnless(hasattr(os, "sched_setaffinity"), "this system has no affinity")
    def test_the_cores_are_those_that_the_program_may_use(self):
        before = os.sched_getaffinity(0)
        os.sched_setaffinity(0, {min(before)})
        try:
            result = self.rows("--vision", "off", "--scene", "reach")
        finally:
            os.sched_setaffinity(0, before)
        self.assertEqual((result["cores"], [row["threads"] for row in result["rows"]]), (1, [1]))

    def test_threads_that_wait_for_each_other_are_not_predicted_to_gain_more_than_their_number(self):
        # Two worlds a thread: the last one of a step is waited for, so less than 4, and more than 1.
        rows = self.rows("--scale", "--threads", "4", "--vision", "off")["rows"]
        one = rows[0]
        self.assertAlmostEqual(one["predicted"] / one["steps_per_second"], 1, places=9)
        gain = rows[-1]["predicted"] / one["steps_per_second"]
        self.assertGreater(gain, 1)
        self.assertLess(gain, 4)

    def test_without_scale_all_threads_and_nothing_else(self):
        result = self.rows("--threads", "2", "--vision", "off", "--scene", "reach")
        self.assertEqual(result["memory"], [])
        row, = result["rows"]
        self.assertEqual(set(row), {"vision", "threads", "worlds", "steps_per_second"})
        self.assertEqual((row["vision"], row["threads"], row["worlds"]), ("off", 2, 4))

    def test_people_get_a_table(self):
        text = self.mimo("bench", "--scale", "--threads", "1", *self.SHORT)
        self.assertRegex(text, r"eyes +threads +worlds +steps a second +x one thread +predicted +apart\n")
        self.assertRegex(text, r"\n +64 +1 +2 +\d+ +1\.00 +\d+ +\d+\n")
        self.assertRegex(text, r"GB of memory read and written a second\n +1 +\d")
        self.assertNotIn("predicted", self.mimo("bench", "--threads", "1", *self.SHORT))
        self.assertEqual(self.files(), [])

    def test_wrong_usage(self):
        for arguments in (["--threads", "0"], ["--threads", "1025"], ["--worlds", "0"], ["--worlds", "two"],
                          ["--seconds", "0"], ["--seconds", "nan"], ["--vision", "0"]):
            with self.subTest(arguments=arguments):
                self.assertIn(arguments[0], self.mimo("bench", *arguments, code=2))
        self.assertIn("moon", self.mimo("bench", "--scene", "moon", code=1))


if __name__ == "__main__":
    unittest.main(verbosity=2)
