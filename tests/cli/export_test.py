"""`mimo export --gltf`: the file is read here as glTF 2.0's specification says, and by Khronos' validator where that is
installed (npm install gltf-validator; its folder node_modules in NODE_PATH).

`mimo export --html`: the recording is taken out of the page again."""
import base64
import ctypes.util
import decimal
import html.parser
import json
import math
import shutil
import struct
import subprocess
import sys
import unittest

from program import COUNTS, Case, needs_hdf5, read_png

WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
VALIDATE = """const validator = require("gltf-validator"), file = require("fs").readFileSync(process.argv[1]);
validator.validateBytes(new Uint8Array(file)).then(report => console.log(JSON.stringify(report.issues)));"""


class Glb:
    def __init__(self, path):
        data = path.read_bytes()
        magic, version, length = struct.unpack("<4sII", data[:12])
        assert (magic, version, length) == (b"glTF", 2, len(data))
        size, kind = struct.unpack("<I4s", data[12:20])
        assert kind == b"JSON"
        self.json = json.loads(data[20:20 + size])
        rest, kind = struct.unpack("<I4s", data[20 + size:28 + size])
        assert kind == b"BIN\0" and len(data) == 28 + size + rest
        self.data = data[28 + size:]

    def view(self, index):
        view = self.json["bufferViews"][index]
        return self.data[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]

    def numbers(self, index):
        accessor = self.json["accessors"][index]
        count, width = accessor["count"], WIDTH[accessor["type"]]
        kind = {5126: "f", 5125: "I"}[accessor["componentType"]]
        values = struct.unpack("<%d%s" % (count * width, kind), self.view(accessor["bufferView"]))
        return [values[i:i + width] for i in range(0, len(values), width)]

    def node(self, name):
        return next(node for node in self.json["nodes"] if node["name"] == name and "mesh" not in node)


def nearer_number(x, wrong):
    """Whether a number beside `wrong` is nearer to the sine of x, by the series in 60 digits."""
    with decimal.localcontext(decimal.Context(prec=60)):
        x, total, term, n = decimal.Decimal(x), decimal.Decimal(0), decimal.Decimal(x), 1
        while abs(term) > decimal.Decimal("1e-50"):
            total, term, n = total + term, -term * x * x / ((n + 1) * (n + 2)), n + 2
        off = abs(decimal.Decimal(wrong) - total)
        return any(abs(decimal.Decimal(math.nextafter(wrong, end)) - total) < off for end in (-2, 2))


class Page(html.parser.HTMLParser):
    """The elements of a page, and what its scripts have, by their ids."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.scripts, self.texts, self.last = [], {}, {}, None
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.last = dict(attrs).get("id") if tag == "script" else None
        if self.last:
            self.scripts[self.last] = dict(attrs)

    def handle_data(self, data):
        if self.last:
            self.texts.setdefault(self.last, data)

    def inside(self, script):
        return base64.b64decode(self.texts[script], validate=True)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def placed(node, points):
    """glTF's quaternions are x y z w: p + 2 v x (v x p + w p)."""
    *axis, w = node["rotation"]
    turned = []
    for p in points:
        inner = [c + w * x for c, x in zip(cross(axis, p), p)]
        turned.append([x + 2 * c + t for x, c, t in zip(p, cross(axis, inner), node["translation"])])
    return turned


