"""Tests of the program `mimo`: what a user gets to see, write and read back.

The path of the program is in the environment as MIMO_PROGRAM. Python's standard library is all that is needed.
"""
import csv
import ctypes
import json
import math
import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

PROGRAM = os.environ.get("MIMO_PROGRAM", "mimo")
SOURCES = pathlib.Path(__file__).resolve().parent.parent.parent
GOLDEN = SOURCES / "tests/golden"


def can_draw():
    for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
        try:
            ctypes.CDLL(name)
            return True
        except OSError:
            pass
    return False


needs_renderer = unittest.skipUnless(can_draw(), "OSMesa is not installed")


def read_png(path):
    """Width, height, bits, channels and the rows of a PNG as bytes."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "not a PNG"
    at, compressed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            compressed += body
        at += 12 + length
    channels = {0: 1, 2: 3}[color]
    return width, height, bits, channels, unfilter(zlib.decompress(compressed), height, channels * bits // 8)


def unfilter(raw, height, pixel):
    stride = len(raw) // height - 1
    rows, above = [], bytes(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            a = line[x - pixel] if x >= pixel else 0
            b = above[x]
            c = above[x - pixel] if x >= pixel else 0
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            line[x] = (line[x] + (0, a, b, (a + b) // 2, nearest)[kind]) & 255
        rows.append(bytes(line))
        above = line
    return rows


def read_npy(path):
    """Type, shape and values of a .npy file."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x93NUMPY\x01\x00", "not a .npy file"
    length, = struct.unpack("<H", data[8:10])
    assert (10 + length) % 64 == 0
    header = eval(data[10:10 + length].decode(), {})
    code = {"<f4": "f", "<i4": "i"}[header["descr"]]
    count = header["shape"][0] * header["shape"][1]
    return header["descr"], header["shape"], struct.unpack("<%d%s" % (count, code), data[10 + length:])


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def mimo(self, *arguments, code=0, env=None):
        """Runs the program in an empty folder; returns its standard output, or the error line if it should fail."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, cwd=self.folder, env=dict(os.environ, **(env or {})))
        self.assertEqual(done.returncode, code, done.stderr)
        if code == 0:
            self.assertEqual(done.stderr, "")
            return done.stdout
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"\Amimo[^\n]*: [^\n]+\n\Z", "not one line")
        return done.stderr

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def files(self):
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*") if p.is_file())


class Usage(Case):
    def test_help(self):
        self.assertIn("rollout", self.mimo("--help"))
        for command in ("run", "bench", "info", "render", "rollout"):
            text = self.mimo(command, "--help")
            self.assertIn("Example", text)
            self.assertIn("mimo " + command, text)
        self.assertEqual(self.files(), [])

    def test_version(self):
        self.assertRegex(self.mimo("--version"), r"^mimo \d+\.\d+\.\d+ \(MuJoCo \d+\.\d+\.\d+\)\n$")

    def test_wrong_usage(self):
        for arguments in ([], ["walk"], ["run", "--fast"], ["run", "--seconds", "-1"], ["run", "--seconds", "soon"],
                          ["run", "--seconds", "nan"], ["run", "--seconds", "inf"], ["run", "--seconds", "-inf"],
                          ["render", "--out", "a.png", "--distance", "nan"], ["render", "--out", "a.png", "--azimuth", "nan"],
                          ["render", "--out", "a.png", "--elevation", "inf"],
                          ["render", "--out", "a.png", "--look-at", "0", "nan", "0"],
                          ["render", "--out", "a.jpg"], ["render", "--out", ".png"], ["render", "--out", "a"],
                          ["render", "--out", "a.png", "--depth", "a.jpg"], ["render", "--out", "a.png", "--segmentation", "a"],
                          ["run", "--vision", "0"], ["run", "--vision", "5000"], ["run", "--vision", "on"],
                          ["run", "--touch", "0"], ["run", "--touch", "-1"], ["run", "--touch", "many"],
                          ["run", "--touch", "nan"], ["run", "--seed", "-1"], ["run", "--seed", "18446744073709551616"],
                          ["bench", "--steps", "0"], ["bench", "--worlds", "0"], ["bench", "--threads", "0"],
                          ["render"], ["render", "--out", "a.png", "--width", "0"],
                          ["render", "--out", "a.png", "--camera", "eye_left", "--distance", "1"],
                          ["rollout", "--out", "a.json"], ["rollout", "--controls", "a.csv"],
                          ["rollout", "--controls", "a.csv", "--out", "a.json", "--jacobian", "thin"],
                          ["rollout", "--controls", "a.csv", "--out", "a.json", "--every", "0"]):
            with self.subTest(arguments=arguments):
                self.assertIn("--help", self.mimo(*arguments, code=2))
        self.assertEqual(self.files(), [])

    def test_unknown_things_are_named(self):
        commands = (["info"], ["run"], ["bench", "--vision", "off"], ["render", "--out", "a.png"])
        for command in commands:
            self.assertIn("moon", self.mimo(*command, "--scene", "moon", code=1))
            self.assertIn("moon.xml", self.mimo(*command, "--scene", "moon.xml", code=1))
            self.assertIn("octopus", self.mimo(*command, "--body", "octopus", code=1))
        self.assertEqual(self.files(), [])

    def test_places_that_cannot_be_written_are_found_before_any_work(self):
        # What would take work is missing or too long: the complaint is still about the place.
        for command in (["render", "--scene", "moon", "--out"], ["render", "--scene", "moon", "--out", "a.png", "--depth"],
                        ["bench", "--paper", "--csv"]):
            self.assertIn("no folder", self.mimo(*command, "no/a.png", code=1))
        controls = self.write("controls.csv", "act:hip_bend\n" + "0\n" * 1000000)
        self.assertIn("no folder", self.mimo("rollout", "--controls", controls, "--out", "no/a.json", code=1))
        (self.folder / "folder.png").mkdir()
        self.assertIn("is a folder", self.mimo("render", "--out", "folder.png", code=1))

    def test_the_manual_page_is_whole(self):
        page = (SOURCES / "src/cli/mimo.1").read_text()
        synopsis, explained = page[page.index(".Sh SYNOPSIS"):page.index(".Sh DESCRIPTION")], page[page.index(".Ss Options"):]
        explained = set(re.findall(r"\.It .*", explained))
        explained = {option for line in explained for option in re.findall(r"Fl -([a-z-]+)", line)}
        used = set()
        for command in ("run", "bench", "info", "render", "rollout"):
            part = re.search(r"\n\.Cm %s\n(.*?)(\n\.Nm|\Z)" % command, synopsis, re.S).group(1)
            help_text = self.mimo(command, "--help")
            options = set(re.findall(r"^ +(?:-h,)?--([a-z-]+)", help_text, re.M)) - {"help"}
            self.assertGreater(len(options), 5)
            self.assertEqual(set(re.findall(r"Fl -([a-z-]+)", part)), options, "synopsis of " + command)
            required = set(re.findall(r"^ +--([a-z-]+) .*\(required\)", help_text, re.M))
            self.assertEqual(set(re.findall(r"^\.Fl -([a-z-]+)", part, re.M)), required, "required by " + command)
            self.assertIn("\n.It Cm %s\n" % command, page)
            used |= options
        self.assertEqual(explained, used)
        for scene in re.search(r"Built-in scene \(([^)]*)", re.sub(r"\s+", " ", self.mimo("run", "--help"))).group(1).split(", "):
            self.assertIn(scene, page)

    def test_full_disk(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        with open("/dev/full", "w") as full:
            done = subprocess.run([PROGRAM, "info", "--vision", "off"], stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"cannot write", done.stderr)


class Info(Case):
    COUNTS = {"nq": 68, "nv": 65, "nu": 44, "bodies": 26, "joints": 50, "geoms": 39, "cameras": 2}

    def info(self, *arguments):
        return json.loads(self.mimo("info", "--vision", "off", "--json", *arguments))

    def test_benchmark_scene(self):
        info = self.info()
        self.assertEqual({key: info[key] for key in self.COUNTS}, self.COUNTS)
        self.assertEqual(info["touch_sensors"], 5685)
        self.assertEqual(self.info("--touch", "off")["touch_sensors"], 0)
        self.assertGreater(self.info("--touch", "2")["touch_sensors"], 3.5 * 5685)
        self.assertAlmostEqual(info["mass_kg"], 10.90487, places=5)
        self.assertAlmostEqual(info["height_m"], 0.778, places=3)
        self.assertEqual(info["versions"]["mujoco"], "2.2.2")
        self.assertRegex(info["versions"]["libmimo"], r"^\d+\.\d+\.\d+$")

    def test_tasks_are_described_as_make_gives_them(self):
        # Motors, senses and torque sensors of the paper's experiments, as the original's environments have them.
        motors = {"reach": 8, "standup": 27, "selfbody": 8, "catch": 40}
        senses = {"reach": {"proprioception"}, "standup": {"proprioception", "vestibular"},
                  "selfbody": {"proprioception", "touch", "task"}, "catch": {"proprioception", "touch", "task"}}
        for scene in motors:
            info = json.loads(self.mimo("info", "--json", "--scene", scene))
            self.assertEqual(len(info["actions"]), motors[scene], scene)
            self.assertEqual({field["name"].split("/")[0] for field in info["observation_fields"]}, senses[scene], scene)
            self.assertEqual(info["task"], scene)
            self.assertEqual(info["frame_skip"], 1 if scene == "selfbody" else 2)
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
        self.assertEqual({key: info[key] for key in self.COUNTS}, self.COUNTS)
        fields = {field["name"]: field for field in info["observation_fields"]}
        self.assertEqual(fields["vision/eye_left"]["shape"], [256, 256, 3])
        self.assertEqual(fields["vision/eye_left"]["dtype"], "uint8")
        self.assertIn("proprioception/position", fields)
        size = {"uint8": 1, "int32": 4, "float32": 4, "float64": 8}
        end = 0
        for field in info["observation_fields"]:
            self.assertEqual(field["offset"] % 64, 0)
            self.assertGreaterEqual(field["offset"], end)
            self.assertIn(field["time"], ("end", "last_start"))
            end = field["offset"] + size[field["dtype"]] * math.prod(field["shape"])
        self.assertLessEqual(end, info["observation_bytes"])

    def test_for_people(self):
        text = self.mimo("info", "--vision", "off")
        self.assertRegex(text, r"nq +68\n")
        self.assertIn("proprioception/position", text)

    def test_several_infants(self):
        info = self.info("--scene", "playdate")
        self.assertEqual((info["agents"], info["nu"], info["touch_sensors"]), (2, 50, 2 * 5685))
        self.assertAlmostEqual(info["mass_kg"], 10.90487, places=5)
        room = self.write("room.xml", '<mujoco><custom><text name="mimo:infants" data="a b c"/><numeric name="mimo:place" '
                          'data="0 0 1 1 0 0 0 1 0 1 1 0 0 0 2 0 1 1 0 0 0"/></custom></mujoco>')
        self.assertEqual(self.info("--scene", room, "--body", "mitten")["nu"], 3 * 44)

    def test_five_fingers(self):
        info = self.info("--body", "fingers")
        # Counts and mass: the original's tables (tests/golden/v2_benchmark); touch: its 5299 sensors (touch_counts.json).
        self.assertEqual((info["nq"], info["nv"], info["nu"]), (112, 109, 88))
        self.assertEqual((info["bodies"], info["joints"], info["geoms"]), (58, 94, 77))
        self.assertAlmostEqual(info["mass_kg"], 10.8999078, places=6)
        self.assertAlmostEqual(info["height_m"], 0.7781, places=6)
        self.assertAlmostEqual(info["touch_sensors"], 5299, delta=0.015 * 5299)

    def test_a_body_that_the_scene_is_not_made_for(self):
        self.assertIn("made for mitten only", self.mimo("info", "--scene", "standup", "--body", "fingers", code=1))

    def test_files(self):
        room = self.write("room.xml", '<mujoco><worldbody><geom type="plane" size="1 1 1"/></worldbody></mujoco>')
        empty = self.info("--scene", room)
        self.assertEqual((empty["nq"], empty["bodies"], empty["mass_kg"]), (0, 1, 0))  # all in it is an agent
        self.assertEqual(empty["observation_fields"], [])
        furnished = self.info("--scene", room, "--body", "mitten")
        self.assertEqual((furnished["nq"], furnished["nu"]), (54, 44))
        own = self.write("own.xml", '<mujoco><include file="mimo/mitten.xml"/></mujoco>')
        self.assertEqual(self.info("--scene", own)["nu"], 44)
        self.assertEqual(self.info("--scene", own, "--body", "mitten")["nu"], 44)

    def test_broken_file(self):
        broken = self.write("broken.xml", "<mujoco><worldbody><geom/></worldbody></mujoco>")
        self.mimo("info", "--scene", broken, code=1)


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

    def test_passive_fall(self):
        # Later than step 120 contacts make the trajectory chaotic.
        golden = [g for g in self.golden["passive_fall"] if g["step"] <= 120]
        for jacobian in ("dense", "sparse"):
            self.assert_close(self.rollout(self.zeros(120), "--every", "20", "--jacobian", jacobian), golden, 1e-9)

    def test_floating(self):
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

    def test_targets_and_muscles(self):
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

    def test_diverging_physics(self):
        ball = self.write("ball.xml", """<mujoco><option timestep="10"/><worldbody><body name="arm">
            <joint name="arm" type="hinge"/><geom size=".1"/></body></worldbody>
            <actuator><motor name="push" joint="arm" gear="1e300"/></actuator></mujoco>""")
        controls = self.write("push.csv", "push\n" + "1e9\n" * 5)
        done = subprocess.run([PROGRAM, "rollout", "--scene", ball, "--controls", controls, "--out", "out.json"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertNotIn("out.json", self.files())

    def test_users_model(self):
        self.write("arm.xml", """<mujoco><worldbody><body name="ball" pos="1 2 3"><freejoint/><geom size=".1"/></body>
            <body name="arm"><joint name="elbow" type="hinge"/><geom size=".1"/></body></worldbody>
            <actuator><motor name="push" joint="elbow"/></actuator></mujoco>""")
        states = self.rollout(self.write("push.csv", "push\n1\n1\n"), "--scene", "arm.xml", "--no-gravity")
        self.assertEqual(states[0]["qpos"], {"free:ball": [1, 2, 3, 1, 0, 0, 0], "elbow": [0]})
        self.assertEqual(set(states[0]["xpos"]), {"world", "ball", "arm"})
        self.assertEqual(states[2]["qpos"]["free:ball"], states[0]["qpos"]["free:ball"])
        self.assertGreater(states[2]["qpos"]["elbow"][0], 0)

    def test_comma_locale(self):
        locales = subprocess.run(["locale", "-a"], stdout=subprocess.PIPE, universal_newlines=True).stdout
        comma = [name for name in locales.split() if re.match(r"(de|fr)_\w+\.utf-?8", name, re.I)]
        if not comma:
            self.skipTest("no locale with a decimal comma is installed")
        plain = self.rollout(self.golden_controls(20))
        self.mimo("rollout", "--controls", "controls.csv", "--out", "comma.json", env={"LC_ALL": comma[0]})
        self.assertEqual(json.loads((self.folder / "comma.json").read_text())["states"], plain)


@needs_renderer
class Render(Case):
    def test_eye(self):
        self.mimo("render", "--camera", "eye_left", "--width", "64", "--height", "48", "--out", "eye.png",
                  "--depth", "depth.png", "--segmentation", "ids.png")
        width, height, bits, channels, rows = read_png(self.folder / "eye.png")
        self.assertEqual((width, height, bits, channels), (64, 48, 8, 3))
        self.assertGreater(len(set(rows)), 10)
        self.assertEqual(read_png(self.folder / "depth.png")[:4], (64, 48, 16, 1))
        self.assertEqual(read_png(self.folder / "ids.png")[:4], (64, 48, 8, 3))
        self.assertEqual(self.files(), ["depth.png", "eye.png", "ids.png"])

    def test_numbers(self):
        self.mimo("render", "--camera", "eye_left", "--width", "64", "--height", "48", "--out", "eye.png",
                  "--depth", "depth.npy", "--segmentation", "ids.npy")
        kind, shape, depth = read_npy(self.folder / "depth.npy")
        self.assertEqual((kind, shape), ("<f4", (48, 64)))
        kind, shape, ids = read_npy(self.folder / "ids.npy")
        self.assertEqual((kind, shape), ("<i4", (48, 64)))
        self.assertLess(max(ids), Info.COUNTS["geoms"])
        self.assertGreater(len(set(ids)), 2)
        # The box's face is one metre ahead: 1 m + the eye's place - half the box.
        seen = [d for d, i in zip(depth, ids) if i >= 0]
        self.assertGreater(min(seen), 0.5)
        self.assertLess(min(seen), 1.0)

    def test_faces(self):
        pictures = set()
        for face in ("neutral", "enjoyment", "sadness", "surprise", "disgust", "anger", "fear"):
            self.mimo("render", "--face", face, "--look-at", "0", "0", "0.77", "--distance", "0.4", "--azimuth", "180",
                      "--elevation", "0", "--width", "64", "--height", "64", "--touch", "off", "--out", "a.png")
            pictures.add((self.folder / "a.png").read_bytes())
        self.assertEqual(len(pictures), 7)

    def test_depth_in_both_formats_agrees(self):
        for name in ("depth.png", "depth.npy"):
            self.mimo("render", "--width", "32", "--height", "24", "--elevation", "0", "--out", "a.png", "--depth", name,
                      "--segmentation", "ids.npy")
        rows = read_png(self.folder / "depth.png")[4]
        metres = read_npy(self.folder / "depth.npy")[2]
        ids = read_npy(self.folder / "ids.npy")[2]
        self.assertIn(-1, ids)
        millimetres = [value for row in rows for value in struct.unpack(">32H", row)]
        for mm, m, i in zip(millimetres, metres, ids):
            self.assertAlmostEqual(mm, m * 1000 if i >= 0 and m < 65.5 else 0, delta=0.51)

    def test_free_camera(self):
        self.mimo("render", "--out", "a.png")
        self.assertEqual(read_png(self.folder / "a.png")[:2], (640, 480))
        self.mimo("render", "--look-at", "0", "-0.1", "0.5", "--distance", "2", "--azimuth", "-90", "--elevation", "-10",
                  "--width", "64", "--height", "64", "--out", "b.png")
        self.assertEqual(read_png(self.folder / "b.png")[:2], (64, 64))

    def test_the_free_camera_stays_in_a_small_room(self):
        walls = "".join('<geom type="box" size="%s" pos="%s"/>' % wall for wall in (
            (".05 2 2", "1.1 0 0"), (".05 2 2", "-1.1 0 0"), ("2 .05 2", "0 1.1 0"), ("2 .05 2", "0 -1.1 0")))
        for name, room in (("world.xml", walls), ("body.xml", "<body>" + walls + "</body>")):
            self.write(name, '<mujoco><include file="mimo/mitten.xml"/><worldbody><light pos="0 0 3"/>%s</worldbody></mujoco>' % room)
            self.mimo("render", "--scene", name, "--width", "160", "--height", "120", "--out", "a.png", "--segmentation", "a.npy")
            ids = read_npy(self.folder / "a.npy")[2]
            self.assertGreater(len(set(ids)), 15)  # walls and background are five

    def test_touch(self):
        # A ball that lies on the head of an infant: sensors and forces change the picture of it.
        self.write("ball.xml", """<mujoco><include file="mimo/mitten.xml"/><worldbody><light pos="0 0 3"/>
            <body pos=".008 0 .74"><freejoint/><geom size=".03"/></body></worldbody></mujoco>""")
        view = ("--scene", "ball.xml", "--look-at", "0", "0", ".7", "--distance", ".4", "--width", "80", "--height", "60")
        for out, touch in (("a.png", "off"), ("b.png", "1"), ("c.png", "1"), ("d.png", "0.5")):
            self.mimo("render", *view, "--touch", touch, "--out", out)
        a, b, c, d = (read_png(self.folder / name)[4] for name in ("a.png", "b.png", "c.png", "d.png"))
        self.assertEqual(b, c)
        self.assertNotEqual(a, b)
        self.assertNotEqual(b, d)

    def test_how_pictures_are_made(self):
        view = ("render", "--width", "64", "--height", "48", "--renderer", "ray")
        quality = {"plain": (), "smooth": ("--samples", "16"), "threads": ("--render-threads", "3"), "all": ("--effects", "shadows,reflections,sky,haze"),
                   "bare": ("--effects", "none"), "fog": ("--effects", "fog,shadows,reflections,sky,haze")}
        for name, options in quality.items():
            self.mimo(*view, *options, "--out", name + ".png")
        pictures = {name: read_png(self.folder / (name + ".png"))[4] for name in quality}
        self.assertEqual(pictures["plain"], pictures["threads"])
        self.assertEqual(pictures["plain"], pictures["all"])
        for name in ("smooth", "bare", "fog"):
            self.assertNotEqual(pictures["plain"], pictures[name], name)
        self.assertNotEqual(pictures["plain"][0][:3], bytes(3))
        self.assertEqual(pictures["bare"][0][:3], bytes(3))  # no sky

    def test_errors(self):
        for option, value in (("--samples", "3"), ("--effects", "shadows,glitter"), ("--effects", ","), ("--render-threads", "0")):
            self.assertIn(option, self.mimo("render", option, value, "--out", "a.png", code=2))
        self.assertIn("eye_third", self.mimo("render", "--camera", "eye_third", "--out", "a.png", code=1))
        self.assertIn("no/a.png", self.mimo("render", "--out", "no/a.png", code=1))
        self.assertIn("crayon", self.mimo("render", "--renderer", "crayon", "--out", "a.png", code=1))
        self.assertEqual(self.files(), [])


class Run(Case):
    PICTURES = ["pictures/%s%s.png" % (when, what) for when in ("", "start_")
                for what in ("anaglyph", "left", "outside", "right", "touch")]

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
                for what in ("anaglyph", "left", "right")]
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

    def test_who_ignores_interrupts_goes_on(self):
        done = subprocess.Popen([PROGRAM, "run", "--seconds", "2", "--vision", "off", "--touch", "off", "--out", "p"],
                                stdout=subprocess.PIPE, universal_newlines=True, cwd=self.folder,
                                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
        done.send_signal(signal.SIGINT)
        text = done.communicate(timeout=60)[0]
        self.assertEqual(done.returncode, 0)
        self.assertIn("2.00 s of scene", text)

    def test_without_eyes(self):
        text = self.mimo("run", "--seconds", "0.1", "--vision", "off", "--out", "p")
        self.assertNotIn("vision/", text)
        self.assertNotIn("p/left.png", self.files())

    def test_room_without_infant(self):
        self.write("room.xml", '<mujoco><worldbody><body><freejoint/><geom size=".1"/></body></worldbody></mujoco>')
        self.assertIn("real time", self.mimo("run", "--scene", "room.xml", "--seconds", "0.1", "--out", "p"))

    def test_folder_that_cannot_be_made(self):
        self.write("file", "")
        self.mimo("run", "--seconds", "0.1", "--vision", "off", "--out", "file/p", code=1)


class Bench(Case):
    KEYS = {"steps", "wall_s", "realtime_factor", "ms_per_step", "split_ms", "touch_sensors", "mean_contacts",
            "raw_physics_us", "reference_us", "allocations_per_step", "step_vs_raw"}

    def bench(self, *arguments):
        return json.loads(self.mimo("bench", "--json", *arguments))

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

    def test_without_touch(self):
        result = self.bench("--vision", "off", "--touch", "off", "--steps", "3")
        self.assertEqual((result["touch_sensors"], result["split_ms"]["touch"]), (0, 0))

    def test_a_step_allocates_nothing(self):
        allocations = self.bench("--vision", "off", "--steps", "200")["allocations_per_step"]
        if allocations is None:
            self.skipTest("allocations cannot be counted in this build")
        self.assertEqual(allocations, 0)

    @needs_renderer
    def test_vision_is_counted(self):
        self.assertGreater(self.bench("--vision", "32", "--steps", "5")["split_ms"]["vision"], 0)

    def test_many_worlds(self):
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

    def test_actuation(self):
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
        self.assertIn("--threads", self.mimo("bench", "--worlds", "2", "--threads", "3", code=1))

    def test_other_scenes(self):
        self.assertEqual(self.bench("--scene", "free", "--vision", "off", "--steps", "3")["steps"], 3)

    def test_for_people(self):
        self.assertRegex(self.mimo("bench", "--vision", "off", "--steps", "3"), r"ms_per_step +\d")
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[1:]])
