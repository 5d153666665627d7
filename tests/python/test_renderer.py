"""mimo.Renderer in the place of mujoco.Renderer: what it shows, its arrays, its errors. Numbers are from geometry."""

import logging
import math
import subprocess
import sys

import numpy as np
import pytest

import mimo

mujoco = pytest.importorskip("mujoco", reason="the package mujoco is not installed")
VERSION = tuple(int(part) for part in mujoco.__version__.split(".")[:2])

# A box on a floor, seen from straight above: its top is 2.5 m away, and 0.4 m wide there.
ROOM = """<mujoco><visual><headlight ambient="1 1 1" diffuse="0 0 0" specular="0 0 0"/></visual>
<worldbody>
  <geom name="floor" type="plane" size="5 5 .1" rgba="0 0 1 1"/>
  <body name="box" pos="0 0 .25"><freejoint/>
    <geom name="box" type="box" size=".2 .2 .25" rgba="1 0 0 1" group="1"/>
    <site name="mark" pos="0 0 .3" size=".05" rgba="0 1 0 1" group="2"/>
  </body>
  <camera name="above" pos="0 0 3" fovy="60"/>
  <camera name="aside" pos="0 -3 1" xyaxes="1 0 0 0 .3 1"/>
</worldbody></mujoco>"""
GEOM, SITE = int(mujoco.mjtObj.mjOBJ_GEOM), int(mujoco.mjtObj.mjOBJ_SITE)


def loaded(xml=ROOM):
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def picture(model, data, camera=-1, option=None, kind="", size=(64, 64), **settings):
    with mimo.Renderer(model, *size, **settings) as renderer:
        if kind:
            getattr(renderer, f"enable_{kind}_rendering")()
        renderer.update_scene(data, camera, option)
        return renderer.render()


@pytest.fixture
def room():
    return loaded()


@pytest.fixture
def renderer(room):
    with mimo.Renderer(room[0], 64, 64) as made:
        made.update_scene(room[1], "above")
        yield made


def test_its_arrays_are_those_of_mujoco(room):
    model, data = room
    with mimo.Renderer(model) as renderer:
        assert (renderer.height, renderer.width) == (240, 320)
        assert renderer.model is model
    with mimo.Renderer(model, 48, 64) as renderer:
        renderer.update_scene(data, camera=0)
        assert (renderer.render().shape, renderer.render().dtype) == ((48, 64, 3), np.uint8)
        renderer.enable_depth_rendering()
        assert (renderer.render().shape, renderer.render().dtype) == ((48, 64), np.float32)
        renderer.enable_segmentation_rendering()
        assert (renderer.render().shape, renderer.render().dtype) == ((48, 64, 2), np.int32)
        renderer.disable_segmentation_rendering()
        assert renderer.render().shape == (48, 64, 3)


def test_colours_depth_and_objects_are_where_they_belong(room):
    model, data = room
    colours, depth = picture(model, data, "above"), picture(model, data, "above", kind="depth")
    objects = picture(model, data, "above", kind="segmentation")
    assert colours[2, 2].tolist() == [0, 0, 255]  # ambient light of 1 alone: as they are painted
    assert colours[32, 34].tolist() == [255, 0, 0]
    assert objects[2, 2].tolist() == [0, GEOM]
    assert objects[32, 34].tolist() == [1, GEOM]
    assert objects[32, 32].tolist() == [0, SITE]
    assert depth[2, 2] == pytest.approx(3, rel=1e-5)
    assert depth[32, 34] == pytest.approx(2.5, rel=1e-5)
    # A box 0.4 m wide, 2.5 m away, under 60 degrees over 64 pixels: 0.4 / (2 * 2.5 * tan 30) of the width.
    wide = (objects[29, :, 0] == 1).sum()
    assert wide == pytest.approx(64 * 0.4 / (5 * math.tan(math.pi / 6)), abs=1)


