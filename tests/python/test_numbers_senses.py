"""Numbers that the guides tell of what nerves and ears report."""

from functools import lru_cache

import numpy as np
from guide import Page

import mimo

RECEPTORS = "unit/receptors/"
LABYRINTH, SKIN, MUSCLES = (RECEPTORS + name for name in ("labyrinth_test.cpp", "skin_test.cpp", "muscles_test.cpp"))
TICK = 0.005

HEAD = """<mujoco><option timestep="0.005" gravity="0 0 -9.81"/><worldbody><body name="head">
  <joint name="roll" axis="1 0 0"/><joint name="yaw" axis="0 0 1"/><geom size="0.07"/></body></worldbody></mujoco>"""


@lru_cache(maxsize=1)
def head_of_a_model():
    scene = mimo.Scene(xml=HEAD)
    scene.add_agent(
        body="scene",
        root="head",
        vision=False,
        touch=False,
        proprioception=False,
        vestibular=mimo.Vestibular.CANALS | mimo.Vestibular.OTOLITHS | mimo.Vestibular.GRAVITY,
        vestibular_at="head",
    )
    return scene


def turning(joint, velocities):
    """Where a head is that turns so, and what is told then, tick by tick."""
    with mimo.World(head_of_a_model(), frame_skip=1) as world:
        world.reset(seed=0)
        angle, moved = 0.0, world.joints(joint)
        for velocity in velocities:
            angle += velocity * TICK
            moved.position, moved.velocity = [angle], [velocity]
            world.step()
            yield angle, {name.rpartition("/")[2]: values.copy() for name, values in world.observation.items()}


def off(angle, told):
    """How far the estimate of gravity is from what is up in a head that has rolled so far, degrees."""
    estimate = told["gravity"] / np.linalg.norm(told["gravity"])
    return np.rad2deg(np.arccos(np.clip(estimate @ [0, np.sin(angle), np.cos(angle)], -1, 1)))


def test_a_lasting_yaw():
    told = [told["canals"][1, 0] - 90 for _, told in turning("yaw", [np.deg2rad(60)] * 3421)]
    ticks = [1, 200, 1140, 2280, 3420]  # 0 is the jerk of the start
    Page("guide/balance.md").says("\n| Hz | {} | {} | {} | {} | {} |", *(told[tick] for tick in ticks))


def test_a_quick_tilt():
    quick = round(0.2 / TICK)
    speeds = [np.deg2rad(90) / 0.2] * quick + [0.0] * round(12 / TICK)
    after = [off(*moment) for moment in turning("roll", speeds)][quick - 1 :]
    Page("guide/balance.md").says(
        "within 0.2 s, and rest | {} degrees off after 0.3 s, at most {} (after {} s), {} after 10 s |",
        *(after[round(0.3 / TICK)], max(after), round(np.argmax(after) * TICK), after[round(10 / TICK)]),
    )


def test_rolling_on_and_on():
    *_, last = turning("roll", [np.deg2rad(60)] * 12000)
    Page("guide/balance.md").says("| rolling constantly at 60 degrees per second | {} degrees off |", off(*last))


def test_a_lasting_tilt():
    scene, told = head_of_a_model(), []
    with mimo.World(scene, frame_skip=1) as world:
        world.reset(seed=0)
        world.joints("roll").position = [np.deg2rad(90)]
        for _ in range(round(60 / TICK) + 2):
            seen = world.step().observation["vestibular/otoliths"]
            told.append(abs(float(seen[0, 0, 1, 0]) - 70))  # the left utricle's outward afferents, regular
    Page("guide/balance.md").says(
        "by 90 degrees regular afferents tell {} Hz after 1 s, {} after 5 and {} after 20, of {} at last",
        *(told[round(seconds / TICK)] for seconds in (1, 5, 20)),
        told[-1],
    )


def test_a_lasting_force():
    tilts = []
    with mimo.World(head_of_a_model(), frame_skip=1) as world:
        world.reset(seed=0)
        world.gravity = [0, 0.2 * 9.81, -9.81]
        for _ in range(round(60 / TICK)):
            told = world.step().observation["vestibular/gravity"]
            tilts.append(np.rad2deg(np.arctan2(np.hypot(told[0], told[1]), told[2])))
    half = next(i for i, tilt in enumerate(tilts) if tilt > 0.5 * tilts[-1]) * TICK
    Page("guide/balance.md").says("a tilt of {} degrees in the end, half of it after {} s |", tilts[-1], half)


