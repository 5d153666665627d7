"""Infants whose actions are goals of joints: a stretch reflex makes torques of them. For cohort.py and learn_pose.py.

An action is a goal for each joint, rad from the start pose, and lasts 50 ms. Every 10 ms the reflex gives each motor
STIFFNESS (goal - angle) - DAMPING velocity, as share of its strength, within its bounds. It is the same at all ages.
"""

import numpy as np

import mimo

SUBSTEPS, FRAME_SKIP = 5, 2  # an action lasts 50 ms, a step of a world 10 ms
STIFFNESS, DAMPING = 2.0, 0.1  # shares of strength per rad, and per rad/s
SEEN = ("proprioception/position", "proprioception/velocity", "proprioception/torque")
SEEN += ("vestibular/acceleration", "vestibular/angular_velocity")
SMALL = 1e-3  # what passes a hyperbolic tangent unchanged is made this small

# Joints of motors whose names differ.
TRUNK = {"hip_bend": "hip_bend1", "hip_twist": "hip_rot1", "hip_lean": "hip_lean1"}
LIMBS = {"shoulder_abduction": "shoulder_ad_ab", "shoulder_internal": "shoulder_rotation"}
LIMBS |= {"wrist_rotation": "hand1", "wrist_flexion": "hand2", "wrist_ulnar": "hand3"}
LIMBS |= {"hip_flex": "hip1", "hip_abduction": "hip2", "hip_rotation": "hip3"}
LIMBS |= {"foot_flexion": "foot1", "foot_inversion": "foot2", "foot_rotation": "foot3"}


def joint_of(motor):
    """The joint that a motor turns, in words of the library."""
    name = motor[len("act:") :]
    side, _, rest = name.partition("_")
    if side in ("left", "right"):
        return f"robot:{side}_{LIMBS.get(rest, rest)}"
    return "robot:" + TRUNK.get(name, name)


class Infants:
    """Worlds of one behaviour, with infants of different ages. Actions are goals of joints, rad from the start."""

    def __init__(self, behaviour, ages, count, strength, **parameters):
        self.batch = mimo.Batch(
            behaviour,
            count,
            task="behaviour",
            ages=ages,
            threads=1,
            frame_skip=FRAME_SKIP,
            touch=False,
            vision=False,
            strength=strength,
            parameters={f"behaviour/{name}": value for name, value in parameters.items()},
        )
        labels = list(self.batch.layout.fields[SEEN[0]].labels)
        self.joints = [labels.index(joint_of(motor)) for motor in self.batch.action_names]
        self.views = self.batch.layout.views(self.batch.blocks)
        self.start = stored_pose(behaviour)[self.joints]
        self.behaviour, self.seconds = behaviour, SUBSTEPS * FRAME_SKIP * self.batch.world(0).timestep

    def observed(self):
        return np.concatenate([self.views[name].reshape(len(self.batch), -1) for name in SEEN], axis=1)

    def reset(self, seeds=None, mask=None):
        self.batch.reset(seeds, mask)
        return self.observed()

    def step(self, action):
        """50 ms: rewards and progress as means of it; who succeeded, and whose time was over, within."""
        goal, low, high = self.start + action, self.batch.action_low, self.batch.action_high
        reward, progress = np.zeros(len(self.batch)), np.zeros(len(self.batch))
        reached, over = np.zeros(len(self.batch), bool), np.zeros(len(self.batch), bool)
        for _ in range(SUBSTEPS):
            angle, velocity = self.views[SEEN[0]][:, self.joints], self.views[SEEN[1]][:, self.joints]
            share = STIFFNESS * (goal - angle) - DAMPING * velocity
            now = self.batch.step(np.clip(share, low, high).astype(np.float32))
            reward += now.reward[:, 0] / SUBSTEPS
            progress += now.terms[:, 0] / SUBSTEPS
            reached |= now.terminated[:, 0] & ~over
            over |= now.terminated[:, 0] | now.truncated[:, 0]
        return self.observed(), reward, progress, reached, over


def stored_pose(behaviour):
    """Angles in which the scene's infant of 18 months starts."""
    world = mimo.World(behaviour, touch=False, vision=False, parameters={"behaviour/pose_noise": 0})
    world.reset(seed=0)
    return np.array(world.observation[SEEN[0]])


def policy_of(infants, goals, layers=(), mean=None, deviation=None, **told):
    """For the program and the browser, which act every 10 ms: the reflex as a part of the network.

    `goals` are the same for ever, or with `layers` what is added to the numbers of the last of them.
    """
    batch, count = infants.batch, len(infants.joints)
    names = SEEN if layers else SEEN[:2]
    fields = [(name, int(np.prod(batch.layout.fields[name].shape))) for name in names]
    width = sum(size for _, size in fields)
    mean, deviation = (
        np.full(width, usual) if given is None else given for given, usual in ((mean, 0.0), (deviation, 1.0))
    )
    reflex, rest = np.zeros((count, width)), STIFFNESS * (infants.start + goals)
    for row, joint in enumerate(infants.joints):
        for place, gain in ((joint, STIFFNESS), (fields[0][1] + joint, DAMPING)):
            reflex[row, place] -= gain * deviation[place]
            rest[row] -= gain * mean[place]
    low, high = (np.asarray(bound, float) for bound in (batch.action_low, batch.action_high))
    half = 2 / (high - low)
    if not layers:
        network = [(half[:, None] * reflex, half * (rest - low) - 1)]
    else:
        network = beside(layers, SMALL * reflex)
        weights = np.hstack([STIFFNESS * layers[-1][0], np.eye(count) / SMALL])
        network.append((half[:, None] * weights, half * (STIFFNESS * layers[-1][1] + rest - low) - 1))
    step = infants.seconds / SUBSTEPS
    return mimo.Policy(
        fields, batch.action_names, network, mean, deviation, scene=infants.behaviour, step_seconds=step, **told
    )


def beside(layers, reflex):
    """All layers but the last, with the numbers of the reflex passed through beside them."""
    count, found = len(reflex), []
    for number, (weights, bias) in enumerate(layers[:-1]):
        rows = len(bias)
        if number == 0:
            joined = np.vstack([weights, reflex])
        else:
            joined = np.block(
                [[weights, np.zeros((rows, count))], [np.zeros((count, weights.shape[1])), np.eye(count)]]
            )
        found.append((joined, np.concatenate([bias, np.zeros(count)])))
    return found