def test_row_0_is_the_top(room):
    objects = picture(*room, "aside", kind="segmentation")
    assert (objects[0] == -1).all()
    assert (objects[-1] == [0, GEOM]).all()


def test_depth_is_the_far_plane_where_nothing_is(room):
    model, data = room
    depth = picture(model, data, "aside", kind="depth")
    assert depth[0, 0] == pytest.approx(model.vis.map.zfar * model.stat.extent, rel=1e-5)


def test_cameras_by_number_name_and_as_an_object(room):
    model, data = room
    fixed = mujoco.MjvCamera()
    fixed.type, fixed.fixedcamid = int(mujoco.mjtCamera.mjCAMERA_FIXED), 1
    expected = picture(model, data, 1)
    np.testing.assert_array_equal(picture(model, data, "aside"), expected)
    np.testing.assert_array_equal(picture(model, data, fixed), expected)
    np.testing.assert_array_equal(picture(model, data, np.int64(1)), expected)
    assert not np.array_equal(picture(model, data, 0), expected)


def test_a_free_camera_looks_at_its_point(room):
    model, data = room
    free = mujoco.MjvCamera()
    free.lookat[:], free.distance, free.azimuth, free.elevation = (0, 0, 0.5), 2, 90, -90
    depth = picture(model, data, free, kind="depth", size=(65, 65))
    assert depth[32, 36] == pytest.approx(2, rel=1e-5)  # the top of the box
    mujoco.mjv_defaultFreeCamera(model, free)
    np.testing.assert_array_equal(picture(model, data, free), picture(model, data))


def test_a_tracking_camera_follows_its_body(room):
    model, data = room
    tracking = mujoco.MjvCamera()
    tracking.type, tracking.trackbodyid = int(mujoco.mjtCamera.mjCAMERA_TRACKING), 1
    tracking.distance, tracking.elevation = 3, -20
    data.qpos[:3] = 1, 2, 0.7
    mujoco.mj_forward(model, data)
    for _ in range(200):  # MuJoCo moves it little by little
        mujoco.mjv_updateCamera(model, data, tracking, mujoco.MjvScene(model, 1))
    objects = picture(model, data, tracking, kind="segmentation", size=(65, 65))
    assert objects[32, 32].tolist() == [1, GEOM]


@pytest.mark.skipif(VERSION < (3, 1), reason="cameras of this MuJoCo have no intrinsics")
def test_a_camera_with_intrinsics():
    """A sensor of 20 x 10 mm behind 10 mm of focal length, its principal point 2 mm right of the middle."""
    camera = 'resolution="128 64" sensorsize=".02 .01" focal=".01 .01" principal=".002 .001"'
    model, data = loaded(ROOM.replace('fovy="60"', camera))
    objects = picture(model, data, "above", kind="segmentation", size=(64, 128))
    rows, columns = np.nonzero((objects == [0, SITE]).all(axis=2))
    sight = {}
    scene, eye = mujoco.MjvScene(model, 1), mujoco.MjvCamera()
    eye.type, eye.fixedcamid = int(mujoco.mjtCamera.mjCAMERA_FIXED), 0
    mujoco.mjv_updateCamera(model, data, eye, scene)
    frustum = scene.camera[0]
    sight["x"] = 64 * (1 - frustum.frustum_center / frustum.frustum_width)
    height = frustum.frustum_top - frustum.frustum_bottom
    sight["y"] = 64 * frustum.frustum_top / height
    assert frustum.frustum_near / height * 64 == pytest.approx(64, rel=1e-3)  # 10 mm over 10 mm
    assert (columns.mean() + 0.5, rows.mean() + 0.5) == pytest.approx((sight["x"], sight["y"]), abs=0.6)
    assert sight["x"] != pytest.approx(64, abs=3)


