"""`mimo record` and `mimo replay`: a run is kept, played again, and compared."""
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import time
import unittest

from program import PROGRAM, SOURCES, Case, needs_hdf5

try:
    import h5py
    import numpy
except ImportError:
    h5py = None


needs_h5py = unittest.skipUnless(h5py, "h5py is not installed")


@needs_hdf5
class Record(Case):
    def record(self, *arguments):
        return self.mimo("record", "--out", "run.h5", "--touch", "off", *arguments)

    def replay(self, *arguments, file="run.h5"):
        return json.loads(self.mimo("replay", file, "--json", *arguments))

    def test_a_replay_is_identical_from_any_time(self):
        self.record("--seconds", "1", "--seed", "3", "--state-every", "0.25")
        for start, state in ((0, 0), (0.2, 0), (0.3, 0.25), (0.75, 0.75), (1, 1)):
            report = self.replay("--from", start)
            self.assertIs(report["identical"], True)
            self.assertEqual(report["largest_difference"], 0)
            self.assertAlmostEqual(report["from_seconds"], state)
            self.assertEqual(report["steps"], round(100 * (1 - state)))
            self.assertIs(report["same_build"], True)

    def test_muscles_reflexes_and_tasks_are_replayed(self):
        self.mimo("record", "--scene", "reach", "--actuation", "muscle", "--reflexes", "all", "--age", "3", "--touch", "0.5",
                  "--seconds", "0.5", "--keep", "all", "--state-every", "0.1", "--out", "run.h5")
        for start in (0, 0.33):
            self.assertIs(self.replay("--from", start)["identical"], True)

    def test_a_file_alone_is_enough(self):
        self.mimo("record", "--scene", "playdate", "--age", "3", "--seconds", "0.2", "--out", "run.h5")
        empty = self.folder / "empty"
        empty.mkdir()
        (self.folder / "run.h5").rename(empty / "run.h5")
        report = self.replay(file="empty/run.h5")
        self.assertIs(report["identical"], True)
        self.assertIs(self.replay("--by-joints", file="empty/run.h5")["by_joints"], True)

    def test_recordings_of_earlier_libraries_are_replayed(self):
        kept = sorted((SOURCES / "tests/states").glob("*/recording.h5"))
        self.assertTrue(kept)
        for file in kept:
            shutil.copy(file, self.folder / "run.h5")
            report = self.replay()
            self.assertEqual(report["steps"], 30)
            self.assertLess(report["largest_difference"], 1e-6)  # to rounding, which may differ from build to build

    @needs_h5py
    def test_recordings_of_older_versions_say_what_they_lack(self):
        self.record("--seconds", "0.1")
        with h5py.File(self.folder / "run.h5", "r+") as file:
            file.attrs["format_version"] = 2
        self.assertIn("has format version 2, which contains no scene; pass it with --scene", self.mimo("replay", "run.h5", code=1))
        report = self.replay("--scene", "benchmark", "--touch", "off")
        self.assertIs(report["identical"], True)

    @needs_h5py
    def test_a_replay_in_another_model_is_refused(self):
        self.record("--seconds", "0.1")
        with h5py.File(self.folder / "run.h5", "r+") as file:
            file["bodies/model_hash"][0] += 1
            file.attrs["mujoco"] = numpy.bytes_("9.9.9")
        error = self.mimo("replay", "run.h5", code=1)
        self.assertIn("MuJoCo 9.9.9", error)
        self.assertIn("--by-joints", error)
        self.assertEqual(self.replay("--by-joints")["steps"], 10)

    def test_what_was_not_recorded_can_be_sensed_later(self):
        self.record("--seconds", "0.5", "--keep", "none")
        self.assertIn("--age: run.h5 holds its world itself", self.mimo("replay", "run.h5", "--age", "6", code=1))
        report = self.replay("--touch", "0.5", "--from", "0.2", "--keep", "touch", "--out", "touch.h5")
        self.assertIs(report["identical"], True)
        self.assertIs(self.replay(file="touch.h5")["identical"], True)
        if h5py:
            with h5py.File(self.folder / "touch.h5") as file:
                force = file["fields/touch/force"]
                self.assertEqual(force.shape[0], 30)
                self.assertGreater(abs(force[:]).max(), 0)  # it lies on the floor

    @needs_h5py
    def test_h5py_reads_a_recording_without_the_library(self):
        self.record("--seconds", "0.4", "--seed", "18446744073709551615")
        with h5py.File(self.folder / "run.h5") as file:
            self.assertEqual(file.attrs["format"], b"mimo recording")
            self.assertEqual(file.attrs["format_version"], 3)
            self.assertEqual(file.attrs["seed"], b"18446744073709551615")
            calls = json.loads(bytes(file["world"][()]))
            self.assertEqual(calls[0]["call"], "add_agents")
            self.assertEqual(calls[0]["config"]["touch"], 0)
            self.assertEqual(file.attrs["byte_order"], b"little")
            self.assertTrue(bytes(file["scene/document"][0]).startswith(b"<mujoco"))
            self.assertTrue(bytes(file["scene/assets/floor.png"][()]).startswith(b"\x89PNG"))
            self.assertEqual(file["terminated"].shape, (40, 1))
            self.assertEqual(file["actions"].shape, (40, 44))
            self.assertEqual(file["joints/position"].shape, (40, 68))  # nq and nv of the benchmark scene
            self.assertEqual(file["joints/velocity"].shape, (40, 65))
            columns = file["joints/position"].attrs["names"].decode().splitlines()
            self.assertEqual(len(columns), 68)
            self.assertNotIn("", columns)
            self.assertAlmostEqual(file["time"][-1], 0.4)
            self.assertEqual(file["fields/proprioception/position"].attrs["unit"], b"rad")
            self.assertEqual(list(file["states/step"]), [0, 40])
            # What is sensed of a joint is where the joint is.
            names = file["joints/position"].attrs["names"].decode().split("\n")
            elbow = file["joints/position"][:, names.index("robot:left_elbow")]
            sensed = file["fields/proprioception/position"]
            column = [i for i, n in enumerate(sensed.attrs["names"].decode().split("\n")) if n == "robot:left_elbow"]
            self.assertEqual(len(column), 1)
            self.assertLess(abs(sensed[:, column[0]] - elbow).max(), 1e-6)

    @needs_h5py
    def test_a_difference_is_told_with_its_size(self):
        self.record("--seconds", "0.3", "--keep", "none")
        with h5py.File(self.folder / "run.h5", "r+") as file:
            file["joints/position"][20, 9] += 0.5
            file.attrs["build"] = numpy.bytes_("libmimo 0.0.1")
        report = self.replay()
        self.assertIs(report["identical"], False)
        self.assertAlmostEqual(report["largest_difference"], 0.5)
        self.assertEqual(report["differs_most_in"], "joints/position")
        self.assertIs(report["same_build"], False)
        text = self.mimo("replay", "run.h5")
        self.assertIn("libmimo 0.0.1", text)
        self.assertIn("from 0.21 s", text)
        with h5py.File(self.folder / "run.h5", "r+") as file:
            file["actions"][5] = -file["actions"][5]
        self.assertGreater(self.replay()["largest_difference"], 0.5)

    def test_a_killed_run_is_whole_up_to_its_last_flush(self):
        for delay in (0.8, 1.37):  # s
            run = subprocess.Popen([PROGRAM, "record", "--seconds", "100000", "--flush-every", "0.05", "--out", "run.h5"],
                                   cwd=self.folder, stderr=subprocess.DEVNULL)
            while run.poll() is None and not (self.folder / "run.h5").exists():
                time.sleep(0.02)
            time.sleep(delay)
            os.kill(run.pid, signal.SIGKILL)
            run.wait()
            report = self.replay()
            self.assertIs(report["identical"], True)
            self.assertGreater(report["steps"], 10)
            if h5py:
                with h5py.File(self.folder / "run.h5", swmr=True) as file:
                    self.assertGreaterEqual(file["time"].shape[0], report["steps"])
            (self.folder / "run.h5").unlink()

    def start(self, *arguments):
        """A run without an end, after its file is there."""
        (self.folder / "run.h5").unlink(missing_ok=True)
        run = subprocess.Popen([PROGRAM, "record", "--seconds", "100000", "--out", "run.h5", *arguments], cwd=self.folder,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        self.addCleanup(run.communicate)
        self.addCleanup(run.kill)
        while run.poll() is None and not (self.folder / "run.h5").exists():
            time.sleep(0.02)
        time.sleep(0.5)
        return run

    def test_a_run_that_is_asked_to_end_is_whole(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            run = self.start("--flush-every", "1000")
            run.send_signal(number)
            output, errors = run.communicate(timeout=30)
            self.assertEqual(run.returncode, -number)
            self.assertEqual(errors, "")
            steps = int(output.split(" steps")[0].split()[-1])
            self.assertGreater(steps, 0)
            self.assertEqual(self.replay()["steps"], steps)
            if h5py:
                with h5py.File(self.folder / "run.h5") as file:  # which bears no mark of being written
                    self.assertEqual(len(file["time"]), steps)
            self.assertEqual(self.files(), ["run.h5"])

    def test_a_second_run_cannot_take_the_file_of_a_running_one(self):
        first = self.start()
        error = self.mimo("record", "--seconds", "0.1", "--out", "run.h5", code=1)
        self.assertIn("a program is using", error)
        first.terminate()
        output, errors = first.communicate(timeout=30)
        self.assertEqual(errors, "")
        self.assertIn("%d steps" % self.replay()["steps"], output)
        self.record("--replace", "--seconds", "0.1")  # now it may
        self.assertEqual(self.replay()["steps"], 10)

    def test_a_recording_stays_unless_asked(self):
        self.record("--seconds", "0.2")
        before = (self.folder / "run.h5").read_bytes()
        error = self.mimo("record", "--seconds", "0.1", "--out", "run.h5", code=1)
        self.assertIn("cannot write run.h5: a recording exists already and is replaced only if `replace` is set", error)
        self.mimo("replay", "run.h5", "--out", "new.h5")
        self.assertIn("cannot write new.h5", self.mimo("replay", "run.h5", "--out", "new.h5", code=1))
        self.assertEqual((self.folder / "run.h5").read_bytes(), before)
        self.mimo("replay", "run.h5", "--from", "0.1", "--out", "new.h5", "--replace")
        self.assertEqual(self.replay(file="new.h5")["steps"], 10)
        self.record("--seconds", "0.1", "--replace")
        self.assertEqual(self.replay()["steps"], 10)
        self.assertEqual(self.files(), ["new.h5", "run.h5"])

    def test_files_that_are_not_recordings_are_not_overwritten(self):
        self.write("data.h5", "two years of data")
        error = self.mimo("record", "--replace", "--seconds", "0.1", "--out", "data.h5", code=1)
        self.assertIn("is not overwritten", error)
        self.assertEqual((self.folder / "data.h5").read_text(), "two years of data")
        self.record("--seconds", "0.1")
        self.assertIn("is not overwritten", self.mimo("replay", "run.h5", "--out", "data.h5", code=1))
        self.assertEqual(self.files(), ["data.h5", "run.h5"])

    def test_folders_and_pipes_are_refused_as_recordings(self):
        self.record("--seconds", "0.1")
        os.mkfifo(self.folder / "pipe")
        for place in ("pipe", "/dev/full", "/dev/null"):
            self.assertIn("cannot write " + place, self.mimo("record", "--seconds", "0.1", "--out", place, code=1))
            self.assertIn("cannot write " + place, self.mimo("replay", "run.h5", "--out", place, code=1))
        for place in ("pipe", "/dev/zero", "."):
            self.assertIn("cannot read " + place, self.mimo("replay", place, code=1))

    def test_a_full_disk_leaves_nothing_and_no_complaints(self):
        def no_room(size):
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

        for size in (0, 4000, 12000):  # bytes: less than a recording has before its first step
            done = subprocess.run([PROGRAM, "record", "--seconds", "0.1", "--out", "run.h5"], cwd=self.folder,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                                  preexec_fn=lambda: (signal.signal(signal.SIGXFSZ, signal.SIG_IGN), no_room(size)))
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertRegex(done.stderr, r"\Amimo record: cannot write run.h5: [^\n]+\n\Z")
            self.assertEqual(self.files(), [])

    def test_a_damaged_beginning(self):
        """HDF5 would read it again and again."""
        self.record("--seconds", "0.1")
        whole = (self.folder / "run.h5").read_bytes()
        for at in range(8, 64, 5):
            (self.folder / "damaged.h5").write_bytes(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1:])
            done = subprocess.run([PROGRAM, "replay", "damaged.h5"], cwd=self.folder, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, universal_newlines=True, timeout=60)
            self.assertEqual(len(done.stderr.splitlines()), done.returncode)  # one line where it is refused
            (self.folder / "cut.h5").write_bytes(whole[:at])
            self.assertIn("cut.h5 is not a recording", self.mimo("replay", "cut.h5", code=1))

    def test_files_that_are_not_recordings_are_refused(self):
        self.assertIn("none.h5", self.mimo("replay", "none.h5", code=1))
        self.write("text.h5", "not a recording")
        self.assertIn("text.h5", self.mimo("replay", "text.h5", code=1))
        self.record("--seconds", "0.3")
        whole = (self.folder / "run.h5").read_bytes()
        (self.folder / "cut.h5").write_bytes(whole[:len(whole) // 2])
        self.assertIn("cut", self.mimo("replay", "cut.h5", "--out", "new.h5", code=1))
        self.assertEqual(self.files(), ["cut.h5", "run.h5", "text.h5"])

    @needs_h5py
    def test_recordings_of_something_else(self):
        path = self.folder / "run.h5"

        def refused(word, **attributes):
            path.unlink(missing_ok=True)  # what is no recording is not written over
            self.record("--seconds", "0.1")
            with h5py.File(path, "r+") as file:
                for name, value in attributes.items():
                    file.attrs[name] = numpy.bytes_(value) if isinstance(value, str) else value
            self.assertIn(word, self.mimo("replay", "run.h5", "--out", "new.h5", code=1))
            self.assertEqual(self.files(), ["run.h5"])

        refused("version 4", format_version=4)
        refused("format", format="another")
        refused("joints", joint_names="nose\n")
        refused("whole number", seed="seven")
        with h5py.File(path, "w") as file:
            file["x"] = 1
        self.assertIn("not a recording", self.mimo("replay", "run.h5", code=1))

    @needs_h5py
    def test_steps_of_other_programs_are_as_long_as_they_were(self):
        self.record("--seconds", "0.3")
        with h5py.File(self.folder / "run.h5", "r+") as file:
            file.attrs["format_version"] = 2
            file.attrs["step_seconds"] = 0.015
        self.assertAlmostEqual(self.replay("--scene", "benchmark")["to_seconds"], 0.45)
        with h5py.File(self.folder / "run.h5", "r+") as file:
            file.attrs["step_seconds"] = 0.0151
        self.assertIn("0.0151", self.mimo("replay", "run.h5", "--scene", "benchmark", code=1))

    def test_bad_arguments(self):
        self.assertIn("no folder", self.mimo("record", "--scene", "moon", "--out", "no/run.h5", code=1))
        self.assertIn("moon", self.mimo("record", "--scene", "moon", "--out", "run.h5", code=1))
        self.assertIn("wings", self.mimo("record", "--keep", "wings", "--out", "run.h5", code=1))
        self.assertEqual(self.files(), [])
        self.record("--seconds", "0.1")
        self.assertIn("--from 7", self.mimo("replay", "run.h5", "--from", "7", code=1))
        self.assertIn("itself", self.mimo("replay", "run.h5", "--out", pathlib.Path("./run.h5"), code=1))


if __name__ == "__main__":
    unittest.main(verbosity=2)
