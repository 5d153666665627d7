"""`mimo info`: what there is in a scene."""
import csv
import json
import math
import unittest

from program import COUNTS, GOLDEN, Case, needs_renderer


class Info(Case):
    def info(self, *arguments):
        return json.loads(self.mimo("info", "--vision", "off", "--json", *arguments))

    def test_numbers_of_the_config_are_set_by_their_names(self):
        usual = self.info("--scene", "reach")["gears"]
        weak = self.info("--scene", "reach", "--set", "strength=0.5")["gears"]
        self.assertEqual(usual.keys(), weak.keys())
        for name, gear in usual.items():
            self.assertAlmostEqual(weak[name], 0.5 * gear)
        self.assertIn("strength", self.mimo("info", "--set", "strenght=1", code=2))
        self.assertIn("NAME=VALUE", self.mimo("info", "--set", "strength", code=2))
        self.assertIn("NAME=VALUE", self.mimo("info", "--set", "touch=0.5", code=2))
        self.assertIn("0.01 to 100", self.mimo("info", "--set", "strength=1000", code=1))

    def test_tasks_with_what_they_measure(self):
        """WHO's windows of achievement: Acta Paediatr Suppl 2006, 450:86-95, abstract."""
        listed = json.loads(self.mimo("info", "--tasks", "--json"))
        self.assertIn("reach", [one["task"] for one in listed if one["measure"] is None])
        scenes = {one["scene"]: one for one in listed if one["measure"] is not None}
        self.assertGreaterEqual(len(scenes), 20)
        windows = {"sit": (3.8, 9.2), "stand-with-support": (4.8, 11.4), "crawl": (5.2, 13.5),
                   "walk-with-help": (5.9, 13.7), "stand": (6.9, 16.9), "walk": (8.2, 17.6)}
        for name, (first, last) in windows.items():
            self.assertEqual((scenes[name]["norm"]["early_months"], scenes[name]["norm"]["late_months"]), (first, last))
            self.assertIn("WHO", scenes[name]["source"])
        for name, one in scenes.items():
            self.assertEqual(one["task"], "behaviour", name)
            self.assertTrue(one["about"] and one["source"], name)
            self.assertIn(one["unit"], ("m", "deg", "times", ""), name)
            if one["source"].startswith("not found"):
                self.assertIsNone(one["norm"]["months"], name)
        self.assertEqual((scenes["sit"]["hold_seconds"], scenes["stand"]["hold_seconds"]), (10, 10))
        self.assertRegex(self.mimo("info", "--tasks"), r"sit +sits without support +tilt upper_body z +at most 45 deg for 10 s")
        one = json.loads(self.mimo("info", "--tasks", "--json", "--scene", "walk"))
        self.assertEqual([it["scene"] for it in one], ["walk"])
        self.assertIn("describes no behaviour", self.mimo("info", "--tasks", "--scene", "reach", code=1))

    def test_eyes_and_nerves_of_an_age(self):
        """Facts of the eyes by their table; delays grow with the distance from the head and shrink with age."""
        newborn, year = (self.info("--scene", "free", "--age", age) for age in ("0", "12"))
        self.assertAlmostEqual(newborn["vision"]["acuity_cpd"], 0.70)
        self.assertAlmostEqual(newborn["vision"]["peak_contrast"], 2.0)
        self.assertAlmostEqual(year["vision"]["acuity_cpd"], 7.47)
        late = newborn["delays_s"]
        self.assertLess(late["face"], late["chest"])
        self.assertLess(late["upper_arm"], late["hand"])
        self.assertLess(late["hand"], late["foot"])
        self.assertAlmostEqual(late["hand"] - late["motor_hand"], 0.004)
        for part, seconds in year["delays_s"].items():
            self.assertLess(seconds, late[part], part)

    def test_counts_and_mass_of_the_benchmark_scene(self):
        info = self.info()
        self.assertEqual({key: info[key] for key in COUNTS}, COUNTS)
        self.assertEqual(info["touch_sensors"], 5685)
        self.assertEqual(self.info("--touch", "off")["touch_sensors"], 0)
        self.assertGreater(self.info("--touch", "2")["touch_sensors"], 3.5 * 5685)
        self.assertAlmostEqual(info["mass_kg"], 10.90487, places=5)
        self.assertAlmostEqual(info["height_m"], 0.778, places=3)
        self.assertEqual(info["versions"]["mujoco"], "2.2.2")
        self.assertRegex(info["versions"]["libmimo"], r"^\d+\.\d+\.\d+(-rc\d+)?$")

    def test_tasks_are_described_as_make_gives_them(self):
        # Of the paper's experiments, as the original's environments have them; rollover's are all motors but the eyes'.
        # BabyBench's as in its configurations for self-touch and hand regard.
        motors = {"reach": 8, "standup": 27, "selfbody": 8, "catch": 40, "rollover": 38, "babybench-crib": 30,
                  "babybench-cubes": 17}
        senses = {"reach": {"proprioception"}, "standup": {"proprioception", "vestibular"},
                  "selfbody": {"proprioception", "touch", "task"}, "catch": {"proprioception", "touch", "task"},
                  "rollover": {"proprioception", "vestibular", "touch"},
                  "babybench-crib": {"proprioception", "vestibular", "touch"},
                  "babybench-cubes": {"proprioception", "vision"}}
        tasks = {"babybench-crib": "selftouch", "babybench-cubes": "handregard"}
        for scene in motors:
            info = json.loads(self.mimo("info", "--json", "--scene", scene))
            self.assertEqual(len(info["actions"]), motors[scene], scene)
            self.assertEqual({field["name"].split("/")[0] for field in info["observation_fields"]}, senses[scene], scene)
            self.assertEqual(info["task"], tasks.get(scene, scene))
            self.assertEqual(info["frame_skip"], 1 if scene == "selfbody" or scene in tasks else 2)
        elbow = {action["name"]: action for action in json.loads(self.mimo("info", "--json", "--scene", "reach"))["actions"]}
        self.assertAlmostEqual(elbow["act:right_elbow"]["high"], 0.83, places=6)
        self.assertIn("act:right_elbow", self.mimo("info", "--scene", "reach"))

    def test_torques_that_are_felt_in_catch(self):
        # docs/differences.md: all sensors of the body, as in the original's scenes of it; its catch has 19 of them.
        sensors = csv.DictReader((GOLDEN / "v2_benchmark/sensors.csv").read_text().splitlines())
        self.assertEqual(sum(sensor["type"] == "torque" for sensor in sensors), 53)
        fields = {field["name"]: field["shape"] for field in self.info("--scene", "catch")["observation_fields"]}
        self.assertEqual(fields["proprioception/torque"], [53, 3])

    @needs_renderer
    def test_options_change_what_make_gives(self):
        info = json.loads(self.mimo("info", "--json", "--scene", "reach", "--vision", "16", "--touch", "1"))
        fields = {field["name"]: field["shape"] for field in info["observation_fields"]}
        self.assertEqual(fields["vision/eye_left"], [16, 16, 3])
        self.assertGreater(info["touch_sensors"], 5000)

    @needs_renderer
    def test_fields_lie_side_by_side(self):
        info = json.loads(self.mimo("info", "--json"))
        self.assertEqual({key: info[key] for key in COUNTS}, COUNTS)
        fields = {field["name"]: field for field in info["observation_fields"]}
        self.assertEqual(fields["vision/eye_left"]["shape"], [256, 256, 3])
        self.assertEqual(fields["vision/eye_left"]["dtype"], "uint8")
        self.assertIn("proprioception/position", fields)
        size = {"uint8": 1, "int32": 4, "float32": 4, "float64": 8}
        end = 0
        for field in info["observation_fields"]:
            self.assertEqual(field["offset"] % 64, 0)
            self.assertGreaterEqual(field["offset"], end)
            # Of a step of two physics steps of 5 ms: its end, or where the last one started.
            self.assertEqual((field["start"], field["period"]), (field["end"], 0.01))
            self.assertIn(field["end"], (0, -0.005))
            end = field["offset"] + size[field["dtype"]] * math.prod(field["shape"])
        self.assertLessEqual(end, info["observation_bytes"])

    def test_without_json_it_prints_a_table(self):
        text = self.mimo("info", "--vision", "off")
        self.assertRegex(text, r"nq +68\n")
        self.assertIn("proprioception/position", text)

    def test_counts_of_scenes_with_several_infants(self):
        info = self.info("--scene", "playdate")
        self.assertEqual((info["agents"], info["nu"], info["touch_sensors"]), (2, 50, 2 * 5685))
        self.assertAlmostEqual(info["mass_kg"], 10.90487, places=5)
        room = self.write("room.xml", '<mujoco><custom><text name="mimo:infants" data="a b c"/><numeric name="mimo:place" '
                          'data="0 0 1 1 0 0 0 1 0 1 1 0 0 0 2 0 1 1 0 0 0"/></custom></mujoco>')
        self.assertEqual(self.info("--scene", room, "--body", "mitten")["nu"], 3 * 44)

    def test_counts_of_the_body_with_five_fingers(self):
        info = self.info("--body", "fingers")
        # Counts and mass: the original's tables (tests/golden/v2_benchmark); touch: its 5299 sensors (touch_counts.json).
        self.assertEqual((info["nq"], info["nv"], info["nu"]), (112, 109, 88))
        self.assertEqual((info["bodies"], info["joints"], info["geoms"]), (58, 94, 77))
        self.assertAlmostEqual(info["mass_kg"], 10.8999078, places=6)
        self.assertAlmostEqual(info["height_m"], 0.7781, places=6)
        self.assertAlmostEqual(info["touch_sensors"], 5299, delta=0.015 * 5299)

    def test_a_body_that_the_scene_is_not_made_for(self):
        self.assertIn("made for mitten only", self.mimo("info", "--scene", "standup", "--body", "fingers", code=1))

    def test_files_with_and_without_an_infant(self):
        room = self.write("room.xml", '<mujoco><worldbody><geom type="plane" size="1 1 1"/></worldbody></mujoco>')
        empty = self.info("--scene", room)
        self.assertEqual((empty["nq"], empty["bodies"], empty["mass_kg"]), (0, 1, 0))  # all in it is an agent
        self.assertEqual(empty["observation_fields"], [])
        furnished = self.info("--scene", room, "--body", "mitten")
        self.assertEqual((furnished["nq"], furnished["nu"]), (54, 44))
        own = self.write("own.xml", '<mujoco><include file="mimo/mitten.xml"/></mujoco>')
        self.assertEqual(self.info("--scene", own)["nu"], 44)
        self.assertEqual(self.info("--scene", own, "--body", "mitten")["nu"], 44)

    def test_a_document_that_does_not_compile_is_refused(self):
        broken = self.write("broken.xml", "<mujoco><worldbody><geom/></worldbody></mujoco>")
        self.mimo("info", "--scene", broken, code=1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