@pytest.mark.skipif(
    not hasattr(mujoco.MjModel, "cam_orthographic") and not hasattr(mujoco.MjModel, "cam_projection"),
    reason="cameras of this MuJoCo are not orthographic",
)
def test_an_orthographic_camera():
    """Of 2 m, 100 pixels show the box's .4 m as 20, as far as the camera may be; its top is flat."""
    said = 'projection="orthographic"' if hasattr(mujoco.MjModel, "cam_projection") else 'orthographic="true"'
    for height in (3, 9):
        model, data = loaded(ROOM.replace('pos="0 0 3" fovy="60"', f'pos="0 0 {height}" fovy="2" {said}'))
        option = mujoco.MjvOption()
        option.sitegroup[2] = 0
        objects = picture(model, data, "above", option, "segmentation", (100, 100))
        assert (objects[..., 0] == 1).sum() == 20 * 20
        depth = picture(model, data, "above", option, "depth", (100, 100))
        np.testing.assert_allclose(depth[41:59, 41:59], height - 0.5, rtol=1e-5)
        np.testing.assert_allclose(depth[:30], height, rtol=1e-5)


def test_groups_hide_and_show(room):
    model, data = room
    option = mujoco.MjvOption()
    option.geomgroup[1] = 0
    assert set(np.unique(picture(model, data, "above", option, "segmentation")[..., 1])) == {GEOM, SITE}
    assert picture(model, data, "above", option, "depth")[32, 34] == pytest.approx(3, rel=1e-5)
    option.sitegroup[2] = 0
    assert (picture(model, data, "above", option, "segmentation") == [0, GEOM]).all()


def test_flags_that_concern_colours(room):
    model, data = room
    option = mujoco.MjvOption()
    option.flags[int(mujoco.mjtVisFlag.mjVIS_TRANSPARENT)] = 1
    through = picture(model, data, "above", option)[32, 34]
    assert through[0] < 255  # the box is not alone
    assert through[2] > 0
    option = mujoco.MjvOption()
    option.flags[int(mujoco.mjtVisFlag.mjVIS_STATIC)] = 0
    assert (picture(model, data, "above", option, "segmentation")[2, 2] == -1).all()


def test_a_texture_can_be_switched_off():
    xml = ROOM.replace('rgba="0 0 1 1"', 'material="painted"').replace(
        "<worldbody>",
        '<asset><texture name="t" type="2d" builtin="flat" rgb1="0 1 0" width="8" height="8"/>'
        '<material name="painted" texture="t"/></asset><worldbody>',
    )
    model, data = loaded(xml)
    option = mujoco.MjvOption()
    assert picture(model, data, "above", option)[2, 2].tolist() == [0, 255, 0]
    option.flags[int(mujoco.mjtVisFlag.mjVIS_TEXTURE)] = 0
    assert picture(model, data, "above", option)[2, 2].tolist() == [255, 255, 255]


