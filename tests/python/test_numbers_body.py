"""Numbers that the guides tell of the body, its growth, nerves and tasks."""

import csv
from functools import lru_cache

import numpy as np
import pytest
from guide import ROOT, Page

import mimo

MONTHS = (0, 1, 2, 3, 6, 9, 12, 18, 24)


@lru_cache(maxsize=None)
def infant(body="mitten", **growth):
    world = mimo.World("free", vision=False, body=body, **growth)
    world.reset(seed=0)
    return world


def median(measure, month):
    """The WHO's, mean of girls and boys."""
    with open(ROOT / "src/growth/who_lms.csv") as file:
        rows = [row for row in csv.DictReader(file) if row["measure"] == measure and float(row["age_months"]) == month]
    assert {row["sex"] for row in rows} == {"m", "f"}
    return np.mean([float(row["M"]) for row in rows])


def joint_range(joint, **growth):
    return np.rad2deg(infant(**growth).get("joint_range", joint)[0])


def gear(motor, **growth):
    return infant(**growth).actuators(motor).gear[0]


def test_growth_drivers():
    page = Page("guide/growth.md")
    page.says("over that of 18 months ({} cm, mean of the sexes)", median("length", 18))
    page.says("over that of 18 months ({} kg)", median("weight", 18))
    page.says("over that of 18 months ({} cm) |", median("head_circumference", 18))


def test_the_body_of_18_months_beside_the_who():
    page, body = Page("guide/growth.md"), infant().agents[0]
    shorter = 100 * (1 - 100 * body.height / median("length", 18))
    page.says(
        "is {} % shorter, {} % heavier",
        100 * (1 - infant(age=18).agents[0].height / infant(age=18, absolute=True).agents[0].height),
        100 * (body.mass / median("weight", 18) - 1),
    )
    assert shorter > 0


def test_strength_by_age():
    page = Page("guide/growth.md")
    factors = [
        gear("act:right_elbow", age=age) / gear("act:right_elbow", age=age, strength_exponent=0) for age in (0, 6)
    ]
    page.says("{} at birth, {} at 6 months. The neck", *factors)


def test_ranges_of_newborns():
    page = Page("guide/growth.md")
    lack = {
        name: [round(-joint_range(joint, age=age)[1]) for age in (0, 3)]
        for name, joint in (("hip", "robot:right_hip1"), ("knee", "robot:right_knee"), ("elbow", "robot:right_elbow"))
    }
    page.says("hips lack {} degrees at birth and {} at 3 months", *lack["hip"])
    page.says("knees {} and {} (Broughton", *lack["knee"])
    page.says("elbows {} and {} (Shah", *lack["elbow"])


def test_eyes_by_age():
    page = Page("guide/maturity.md")
    for months in (0, 1, 1.5, 2.5, 4, 6, 9, 12, 18, 24):
        eyes = mimo.Maturity.at(months)
        page.says(f"\n| {months} | {{}} | {{}} | {{}} |", eyes.acuity, eyes.peak_contrast, eyes.chroma)


def test_nerves_by_age():
    page = Page("guide/maturity.md")
    rows = {
        "conduction speed, m/s": ("conduction_speed", 1),
        "brain stem to cortex, ms": ("sensory_delay", 1e3),
        "cortex to brain stem, ms": ("motor_delay", 1e3),
        "eye to cortex, ms": ("vision_delay", 1e3),
        "inner ear to brain stem, ms": ("vestibular_delay", 1e3),
        "ear to cortex, ms": ("hearing_delay", 1e3),
    }
    for row, (name, factor) in rows.items():
        values = [factor * getattr(mimo.Maturity.at(months), name) for months in MONTHS]
        page.says(f"\n| {row} |" + " {} |" * len(MONTHS), *values)


def test_contents_of_pictures():
    page = Page("guide/maturity.md")
    finest = [pixels / 2 / (2 * np.tan(np.deg2rad(30))) * np.deg2rad(1) for pixels in (64, 256)]
    page.says("64 pixels over 60 degrees show at most {} cycles per degree", finest[0])
    page.says("and 256 pixels {}, which", finest[1], within=0.05)
    page.says("L / ln(1 + L) times as large, {} times for 10", 10 / np.log(11))
    Page("guide/limited-senses.md").says("cannot show more than {} in its middle", finest[1], within=0.05)


