"""`mimo new`: folders for senses and tasks of one's own. tests/consumer builds them and runs their tests."""
import unittest

from program import Case


class New(Case):
    def test_a_sense_has_its_name_everywhere(self):
        self.assertIn("warm_nose.cpp, test.cpp, CMakeLists.txt", self.mimo("new", "sense", "warm_nose"))
        self.assertEqual(self.files(), ["warm_nose/CMakeLists.txt", "warm_nose/test.cpp", "warm_nose/warm_nose.cpp"])
        source = (self.folder / "warm_nose/warm_nose.cpp").read_text()
        self.assertIn('MIMO_SENSE(mimo::sense<WarmNose>("warm_nose"))', source)
        for file in self.files():
            self.assertNotIn("@", (self.folder / file).read_text())

    def test_a_task_has_its_name_everywhere(self):
        self.mimo("new", "task", "hold_up")
        self.assertEqual(self.files(), ["hold_up/CMakeLists.txt", "hold_up/hold_up.h", "hold_up/test.cpp"])
        self.assertIn("class HoldUp : public mimo::Task", (self.folder / "hold_up/hold_up.h").read_text())

    def test_nothing_is_written_over(self):
        (self.folder / "nose").mkdir()
        (self.folder / "nose/mine.txt").write_text("mine")
        (self.folder / "toes").write_text("mine")
        for name in ("nose", "toes"):
            self.assertIn(f"{name} exists already", self.mimo("new", "sense", name, code=1))
        self.assertEqual(self.files(), ["nose/mine.txt", "toes"])

    def test_names_that_no_sense_can_have(self):
        for name in ("Nose", "my nose", "../nose", "nose/left", "1nose", "_", "n" * 64, ""):
            self.assertIn(f'NAME is "{name}"', self.mimo("new", "sense", name, code=1))
        for arguments in (["new"], ["new", "sense"], ["new", "smell", "nose"], ["new", "sense", "nose", "left"]):
            self.assertIn("--help", self.mimo(*arguments, code=2))
        self.assertEqual(self.files(), [])

    def test_a_folder_that_cannot_be_made(self):
        self.folder.chmod(0o500)
        try:
            import os
            if os.access(self.folder, os.W_OK):
                self.skipTest("this user may write everywhere")
            self.assertIn("nose cannot be made", self.mimo("new", "sense", "nose", code=1))
        finally:
            self.folder.chmod(0o700)


if __name__ == "__main__":
    unittest.main(verbosity=2)
