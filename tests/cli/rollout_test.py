"""`mimo rollout`: recorded controls in, recorded numbers out."""
import csv
import json
import re
import subprocess
import unittest

from program import GOLDEN, PROGRAM, Case


class Rollout(Case):
    @classmethod
    def setUpClass(cls):
        cls.golden = json.loads((GOLDEN / "trajectories_v1.json").read_text())

    def rollout(self, controls, *arguments):
        self.mimo("rollout", "--controls", controls, "--out", "states.json", *arguments)
        return json.loads((self.folder / "states.json").read_text())["states"]

    def assert_close(self, states, golden, tolerance):
        self.assertEqual([s["step"] for s in states], [g["step"] for g in golden])
        for state, expected in zip(states, golden):
            for quantity in ("qpos", "qvel"):
                self.assertEqual(set(state[quantity]), set(expected[quantity]))
                for joint, values in expected[quantity].items():
                    self.assertEqual(len(values), len(state[quantity][joint]))
                    worst = max(abs(a - b) for a, b in zip(values, state[quantity][joint]))
                    self.assertLess(worst, tolerance, "%s of %s, step %d" % (quantity, joint, state["step"]))

    def zeros(self, rows):
        return self.write("zeros.csv", "act:hip_bend\n" + "0\n" * rows)

    def golden_controls(self, rows):
        lines = (GOLDEN / "controls_v1.csv").read_text().splitlines()[:rows + 1]
        return self.write("controls.csv", "\n".join(lines) + "\n")

    def test_a_passive_fall_agrees_with_the_recorded_one(self):
        # Later than step 120 contacts make the trajectory chaotic.
        golden = [g for g in self.golden["passive_fall"] if g["step"] <= 120]
        for jacobian in ("dense", "sparse"):
            self.assert_close(self.rollout(self.zeros(120), "--every", "20", "--jacobian", jacobian), golden, 1e-9)

    def test_floating_agrees_with_the_recorded_numbers(self):
        golden = self.golden["floating_no_contact_no_gravity_random_control"]
        for jacobian in ("dense", "sparse"):
            states = self.rollout(self.golden_controls(200), "--every", "20", "--no-contact", "--no-gravity",
                                  "--jacobian", jacobian)
            self.assert_close(states, golden, 1e-9)

    def test_default_and_dense_agree_until_a_contact_jumps(self):
        # docs/guide/reproducibility.md
        dense, default = (self.rollout(self.golden_controls(400), *options) for options in (("--jacobian", "dense"), ()))
        worst = [max(abs(a - b) for joint in one["qpos"] for a, b in zip(one["qpos"][joint], two["qpos"][joint]))
                 for one, two in zip(dense, default)]
        self.assertLess(max(worst[:86]), 1e-12)
        self.assertGreater(worst[400], 1e-6)

    def test_which_states_are_kept(self):
        self.assertEqual([s["step"] for s in self.rollout(self.zeros(3))], [0, 1, 2, 3])
        self.assertEqual([s["step"] for s in self.rollout(self.zeros(5), "--every", "2")], [0, 2, 4, 5])
        self.assertEqual([s["step"] for s in self.rollout(self.zeros(4), "--every", "2")], [0, 2, 4])
        self.assertEqual([s["step"] for s in self.rollout(self.zeros(2), "--every", "9")], [0, 2])

    def test_poses_belong_to_their_joints(self):
        for state in self.rollout(self.zeros(10), "--every", "5"):
            self.assertEqual(state["xpos"]["world"], [0, 0, 0])
            self.assertEqual(len(state["xpos"]), 26)
            self.assertEqual(state["xpos"]["mimo_location"], state["qpos"]["mimo_orientation"][:3])
            self.assertEqual(state["xpos"]["test_object1"], state["qpos"]["free:test_object1"][:3])

    def test_an_elbow_follows_its_target_and_its_stronger_muscle(self):
        # Without gravity and contacts the elbow goes where it is told to, and where the stronger muscle pulls it.
        elbow, floating = "robot:left_elbow", ("--no-gravity", "--no-contact")
        target = self.write("target.csv", "act:left_elbow\n" + "-1\n" * 300)
        states = self.rollout(target, "--actuation", "position", *floating, "--every", "300")
        self.assertAlmostEqual(states[-1]["qpos"][elbow][0], -1, delta=0.15)
        ends = []
        for side in ("negative", "positive"):
            pull = self.write("pull.csv", "act:left_elbow/%s\n" % side + "1\n" * 40)
            ends.append(self.rollout(pull, "--actuation", "muscle", *floating, "--every", "40")[-1]["qpos"][elbow][0])
        self.assertLess(ends[0], ends[1] - 0.1)
        self.assertIn("act:left_elbow", self.mimo("rollout", "--actuation", "muscle", "--controls", target, "--out",
                                                  "a.json", code=1))

    def test_keeping_states_does_not_change_them(self):
        often = self.rollout(self.golden_controls(60))
        seldom = self.rollout(self.golden_controls(60), "--every", "30")
        self.assertEqual(seldom, [often[0], often[30], often[60]])

    def test_order_and_choice_of_columns(self):
        with open(GOLDEN / "controls_v1.csv") as file:
            rows = list(csv.reader(file))[:31]
        some = self.write("some.csv", "\n".join(",".join(row[2:5]) for row in rows))
        other = self.write("other.csv", "\r\n".join(" , ".join(row[4:1:-1]) for row in rows) + "\r\n\r\n")
        self.assertEqual(self.rollout(some), self.rollout(other))

    def test_bad_controls(self):
        cases = {"": "line 1", "\n0\n": "line 1", "act:hip_bend\n": "no rows", "act:nose\n0\n": "act:nose",
                 "act:hip_bend,act:hip_bend\n0,0\n": "two columns", "act:hip_bend,\n0,0\n": "column 2",
                 "act:hip_bend,act:hip_lean\n0,0\n0\n": "line 3", "act:hip_bend\n0\n0,0\n": "line 3",
                 "act:hip_bend\n0\nnan\n": "line 3", "act:hip_bend\ninf\n": "line 2", "act:hip_bend\nfast\n": "line 2",
                 "act:hip_bend\n0x1\n": "line 2", "act:hip_bend\n1e999\n": "line 2", "act:hip_bend\n+-1\n": "line 2",
                 "act:hip_bend\n0\n\n0\n": "line 4"}
        for text, message in cases.items():
            with self.subTest(text=text):
                controls = self.write("bad.csv", text)
                error = self.mimo("rollout", "--controls", controls, "--out", "out.json", code=1)
                self.assertIn(message, error)
                self.assertIn("bad.csv", error)
        self.assertEqual(self.files(), ["bad.csv"])

    def test_files_that_cannot_be_used(self):
        self.assertIn("none.csv", self.mimo("rollout", "--controls", "none.csv", "--out", "out.json", code=1))
        self.assertIn("no/out.json", self.mimo("rollout", "--controls", self.zeros(1), "--out", "no/out.json", code=1))

    def test_a_simulation_that_diverges_is_an_error(self):
        ball = self.write("ball.xml", """<mujoco><option timestep="10"/><worldbody><body name="arm">
            <joint name="arm" type="hinge"/><geom size=".1"/></body></worldbody>
            <actuator><motor name="push" joint="arm" gear="1e300"/></actuator></mujoco>""")
        controls = self.write("push.csv", "push\n" + "1e9\n" * 5)
        done = subprocess.run([PROGRAM, "rollout", "--scene", ball, "--controls", controls, "--out", "out.json"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertNotIn("out.json", self.files())

    def test_a_users_own_model_without_an_infant(self):
        self.write("arm.xml", """<mujoco><worldbody><body name="ball" pos="1 2 3"><freejoint/><geom size=".1"/></body>
            <body name="arm"><joint name="elbow" type="hinge"/><geom size=".1"/></body></worldbody>
            <actuator><motor name="push" joint="elbow"/></actuator></mujoco>""")
        states = self.rollout(self.write("push.csv", "push\n1\n1\n"), "--scene", "arm.xml", "--no-gravity")
        self.assertEqual(states[0]["qpos"], {"free:ball": [1, 2, 3, 1, 0, 0, 0], "elbow": [0]})
        self.assertEqual(set(states[0]["xpos"]), {"world", "ball", "arm"})
        self.assertEqual(states[2]["qpos"]["free:ball"], states[0]["qpos"]["free:ball"])
        self.assertGreater(states[2]["qpos"]["elbow"][0], 0)

    def test_a_locale_with_a_decimal_comma_changes_nothing(self):
        locales = subprocess.run(["locale", "-a"], stdout=subprocess.PIPE, universal_newlines=True).stdout
        comma = [name for name in locales.split() if re.match(r"(de|fr)_\w+\.utf-?8", name, re.I)]
        if not comma:
            self.skipTest("no locale with a decimal comma is installed")
        plain = self.rollout(self.golden_controls(20))
        self.mimo("rollout", "--controls", "controls.csv", "--out", "comma.json", env={"LC_ALL": comma[0]})
        self.assertEqual(json.loads((self.folder / "comma.json").read_text())["states"], plain)


if __name__ == "__main__":
    unittest.main(verbosity=2)
