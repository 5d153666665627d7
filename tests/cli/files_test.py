"""Files that commands read and write: whole or not at all, and nothing that would be waited for."""
import os
import resource
import signal
import stat
import subprocess
import unittest

from program import PROGRAM, Case

CONTROLS = "act:hip_bend\n" + "0.5\n" * 60


def small_files(size):
    """For a child: its files may not grow beyond that many bytes, as on a full disk."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


class Files(Case):
    def setUp(self):
        super().setUp()
        self.write("controls.csv", CONTROLS)

    def rollout(self, out, **options):
        return self.mimo("rollout", "--controls", "controls.csv", "--out", out, **options)

    def writers(self):
        """Commands that end with the name of what they write, and that name."""
        yield ["rollout", "--controls", "controls.csv", "--out"], "out.json"
        yield ["export", "--gltf"], "out.glb"
        yield ["replay", "--motion", "motion.csv", "--forces"], "out.csv"
        yield ["render", "--width", "64", "--height", "64", "--out"], "out.png"

    def test_a_full_disk_leaves_what_was_there(self):
        self.write("motion.csv", "time,robot:left_elbow\n0,0\n0.1,-0.1\n0.2,-0.2\n")
        for command, name in self.writers():
            for before in (None, "as it was"):
                if before:
                    self.write(name, before)
                there = self.files()
                done = subprocess.run([PROGRAM, *command, name], cwd=self.folder, stdout=subprocess.PIPE,
                                      stderr=subprocess.PIPE, universal_newlines=True, preexec_fn=lambda: small_files(64))
                self.assertEqual(done.returncode, 1)
                self.assertIn("cannot write " + name, done.stderr)
                self.assertEqual(self.files(), there)
                if before:
                    self.assertEqual((self.folder / name).read_text(), before)

    def test_a_pipe_with_a_name_is_not_waited_for(self):
        for name in ("out.json", "out.glb", "out.csv", "out.png", "motion.csv", "motion.bvh", "pipe.csv"):
            os.mkfifo(self.folder / name)
        for command, name in self.writers():
            self.assertIn("it is a named pipe", self.mimo(*command, name, code=1))
        for name in ("motion.csv", "motion.bvh"):
            self.assertIn("cannot read " + name, self.mimo("replay", "--motion", name, code=1))
        self.assertIn("cannot read pipe.csv",
                      self.mimo("rollout", "--controls", "pipe.csv", "--out", "new.json", code=1))
        self.assertIn("cannot read /dev/zero",
                      self.mimo("rollout", "--controls", "/dev/zero", "--out", "new.json", code=1))

    def test_open_pipes_and_devices_are_used(self):
        with open(self.folder / "controls.csv") as controls:
            done = subprocess.run([PROGRAM, "rollout", "--controls", "/dev/stdin", "--out", "/dev/stdout"], stdin=controls,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.rollout("out.json")
        self.assertEqual(done.stdout, (self.folder / "out.json").read_bytes())
        piped = subprocess.run([PROGRAM, "rollout", "--controls", "/dev/stdin", "--out", "/dev/null"],
                               input=CONTROLS.encode(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder)
        self.assertEqual((piped.returncode, piped.stderr), (0, b""))

    def test_a_file_stays_what_it_is(self):
        self.write("secret.json", "")
        (self.folder / "secret.json").chmod(0o600)
        (self.folder / "link.json").symlink_to("secret.json")
        self.rollout("link.json")
        self.assertTrue((self.folder / "link.json").is_symlink())
        self.assertEqual(stat.S_IMODE((self.folder / "secret.json").stat().st_mode), 0o600)
        self.assertIn("states", (self.folder / "secret.json").read_text())
        self.assertEqual(self.files(), ["controls.csv", "link.json", "secret.json"])

    def test_a_file_where_a_folder_should_be(self):
        for place in ("controls.csv", "/dev/null"):
            self.assertIn("cannot make the folder " + place + ": a file is there",
                          self.mimo("run", "--seconds", "0.01", "--vision", "off", "--out", place, code=1))


if __name__ == "__main__":
    unittest.main(verbosity=2)