def test_ways_of_nerves():
    newborn, speed = infant(age=0, maturity="all"), mimo.Maturity.at(0).conduction_speed
    foot, hand = (newborn.bodies(name).nerve_length[0] for name in ("left_foot", "left_hand"))
    Page("guide/maturity.md").says(
        "A newborn's hand is {} ms nearer to its brain than its foot", 1e3 * (foot - hand) / speed
    )
    one_way, cord = 1e3 * foot / speed, 12
    Page("guide/reflexes.md").says(
        "foot that is {} m from its brain stem withdraws after {} + {} + {} = {} ms",
        *(foot, one_way, one_way, cord, 2 * one_way + cord),
    )


def test_thresholds_and_speeds_of_reflexes():
    page = Page("guide/reflexes.md")
    page.says("at the nerves' speed ({} m/s at birth", mimo.Maturity.at(0).conduction_speed)
    page.tested("| {} mN on a foot of a newborn, {} mN from 12 months on", "unit/receptors/skin_test.cpp")


def test_counts_of_sensors():
    page = Page("guide/touch.md")

    def sensors(body, scale):
        with mimo.World("free", vision=False, body=body, touch_scale=scale) as world:
            return world.layout.fields["touch/force"].shape[0]

    page.says(
        "1 the mitten body has {} sensors, at 2 it has {}, at 0.5 it has {}; with five fingers it has {}, {} and {}.",
        *(sensors(body, scale) for body in ("mitten", "fingers") for scale in (1, 2, 0.5)),
    )
    Page("guide/skin.md").says("of a step without eyes for {} sensors", sensors("mitten", 1))
    table = Page("differences.md")
    for body, name in (("mitten", "mitten"), ("fingers", "five-fingered")):
        ours = {scale: sensors(body, scale) for scale in (0.25, 0.5, 1, 2)}
        texts = table.numbers(f"| **all of the {name} body** | {{}}, {{}} | {{}}, {{}} | **{{}}, {{}}** | {{}}, {{}} |")
        assert [int(text) for text in texts[::2]] == list(ours.values())


def test_lengths_of_episodes():
    parameters, page = mimo.Scene("reach").parameters, Page("tasks.md")
    steps = [parameters[f"{task}/episode_steps"] for task in ("reach", "standup", "selfbody", "catch", "rollover")]
    page.says(
        "| length | {} steps of 10 ms | {} of 10 ms | {} of 5 ms | {} of 10 ms | {} of 10 ms |",
        *steps,
    )
    page.says("* `success`: {} when the right arm or hand touches the ball", parameters["reach/success_reward"])
    page.says("Success is a head at {} m or above", parameters["standup/success_height"])
    page.says("* `success`: {} when the target feels a force", parameters["selfbody/success_reward"])
    page.says("* `no_touch`: otherwise {}.", -abs(parameters["selfbody/no_touch_reward"]))


def test_motors_that_act():
    page, counts = Page("tasks.md"), {}
    for task in ("reach", "standup", "selfbody", "catch", "rollover"):
        with mimo.World(task, vision=False) as world:
            counts[task] = len(world.action_names)
    page.says(
        "right arm and hand, {} motors | trunk, arms, hands, legs, {} motors | right arm and hand, {} motors "
        "| right wrist and fingers, {} muscles | all but the eyes, {} motors |",
        *counts.values(),
    )


@pytest.mark.parametrize("scene", ["free", "selfbody"])
def test_time_steps(scene):
    page = Page("guide/time-and-frames.md")
    with mimo.World(scene, vision=False) as world:
        assert world.timestep == 0.005
        assert world.layout.step_seconds == world.timestep * world.frame_skip
        said = "Built-in scenes take {} of them," if scene == "free" else "of them, `selfbody` {}."
        page.says(said, world.frame_skip)


def test_babybench_s_motors():
    page, motors = Page("tasks.md"), []
    for scene in ("babybench-base", "babybench-crib", "babybench-cubes"):
        with mimo.World(scene, vision=False) as world:
            motors.append(len(world.action_names))
    page.says("| acts | all, {} motors | all but feet and eyes, {} motors | head, arms, wrists, {} motors |", *motors)
    parameters = mimo.Scene("babybench-base").parameters
    page.says("An episode starts with {} physics steps without control", parameters["selftouch/settle_steps"])
    page.says("then {} with random actions within their", parameters["selftouch/warm_up_steps"])
    page.says("is less than {} degrees beside the axis", np.rad2deg(parameters["handregard/angle"]))