class Export(Case):
    def test_a_gltf_file_holds_every_geom_and_body(self):
        self.mimo("export", "--gltf", "a.glb")
        file = Glb(self.folder / "a.glb")
        meshes = [node for node in file.json["nodes"] if "mesh" in node]
        self.assertEqual(len(meshes), COUNTS["geoms"])
        for part in (mesh["primitives"][0] for mesh in file.json["meshes"]):
            positions = file.numbers(part["attributes"]["POSITION"])
            self.assertLess(max(i for i, in file.numbers(part["indices"])), len(positions))
            self.assertEqual(len(file.numbers(part["attributes"]["NORMAL"])), len(positions))
        for image in file.json["images"]:
            self.assertEqual(file.view(image["bufferView"])[:8], b"\x89PNG\r\n\x1a\n")
        rough = [m["pbrMetallicRoughness"]["roughnessFactor"] for m in file.json["materials"]]
        self.assertTrue(all(0 < one <= 1 for one in rough))

    def test_faces_of_cubes_do_not_bleed(self):
        """Mipmaps mix a border with what is behind it: each of the six faces, one above the other, has a margin of an
        eighth of its size, so that on a face of 1.25 edges texcoords lie between 0.125 / 1.25 and 1.125 / 1.25."""
        self.mimo("export", "--gltf", "a.glb")
        file = Glb(self.folder / "a.glb")
        (head,) = [mesh for mesh in file.json["meshes"] if mesh["name"] == "head"]
        part = head["primitives"][0]
        texcoords = file.numbers(part["attributes"]["TEXCOORD_0"])
        for u, v in texcoords:
            for at in (u, 6 * v % 1):
                self.assertGreater(at, 0.1)
                self.assertLess(at, 0.9)
        self.assertEqual({int(6 * v) for _, v in texcoords}, set(range(6)))
        surface = file.json["materials"][part["material"]]["pbrMetallicRoughness"]
        image = file.json["images"][file.json["textures"][surface["baseColorTexture"]["index"]]["source"]]
        (self.folder / "head.png").write_bytes(file.view(image["bufferView"]))
        width, height, _, _, rows = read_png(self.folder / "head.png")
        self.assertEqual((width, height), (320, 6 * 320))  # of 256 pixels
        size = len(rows[0]) // 320
        for face in range(6):
            pixels = rows[320 * face:320 * (face + 1)]
            self.assertEqual({pixels[row] for row in range(32)}, {pixels[32]})  # borders are repeated
            self.assertEqual({pixels[row] for row in range(288, 320)}, {pixels[287]})
            middle = pixels[160]
            self.assertEqual(middle[:32 * size], middle[32 * size:33 * size] * 32)

    def test_things_lie_where_the_scene_has_them_in_gltfs_frame(self):
        """Where the ball of a scene of known numbers lies: in glTF x is to the left, y up, z forward."""
        (self.folder / "room.xml").write_text(
            "<mujoco><worldbody><geom name='floor' type='plane' size='2 3 1' rgba='.5 .2 1 .25'/>"
            "<body name='ball' pos='1 2 3' euler='10 20 30'><freejoint/>"
            "<geom name='ball' size='.25' pos='0 0 .5'/></body></worldbody></mujoco>")
        self.mimo("export", "--scene", "room.xml", "--gltf", "a.glb")
        file = Glb(self.folder / "a.glb")
        body = file.node("ball")
        for place, expected in zip(body["translation"], (2, 3, 1)):
            self.assertAlmostEqual(place, expected, places=5)
        geom = file.json["nodes"][body["children"][0]]
        part = file.json["meshes"][geom["mesh"]]["primitives"][0]
        points = placed(body, placed(geom, file.numbers(part["attributes"]["POSITION"])))
        middle = placed(body, placed(geom, [(0, 0, 0)]))[0]
        self.assertAlmostEqual(math.dist(middle, body["translation"]), 0.5, places=5)
        # Turned by 10 degrees about x, then 20 about y, then 30 about z: what was up is now at these numbers of ours.
        up = (math.sin(math.radians(20)), -math.sin(math.radians(10)) * math.cos(math.radians(20)),
              math.cos(math.radians(10)) * math.cos(math.radians(20)))
        for place, expected in zip(middle, (2 + up[1] / 2, 3 + up[2] / 2, 1 + up[0] / 2)):
            self.assertAlmostEqual(place, expected, places=5)
        self.assertTrue(all(abs(math.dist(p, middle) - 0.25) < 1e-5 for p in points))
        floor = next(m for m in file.json["materials"] if m.get("alphaMode") == "BLEND")
        color = floor["pbrMetallicRoughness"]["baseColorFactor"]
        # IEC 61966-2-1, where a screen's level is linear light.
        for value, expected in zip(color, ((0.555 / 1.055) ** 2.4, (0.255 / 1.055) ** 2.4, 1, 0.25)):
            self.assertAlmostEqual(value, expected, places=6)

    def test_seconds_add_an_animation_of_the_bodies(self):
        self.mimo("export", "--gltf", "a.glb", "--seconds", "0.5", "--segments", "8")
        file = Glb(self.folder / "a.glb")
        animation, = file.json["animations"]
        times = [t for t, in file.numbers(animation["samplers"][0]["input"])]
        self.assertEqual(len(times), 51)  # steps of 10 ms
        self.assertAlmostEqual(times[-1], 0.5, places=6)
        moved = {file.json["nodes"][c["target"]["node"]]["name"] for c in animation["channels"]}
        self.assertIn("head", moved)
        self.assertNotIn("world", moved)
        for channel in animation["channels"]:
            values = file.numbers(animation["samplers"][channel["sampler"]]["output"])
            self.assertEqual(len(values), len(times))
            if channel["target"]["path"] == "rotation":
                self.assertTrue(all(abs(math.hypot(*q) - 1) < 1e-5 for q in values))
                self.assertTrue(all(sum(a * b for a, b in zip(p, q)) >= 0 for p, q in zip(values, values[1:])))
            start = file.json["nodes"][channel["target"]["node"]][channel["target"]["path"]]
            self.assertTrue(all(abs(abs(a) - abs(b)) < 1e-6 for a, b in zip(start, values[0])))

    def test_wrong_arguments_are_named_and_write_nothing(self):
        self.assertIn("ends in .glb", self.mimo("export", "--gltf", "a.obj", code=2))
        self.assertIn("multiple of 4", self.mimo("export", "--gltf", "a.glb", "--segments", "6", code=2))
        self.assertIn("no folder", self.mimo("export", "--gltf", "no/a.glb", code=1))
        self.assertEqual(self.files(), [])

    def test_khronos_validator_finds_no_error(self):
        node = shutil.which("node")
        have = node and subprocess.run([node, "-e", 'require("gltf-validator")'], capture_output=True).returncode == 0
        if not have:
            self.skipTest("the npm package gltf-validator is not installed, or not in NODE_PATH")
        self.mimo("export", "--scene", "showroom", "--gltf", "a.glb", "--seconds", "0.2")
        path = str(self.folder / "a.glb")
        report = json.loads(subprocess.run([node, "-e", VALIDATE, path], capture_output=True, check=True).stdout)
        self.assertEqual((report["numErrors"], report["numWarnings"]), (0, 0), report["messages"][:5])

    def need_a_replay(self):
        if json.loads(self.mimo("info", "--json"))["versions"]["mujoco"] != "2.2.2":
            self.skipTest("MuJoCo 4 makes another model of a recording's document, which is then not played")

    @needs_hdf5
    def test_a_page_holds_the_recording(self):
        self.need_a_replay()
        self.mimo("record", "--seconds", "0.1", "--out", 'a "b" & <c>.h5')
        self.write("page.html", "<p>before</p><!-- recording --><p>behind</p>")
        self.mimo("export", "--html", "run.html", "--page", "page.html", 'a "b" & <c>.h5')
        page = Page((self.folder / "run.html").read_text())
        self.assertEqual(page.tags, ["p", "script", "script", "p"])
        self.assertEqual(page.scripts["recording"]["data-name"], 'a "b" & <c>.h5')
        recording = (self.folder / 'a "b" & <c>.h5').read_bytes()
        self.assertEqual(page.inside("recording"), recording)

    @needs_hdf5
    def test_a_page_knows_how_the_c_library_rounds(self):
        """Each row is what libm gives where another number is nearer; the page's own functions miss one in thousands."""
        libm = ctypes.util.find_library("m")
        if sys.platform != "linux" or libm is None:
            self.skipTest("only on Linux a program sees what its libraries call")
        self.need_a_replay()
        functions = [getattr(ctypes.CDLL(libm), name) for name in
                     ("exp", "log", "sin", "cos", "tan", "asin", "acos", "pow", "atan2")]
        for function in functions:
            function.restype = ctypes.c_double
        self.mimo("record", "--scene", "standup", "--seconds", "1", "--out", "run.h5")
        self.write("page.html", "<!-- recording -->")
        self.assertEqual(self.mimo("export", "--html", "run.html", "--page", "page.html", "run.h5"), "")
        rows = list(struct.iter_unpack("<Qddd", Page((self.folder / "run.html").read_text()).inside("rounding")))
        self.assertGreater(len(rows), 10)  # of some ten thousand calls
        for number, x, y, result in rows:
            arguments = [ctypes.c_double(x), ctypes.c_double(y)][:2 if number >= 7 else 1]
            self.assertEqual(functions[number](*arguments), result, (number, x, y))
        of_sines = [nearer_number(x, result) for number, x, _, result in rows if number == 2]
        self.assertGreater(len(of_sines), 0)
        self.assertGreater(sum(of_sines), 0.9 * len(of_sines))

    @needs_hdf5
    def test_what_a_page_cannot_play_writes_nothing(self):
        self.mimo("record", "--seconds", "0.1", "--out", "run.h5")
        self.write("page.html", "<!-- recording -->")
        self.write("other.html", "<p>")
        there = self.files()
        for given, told in (
            (["run.h5", "--page", "other.html"], "other.html is not the page that ./dev web makes for recordings"),
            (["run.h5", "--page", "no.html"], "cannot read no.html"),
            (["other.html", "--page", "page.html"], "other.html is not a recording"),
            (["no.h5", "--page", "page.html"], "cannot read no.h5"),
            (["run.h5", "--page", "page.html", "--scene", "reach"], "--scene has no effect with --html"),
            (["run.h5", "--page", "page.html", "--gltf", "a.glb"], "--gltf has no effect with --html"),
        ):
            self.assertIn(told, self.mimo("export", "--html", "run.html", *given, code=1))
        self.assertIn("the recording", self.mimo("export", "--html", "run.html", code=2))
        self.assertIn("ends in .html", self.mimo("export", "--html", "run.h5", "run.h5", code=2))
        for other in (["--gltf", "a.glb"], ["--fmu", "a.fmu"], []):
            self.assertIn("--page is for --html, the page to be written: --html FILE.html run.h5 is missing",
                          self.mimo("export", *other, "--page", "page.html", code=1))
        self.assertEqual(self.files(), there)

    def test_usd_is_the_python_package_s(self):
        told = self.mimo("export", "--usd", "infant.usda", code=1)
        self.assertIn("--usd is written by the Python package: pip install 'mimo[usd]', then "
                      "python -m mimo.export --usd infant.usda --scene SCENE", told)
        self.assertIn("--gltf", self.mimo("export", code=2))
        self.assertEqual(self.files(), [])

    def test_recordings_are_the_python_package_s(self):
        for option, extra in (("--nwb", "nwb"), ("--bids-motion", "bids"), ("--csv", "bids"), ("--wav", "bids"),
                              ("--mp4", "video")):
            told = self.mimo("export", option, "out", "run.h5", code=1)
            self.assertIn("%s is written by the Python package: pip install 'mimo[%s]', then "
                          "python -m mimo.export %s out run.h5" % (option, extra, option), told)
        self.assertIn("--gltf writes a scene, not the recording run.h5",
                      self.mimo("export", "--gltf", "a.glb", "run.h5", code=1))
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    unittest.main()
