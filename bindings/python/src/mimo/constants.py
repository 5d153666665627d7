"""The constants of mimo.h, as enums. A test compares them with the header."""

from __future__ import annotations

from enum import IntEnum, IntFlag


class Proprioception(IntFlag):
    """What the joints tell. ALL is a bit of its own: all that the library has."""

    VELOCITY = 0x01
    TORQUE = 0x02
    LIMIT = 0x04
    ACTUATION = 0x08
    JOINT_TORQUE = 0x10
    POSITION = 0x20
    EFFORT = 0x40
    SPINDLE_PRIMARY = 0x80
    SPINDLE_SECONDARY = 0x100
    TENDON_ORGAN = 0x200
    JOINT_RECEPTOR = 0x400
    ALL = 0x80000000


class Vision(IntFlag):
    """What both eyes give."""

    RGB = 0x01
    DEPTH = 0x02
    SEGMENTATION = 0x04


class Vestibular(IntFlag):
    """What the sense of balance tells."""

    ACCELERATION = 0x1
    ANGULAR_VELOCITY = 0x2
    CANALS = 0x4
    OTOLITHS = 0x8
    GRAVITY = 0x10


class Reflex(IntFlag):
    """Reflexes of newborns. ALL is a bit of its own: all that the body can do. FELT: the field has all of these."""

    PALMAR_GRASP = 0x1
    PLANTAR_GRASP = 0x2
    ROOTING = 0x4
    MORO = 0x8
    ASYMMETRIC_TONIC_NECK = 0x10
    STEPPING = 0x20
    WITHDRAWAL = 0x40
    FELT = 0x40000000
    ALL = 0x80000000


class Hearing(IntFlag):
    """What ears tell."""

    EARS = 0x1
    BANDS = 0x2


class Place(IntEnum):
    """Which point of an infant lies at its position."""

    SCENE = 0
    ROOT = 1
    SOLES = 2
    LOWEST = 3


class Sex(IntEnum):
    """Whose growth an infant follows."""

    MEAN = 0
    FEMALE = 1
    MALE = 2


class GrowthModel(IntEnum):
    """Where the sizes of an infant's body come from: the WHO's standards of growth, or the rules of MIMo v2."""

    WHO = 0
    ORIGINAL = 1


class Mature(IntFlag):
    """What of an infant is as old as it. ALL is a bit of its own: all but the options of the eyes, the last two."""

    BODY = 0x1
    EYES = 0x2
    DELAYS = 0x4
    THRESHOLD = 0x8
    FLICKER = 0x10
    ALL = 0x80000000


class Actuation(IntEnum):
    """What an action is: a motor's share of its largest torque, a joint's angle, or a muscle's activation."""

    TORQUE = 0
    POSITION = 1
    MUSCLE = 2
    MUJOCO_MUSCLE = 3


class Act(IntFlag):
    """Parts of the body that have motors. ALL is a bit of its own: all that the library has."""

    TRUNK = 0x01
    HEAD = 0x02
    EYES = 0x04
    RIGHT_ARM = 0x08
    LEFT_ARM = 0x10
    RIGHT_HAND = 0x20
    LEFT_HAND = 0x40
    RIGHT_LEG = 0x80
    LEFT_LEG = 0x100
    RIGHT_FOOT = 0x200
    LEFT_FOOT = 0x400
    ALL = 0x80000000
    NONE = 0x40000000


class Touch(IntFlag):
    """What the skin tells."""

    FORCE = 0x1
    NORMAL_FORCE = 0x2
    SLIP = 0x4
    FRICTION_USE = 0x8
    SA1 = 0x10
    RA = 0x20
    PC = 0x40
    SA2 = 0x80
    TEMPERATURE = 0x100
    COLD = 0x200
    WARM = 0x400
    NOCICEPTION_FAST = 0x800
    NOCICEPTION_SLOW = 0x1000
    UNITS = 0x2000


class TouchResponse(IntEnum):
    """Who feels how much of a touch."""

    NEAREST = 1
    LINEAR = 2
    GAUSSIAN = 3


class Frame(IntEnum):
    """Frame of reference of touch forces."""

    BODY = 1
    WORLD = 2
    SKIN = 3


class Shape(IntEnum):
    """Shapes of objects, and what their size is."""

    SPHERE = 1  # radius
    CAPSULE = 2  # radius, half length of the cylindrical part
    ELLIPSOID = 3  # three radii
    CYLINDER = 4  # radius, half length
    BOX = 5  # three half lengths


class Jacobian(IntEnum):
    """How MuJoCo solves: the same solution to rounding, sparse is faster."""

    MODEL = 0
    DENSE = 1
    SPARSE = 2