def test_parameters_of_tasks():
    page, parameters = Page("tasks.md"), mimo.Scene("reach").parameters
    page.says("Success is a posture of {} (144 degrees)", parameters["rollover/success"])
    page.says("(the stature at birth is {},", infant(age=0).agents[0].height / infant().agents[0].height)
    page.says(
        "another ball, {} to {} mm in radius and {} to {} g",
        *(1e3 * parameters[f"catch/{name}"] for name in ("radius_low", "radius_high", "mass_low", "mass_high")),
        within=1e-6,
    )
    page.says(
        "* `success`: {} when the skin has touched the ball in {} consecutive steps",
        *(parameters[f"catch/{name}"] for name in ("success_reward", "hold_steps")),
    )
    page.says(
        "* `failure`: {} when the ball is {} cm below the palm or {} cm away",
        *(
            parameters["catch/failure_reward"],
            100 * parameters["catch/lost_below"],
            100 * parameters["catch/lost_beyond"],
        ),
    )
    page.says("* `effort`: minus {} times the effort", parameters["catch/effort_weight"])
    page.says("up to {} cm to each side of, and {} cm above", *(100 * parameters[f"catch/{it}_spread"] for it in "xz"))
    page.says("* `height`: height of the head's origin minus {} m", parameters["standup/base_height"])
    page.says(
        "ball is moved by {}..0 m in x, {}..{} in y and {}..0 in z",
        *(parameters[f"reach/target_{it}"] for it in ("x_low", "y_low", "y_high", "z_low")),
    )
    page.says("Each joint starts up to {} rad off the stored pose", parameters["standup/pose_noise"])


def test_motors_of_the_original():
    page = Page("coming-from-mimo.md")
    for name, scene, options in (
        ("MIMoReach", "reach", {}),
        ("MIMoStandup", "standup", {}),
        ("MIMoSelfBody", "selfbody", {}),
        ("MIMoBench", "benchmark", {}),
        ("MIMoBenchV2", "benchmark", {"body": "fingers"}),
        ("MIMoShowroom", "showroom", {}),
        ("MIMoMuscle", "benchmark", {"body": "fingers", "actuation": mimo.Actuation.MUSCLE}),
    ):
        row = next(line for line in page.text.splitlines() if line.startswith(f"| `{name}-v0`"))
        claim = row[: row.rindex("|", 0, -2) + 1] + " {}, {} |"
        with mimo.World(scene, vision=False, **options) as world:
            page.says(claim, *[len(world.action_names)] * 2)


def test_eyes_of_the_body():
    page = Page("vision.md")
    pan, tilt, roll = (joint_range(f"robot:left_eye_{name}") for name in ("horizontal", "vertical", "torsional"))
    page.says("Each eye pans by {} degrees", pan[1])
    page.says("tilts from {} down to {} up and rolls by {};", -tilt[0], tilt[1], roll[1])
    world = infant()
    apart = np.linalg.norm(world.bodies("left_eye").position[0] - world.bodies("right_eye").position[0])
    page.says("the eyes' centres are {} mm apart", 1e3 * apart)
    page.says("2 atan({} m / d) for a point", apart / 2)


def test_worlds_of_batches():
    page = Page("guide/observations.md")
    with mimo.World("free", vision=False) as world:
        touch, angles = (world.layout.fields[name] for name in ("touch/force", "proprioception/position"))
        assert angles.start == angles.end == 0
        page.says("| touch, torques, balance, pictures | {}, {}:", touch.start, touch.end)


def sensors_of(body, parts):
    """How many sensors each of these parts has, at four densities."""
    counts = []
    for scale in (0.25, 0.5, 1, 2):
        with mimo.World("free", vision=False, body=body, touch_scale=scale) as world:
            bodies = list(world.layout.receptors("touch/force").bodies)
            counts.append([bodies.count(world.find(mimo.Kind.BODY, part)) for part in parts])
    return np.transpose(counts)


def test_sensors_of_parts():
    """Ours are the first of each two."""
    rows = "".join(
        f"| {part} |" + " {}, {} |" * 4 + " " for part in ("upper_body", "hand", "fingers", "lower_leg", "foot", "toes")
    )
    written = Page("differences.md").numbers(rows.strip())[::2]
    parts = ["upper_body", "left_hand", "left_fingers", "left_lower_leg", "left_foot", "left_toes"]
    assert [int(text) for text in written] == sensors_of("mitten", parts).ravel().tolist()
    rows = (
        "| upper_body |"
        + " {}, {} |" * 4
        + " | hand |"
        + " {}, {} |" * 4
        + " | lfmetacarpal | equal |"
        + " {}, {} |" * 3
    )
    written = Page("differences.md").numbers(rows)[::2]
    counts = sensors_of("fingers", ["upper_body", "left_hand", "left_lfmetacarpal"])
    assert [int(text) for text in written] == [*counts[0], *counts[1], *counts[2][1:]]
