"""`mimo replay --motion`: a table of joint positions is followed."""
import csv
import json
import unittest

from program import Case


class Motion(Case):
    def follow(self, table, *arguments, scene="free"):
        path = self.write("motion.csv", table)
        return json.loads(self.mimo("replay", "--motion", path, "--scene", scene, "--touch", "off", "--json", *arguments))

    def test_a_pose_is_held_with_the_infants_weight(self):
        report = self.follow("time,left_elbow\n0,-0.5\n0.1,-0.5\n")
        weight = 9.81 * json.loads(self.mimo("info", "--scene", "free", "--json"))["mass_kg"]
        root = [name for name in report["largest_forces"] if name.endswith(":fz")]
        self.assertEqual(len(root), 1)
        self.assertAlmostEqual(report["largest_forces"][root[0]], weight, delta=1e-4)
        self.assertEqual((report["steps"], report["rows"], report["beyond_limits"]), (10, 2, []))

    def test_a_smooth_curve_passes_through_the_rows(self):
        """The natural cubic spline through 0, -1, 0 at 0, 1, 2 s bends by 3 rad/s2 in the middle: it starts with
        -1.5 rad/s and ends with 1.5."""
        for names, rows, arguments in (("left_elbow", "0,0\n1,-1\n2,0\n", ()), ("robot:left_elbow", "0,0\n1,-57.29578\n2,0\n", ["--degrees"])):
            senses = self.follow("time,%s\n%s" % (names, rows), *arguments)["senses"]
            self.assertAlmostEqual(senses["proprioception/position"]["min"], -1, places=4)
            self.assertAlmostEqual(senses["proprioception/velocity"]["min"], -1.5, delta=0.01)
            self.assertAlmostEqual(senses["proprioception/velocity"]["max"], 1.5, delta=0.01)

    def test_who_falls_freely_is_held_by_nothing(self):
        """z = z0 - g t^2 / 2, given at 200 rows a second; the balance organ then feels no acceleration."""
        rows = "".join("%.9f,%.9f\n" % (0.005 * i, 2 - 9.81 / 2 * (0.005 * i) ** 2) for i in range(101))
        report = self.follow("time,root:z\n" + rows, "--forces", "forces.csv")
        with open(self.folder / "forces.csv", newline="") as file:
            table = list(csv.DictReader(file))
        self.assertEqual(len(table), 100)
        middle = table[20:80]  # a natural spline does not bend at its ends
        vertical = [name for name in table[0] if name.endswith(":fz")][0]
        self.assertLess(max(abs(float(row[vertical])) for row in middle), 0.05)
        self.assertGreater(report["largest_forces"][vertical], 1)

    def test_a_turn_is_a_quaternion(self):
        """Half a turn about z in a second, told with quaternions of both signs, is pi rad/s."""
        rows = "0,1,0,0,0\n0.5,-0.70710678,0,0,-0.70710678\n1,0,0,0,1\n"
        senses = self.follow("time,root:qw,root:qx,root:qy,root:qz\n" + rows)["senses"]
        turned = max(abs(senses["vestibular/angular_velocity"][end]) for end in ("min", "max"))
        self.assertAlmostEqual(turned, 3.1416, delta=0.7)  # its points are smoothed as numbers

    def test_limits_are_told(self):
        self.assertEqual(self.follow("time,left_elbow\n0,0\n1,2\n")["beyond_limits"], ["robot:left_elbow"])

    def test_bad_tables(self):
        for table, message in (("left_elbow\n0\n", "no column 'time'"), ("time,nose\n0,0\n", "no joint for column 'nose'"),
                               ("time,left_elbow\n0,0\n0,1\n", "does not increase in row 2"),
                               ("time,left_elbow\n0,zero\n", "line 2"), ("time,left_elbow\n0\n", "line 2"),
                               ("time,left_elbow\n", "no rows"), ("", "header of joint names"),
                               ("time,mimo_orientation:qw\n0,1\n", "four columns")):
            path = self.write("bad.csv", table)
            self.assertIn(message, self.mimo("replay", "--motion", path, "--scene", "free", "--forces", "f.csv", code=1))
        self.assertIn("nothing.csv", self.mimo("replay", "--motion", "nothing.csv", code=1))
        self.assertIn("--motion", self.mimo("replay", "run.h5", "--forces", "forces.csv", code=2))
        self.assertIn("required", self.mimo("replay", code=2))
        self.assertEqual([name for name in self.files() if name != "bad.csv"], [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
