"""Movements of infants with few numbers: a posture, a rhythm, an answer to tilting, a stretch reflex. For cohort.py.

Goals of joints, rad from the start pose, are a posture, the same left and right; plus a rhythm of one period, opposite
left and right, sine plus cosine, so that it pulls at once and first grows; plus what answers the labyrinth: pitch and
its rate the same left and right, roll and its rate opposite. In every step the reflex gives each motor
stiffness (goal - angle) - damping velocity, as share of its strength, within its bounds. A movement is a row of COUNT
numbers that a search draws around 0 with deviation 1.
"""

import numpy as np

import mimo
from mimo.policy import StretchReflex

ANGLES, VELOCITIES = "proprioception/position", "proprioception/velocity"
LABYRINTH = (("vestibular/acceleration", 9.81), ("vestibular/angular_velocity", 1.0))  # with what scales them
CLIP = 10.0  # scaled numbers of the labyrinth go no further
PITCH, ROLL, PITCHING, ROLLING = 0, 1, 4, 3  # their places in the labyrinth's numbers
SPEEDS = {"stiffness": 2.0, "damping": 0.1, "period": 1.5}  # in the middle: shares of strength per rad, per rad/s; s
SPREAD = {"stiffness": 0.5, "damping": 0.5, "period": 0.4, "rhythm": 1.0, "balance": 1.0}  # of their logarithms
LARGE = {"posture": 0.3, "rhythm": 0.3, "tilt": 0.1, "turning": 0.05}  # deviations of goals, rad; by g, rad/s

POSTURE = ["hip_bend", "head_tilt", "shoulder_horizontal", "shoulder_abduction", "shoulder_internal", "elbow"]
POSTURE += ["wrist_flexion", "hip_flex", "hip_abduction", "hip_rotation", "knee", "foot_flexion"]
RHYTHM = ["hip_twist", "hip_lean", "head_swivel", "shoulder_horizontal", "shoulder_abduction", "shoulder_internal"]
RHYTHM += ["elbow", "hip_flex", "hip_abduction", "hip_rotation", "knee", "foot_flexion"]
SAGITTAL = ["hip_bend", "shoulder_horizontal", "hip_flex", "knee", "foot_flexion"]
FRONTAL = ["hip_lean", "hip_flex", "hip_abduction", "foot_inversion"]
# Motors, what moves them, whether left and right are opposite, and how large a number of 1 is.
PARTS = [(POSTURE, "posture", False, "posture"), (RHYTHM, "clock", True, "rhythm")]
PARTS += [(SAGITTAL, PITCH, False, "tilt"), (SAGITTAL, PITCHING, False, "turning")]
PARTS += [(FRONTAL, ROLL, True, "tilt"), (FRONTAL, ROLLING, True, "turning")]
COUNT = len(SPREAD) + sum(len(motors) for motors, *_ in PARTS)

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


def spread_over(names, motors, opposite):
    """A row for each name: 1 at its motors, and where left and right are opposite -1 on the left."""
    rows = np.zeros((len(names), len(motors)))
    for row, name in zip(rows, names):
        for place, motor in enumerate(motors):
            if motor in (f"act:{name}", f"act:right_{name}"):
                row[place] = 1
            elif motor == f"act:left_{name}":
                row[place] = -1 if opposite else 1
    return rows


class Movement:
    """What a row of numbers means: posture, rhythm and balance as weights of goals, the reflex and the period."""

    def __init__(self, numbers, motors):
        logarithms = dict(zip(SPREAD, np.array(list(SPREAD.values())) * numbers[: len(SPREAD)]))
        self.stiffness, self.damping, self.period = (
            SPEEDS[name] * np.exp(logarithms[name]) for name in ("stiffness", "damping", "period")
        )
        rhythm, balance = np.exp(logarithms["rhythm"]), np.exp(logarithms["balance"])
        sizes = {"posture": 1, "rhythm": rhythm, "tilt": balance, "turning": balance}
        self.posture, self.clock, self.balance = None, None, np.zeros((6, len(motors)))
        place = len(SPREAD)
        for names, moved_by, opposite, size in PARTS:
            part = numbers[place : place + len(names)] @ spread_over(names, motors, opposite)
            part *= sizes[size] * LARGE[size]
            place += len(names)
            if moved_by == "posture":
                self.posture = part
            elif moved_by == "clock":
                self.clock = part
            else:
                self.balance[moved_by] = part