def maculae(hertz):
    """|H| of regular and irregular afferents, spikes/s per g: the library's sum and Schneider's function."""
    s = 2j * np.pi * hertz
    sums = {
        (46.165, (8.394, 8.539, 9.786, 14.278)): (59.01, 0.0643, 2.208, 0.0138, 0.0255),
        (30.558, (35.685, 68.376, 131.808, 377.814)): (112.74, 0.3084, 2.6834, 0.0136, 0.0318),
    }
    for (still, gains), (k, k1, k2, a, b) in sums.items():
        ours = still + sum(gain * s / (s + corner) for gain, corner in zip(gains, (0.1, 1, 10, 100), strict=True))
        yield abs(ours), abs(k * s**k1 * (1 + a * s) ** k2 / (1 + b * s))


def test_how_maculae_follow():
    page, slow, once, fast = Page("guide/balance.md"), *(list(maculae(hertz)) for hertz in (0.1, 1, 5))
    page.says("rates are {} % (regular) and {} % (irregular) too high at 5 Hz", *(100 * (a / b - 1) for a, b in fast))
    page.says(
        "regular ones have {} and {}, irregular ones {} and {}.", *(it[i][0] for i in (0, 1) for it in (slow, once))
    )


def test_the_guide_s_numbers_of_balance():
    page = Page("guide/balance.md")
    page.tested("| left anterior | {} | {} | {} |", LABYRINTH)
    page.tested("| left horizontal | {} | {} | {} |", LABYRINTH)
    page.tested("| left posterior | {} | {} | {} |", LABYRINTH)
    page.tested("| right anterior | {} | {} | {} |", LABYRINTH)
    page.tested("| right horizontal | {} | {} | {} |", LABYRINTH)
    page.tested("| right posterior | {} | {} | {} |", LABYRINTH)
    page.tested("the long time constant Tc = {} s", LABYRINTH)
    page.tested("| shaking by {} g at {} Hz | moves it by {} g |", LABYRINTH)
    page.tested("| a constant {} g to one side | taken for a tilt of {} degrees", LABYRINTH)
    page.tested("a static gain, as afferents do: {} and", LABYRINTH)
    page.says("adds {} Hz to the left utricle's outward afferents", 46.165)
    page.says(
        "K T2/T1, the gain at medium frequencies, is {} for regular and {} for", 2.83 * 2.7 / 17.5, 27.09 * 0.6 / 30
    )


@lru_cache(maxsize=None)
def voice(age):
    """What the left ear hears of an infant's own cry and vowels; and of silence."""
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, touch=False, hearing=True, voice=True, age=age)
    random, heard = np.random.default_rng(1), []
    with mimo.World(scene) as world:
        action = np.zeros(len(world.action_names), np.float32)
        world.reset(seed=0)
        for step in range(600):
            if step % 20 == 0:
                action[-4:] = 1, random.uniform(-0.5, 0.5), random.uniform(0.7, 1.3), random.uniform(0.7, 1.3)
            heard.append(world.step(action).observation["hearing/ear_left"].copy())
    return np.concatenate(heard)


def test_how_loud_a_cry_is():
    page, cry = Page("guide/hearing.md"), voice(3)
    page.says("a cry of up to {} Pa at the own ears", np.abs(cry).max())
    at_ears = 10 * np.log10(np.mean(np.square(cry[16000:], dtype=np.float64)) / 4e-10)
    page.says("1 a cry of {} dB at 1 m", at_ears - 17, within=1)
    page.tested("At the infant's own ears it is {} dB louder than at 1 m", "unit/hearing/ears_test.cpp")


def test_the_guide_s_numbers_of_hearing():
    page, ears = Page("guide/hearing.md"), "unit/hearing/ears_test.cpp"
    page.tested("delayed by its distance over {} m/s", ears)
    page.tested("at 250, 500 and 1000 Hz, 2 m away, all azimuths | within {} µs", ears)
    page.tested("at 1 to 4 kHz, 2 m away, all azimuths | within {} dB; {} at 250 and 500 Hz", ears)
    page.tested("15 cm to 1 m away | within {} dB; from the side at 25 cm and 250 Hz {} dB", ears)
    page.tested("hardwood on hardwood at {} m/s and {} N gives {} dB", "unit/sound/scrape_test.cpp")
    page.tested("gives {} dB (sound exposure level", "unit/sound/strike_test.cpp")
    voices = "unit/growth/maturity_test.cpp"
    page.tested("around the pitch of its age: {} Hz at 3 months, {} at 6, {} from 9 on", voices)
    page.tested("of {} cm at birth and {} at 24 months: {}, {}, {} and {}, {}, {} Hz", voices)


