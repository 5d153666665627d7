"""Quaternions, against rotations that can be done in the head."""

import numpy as np

import mimo
from mimo.frames import after, inverse, placed, turned

HALF = np.sqrt(0.5)
ABOUT_Z, ABOUT_X = [HALF, 0, 0, HALF], [HALF, HALF, 0, 0]  # a quarter turn each


def test_quarter_turns():
    """About z a quarter turn takes x to y, about x it takes y to z."""
    np.testing.assert_allclose(turned(ABOUT_Z, [[1, 0, 0], [0, 1, 0]]), [[0, 1, 0], [-1, 0, 0]], atol=1e-12)
    np.testing.assert_allclose(turned(after(ABOUT_X, ABOUT_Z), [1, 0, 0]), [[0, 0, 1]], atol=1e-12)
    np.testing.assert_allclose(after(ABOUT_X, inverse(ABOUT_X)), [[1, 0, 0, 0]], atol=1e-12)


def test_points_turn_with_their_body():
    scene = mimo.Scene()
    scene.add_object("box", shape=mimo.Shape.BOX, size=[1, 1, 1], position=[5, 0, 0], orientation=[1, 0, 0, 1])
    with mimo.World(scene) as world:
        box = world.bodies("box")
        np.testing.assert_allclose(placed(box.position, box.orientation, [1.0, 0, 0]), [[5, 1, 0]], atol=1e-12)