class Infants:
    """Worlds of one behaviour and age, with the nerves of that age; each has its movement. A step is 10 ms."""

    def __init__(self, behaviour, age, count, strength, pose_noise):
        self.batch = mimo.Batch(
            behaviour,
            count,
            task="behaviour",
            ages=[{"age": age, "maturity": ["body", "delays"]}],
            threads=1,
            touch=False,
            vision=False,
            strength=strength,
            parameters={"behaviour/ends_on_success": 1, "behaviour/pose_noise": pose_noise},
        )
        batch, self.behaviour = self.batch, behaviour
        labels = list(batch.layout.fields[ANGLES].labels)
        self.joints = [joint_of(motor) for motor in batch.action_names]
        self.places = [labels.index(joint) for joint in self.joints]
        self.views = {name: view.reshape(count, -1) for name, view in batch.layout.views(batch.blocks).items()}
        self.start = stored_pose(behaviour)[self.places]
        self.seconds = batch.world(0).timestep * batch.world(0).frame_skip
        self.scale = np.concatenate([np.full(3, scale) for _, scale in LABYRINTH])
        self.stiffness, self.damping, self.period = np.zeros((count, 1)), np.zeros((count, 1)), np.ones(count)
        self.weights = np.zeros((count, 9, len(self.joints)))
        self.steps = np.zeros(count, int)  # of each world's attempt

    def begin(self, world, numbers):
        """Gives a world a movement; reset begins it."""
        movement = Movement(numbers, self.batch.action_names)
        self.stiffness[world], self.damping[world] = movement.stiffness, movement.damping
        self.period[world] = movement.period
        self.weights[world] = np.vstack([movement.posture, movement.clock, movement.clock, movement.balance])

    def reset(self, seeds, mask=None):
        self.batch.reset(seeds, mask)
        self.steps[... if mask is None else mask] = 0

    def step(self):
        """Progress, whether all holds, effort; success; and whose time is over, of each world."""
        views, batch = self.views, self.batch
        turn = 2 * np.pi * self.steps * self.seconds / self.period
        felt = np.hstack([views[name] for name, _ in LABYRINTH]) / self.scale
        moved_by = np.column_stack([np.ones(len(turn)), np.sin(turn), np.cos(turn), np.clip(felt, -CLIP, CLIP)])
        goals = self.start + np.einsum("wi,wij->wj", moved_by, self.weights)
        pull = self.stiffness * (goals - views[ANGLES][:, self.places])
        pull -= self.damping * views[VELOCITIES][:, self.places]
        now = batch.step(np.clip(pull, batch.action_low, batch.action_high).astype(np.float32))
        self.steps += 1
        progress, held, control = now.terms.T
        return progress, held > 0, -control, now.terminated[:, 0], now.truncated[:, 0]

    def achieved(self):
        """The measure, the conditions, and the longest time for which all held, of each world."""
        return np.asarray(self.batch.get(mimo.Quantity.AGENT_ACHIEVED)).reshape(len(self.batch), -1)


def stored_pose(behaviour):
    """Angles in which the scene's infant of 18 months starts."""
    world = mimo.World(behaviour, touch=False, vision=False, parameters={"behaviour/pose_noise": 0})
    world.reset(seed=0)
    return np.array(world.observation[ANGLES])


def policy_of(infants, numbers, **told):
    """For the program, the browser and Python: one layer, a clock of one period, and the reflex."""
    motors = infants.batch.action_names
    movement = Movement(numbers, motors)
    weights = np.vstack([movement.balance, movement.clock, movement.clock]).T
    deviation = np.concatenate([infants.scale, np.ones(2)])
    return mimo.Policy(
        [(name, 3) for name, _ in LABYRINTH],
        motors,
        [(weights, movement.posture)],
        np.zeros(8),
        deviation,
        clip=CLIP,
        scene=infants.behaviour,
        delays=True,
        step_seconds=infants.seconds,
        clock_s=[movement.period],
        reflex=StretchReflex(movement.stiffness, movement.damping, infants.joints, list(infants.start)),
        **told,
    )