def test_thresholds_of_hearing():
    claim = "at 500 Hz {} dB for a newborn, {} at 3, {} at 6 and {} at 12 months, {} for adults"
    Page("guide/hearing.md").tested(claim, "unit/growth/maturity_test.cpp")


def test_sound_in_steps():
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, touch=False, hearing=True)
    with mimo.World(scene) as world:
        samples = world.layout.fields["hearing/ear_left"].shape[0]
        claim = "{} in the 5 ms of built-in scenes, so 16 000 per second, and {} in an environment step of two"
        Page("guide/hearing.md").says(claim, samples / world.frame_skip, samples)


def test_the_guide_s_numbers_of_skin():
    page = Page("guide/skin.md")
    page.tested("| SA1, hold of 1 mm | {} | {} |", SKIN)
    page.tested("| SA1, ramp to 1 mm at {}, {}, {}, {} mm/s | {}, {}, {}, {} |", SKIN)
    page.tested("| RA, at {}, {}, {}, {}, {} mm/s | {}, {}, {}, {}, {} | {}, {}, {}, {}, {} |", SKIN)
    page.tested("in a room of {}, with a time constant of {} s", SKIN)
    page.tested("divide a region among its parts: {} at fingertips, {} in palms", SKIN)
    page.tested("{} are in both hands and {} in the face", SKIN)
    page.tested("trunk {}, arms 30,240, thighs 23,940, lower legs 17,640, feet {}.", SKIN)
    page.tested("| {} | {} | 29.48 | {} | {} | 32.09 | {} |", SKIN)
    page.tested("1 N with 10 mm makes {} kPa, with 0.5 mm {} kPa", SKIN)


def test_afferents_of_a_person():
    with mimo.World("free", vision=False, touch=mimo.Touch.UNITS) as world:
        world.reset(0)
        units = world.observation["touch/units"].astype(float)
        bodies = world.layout.receptors("touch/units").bodies
        eye = units[bodies == world.find(mimo.Kind.BODY, "left_eye")].sum()
    page = Page("guide/skin.md")
    page.says("all add up to {}, of which", units.sum())
    page.says("An eyeball has {}, as many", eye)


def test_the_guide_s_numbers_of_muscles():
    page = Page("guide/proprioception.md")
    page.tested("| 0.11 | {}, {} | {}, 101.4 | {}, {} |", MUSCLES)
    page.tested("| 0.66 | {}, {} | {}, 101.8 | {}, {} |", MUSCLES)
    page.tested("| 1.55 | {}, {} | {}, {} | {}, {} |", MUSCLES)
    page.tested("| Ia | {} | {} | {} | {} |", MUSCLES)
    page.tested("| II | {} | {} | {} | {} |", MUSCLES)
    page.tested("starts at {} of its final value, is at {} after 1 s and {} after 5", MUSCLES)


def test_skin_at_rest():
    page, settled = Page("guide/skin.md"), []
    for room in (24, 15):
        scene = mimo.Scene("free")
        scene.add_agent(vision=False, touch=mimo.Touch.FORCE | mimo.Touch.TEMPERATURE, touch_scale=0.25)
        scene.set_room_temperature(room)
        with mimo.World(scene) as world:
            world.reset(seed=0)
            settled.append(float(np.median(world.step().observation["touch/temperature"])))
    page.says("{} degrees in a room of 24, with", settled[0])
    assert settled[1] < 31


def test_limits_of_senses():
    """A Gaussian that leaves half of some lines leaves 0.5^(r^2) of lines r times as fine."""
    claim = "lines half as fine {} %, lines twice as fine {} %"
    Page("guide/limited-senses.md").says(claim, 100 * 0.5**0.25, 100 * 0.5**4)


def test_fields_of_ears():
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, touch=False, hearing=True, age=0)
    with mimo.World(scene) as world:
        bands, apart = (world.layout.fields[f"hearing/{name}"] for name in ("bands", "time_difference"))
        Page("guide/hearing.md").says("| `hearing/bands` | [{}, {}] | dB |", *bands.shape)
        Page("guide/hearing.md").says("| `hearing/time_difference` | [{}] | s |", *apart.shape)
