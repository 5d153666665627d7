"""`mimo replay --motion`: a table of joint positions is followed."""
import csv
import json
import math
import time
import unittest

from program import Case
from skeleton import JOINTS, bvh


LEGS = 0.135 + 0.177  # m from hip to knee and to ankle, of the body at 18 months (models/mimo/parts)


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

    def test_an_infant_in_free_fall_is_held_by_no_force(self):
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

    def test_joints_beyond_their_limits_are_listed(self):
        self.assertEqual(self.follow("time,left_elbow\n0,0\n1,2\n")["beyond_limits"], ["robot:left_elbow"])

    def joints(self, *arguments):
        """Rows of the joints' positions, by name."""
        self.mimo("replay", "--scene", "free", "--touch", "off", "--joints", "joints.csv", *arguments)
        with (self.folder / "joints.csv").open() as file:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]

    def test_a_shank_that_hangs_back_is_a_bent_knee(self):
        """Thighs as they stand; the left shank is turned by 0.7 rad about the axis that points left, so backwards."""
        half = 0.35
        rows = "".join("%g,1,0,0,0,%.17g,0,%.17g,0\n" % (time, math.cos(half * share), math.sin(half * share))
                       for time, share in ((0, 0), (0.1, 0.5), (0.2, 1)))
        names = ["%s:%s" % (body, part) for body in ("left_upper_leg", "left_lower_leg") for part in ("qw", "qx", "qy", "qz")]
        path = self.write("poses.csv", "time,%s\n%s" % (",".join(names), rows))
        rows = self.joints("--motion", path)
        for row, angle in zip(rows, (0, 0.35, 0.7)):
            self.assertAlmostEqual(row["robot:left_knee"], -angle, delta=1e-9)
            self.assertAlmostEqual(row["robot:left_hip1"], 0, delta=1e-9)
        report = self.follow((self.folder / "poses.csv").read_text())
        self.assertLess(report["pose_errors"]["left_lower_leg"]["angle_largest"], 1e-9)

    def test_what_a_joint_cannot_do_is_told(self):
        """A knee bends about one axis only: a shank that is turned by 0.2 rad about itself stays 0.2 rad off, where the
        thigh has to stay."""
        rows = "".join("%g,%s%.17g,0,0,%.17g\n" % (time, "1,0,0,0," * 3, math.cos(0.1), math.sin(0.1)) for time in (0, 1))
        bodies = ["mimo_location", "hip", "left_upper_leg", "left_lower_leg"]
        names = ",".join("%s:%s" % (body, part) for body in bodies for part in ("qw", "qx", "qy", "qz"))
        errors = self.follow("time,%s\n%s" % (names.replace("mimo_location:", "root:"), rows))["pose_errors"]
        self.assertEqual(set(errors), set(bodies[1:]))
        self.assertAlmostEqual(errors["left_upper_leg"]["angle_largest"] + errors["left_lower_leg"]["angle_largest"], 0.2,
                               delta=1e-6)
        self.assertAlmostEqual(errors["left_lower_leg"]["angle_largest"], 0.1, delta=1e-6)  # least squares share it

    def test_a_place_alone_moves_the_whole_infant(self):
        rows = self.joints("--motion", self.write("places.csv", "time,hip:x,hip:y,hip:z\n0,0,0,0.4\n1,0.3,-0.2,0.5\n"))
        for axis, there in zip("xyz", (0.3, -0.2, 0.5)):
            self.assertAlmostEqual(rows[1]["mimo_orientation:" + axis], there, delta=1e-9)

    def test_a_skeleton_stands_bends_and_turns(self):
        """Arms that hang, an elbow bent by a right angle, a knee by 60 degrees; then a quarter turn to the left."""
        hang = {"LeftArm": (-80, 0, 0), "RightArm": (80, 0, 0)}
        bent = dict(hang, LeftForeArm=(0, 0, -90), RightLeg=(0, 60, 0))
        turned = dict(bent, Hips=(0, 0, 90), at=(10, 90, 0))
        for up in ("z", "y"):
            path = self.write("walk.bvh", bvh(hang, bent, turned, up=up))
            rows = self.joints("--motion", path, "--up", up)
            self.assertAlmostEqual(rows[0]["robot:left_elbow"], 0, delta=0.02)
            self.assertAlmostEqual(rows[1]["robot:left_elbow"], -math.pi / 2, delta=1e-6)
            self.assertAlmostEqual(rows[1]["robot:right_elbow"], 0, delta=0.02)
            self.assertAlmostEqual(rows[1]["robot:right_knee"], -math.pi / 3, delta=1e-6)
            self.assertAlmostEqual(rows[1]["robot:left_knee"], 0, delta=1e-6)
            self.assertAlmostEqual(rows[2]["mimo_orientation:qw"], math.sqrt(0.5), delta=1e-6)
            self.assertAlmostEqual(rows[2]["mimo_orientation:qz"], math.sqrt(0.5), delta=1e-6)  # about what is up
            # 10 cm to its left, in units of legs: the skeleton's are 80 cm, the infant's so many
            legs = abs(rows[2]["mimo_orientation:y"] - rows[1]["mimo_orientation:y"]) * 80 / 10
            self.assertAlmostEqual(legs, LEGS, delta=1e-3)
        scaled = self.joints("--motion", path, "--scale", "0.001")
        self.assertAlmostEqual(scaled[2]["mimo_orientation:y"] - scaled[1]["mimo_orientation:y"], 0.01, delta=1e-6)

    def test_prefixed_names_are_known_and_others_need_a_map(self):
        frames = [{"LeftLeg": (0, 50, 0)}]
        rows = self.joints("--motion", self.write("a.bvh", bvh(*frames, rename=lambda name: "mixamorig:" + name)))
        self.assertAlmostEqual(rows[0]["robot:left_knee"], -math.radians(50), delta=1e-6)
        own = self.write("own.bvh", bvh(*frames, rename=lambda name: "bone_" + name))
        self.assertIn("--map", self.mimo("replay", "--motion", own, code=1))
        names = self.write("map.csv", "bone_LeftUpLeg,left_upper_leg\nbone_LeftLeg, left_lower_leg\n")
        rows = self.joints("--motion", own, "--map", names)
        self.assertAlmostEqual(rows[0]["robot:left_knee"], -math.radians(50), delta=1e-6)
        for line, word in (("bone_Tail,left_foot\n", "bone_Tail"), ("bone_Head,wing\n", "'wing'"), ("bone_Head\n", "line 1")):
            self.write("map.csv", line)
            self.assertIn(word, self.mimo("replay", "--motion", own, "--map", names, code=1))

    def bent_elbow(self, text, *arguments):
        """The left elbow in degrees, in the second frame of a skeleton whose forearm is turned by 60 degrees there."""
        return math.degrees(self.joints("--motion", self.write("a.bvh", text), *arguments)[1]["robot:left_elbow"])

    def test_a_map_of_one_arm_leaves_the_other_joints_their_usual_names(self):
        """Only the mapped arm moves, but hips, head and legs still say which axis points up and how long legs are."""
        names = {"LeftArm": "Bip01 L Up", "LeftForeArm": "Bip01 L Fore"}
        table = self.write("map.csv", "Bip01 L Up,left_upper_arm\nBip01 L Fore,left_lower_arm\n")
        turned = {"LeftForeArm": (0, 0, -60), "LeftLeg": (0, 50, 0)}
        for up in ("y", "z"):
            path = self.write("a.bvh", bvh({}, turned, rename=lambda name: names.get(name, name), up=up))
            rows = self.joints("--motion", path, "--map", table)
            self.assertAlmostEqual(math.degrees(rows[1]["robot:left_elbow"]), -60, delta=0.2)
            self.assertEqual(rows[1]["robot:left_knee"], rows[0]["robot:left_knee"])

    def test_a_straight_elbow_bends_in_any_plane(self):
        """From an arm stretched to the side the forearm goes forwards, down, or up: the upper arm turns for it."""
        for turn in ((0, 0, -60), (-60, 0, 0)):
            self.assertAlmostEqual(self.bent_elbow(bvh({}, {"LeftForeArm": turn})), -60, delta=0.5)

    def test_names_of_other_programs_give_the_same_movement(self):
        """The same movement by the names of other programs."""
        frames = [{}, {"LeftForeArm": (0, 0, -60)}]
        sides = ("UpLeg", "Leg", "Foot", "Arm", "ForeArm", "Hand")
        families = {  # those of the legs and arms, left; a name per word of `sides`
            "Biovision": ("LeftHip", "LeftKnee", "LeftAnkle", "LeftShoulder", "LeftElbow", "LeftWrist"),
            "SMPL": ("L_Hip", "L_Knee", "L_Ankle", "L_Shoulder", "L_Elbow", "L_Wrist"),
            "Biped": ("Bip01 L Thigh", "Bip01 L Calf", "Bip01 L Foot", "Bip01 L UpperArm", "Bip01 L Forearm", "Bip01 L Hand"),
            "Unreal": ("thigh_l", "calf_l", "foot_l", "upperarm_l", "lowerarm_l", "hand_l"),
            "VRM": ("J_Bip_L_UpperLeg", "J_Bip_L_LowerLeg", "J_Bip_L_Foot", "J_Bip_L_UpperArm", "J_Bip_L_LowerArm", "J_Bip_L_Hand"),
        }
        right = self.bent_elbow(bvh(*frames))
        self.assertAlmostEqual(right, -60, delta=0.2)
        for family, left in families.items():
            names = {"Left" + part: name for part, name in zip(sides, left)}
            other = {"Left": "Right", "L_": "R_", " L ": " R ", "_l": "_r", "_L_": "_R_"}
            for part, name in list(names.items()):
                word = next(word for word in other if word in name)
                names[part.replace("Left", "Right")] = name.replace(word, other[word], 1)
            if family == "Biped":
                names["Hips"] = "Bip01 Pelvis"
            text = bvh(*frames, rename=lambda name, names=names: names.get(name, name))
            self.assertAlmostEqual(self.bent_elbow(text), right, delta=1e-6, msg=family)

    def test_names_that_are_known_in_part_are_refused(self):
        text = bvh({}, {}, rename=lambda name: name.replace("Leg", "Limb"))
        message = self.mimo("replay", "--motion", self.write("a.bvh", text), "--scene", "free", code=1)
        self.assertIn("no joint has a usual name for left_upper_leg, left_lower_leg, right_upper_leg, right_lower_leg; --map", message)
        # names that say one thing, bones that say another
        text = bvh({}, {}, rename=lambda name: {"LeftForeArm": "RightForeArm", "RightForeArm": "LeftForeArm"}.get(name, name))
        message = self.mimo("replay", "--motion", self.write("a.bvh", text), "--scene", "free", code=1)
        self.assertIn("'LeftForeArm' is called as left_lower_arm usually is, but does not hang on 'LeftArm'", message)

    def test_a_skeleton_has_to_stand_at_rest(self):
        """Bones that lie along x at rest, as Rokoko's; in the first frame they are turned so that the skeleton stands."""
        lie = {name: (name, parent, (sum(x * x for x in offset) ** 0.5, 0, 0)) for name, parent, offset in JOINTS}
        # the trunk is turned up; arms go out to both sides, seen from there; legs back down
        stand = {"Spine": (90, 0, 0), "LeftArm": (-90, 0, 0), "RightArm": (90, 0, 0), "LeftUpLeg": (-90, 0, 0), "RightUpLeg": (-90, 0, 0)}
        hips = {"LeftUpLeg": (9, -2, 0), "RightUpLeg": (-9, -2, 0), "LeftArm": (15, -15, 0), "RightArm": (15, 15, 0)}
        bones = [(name, parent, hips.get(name, offset)) for name, parent, offset in lie.values()]
        bent = dict(stand, LeftForeArm=(-60, 0, 0))
        text = bvh(stand, bent, joints=bones)
        message = self.mimo("replay", "--motion", self.write("a.bvh", text), "--scene", "free", code=1)
        self.assertIn("does not stand upright at rest", message)
        self.assertIn("--rest-frame N", message)
        self.assertAlmostEqual(self.bent_elbow(text, "--rest-frame", "0"), -60, delta=0.5)
        message = self.mimo("replay", "--motion", "a.bvh", "--rest-frame", "2", "--scene", "free", code=1)
        self.assertIn("--rest-frame is 2, the frames are 0 to 1", message)

    def test_the_skeleton_tells_what_is_up(self):
        frames = [{}, {"LeftForeArm": (0, 0, -60)}]
        for up, other in (("y", "z"), ("z", "y")):
            path = self.write("a.bvh", bvh(*frames, up=up))
            row = self.joints("--motion", path)[0]
            self.assertAlmostEqual(row["mimo_orientation:qw"] ** 2 + row["mimo_orientation:qz"] ** 2, 1, delta=1e-6)
            message = self.mimo("replay", "--motion", path, "--up", other, "--scene", "free", code=1)
            self.assertIn("--up is %s, but the skeleton stands along %s" % (other, up), message)

    def test_files_that_exporters_write_differently_are_read(self):
        frames = [{}, {"LeftForeArm": (0, 0, -60)}]
        whole = bvh(*frames)
        right = self.bent_elbow(whole)
        prop = "ROOT Prop\n{\nOFFSET 5 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION"
        rows = whole.replace("MOTION", prop).splitlines()
        rows[-2:] = [row + " 0 0 0" for row in rows[-2:]]
        for text in ("\ufeff" + whole, whole.replace("End Site", "End site"), whole.replace("End Site", "END SITE"),
                     whole.replace("\n", "\r\n"), whole.replace("\n{\n", "{").replace("End Site\n{", "End Site{"),
                     whole.replace("rotation", "ROTATION").replace("Xposition", "xPosition"), whole.replace("Frames: 2", "Frames: 1"), whole.replace("Frames: 2", "Frames: 3"),
                     whole.replace("Frames: ", "Frames:").replace("Time: ", "Time:"), whole.replace("End Site", "End Site Tip"),
                     "\n".join(rows)):
            self.assertAlmostEqual(self.bent_elbow(text), right, delta=1e-9)
        report = json.loads(self.mimo("replay", "--scene", "free", "--touch", "off", "--json", "--motion",
                                      self.write("a.bvh", whole.replace("Frames: 2", "Frames: 1"))))
        self.assertIn("'Frames:' says 1, the file has 2: all of these are read", report["notes"])

    def test_joints_that_move_no_body_are_told(self):
        joints = JOINTS + (("Tail", "Hips", (0, 0, -10)),)
        path = self.write("a.bvh", bvh({}, {}, joints=joints))
        report = json.loads(self.mimo("replay", "--scene", "free", "--touch", "off", "--json", "--motion", path))
        self.assertEqual(report["notes"], ["joints that move no body: Tail"])

    def test_a_limb_without_anything_below_it_is_refused(self):
        text = bvh({}, {}, joints=[joint for joint in JOINTS if joint[0] != "LeftHand"])
        self.assertAlmostEqual(self.bent_elbow(text), -90, delta=0.2)  # its end site points down, the arm to the side
        message = self.mimo("replay", "--scene", "free", "--motion", self.write("a.bvh", text.replace("OFFSET 0 -5 0", "OFFSET 0 0 0")), code=1)
        self.assertIn("nothing tells where 'LeftForeArm', which moves left_lower_arm, points to", message)

    def test_tables_of_spreadsheets(self):
        """R's write.csv quotes, countries with a decimal comma separate by semicolons, editors put a mark first."""
        for table in ('"time","left_elbow"\n0,-0.1\n0.04,-0.2\n', 'time,left_elbow\n"0","-0.1"\n"0.04","-0.2"\n',
                      "time;left_elbow\n0;-0,1\n0,04;-0,2\n", "time\tleft_elbow\n0\t-0,1\n0,04\t-0,2\n",
                      "\ufefftime,left_elbow\n0,-0.1\n0.04,-0.2\n", "time,left_elbow\r0,-0.1\r0.04,-0.2\r",
                      ' "time" , "left_elbow" \r\n "0" ,-0.1\r\n0.04, "-0.2"\r\n'):
            rows = self.joints("--motion", self.write("m.csv", table))
            self.assertEqual([round(row["robot:left_elbow"], 12) for row in rows], [-0.1, -0.2])
        names = self.write("map.csv", '\ufeff"LeftUpLeg";"left_upper_leg"\n"LeftLeg";left_lower_leg\n')
        rows = self.joints("--motion", self.write("a.bvh", bvh({"LeftLeg": (0, 50, 0)})), "--map", names)
        self.assertAlmostEqual(rows[0]["robot:left_knee"], -math.radians(50), delta=1e-6)

    def test_bad_skeletons_are_refused_with_a_reason(self):
        whole = bvh({}, {})
        for text, message in ((whole[:200], "the file ends"), (whole[:-20], "line "), (whole + "3", "51 numbers for each frame"),
                              (whole.replace("Frames: 2", "Frames: 4"), "expected 4 frames, as 'Frames:' says, not '2'"),
                              (whole.replace("Frames: 2", "Frames: many"), "many"), ("time,left_elbow\n0,0\n", "HIERARCHY"),
                              (whole.replace("Xposition", "Wposition", 1), "Wposition"), ("", "the file ends"),
                              (whole.replace("Frame Time: 0.05", "Frame Time: 0"), "frame time from 1e-6 to 3600 s, not '0'"),
                              (whole.replace("OFFSET 0 0 0", "OFFSET 0 nan 0", 1), "nan"),
                              ("HIERARCHY\nROOT a\n" + "{ OFFSET 0 0 0 CHANNELS 0 JOINT b\n" * 2000, "at most")):
            path = self.write("bad.bvh", text)
            self.assertIn(message, self.mimo("replay", "--motion", path, "--scene", "free", "--joints", "j.csv", code=1))
        self.assertNotIn("j.csv", self.files())

    def test_bad_tables_are_refused_with_a_reason(self):
        for table, message in (("left_elbow\n0\n", "no column 'time'"), ("time,nose\n0,0\n", "no joint for column 'nose'"),
                               ("time,left_elbow\n0,0\n0,1\n", "does not increase in row 2"),
                               ("time,left_elbow\n0,zero\n", "line 2"), ("time,left_elbow\n0\n", "line 2"),
                               ("time,left_elbow\n", "no rows"), ("", "header of joint names"),
                               ("time,mimo_orientation:qw\n0,1\n", "four columns"),
                               ("time,hip:x\n0,1\n", "the position of hip has 1 of its 3 columns"),
                               ("time,hip:qw,hip:qx,hip:qy,hip:qz\n0,0,0,0,0\n", "orientation of hip is 0 0 0 0"),
                               ("time,wing:qw\n0,1\n", "of the bodies mimo_location, hip")):
            path = self.write("bad.csv", table)
            self.assertIn(message, self.mimo("replay", "--motion", path, "--scene", "free", "--forces", "f.csv", code=1))
        self.assertIn("nothing.csv", self.mimo("replay", "--motion", "nothing.csv", code=1))
        self.assertIn("--motion", self.mimo("replay", "run.h5", "--forces", "forces.csv", code=2))
        self.assertIn("required", self.mimo("replay", code=2))
        self.assertEqual([name for name in self.files() if name != "bad.csv"], [])

    def refused(self, name, text, *arguments):
        """Of `mimo replay --motion`: what it says, after the program's own name."""
        path = self.write(name, text)
        return self.mimo("replay", "--motion", path, "--scene", "free", *arguments, code=1).split(": ", 1)[1]

    def test_cells_whose_quotes_do_not_close_are_refused(self):
        head = "time,left_elbow\n0,0\n"
        for table, message in (('time,"left_elbow\n0,0\n', "line 1: the quote before 'left_elbow' is not closed"),
                               ('"time,left_elbow\n0,0\n', "line 1: the quote before 'time,left_elbow' is not closed"),
                               (head + '1,"0.5\n', "line 3: the quote before '0.5' is not closed"),
                               (head + '1,"0.5""\n', "line 3: the quote before '0.5\"\"' is not closed"),
                               (head + '1,"0"5\n', "line 3: the quoted cell '0' is followed by '5'; expected the next cell"),
                               (head + '"1" 2,0\n', "line 3: the quoted cell '1' is followed by '2,0'; expected the next cell"),
                               (head + '1,0"5\n', "line 3: the cell '0\"5' has a quote within")):
            self.assertIn("m.csv, " + message, self.refused("m.csv", table))
        names = self.write("map.csv", 'LeftUpLeg,"left_upper_leg\n')
        self.assertIn("map.csv, line 1: the quote before 'left_upper_leg' is not closed", self.refused("a.bvh", bvh({}), "--map", names))

    def test_tables_with_many_columns_are_read_in_time(self):
        """A hundred times as many columns must not take ten thousand times as long."""
        def seconds(columns):
            table = ",".join("c%d" % i for i in range(columns)) + "\n" + ",".join("0" * columns) + "\n"
            before = time.monotonic()
            self.assertIn("no column 'time'", self.refused("wide.csv", table))
            return time.monotonic() - before
        self.assertLess(seconds(200000), 100 * seconds(2000))

    def test_numbers_that_are_slips_are_refused(self):
        whole = bvh({}, {})
        number = "a number from -1e12 to 1e12"
        for name, text, message in (("a.bvh", whole.replace("OFFSET 0 10 0", "OFFSET 0 1e200 0"), number + ", not '1e200'"),
                                    ("a.bvh", whole.replace("\n0 90 0", "\n0 1e300 0"), number + ", not '1e300'"),
                                    ("a.bvh", whole.replace("Time: 0.05", "Time: 1e-300"), "from 1e-6 to 3600 s, not '1e-300'"),
                                    ("a.bvh", whole.replace("Time: 0.05", "Time: 1e300"), "from 1e-6 to 3600 s, not '1e300'"),
                                    ("m.csv", "time,left_elbow\n0,0\n1e300,1\n", "line 3: column 'time' should be " + number),
                                    ("m.csv", "time,left_elbow\n0,0\n1e-9,1\n", "expected a microsecond at least"),
                                    ("m.csv", "time,left_elbow\n0,0\n1e9,1\n", "takes 1e+09 s, expected at most a day (86400 s)")):
            self.assertIn(message, self.refused(name, text))

    def test_skeletons_of_two_meanings_are_refused(self):
        whole = bvh({}, {})
        for new, message in (("LeftArm", "2 joints are called 'LeftArm', expected one for left_upper_arm"),):
            self.assertIn(message, self.refused("a.bvh", whole.replace("JOINT Spine", "JOINT " + new)))
        names = self.write("map.csv", "LeftArm,left_upper_arm\n")
        self.assertIn("a.bvh has two joints 'LeftArm'", self.refused("a.bvh", whole.replace("JOINT Spine", "JOINT LeftArm"), "--map", names))
        # arms alone do not tell what is up; nor does a skeleton that leans by 45 degrees from y to z
        own = bvh({}, rename=lambda name: "bone_" + name)
        arms = self.write("map.csv", "bone_LeftArm,left_upper_arm\nbone_LeftForeArm,left_lower_arm\n")
        self.assertIn("whether the file's y or its z points up; --up does", self.refused("a.bvh", own, "--map", arms))
        self.joints("--motion", self.write("a.bvh", own), "--map", arms, "--up", "y")
        half = math.sqrt(0.5)
        lean = [(name, parent, (x, half * y, half * y)) for name, parent, (x, y, z) in JOINTS]
        self.assertIn("whether the file's y or its z points up; --up does", self.refused("a.bvh", bvh({}, joints=lean)))
        # a second person, whose head is the only one
        head = "ROOT Head\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION"
        rows = whole.replace("JOINT Head", "JOINT Top").replace("MOTION", head).splitlines()
        rows[-2:] = [row + " 0 0 0" for row in rows[-2:]]
        self.assertIn("'Head' is called as head usually is, but hangs on another ROOT than 'Hips'", self.refused("a.bvh", "\n".join(rows)))
        twice = whole.replace("6 Xposition Yposition", "6 Xposition Xposition")
        self.assertIn("expected each position once, not 'Xposition", self.refused("a.bvh", twice))

    def test_messages_are_one_line_whatever_files_hold(self):
        message = self.refused("m.csv", "time,\x1b[31mnose\0\x7f\n0,0\n")
        self.assertIn("column '?[31mnose??'; there are:", message)
        self.assertEqual(message.count("\n"), 1)
        joints = JOINTS + (("Tail\x1b[31m", "Hips", (0, 0, -10)),)
        said = self.mimo("replay", "--scene", "free", "--touch", "off", "--motion", self.write("a.bvh", bvh({}, joints=joints)))
        self.assertIn("joints that move no body: Tail?[31m", said)
        (self.folder / "b.bvh").write_bytes(bvh({}, joints=joints).encode().replace(b"Tail", b"Qu\xe9"))
        report = json.loads(self.mimo("replay", "--scene", "free", "--touch", "off", "--json", "--motion", "b.bvh"))
        self.assertIn("joints that move no body: Qu\ufffd", report["notes"][0])


if __name__ == "__main__":
    unittest.main(verbosity=2)
