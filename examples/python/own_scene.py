"""A scene of one's own: an infant in the free room, a ball that falls on it, and skin that feels it.

Where the ball is, seen from the head, is a field of its own, asked for with add_field.

python own_scene.py
"""

import numpy as np

import mimo

scene = mimo.Scene("free")
scene.add_object("toy", shape=mimo.Shape.SPHERE, size=0.04, position=[0.0, 0.0, 1.5], mass=0.2)
scene.add_agent(vision=False, touch=mimo.Touch.FORCE, touch_scale=0.5)
scene.set_touch("left_foot", 0.005)
scene.add_field("toy/place", mimo.Quantity.BODY_POSITION, "toy", relative_to="head")

with mimo.World(scene) as world:
    toy, head = world.bodies("toy"), world.bodies("head")
    print(f"{world.layout.fields['touch/force'].receptors} touch sensors")
    world.reset(seed=0)
    toy.position = head.position + np.array([0.0, 0.0, 0.3])  # above the head
    for _ in range(60):
        observation = world.step().observation
        force = np.linalg.norm(observation["touch/force"], axis=-1)
        if force.max() > 0:
            break
    skin = world.layout.receptors("touch/force")
    where = world.name(mimo.Kind.BODY, int(skin.bodies[force.argmax()]))
    print(f"after {world.time:.2f} s the {where} feels most: {force.max():.2f} N")
    print(f"the toy is at {observation['toy/place'][0].round(3)} m from the head, in its frame")
