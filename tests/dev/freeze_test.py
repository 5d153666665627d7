"""freeze_test.py REPOSITORY: when ./dev freeze puts a new recording in the place of the kept one."""

import sys
import tempfile
import unittest
from pathlib import Path

try:
    import h5py
except ImportError:
    h5py = None

REPOSITORY = Path(sys.argv.pop(1))
sys.path.insert(0, str(REPOSITORY))

from tools import interface  # noqa: E402


@unittest.skipUnless(h5py, "h5py is not installed (Debian package python3-h5py)")
class KeptRecording(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def recording(self, name, build="one", times=(0.01, 0.02), seed=7, other=None):
        file = self.folder / name
        with h5py.File(file, "w") as run:
            run.attrs["build"] = build
            run.attrs["seed"] = seed
            run.create_dataset("joints/position", data=times)
            if other:
                run[other] = [1]
        return file

    def taken(self, **what):
        """Whether a recording that differs in this takes the place of the kept one."""
        kept, made = self.recording("kept.h5"), self.recording("made.h5", **what)
        before = kept.read_bytes()
        interface.keep_recording(made, kept)
        self.assertIn(kept.read_bytes(), (before, made.read_bytes()))
        return kept.read_bytes() != before

    def test_the_kept_one_stays_where_only_the_build_differs(self):
        self.assertFalse(self.taken(build="another"))

    def test_other_numbers_names_or_attributes_replace_it(self):
        self.assertTrue(self.taken(times=(0.01, 0.03)))
        self.assertTrue(self.taken(times=(0.01, 0.02, 0.03)))
        self.assertTrue(self.taken(seed=8))
        self.assertTrue(self.taken(other="new"))

    def test_a_first_one_is_kept(self):
        made = self.recording("made.h5")
        interface.keep_recording(made, self.folder / "none.h5")
        self.assertEqual((self.folder / "none.h5").read_bytes(), made.read_bytes())


if __name__ == "__main__":
    unittest.main(verbosity=2)