def test_samples_look_up_the_texture_each():
    """24 fields of a chequered plane across 32 pixels, 1.33 a field, against the shares of black and white in each."""
    xml = """<mujoco><visual><headlight ambient="1 1 1" diffuse="0 0 0" specular="0 0 0"/></visual>
        <asset><texture name="t" type="2d" builtin="checker" rgb1="0 0 0" rgb2="1 1 1" width="512" height="512"/>
          <material name="m" texture="t" texrepeat="12 12" texuniform="false"/></asset>
        <worldbody><geom type="plane" size="1 1 .1" material="m"/>
          <camera name="a" pos="0 0 4" fovy="{}"/></worldbody></mujoco>"""
    seen = loaded(xml.format(math.degrees(2 * math.atan(1 / 4))))
    waves = np.where(np.arange(24 * 32) // 32 % 2, 1.0, -1.0).reshape(32, 24).mean(1)  # of 24 parts of each pixel
    shares = 0.5 - 0.5 * np.outer(waves, waves)
    wrong = {}
    for samples in (1, 4, 16):
        white = picture(*seen, "a", size=(32, 32), samples=samples)[..., 0] / 255
        wrong[samples] = min(np.abs(white - shares).mean(), np.abs(white - (1 - shares)).mean())
    assert wrong[4] < 0.8 * wrong[1]
    assert wrong[16] < 0.35 * wrong[1]


@pytest.mark.skipif(not hasattr(mujoco, "mjtColorSpace"), reason="textures of this MuJoCo have no colour space")
def test_flat_textures_in_srgb_are_decoded_and_cubes_are_not():
    """As MuJoCo draws them. (((188 / 255 + .055) / 1.055) ** 2.4) * 255 = 128.2, and 64 is 13.1 (IEC 61966-2-1)."""
    assets = "".join(
        f'<texture name="{kind}" type="{kind}" builtin="flat" rgb1="{188 / 255} {188 / 255} {64 / 255}" width="8" '
        f'height="8" colorspace="sRGB"/><material name="{kind}" texture="{kind}"/>'
        for kind in ("2d", "cube")
    )
    xml = ROOM.replace('rgba="0 0 1 1"', 'material="2d"').replace('rgba="1 0 0 1"', 'material="cube"')
    model, data = loaded(xml.replace("<worldbody>", f"<asset>{assets}</asset><worldbody>"))
    shown = picture(model, data, "above")
    assert shown[2, 2].tolist() == [128, 128, 13]
    assert shown[32, 34].tolist() == [188, 188, 64]


def test_a_scene_stays_as_it_was_until_the_next_update(room, renderer):
    before = renderer.render()
    room[1].qpos[0] = 1
    mujoco.mj_forward(*room)
    np.testing.assert_array_equal(renderer.render(), before)
    renderer.update_scene(room[1], "above")
    assert not np.array_equal(renderer.render(), before)


def test_changes_of_the_model_show(room, renderer):
    model, data = room
    model.geom_rgba[1] = 1, 1, 0, 1
    model.geom_size[1, 0] = 0.3
    renderer.update_scene(data, "above")
    shown = renderer.render()
    assert shown[32, 34].tolist() == [255, 255, 0]
    assert shown[32, 37].tolist() == [255, 255, 0]  # 0.2 m are 4.4 pixels, 0.3 m are 6.7
    model.vis.headlight.ambient[:] = 0.5
    renderer.update_scene(data, "above")
    assert renderer.render()[32, 34].tolist() == pytest.approx([128, 128, 0], abs=1)


def test_a_height_field_may_change():
    xml = ROOM.replace("<worldbody>", '<asset><hfield name="h" nrow="8" ncol="8" size="1 1 1 .1"/></asset><worldbody>')
    model, data = loaded(xml.replace("</body>", '</body><geom type="hfield" hfield="h" pos="0 0 .01"/>'))
    option = mujoco.MjvOption()
    option.geomgroup[1] = option.sitegroup[2] = 0
    with mimo.Renderer(model, 64, 64) as renderer:
        renderer.enable_depth_rendering()
        renderer.update_scene(data, "above", option)
        assert renderer.render()[32, 32] == pytest.approx(2.99, rel=1e-4)
        model.hfield_data[:] = 1  # 1 m
        renderer.update_scene(data, "above", option)
        assert renderer.render()[32, 32] == pytest.approx(1.99, rel=1e-4)


def test_geoms_that_a_program_adds_to_the_scene(room, renderer):
    data = room[1]
    scene = renderer.scene
    renderer.update_scene(data, "above")
    place, turn, colour = np.array([0, 0, 1.0]), np.eye(3).ravel(), np.array([1, 0, 1, 1], np.float32)
    ball = scene.geoms[scene.ngeom]
    mujoco.mjv_initGeom(ball, int(mujoco.mjtGeom.mjGEOM_SPHERE), np.array([0.1, 0, 0]), place, turn, colour)
    scene.ngeom += 1
    assert renderer.render()[32, 32].tolist() == [255, 0, 255]
    renderer.enable_depth_rendering()
    assert renderer.render()[32, 32] == pytest.approx(1.9, abs=5e-3)  # half a pixel from its top
    renderer.update_scene(data, "above")
    assert renderer.render()[32, 32] > 2


def test_flags_of_the_scene():
    light = '<light pos="1 0 3" dir="-.3 0 -1" castshadow="true"/><camera'
    model, data = loaded(ROOM.replace("<camera", light, 1).replace('ambient="1 1 1"', 'ambient=".2 .2 .2"'))
    with mimo.Renderer(model, 64, 64) as renderer:
        renderer.update_scene(data, "above")
        shaded = renderer.render()
        renderer.scene.flags[int(mujoco.mjtRndFlag.mjRND_SHADOW)] = 0
        bright = renderer.render()
    assert (bright >= shaded).all()
    assert (bright > shaded).any(axis=2).sum() > 20  # the shadow of the box


def test_what_mujoco_adds_to_a_picture(room):
    """Contact points are cylinders that MuJoCo adds: the box touches the floor in four of them."""
    model, data = room
    mujoco.mj_forward(model, data)
    option = mujoco.MjvOption()
    option.flags[int(mujoco.mjtVisFlag.mjVIS_CONTACTPOINT)] = 1
    option.geomgroup[1] = option.sitegroup[2] = 0
    assert data.ncon == 4
    plain, marked = picture(model, data, "above"), picture(model, data, "above", option)
    assert (marked != picture(model, data, "above", without(option))).any()
    assert plain.shape == marked.shape


def without(option):
    bare = mujoco.MjvOption()
    bare.geomgroup[:], bare.sitegroup[:] = option.geomgroup, option.sitegroup
    return bare


def test_out(room, renderer):
    expected = renderer.render()
    out = np.zeros((64, 64, 3), np.uint8)
    assert renderer.render(out=out) is out
    np.testing.assert_array_equal(out, expected)
    other = np.zeros((64, 64, 3), np.float64)
    np.testing.assert_array_equal(renderer.render(out=other), expected)
    gaps = np.zeros((64, 128, 3), np.uint8)[:, ::2]
    np.testing.assert_array_equal(renderer.render(out=gaps), expected)


def test_what_is_wrong_is_named(room, renderer):
    model, data = room
    with pytest.raises(ValueError, match=r"out\.shape == \(64, 64, 3\).*out\.shape=\(64, 64\)"):
        renderer.render(out=np.zeros((64, 64), np.uint8))
    with pytest.raises(ValueError, match=r'"nowhere" does not exist.*above.*aside'):
        renderer.update_scene(data, "nowhere")
    for number in (2, -2, 2**40):
        with pytest.raises(ValueError, match=rf"camera id {number} is out of range \[-1, 2\)"):
            renderer.update_scene(data, number)
    with pytest.raises(TypeError, match=r"camera is 0\.5, expected a number, a name"):
        renderer.update_scene(data, 0.5)
    with pytest.raises(TypeError, match=r"data is None, expected a mujoco\.MjData"):
        renderer.update_scene(None)
    with pytest.raises(TypeError, match=r"scene_option is 1, expected a mujoco\.MjvOption"):
        renderer.update_scene(data, -1, 1)
    with pytest.raises(ValueError, match="data belongs to another model: its geom_xpos"):
        renderer.update_scene(loaded("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>")[1])
    with pytest.raises(TypeError, match=r"model is 3, expected a mujoco\.MjModel"):
        mimo.Renderer(3)
    for size in (0, -1, 2**31, 16385):
        with pytest.raises(ValueError, match=f"height is {size}, expected 1 to 16384"):
            mimo.Renderer(model, size, 64)
        with pytest.raises(ValueError, match=f"width is {size}, expected 1 to 16384"):
            mimo.Renderer(model, 64, size)
    with pytest.raises(ValueError, match="samples is 3, expected 1, 4, 16, 64"):
        mimo.Renderer(model, samples=3)


def test_poses_that_are_not_finite_are_refused(room, renderer):
    room[1].geom_xpos[1] = np.nan
    renderer.update_scene(room[1], "aside")
    with pytest.raises(ValueError, match=r"geom_positions.*nan"):
        renderer.render()


def test_a_closed_renderer_says_so(room):
    renderer = mimo.Renderer(room[0], 8, 8)
    with pytest.raises(RuntimeError, match="render cannot be called before update_scene"):
        renderer.render()
    renderer.close()
    renderer.close()
    with pytest.raises(RuntimeError, match="render cannot be called after close"):
        renderer.render()


def test_what_is_not_drawn_is_told_once(room, caplog):
    model, data = loaded(
        ROOM.replace("</worldbody>", '</worldbody><sensor><rangefinder site="mark"/></sensor>'),
    )
    option = mujoco.MjvOption()
    with caplog.at_level(logging.WARNING, "mimo"), mimo.Renderer(model, 8, 8) as renderer:
        for _ in range(3):
            renderer.update_scene(data, 0, option)
    told = [record.message for record in caplog.records if record.name == "mimo"]
    caplog.clear()
    assert told == ["mimo.Renderer does not draw beams of range finders"]


def test_a_batch_draws_what_single_pictures_show(room):
    model, _ = room
    several = []
    for i in range(3):
        data = mujoco.MjData(model)
        data.qpos[0] = 0.2 * i
        mujoco.mj_forward(model, data)
        several.append(data)
    with mimo.Renderer(model, 32, 48, threads=0) as renderer:
        drawn = renderer.render_batch(several, cameras=[0, "aside"])
        assert (drawn.shape, drawn.dtype) == ((3, 2, 32, 48, 3), np.uint8)
        for i, data in enumerate(several):
            for j, camera in enumerate((0, "aside")):
                renderer.update_scene(data, camera)
                np.testing.assert_array_equal(drawn[i, j], renderer.render())
        out = np.zeros_like(drawn)
        assert renderer.render_batch(several, [0, 1], out=out) is out
        np.testing.assert_array_equal(out, drawn)
        renderer.enable_depth_rendering()
        assert renderer.render_batch(several).shape == (3, 1, 32, 48)
        assert renderer.render_batch([]).shape == (0, 1, 32, 48)
        with pytest.raises(ValueError, match=r"out is uint8 of the shape \(3, 2, 32, 48, 3\), expected float32"):
            renderer.render_batch(several, out=out)


def calls_of(model, data, renderer):
    count = 0

    def profile(frame, event, argument):
        nonlocal count
        count += event in ("call", "c_call")

    renderer.update_scene(data)
    sys.setprofile(profile)
    try:
        renderer.update_scene(data)
        renderer.render()
    finally:
        sys.setprofile(None)
    return count


def test_python_does_nothing_for_each_geom():
    counts = []
    for n in (1, 300):
        geoms = "".join(f'<geom size=".01" pos="{i / 100} 0 0"/>' for i in range(n))
        model, data = loaded(f"<mujoco><worldbody>{geoms}</worldbody></mujoco>")
        with mimo.Renderer(model, 8, 8) as renderer:
            counts.append(calls_of(model, data, renderer))
    assert counts[0] == counts[1]


def test_importing_mimo_needs_nothing_but_numpy():
    code = (
        "import sys\n"
        "class Nothing:\n"
        "    def find_spec(self, name, path=None, target=None):\n"
        "        if name.split('.')[0] in ('gymnasium', 'typing_extensions', 'mujoco', 'pettingzoo'):\n"
        "            raise ImportError(name)\n"
        "sys.meta_path.insert(0, Nothing())\n"
        "import mimo\n"
        "mimo.Renderer, mimo.Stage\n"
        "print(sorted({name.split('.')[0] for name in sys.modules} & {'gymnasium', 'mujoco', 'scipy', 'PIL'}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (done.returncode, done.stdout.strip()) == (0, "[]"), done.stderr
