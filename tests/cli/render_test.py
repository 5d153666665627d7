"""`mimo render`: a picture, and its depths and objects."""
import struct
import unittest

from program import COUNTS, Case, needs_renderer, read_npy, read_png


@needs_renderer
class Render(Case):
    def test_an_eyes_picture_depth_and_segmentation_as_png(self):
        self.mimo("render", "--camera", "eye_left", "--width", "64", "--height", "48", "--out", "eye.png",
                  "--depth", "depth.png", "--segmentation", "ids.png")
        width, height, bits, channels, rows = read_png(self.folder / "eye.png")
        self.assertEqual((width, height, bits, channels), (64, 48, 8, 3))
        self.assertGreater(len(set(rows)), 10)
        self.assertEqual(read_png(self.folder / "depth.png")[:4], (64, 48, 16, 1))
        self.assertEqual(read_png(self.folder / "ids.png")[:4], (64, 48, 8, 3))
        self.assertEqual(self.files(), ["depth.png", "eye.png", "ids.png"])

    def test_depth_and_segmentation_as_npy(self):
        self.mimo("render", "--camera", "eye_left", "--width", "64", "--height", "48", "--out", "eye.png",
                  "--depth", "depth.npy", "--segmentation", "ids.npy")
        kind, shape, depth = read_npy(self.folder / "depth.npy")
        self.assertEqual((kind, shape), ("<f4", (48, 64)))
        kind, shape, ids = read_npy(self.folder / "ids.npy")
        self.assertEqual((kind, shape), ("<i4", (48, 64)))
        self.assertLess(max(ids), COUNTS["geoms"])
        self.assertGreater(len(set(ids)), 2)
        # The box's face is one metre ahead: 1 m + the eye's place - half the box.
        seen = [d for d, i in zip(depth, ids) if i >= 0]
        self.assertGreater(min(seen), 0.5)
        self.assertLess(min(seen), 1.0)

    def test_eyes_of_an_age(self):
        """A newborn sees no colour, and less of what is fine; with perfect eyes it sees as by the plain camera."""
        pictures = {}
        for name, options in (("newborn", ["--age", "0"]), ("perfect", ["--age", "0", "--eyes", "perfect"]),
                              ("year", ["--age", "12"])):
            self.mimo("render", *options, "--camera", "eye_left", "--width", "96", "--height", "64", "--out", "a.png")
            width, height, _, channels, rows = read_png(self.folder / "a.png")
            self.assertEqual((width, height, channels), (96, 64, 3))
            pictures[name] = [[tuple(row[i:i + 3]) for i in range(0, len(row), 3)] for row in rows]
        colours = {name: max(max(pixel) - min(pixel) for row in rows for pixel in row)
                   for name, rows in pictures.items()}
        self.assertEqual(colours["newborn"], 0)
        self.assertGreater(colours["perfect"], 50)
        self.assertGreater(colours["year"], 50)

    def test_each_face_gives_another_picture(self):
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

    def test_the_free_camera_goes_where_options_put_it(self):
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

    def test_sensors_and_forces_are_drawn_on_the_picture(self):
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

    def test_samples_and_effects_change_pictures_and_threads_do_not(self):
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

    def test_wrong_options_are_named_and_write_nothing(self):
        for option, value in (("--samples", "3"), ("--effects", "shadows,glitter"), ("--effects", ","), ("--render-threads", "0")):
            self.assertIn(option, self.mimo("render", option, value, "--out", "a.png", code=2))
        self.assertIn("eye_third", self.mimo("render", "--camera", "eye_third", "--out", "a.png", code=1))
        self.assertIn("no/a.png", self.mimo("render", "--out", "no/a.png", code=1))
        self.assertIn("crayon", self.mimo("render", "--renderer", "crayon", "--out", "a.png", code=1))
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    unittest.main(verbosity=2)
