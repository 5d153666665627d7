"""The world as an engine gets it.

It is drawn here with nothing but meshes, poses, materials and textures, beside the library's own pictures.
"""

import math

import numpy as np
import pytest

import mimo
from mimo.geometry import HEADLIGHT

WIDTH, HEIGHT, FOVY = 160, 120, 45.0
NEAR = 0.01  # m
FOCAL = HEIGHT / 2 / math.tan(math.radians(FOVY) / 2)  # pixels; half the picture is a whole number of them


class Camera:
    """A pinhole at a distance from a point, as the options of pictures describe it."""

    def __init__(self, look_at, distance, azimuth, elevation):
        self.options = dict(look_at=look_at, distance=distance, azimuth=azimuth, elevation=elevation, fovy=FOVY)
        across, up = math.radians(azimuth), math.radians(elevation)
        ahead = np.array([math.cos(up) * math.cos(across), math.cos(up) * math.sin(across), math.sin(up)])
        right = np.cross(ahead, [0, 0, 1]) / np.linalg.norm(np.cross(ahead, [0, 0, 1]))
        self.position = np.asarray(look_at) - distance * ahead
        self.axes = np.stack([right, np.cross(ahead, right), ahead])  # right, down, ahead

    def seen(self, points):
        """Right, down and ahead of the camera, m."""
        return (points - self.position) @ self.axes.T


def turned(rotation, vectors):
    w, axis = rotation[0], np.asarray(rotation[1:], float)
    return vectors + 2 * np.cross(axis, np.cross(axis, vectors) + w * vectors)


def clipped(corners):
    """The part of a polygon (rows: right, down, ahead, and what goes with them) that is in front of the camera."""
    kept = []
    for here, there in zip(corners, np.roll(corners, -1, axis=0)):
        if here[2] >= NEAR:
            kept.append(here)
        if (here[2] >= NEAR) != (there[2] >= NEAR):
            kept.append(here + (NEAR - here[2]) / (there[2] - here[2]) * (there - here))
    return kept


