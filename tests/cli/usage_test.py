"""`mimo` without a command, with a wrong one, and its manual page."""
import os
import re
import subprocess
import sys
import unittest

from program import PROGRAM, SOURCES, Case


class Usage(Case):
    def test_help(self):
        self.assertIn("rollout", self.mimo("--help"))
        for command in ("run", "info", "render", "rollout", "export", "record", "replay", "new", "bench"):
            text = self.mimo(command, "--help")
            self.assertIn("Example", text)
            self.assertIn("mimo " + command, text)
        self.assertEqual(self.files(), [])

    def test_version(self):
        self.assertRegex(self.mimo("--version"), r"^mimo \d+\.\d+\.\d+(-rc\d+)? \(MuJoCo \d+\.\d+\.\d+\)\n$")

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
                          ["run", "--sound", "a.mp3"], ["run", "--full-scale", "0"],
                          ["render"], ["render", "--out", "a.png", "--width", "0"],
                          ["render", "--out", "a.png", "--camera", "eye_left", "--distance", "1"],
                          ["rollout", "--out", "a.json"], ["rollout", "--controls", "a.csv"],
                          ["rollout", "--controls", "a.csv", "--out", "a.json", "--jacobian", "thin"],
                          ["rollout", "--controls", "a.csv", "--out", "a.json", "--every", "0"],
                          ["record"], ["replay"], ["record", "--out", "a.h5", "--compression", "10"],
                          ["export"], ["export", "--gltf", "a.gltf"], ["export", "--gltf", "a.glb", "--seconds", "-1"]):
            with self.subTest(arguments=arguments):
                self.assertIn("--help", self.mimo(*arguments, code=2))
        self.assertEqual(self.files(), [])

    def test_unknown_things_are_named(self):
        commands = (["info"], ["export", "--gltf", "a.glb"], ["record", "--out", "a.h5"], ["run"], ["render", "--out", "a.png"])
        for command in commands:
            self.assertIn("moon", self.mimo(*command, "--scene", "moon", code=1))
            self.assertIn("moon.xml", self.mimo(*command, "--scene", "moon.xml", code=1))
            self.assertIn("octopus", self.mimo(*command, "--body", "octopus", code=1))
        self.assertEqual(self.files(), [])

    def test_the_nearest_option_or_command_is_named(self):
        for arguments, said in ((["run", "--secnds", "3"], "mimo run: there is no option --secnds; did you mean --seconds?"),
                                (["run", "--vison=off"], "mimo run: there is no option --vison; did you mean --vision?"),
                                (["render", "--widht", "3", "--out", "a.png"], "no option --widht; did you mean --width?"),
                                (["run", "--tasks", "reach"], "there is no option --tasks; did you mean --task?"),
                                (["run", "--wheels", "4"], "there is no option --wheels (see mimo run --help)"),
                                (["rnu"], "mimo: there is no command rnu; did you mean run? (see mimo --help)"),
                                (["recrod", "--out", "a.h5"], "there is no command recrod; did you mean record?"),
                                (["walk"], "mimo: there is no command walk (see mimo --help)"),
                                (["run", "reach"], "mimo run: 'reach' is not an option; this command takes only options"),
                                (["--seconds", "3"], "mimo: --seconds belongs behind a command, such as run")):
            with self.subTest(arguments=arguments):
                self.assertIn(said, self.mimo(*arguments, code=2))
        self.assertEqual(self.files(), [])

    def test_places_that_cannot_be_written_are_found_before_any_work(self):
        # What would take work is missing or too long: the complaint is still about the place.
        for command in (["render", "--scene", "moon", "--out"], ["render", "--scene", "moon", "--out", "a.png", "--depth"]):
            self.assertIn("no folder", self.mimo(*command, "no/a.png", code=1))
        controls = self.write("controls.csv", "act:hip_bend\n" + "0\n" * 1000000)
        self.assertIn("no folder", self.mimo("rollout", "--controls", controls, "--out", "no/a.json", code=1))
        (self.folder / "folder.png").mkdir()
        self.assertIn("is a folder", self.mimo("render", "--out", "folder.png", code=1))

    def test_the_manual_page_is_what_the_program_says(self):
        subprocess.run([sys.executable, SOURCES / "docs/make_manual.py", PROGRAM, "--check"], check=True)
        page = (SOURCES / "src/cli/mimo.1").read_text().replace("\\", "")
        synopsis, explained = page[page.index(".Sh SYNOPSIS"):page.index(".Sh DESCRIPTION")], page[page.index(".Sh DESCRIPTION"):]
        shared = set(re.findall(r"^\.It Fl -([a-z-]+)", page[page.index(".Ss Options of several"):], re.M))
        for command in ("run", "info", "render", "rollout", "export", "record", "replay", "bench"):
            help_text = self.mimo(command, "--help")
            options = set(re.findall(r"^ +(?:-h,)?--([a-z-]+)", help_text, re.M)) - {"help"}
            self.assertGreater(len(options), 5)
            part = re.search(r"\n\.Ss mimo %s\n(.*?)\n\.Ss " % command, explained, re.S).group(1)
            listed = set(re.findall(r"--([a-z-]+)", part[part.index("Also takes"):]))
            self.assertLessEqual(listed, shared, "explained below for " + command)
            self.assertEqual(set(re.findall(r"^\.It Fl -([a-z-]+)", part, re.M)) | listed, options, "options of " + command)
            required = set(re.findall(r"^ +--([a-z-]+) .*\(required\)", help_text, re.M))
            used = re.search(r"\n\.Cm %s\n(.*?)(\n\.Nm|\Z)" % command, synopsis, re.S).group(1)
            self.assertEqual(set(re.findall(r"Fl -([a-z-]+)", used)), required, "required by " + command)
        for scene in re.search(r"Built-in scene \(([^)]*)", re.sub(r"\s+", " ", self.mimo("run", "--help"))).group(1).split(", "):
            self.assertIn(scene, page)

    def test_full_disk(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        with open("/dev/full", "w") as full:
            done = subprocess.run([PROGRAM, "info", "--vision", "off"], stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"cannot write", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
