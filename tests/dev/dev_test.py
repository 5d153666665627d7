"""dev_test.py REPOSITORY: ./dev of a repository, with stand-ins for the programs that it calls."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1))
PARTS = ["--quick", "--python", "--rust", "--csharp", "--octave", "--same", "--package", "--asan"]
INSTALLED = 'printf "%s installed\\n" "${@:4}"'


class Dev(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.clone = Path(self.temporary.name) / "a folder" / "libmimo"
        shutil.copytree(REPOSITORY / "tools", self.clone / "tools")
        shutil.copy(REPOSITORY / "dev", self.clone)
        self.stub("dpkg-query", INSTALLED)

    def stub(self, program, script):
        """A program of that name, which keeps what it is called with."""
        file = Path(self.temporary.name) / "bin" / program
        file.parent.mkdir(exist_ok=True)
        file.write_text(f'#!/bin/bash\necho "$0 $*" >>"{self.temporary.name}/calls"\n{script}\n')
        file.chmod(0o755)

    def calls(self, program):
        lines = (Path(self.temporary.name) / "calls").read_text().splitlines()
        return [line.split("/" + program + " ", 1)[1] for line in lines if "/" + program + " " in line]

    def dev(self, *arguments):
        path = f"{self.temporary.name}/bin:{os.environ['PATH']}"
        return subprocess.run(
            [self.clone / "dev", *arguments], capture_output=True, text=True, env={**os.environ, "PATH": path}
        )

    def test_a_part_that_fails_does_not_end_the_tests(self):
        self.stub("cmake", "exit 1")
        done = self.dev("test")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout.splitlines()[0], "Tests to run: " + " ".join(PARTS))
        self.assertEqual(
            [line.split()[:2] for line in done.stdout.splitlines()[-len(PARTS) :]],
            [[part[2:], "FAILED"] for part in PARTS],
        )
        self.assertEqual(
            done.stderr.strip().splitlines()[-1], "dev: tests failed; again with: ./dev test " + " ".join(PARTS)
        )

    def test_the_tests_say_first_what_they_run_and_how_long_it_takes(self):
        self.stub("cmake", "exit 0")
        lines = self.dev("test", "--tsan", "--quick").stdout.splitlines()
        self.assertEqual(lines[0], "Tests to run: --tsan --quick")
        self.assertRegex(lines[1], r"^tsan +\? min  what uses threads")
        self.assertRegex(lines[2], r"^quick +\d+ min  the library and the program$")
        self.assertRegex(lines[3], r"^Together about \d+ minutes, and 1 that nobody has timed here$")
        self.assertRegex(lines[4], r"^==== 1 of 2: tsan, .*, about \? min$")
        self.assertRegex("\n".join(lines), r"\n==== 2 of 2: quick, ")
        again = self.dev("test", "--tsan").stdout.splitlines()
        self.assertRegex(again[1], r"^tsan +1 min ")  # what it took here

    def test_only_what_failed_is_named(self):
        self.stub("cmake", "[[ $* != *asan* ]]")
        done = self.dev("test", "--quick", "--asan")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(
            [line.split()[:2] for line in done.stdout.splitlines()[-2:]], [["quick", "passed"], ["asan", "FAILED"]]
        )
        self.assertEqual(done.stderr.strip().splitlines()[-1], "dev: tests failed; again with: ./dev test --asan")
        self.assertEqual(self.dev("test", "--quick", "--quick").returncode, 0)

    def test_parts_by_themselves(self):
        self.stub("cmake", "exit 0")
        for folder in ("build", "build-asan"):
            program = self.clone / folder / "bin/capi_same"
            program.parent.mkdir(parents=True)
            program.write_text("#!/bin/bash\necho the same\n")
            program.chmod(0o755)
        for part, preset in (
            ("--quick", "release"),
            ("--tsan", "tsan"),
            ("--asan", "asan"),
            ("--asan-rooms", "asan-rooms"),
        ):
            self.assertEqual(self.dev("test", part).returncode, 0)
            self.assertIn(f"--workflow --preset {preset}", self.calls("cmake"))

    def test_other_systems_have_presets_and_what_stands_in_for_them(self):
        (self.clone / "build/cross/mujoco/windows").mkdir(parents=True)
        (self.clone / "build/cross/complete").touch()
        self.stub("cmake", "exit 0")
        self.assertEqual(self.dev("build", "--windows").returncode, 0)
        self.assertEqual(
            self.calls("cmake")[1:], ["--preset windows", "--build --preset windows --target mimo mimo_program"]
        )

    def test_an_unknown_platform_is_named(self):
        done = self.dev("wheel", "--platform", "amiga")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("no platform 'amiga'; there are: linux arm windows macos macos-x86 all", done.stderr)

    def test_the_page_of_recordings_is_for_packages_that_are_made_with_it(self):
        done = self.dev("wheel", "--page")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("--page goes with --platform", done.stderr)
        made = self.clone / "build/web/recording.html"
        made.parent.mkdir(parents=True)
        made.write_text("a page")
        code = "from pathlib import Path; from tools.packages import put_page; folder = Path('build-debian')\n"
        code += "for page in (Path('build/web/recording.html'), None):\n"
        code += "  put_page(folder, page); print((folder / 'web/recording.html').is_file())"
        said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=self.clone)
        self.assertEqual((said.stdout, said.stderr), ("True\nFalse\n", ""))

    def test_another_mujoco_than_expected_is_refused(self):
        (self.clone / "build/cross").mkdir(parents=True)
        (self.clone / "build/cross/complete").touch()
        made = self.clone / "build/tools/bin/pip"
        made.parent.mkdir(parents=True)
        shutil.copy(self.clone / "tools/pins/tools.txt", made.parents[1] / "pins.txt")
        made.write_text("#!/bin/bash\nmkdir -p build/cross/wheel/mujoco; touch build/cross/wheel/mujoco/mujoco.dll\n")
        made.chmod(0o755)
        self.stub("cmake", "exit 0")
        done = self.dev("build", "--windows")
        self.assertEqual(done.returncode, 1)
        self.assertIn("mujoco.dll is not the one that is expected", done.stderr)

    def test_an_unknown_part_is_named(self):
        done = self.dev("test", "--quick", "--slow")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("test does not take '--slow'", done.stderr)

    def test_another_mujoco_is_used_until_the_next_build(self):
        self.stub("cmake", "exit 0")
        fetched = self.clone / "build/mujoco4/mujoco"
        fetched.mkdir(parents=True)
        (fetched / "libmujoco.so.4.0.1").touch()
        for file in ("lib/libmimo-mujoco4.so.1", "bin/mimo"):
            for folder, text in (("build", "2.2"), ("build-mujoco4", "4.0")):
                (self.clone / folder / file).parent.mkdir(parents=True, exist_ok=True)
                (self.clone / folder / file).write_text(text)
        done = self.dev("build", "--mujoco", "4")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("--build --preset mujoco4 --target mimo mimo_program", self.calls("cmake"))
        ours = [self.clone / "build/lib/libmimo-mujoco4.so.1", self.clone / "build/bin/mimo"]
        self.assertEqual([file.read_text() for file in ours], ["4.0", "4.0"])
        self.assertEqual(self.dev("build").returncode, 0)
        self.assertEqual([file.exists() for file in ours], [False, False])  # so that they are made again

    def test_an_unknown_mujoco_is_named(self):
        done = self.dev("build", "--mujoco", "3")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("--mujoco: invalid choice: '3'", done.stderr)

    def test_every_command_and_part_is_explained(self):
        said = self.dev("help").stdout
        for command in ("build", "demo", "test", "zoo", "bench", "ratios", "package", "wheel", "train", "lint", "format", "pins",
                        "docs", "freeze", "clean"):  # fmt: skip
            self.assertRegex(said, rf"\n +{command} +\w")
            self.assertEqual(self.dev(command, "--help").returncode, 0)
        said = self.dev("test", "--help").stdout
        for part in PARTS:
            self.assertRegex(said, rf"\n +{part} +\w")

    def refused(self, sentence, *arguments):
        """A command fails with one line, and says all of this sentence."""
        done = self.dev(*arguments)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        self.assertIn(sentence, done.stderr)

    def test_an_old_cmake_is_refused_in_a_sentence(self):
        self.stub("cmake", 'echo "cmake version 3.22.1"')
        for command in ("demo", "build"):
            self.refused("CMake 3.22 is too old; please install 3.25 or newer", command)

    def test_libraries_that_cmake_misses_are_named_in_a_sentence(self):
        said = "CMake Error at cmake/M.cmake:74 (message):\n  libmimo needs pugixml, fmt.\n\n  On Debian: apt-get\n"
        script = f"[[ $1 == --version ]] && echo 'cmake version 3.25.1' && exit\nprintf '{said}' >&2; exit 1"
        self.stub("cmake", script.replace("\n\n", "\n"))
        self.refused("dev: libmimo needs pugixml, fmt.", "build")

    def test_a_full_disk_is_refused_before_compiling(self):
        self.stub("cmake", "exit 0")
        file = self.clone / "tools/build.py"
        file.write_text(file.read_text().replace("SPACE = 300 *", "SPACE = 10**12 *"))
        self.refused(f"MB are free on the disk of {self.clone}; please make room", "build")

    def test_without_root_the_command_is_named(self):
        file = self.clone / "tools/need.py"
        file.write_text(file.read_text().replace("os.geteuid()", "1000"))
        self.stub("dpkg-query", "exit 1")
        self.stub("apt-get", "exit 1")
        self.refused("packages are missing; please run: sudo apt-get update && sudo apt-get install", "demo")

    def test_arguments_are_handed_on(self):
        self.stub("cmake", "exit 0")
        program = self.clone / "build/bin/mimo"
        program.parent.mkdir(parents=True)
        program.write_text('#!/bin/bash\necho "$@"\n')
        program.chmod(0o755)
        said = self.dev("demo", "--seconds", "0.05", "--seed", "3").stdout
        self.assertIn("run --out demo --seconds 0.05 --seed 3\n", said)
        for step in ("1 of 3: Debian packages", "2 of 3: compile", "3 of 3: simulate"):
            self.assertRegex(said, rf"\n?==== {step}.* \(usually [a-z]")
        self.assertRegex(said, r"The pictures are in .*/demo\. Open first:\n +outside.png ")

    @unittest.skipIf(os.geteuid() != 0, "only root installs packages")
    def test_another_apt_is_waited_for(self):
        self.stub("dpkg-query", "exit 1")
        self.stub("cmake", "exit 0")
        busy = Path(self.temporary.name) / "busy"
        busy.touch()
        self.stub(
            "apt-get",
            f'[[ $1 == update && -e "{busy}" ]] || exit 0\nrm "{busy}"\n'
            "echo 'E: Could not get lock /var/lib/apt/lists/lock. It is held by process 1 (apt-get)' >&2\nexit 100",
        )
        done = self.dev("build")
        self.assertEqual(done.returncode, 0, done.stderr)
        update, again, install = self.calls("apt-get")
        self.assertEqual(update, again)
        self.assertIn("DPkg::Lock::Timeout=", install)

    def test_an_apt_that_fails_says_what_to_do(self):
        file = self.clone / "tools/need.py"
        file.write_text(file.read_text().replace("os.geteuid()", "0"))
        self.stub("dpkg-query", "exit 1")
        for said, sentence in (
            ("W: Failed to fetch http://deb.debian.org/x  Temporary failure", "please check the network"),
            (
                "E: Unable to locate package libmujoco-dev",
                "apt has no libmujoco-dev: ./dev installs packages on Debian",
            ),
            ("E: You don't have enough free space in /var/cache/apt/archives/.", "please make room for 700 MB"),
            ("E: Broken packages", "(E: Broken packages)"),
        ):
            self.stub("apt-get", f'echo "{said}" >&2\n[[ $1 == update ]] || exit 100')
            self.refused(sentence, "build")

    def test_a_system_without_apt_is_told_what_to_install(self):
        programs = Path(self.temporary.name) / "few"
        programs.mkdir()
        for program in ("bash", "dirname", "python3", "env"):
            (programs / program).symlink_to(shutil.which(program))
        path = {**os.environ, "PATH": str(programs)}
        done = subprocess.run([self.clone / "dev", "build"], capture_output=True, text=True, env=path)
        self.assertEqual((done.returncode, done.stderr), (1, "dev: please install: c++ cmake ninja\n"))

    def test_an_old_python_is_told_so(self):
        script = (self.clone / "dev").read_text().replace("/usr/bin/python3 python3", "python3")
        self.stub("python3", "exit 1")  # as python3.8 -c 'import tomllib'
        self.stub("apt-get", "exit 100")
        (self.clone / "dev").write_text(script.replace("$EUID == 0", "1 == 0"))
        self.refused("please install Python 3.11 or newer", "demo")
        (self.clone / "dev").write_text(script.replace("$EUID == 0", "1 == 1"))
        self.refused("apt-get cannot install python3; please check the network", "demo")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[1:]])