class Canvas:
    """A z-buffer of geoms and their places in textures."""

    def __init__(self):
        self.near = np.zeros((HEIGHT, WIDTH))  # 1 / depth
        self.geom = np.full((HEIGHT, WIDTH), -1)
        self.texcoord = np.zeros((HEIGHT, WIDTH, 2))

    def draw(self, geom, seen, texcoords, triangles):
        corners = np.concatenate([seen, texcoords], axis=1)[triangles]
        sides = np.cross(corners[:, 1, :3] - corners[:, 0, :3], corners[:, 2, :3] - corners[:, 0, :3])
        facing = np.einsum("ij,ij->i", sides, corners[:, 0, :3]) < 0  # counter-clockwise from outside
        # Most triangles are so small that no pixel's middle lies in them.
        places = FOCAL * corners[..., :2] / np.maximum(corners[..., 2:3], NEAR) + 0.5
        covers = (np.ceil(places.min(axis=1)) <= np.floor(places.max(axis=1))).all(axis=1)
        for triangle in corners[facing & (covers | (corners[..., 2] < NEAR).any(axis=1))]:
            if (triangle[:, 2] >= NEAR).all():
                self.fill(geom, triangle)
            elif (triangle[:, 2] >= NEAR).any():
                polygon = clipped(triangle)
                for i in range(2, len(polygon)):
                    self.fill(geom, np.array([polygon[0], polygon[i - 1], polygon[i]]))

    def fill(self, geom, corners):
        x, y = FOCAL * corners[:, 0] / corners[:, 2] + WIDTH / 2, FOCAL * corners[:, 1] / corners[:, 2] + HEIGHT / 2
        left, right = max(0, math.ceil(x.min() - 0.5)), min(WIDTH, math.floor(x.max() + 0.5))
        top, bottom = max(0, math.ceil(y.min() - 0.5)), min(HEIGHT, math.floor(y.max() + 0.5))
        area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])
        if left >= right or top >= bottom or area == 0:
            return
        px, py = np.arange(left, right) + 0.5, np.arange(top, bottom)[:, None] + 0.5
        b = ((px - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (py - y[0])) / area
        c = ((x[1] - x[0]) * (py - y[0]) - (px - x[0]) * (y[1] - y[0])) / area
        parts = np.stack([1 - b - c, b, c], axis=-1) / corners[:, 2]  # as perspective has it
        near, inside = parts.sum(axis=-1), (b >= -1e-9) & (c >= -1e-9) & (b + c <= 1 + 1e-9)
        window = np.s_[top:bottom, left:right]
        wins = inside & (near > self.near[window])
        self.near[window][wins] = near[wins]
        self.geom[window][wins] = geom
        self.texcoord[window][wins] = (parts[wins] @ corners[:, 3:]) / near[wins][:, None]


def draw(world, camera):
    canvas, poses = Canvas(), world.poses("geom")
    for geom, mesh in enumerate(world.meshes(segments=48, plane=1000)):
        if world.appearance(geom).visible:
            placed = turned(poses.rotations[geom], mesh.positions.astype(float)) + poses.positions[geom]
            canvas.draw(geom, camera.seen(placed), mesh.texcoords.astype(float), mesh.triangles)
    return canvas


def colors(world, canvas):
    """Of each pixel that shows a geom in light of strength 1: its material's colour times its texture's."""
    painted = np.zeros((HEIGHT, WIDTH, 3))
    for geom in np.unique(canvas.geom[canvas.geom >= 0]):
        material, where = world.appearance(int(geom)), canvas.geom == geom
        painted[where] = np.minimum(1, (1 + material.emission) * np.array(material.color[:3]))
        if material.texture >= 0:
            pixels = world.texture(material.texture).pixels
            height, width, _ = pixels.shape
            at = np.floor((canvas.texcoord[where] % 1) * [width, height]).astype(int)
            painted[where] *= pixels[np.minimum(at[:, 1], height - 1), np.minimum(at[:, 0], width - 1), :3] / 255
    return painted


def inner(ids):
    """Pixels whose neighbours show the same geom."""
    same = np.ones(ids.shape, bool)
    for rows in (-1, 0, 1):
        for columns in (-1, 0, 1):
            same &= np.roll(ids, (rows, columns), (0, 1)) == ids
    same[[0, -1]] = same[:, [0, -1]] = False
    return same


VIEWS = [
    ("benchmark", {}, Camera([0, 0, 0.3], 1.1, 200, -15)),
    ("benchmark", {"body": "fingers"}, Camera([0, 0, 0.3], 1.0, 140, -10)),
    ("showroom", {}, Camera([0.2, 0, 0.3], 1.8, 160, -25)),
    ("showroom", {}, Camera([0.1, 0, 0.3], 1.2, 20, -40)),
]


@pytest.mark.parametrize(("scene", "options", "camera"), VIEWS)
def test_an_engine_sees_the_same_world(scene, options, camera):
    with mimo.World(scene, vision=False, touch=False, **options) as world:
        world.reset(seed=3)
        for _ in range(20):
            world.step(np.sin(np.arange(len(world.layout.actions))))
        seen = world.draw(width=WIDTH, height=HEIGHT, **camera.options).segmentation
        drawn = draw(world, camera).geom
    inside = inner(seen)
    assert len(np.unique(seen)) > 20
    assert inside.mean() > 0.5
    assert (drawn == seen)[inside].mean() > 0.99
    assert (drawn == seen).mean() > 0.95


LIT = """<mujoco><visual><headlight ambient="1 1 1" diffuse="0 0 0" specular="0 0 0"/></visual>
<asset><texture name="squares" type="2d" builtin="checker" width="64" height="64" rgb1=".9 .2 .1" rgb2=".1 .3 .8"/>
<material name="squares" texture="squares" texrepeat="3 2" specular="0" rgba=".8 .9 1 1"/></asset>
<worldbody><geom type="plane" size="2 3 1" material="squares"/>
<geom type="box" size=".1 .2 .1" pos=".4 .5 .1" rgba=".2 .7 .4 1"/></worldbody></mujoco>"""


@pytest.mark.parametrize("azimuth", [160, 20])
def test_an_engine_sees_the_same_colours(azimuth):
    """Light that is the same everywhere leaves the colours as they are."""
    scene = mimo.Scene(xml=LIT)
    scene.add_agent(body="fingers", vision=False, touch=False)
    camera = Camera([0, 0, 0.25], 1.2, azimuth, -20)
    with mimo.World(scene, render=0, samples=4) as world:
        world.set_face("surprise")
        picture = world.draw(width=WIDTH, height=HEIGHT, **camera.options)
        canvas = draw(world, camera)
        painted = 255 * colors(world, canvas)
    inside = inner(picture.segmentation) & (canvas.geom == picture.segmentation) & (canvas.geom >= 0)
    apart = np.abs(painted - picture.rgb)[inside].max(axis=-1)
    assert np.median(apart) <= 2  # of 255
    assert apart.mean() < 6  # a pixel of ours is one of the texture's, theirs is a mixture


@pytest.fixture(scope="module")
def small():
    with mimo.World("benchmark", vision=False) as world:
        world.reset(seed=1)
        yield world


def test_poses_in_frames_of_engines(small):
    """Unity: x right, y up, z forward, left-handed; quaternions x y z w."""
    ours, unity = small.poses("body"), small.poses("body", axes="unity")
    np.testing.assert_allclose(unity.positions, ours.positions[:, [1, 2, 0]] * [-1, 1, 1], atol=1e-6)
    np.testing.assert_allclose(unity.rotations[:, 3], ours.rotations[:, 0], atol=1e-6)
    unreal = small.poses("geom", axes=mimo.Axes.UNREAL).positions
    np.testing.assert_allclose(unreal, 100 * small.poses().positions * [1, -1, 1], atol=1e-4)
    with pytest.raises(ValueError, match="unity"):
        small.poses(axes="blender")
    with pytest.raises(mimo.ArgumentError, match="expected body, geom, site or camera"):
        small.poses("joint")


def test_touch_sensors_lie_on_the_meshes(small):
    """A sensor's place and a mesh's vertices meet in an engine's frame, a radius from a sphere's middle."""
    receptors = small.layout.receptors("touch/force")
    head = small.find("geom", "head")
    on_head = np.asarray(receptors.geoms) == head
    assert on_head.sum() > 10
    bodies = small.poses("body")
    of = small.find("body", "head")
    placed = turned(bodies.rotations[of], np.asarray(receptors.position)[on_head]) + bodies.positions[of]
    there = mimo.convert_points(placed, "unity") - small.poses("geom", axes="unity").positions[head]
    radius = np.linalg.norm(small.mesh("head", axes="unity").positions, axis=1)
    np.testing.assert_allclose(np.linalg.norm(there, axis=1), radius.max(), atol=1e-5)


def test_changes_show_in_pictures(small):
    world = small.clone()
    before = world.appearance("head")
    world.set_face("surprise")
    assert before.texture != world.appearance("head").texture
    assert world.texture(before.texture).type is mimo.TextureType.CUBE
    assert not np.array_equal(
        world.texture(before.texture).pixels, world.texture(world.appearance("head").texture).pixels
    )
    sky = [world.texture(i).type for i in range(world.texture_count)].count(mimo.TextureType.SKY)
    assert sky == 1
    with pytest.raises(mimo.ArgumentError, match="texture_id is 999"):
        world.texture(999)
    with pytest.raises(ValueError, match="texture is 1099511627776"):
        world.texture(2**40)


def test_lights():
    scene = mimo.Scene(
        xml=LIT.replace("<worldbody>", "<worldbody><light pos='1 2 3' dir='0 3 -4' diffuse='.1 .2 .3'/>")
    )
    with mimo.World(scene) as world:
        (light,) = world.light_sources(axes="unity")
        np.testing.assert_allclose(light.position, [-2, 3, 1], atol=1e-6)
        np.testing.assert_allclose(light.direction, [-0.6, -0.8, 0], atol=1e-6)
        np.testing.assert_allclose(light.diffuse, [0.1, 0.2, 0.3], atol=1e-6)
        assert (light.active, light.casts_shadow, light.directional) == (True, True, False)
        np.testing.assert_allclose(world.light(HEADLIGHT).ambient, 1)
        with pytest.raises(mimo.ArgumentError, match="id is 1"):
            world.light(1)


def test_wrong_arguments(small):
    with pytest.raises(mimo.ArgumentError, match="segments is 6"):
        small.mesh("head", segments=6)
    with pytest.raises(mimo.NotFoundError, match="no geom named"):
        small.appearance("tail")
    with pytest.raises(ValueError, match="rows of 3"):
        mimo.convert_points([1, 2], "godot")
    np.testing.assert_array_equal(mimo.convert_directions([[1, 2, 3]], "gltf"), [[2, 3, 1]])
    with pytest.raises(ValueError, match="rows of 7"):
        mimo.convert_poses([1, 2, 3], "godot")


def test_poses_of_single_bodies(small):
    hands = small.bodies("left_hand", "right_hand")
    poses = mimo.convert_poses(hands.read("pose", now=True), "unreal")
    everything = small.poses("body", axes="unreal")
    np.testing.assert_array_equal(poses[:, :3], everything.positions[hands.ids])
    np.testing.assert_array_equal(poses[:, 3:], everything.rotations[hands.ids])