class Disable(IntFlag):
    """Parts of physics to leave out."""

    CONTACT = 0x1
    GRAVITY = 0x2
    OWN_SOLVER = 0x4


class Render(IntFlag):
    """What pictures show; what is left out costs nothing."""

    SHADOWS = 0x01
    REFLECTIONS = 0x02
    SKY = 0x04
    HAZE = 0x08
    FOG = 0x10


class Look(IntEnum):
    """What turns to look at a point: the eyes alone, or the head first, so that the eyes have to turn little."""

    EYES = 0
    HEAD = 1


class Outcome(IntEnum):
    """What an agent has made of a step."""

    NONE = 0
    SUCCESS = 1
    FAILURE = -1


class Receptor(IntEnum):
    """What is to be known of receptors."""

    BODY = 1
    GEOM = 2
    POSITION = 3
    FRAME = 4


class WarningCode(IntEnum):
    """What physics warns of."""

    CONTACTS_DROPPED = 1
    CONSTRAINTS_DROPPED = 2
    BAD_POSITION = 3
    BAD_VELOCITY = 4
    BAD_ACCELERATION = 5
    BAD_CONTROL = 6
    INERTIA = 7
    NOT_CONVERGED = 8


class Kind(IntEnum):
    """What a name or a quantity belongs to."""

    BODY = 1
    JOINT = 2
    GEOM = 3
    SITE = 4
    CAMERA = 5
    ACTUATOR = 6
    SENSOR = 7
    LIGHT = 8
    CONTACT = 9
    STEP_CONTACT = 10
    AGENT = 11
    FACE = 12
    WORLD = 13
    WARNING = 14


class Axes(IntEnum):
    """Frames of engines; mimo.h says which way their axes point."""

    MIMO = 0
    UNITY = 1
    UNREAL = 2
    GODOT = 3
    GLTF = 4


class TextureType(IntEnum):
    """How a texture's pixels are to be understood."""

    FLAT = 0
    CUBE = 1
    SKY = 2


class Quantity(IntEnum):
    """What can be read, and in part written; mimo.h says what each is."""

    JOINT_POSITION = 1
    JOINT_VELOCITY = 2
    JOINT_FORCE = 3
    JOINT_ACCELERATION = 4
    JOINT_RANGE = 5
    BODY_POSITION = 6
    BODY_ORIENTATION = 7
    BODY_VELOCITY = 8
    BODY_FORCE = 9
    BODY_MASS = 10
    BODY_CENTER_OF_MASS = 11
    GEOM_POSITION = 12
    GEOM_ORIENTATION = 13
    GEOM_SIZE = 14
    SITE_POSITION = 15
    SITE_ORIENTATION = 16
    CAMERA_POSITION = 17
    CAMERA_ORIENTATION = 18
    ACTUATOR_CONTROL = 19
    ACTUATOR_FORCE = 20
    SENSOR_VALUE = 21
    ACTUATOR_GEAR = 22
    BODY_POSE = 23
    GEOM_POSE = 24
    SITE_POSE = 25
    CAMERA_POSE = 26
    GEOM_FRICTION = 27
    GEOM_COLOR = 28
    JOINT_DAMPING = 29
    JOINT_LOCK = 30
    LIGHT_POSITION = 31
    LIGHT_DIRECTION = 32
    LIGHT_COLOR = 33
    CONTACT_GEOMS = 34
    CONTACT_BODIES = 35
    CONTACT_POSITION = 36
    CONTACT_FRAME = 37
    CONTACT_DISTANCE = 38
    CONTACT_FORCE = 39
    CONTACT_TORQUE = 40
    STEP_CONTACT_GEOMS = 41
    STEP_CONTACT_BODIES = 42
    STEP_CONTACT_START = 43
    STEP_CONTACT_END = 44
    STEP_CONTACT_IMPULSE = 45
    STEP_CONTACT_PEAK_FORCE = 46
    STEP_CONTACT_PEAK_POSITION = 47
    AGENT_FACE = 48
    WORLD_GRAVITY = 49
    WARNING_COUNT = 50
    SITE_VELOCITY = 51
    AGENT_GOAL = 52
    AGENT_ACHIEVED = 53
    AGENT_AGE = 54
    AGENT_PHYSIOLOGICAL_AGE = 55
    BODY_NERVE_LENGTH = 56
    ACTUATOR_FUSIMOTOR_DRIVE = 57


NOW = 0x40000000  # or-ed to a quantity: its value of now


class Autoreset(IntEnum):
    """What a batch does when an episode ends; the modes of Gymnasium's vector environments."""

    NONE = 0
    NEXT_STEP = 1
    SAME_STEP = 2
