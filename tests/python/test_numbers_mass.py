"""Numbers that the guides tell of where an infant's mass is, how thick it is, and how long its nerves are."""

from functools import lru_cache

import numpy as np
from guide import Page

import mimo

MONTHS = (0, 1, 3, 6, 9, 12, 18, 24)
LEGS = [f"{side}_{part}" for side in ("left", "right") for part in ("upper_leg", "lower_leg", "foot", "toes")]
TRUNK = ["hip", "lower_body", "upper_body"]


@lru_cache(maxsize=None)
def infant(age):
    world = mimo.World("free", vision=False, age=age)
    world.reset(seed=0)
    return world


def mass(age, *bodies):
    return infant(age).bodies(*bodies).mass.sum()


def share(age, *bodies):
    return mass(age, *bodies) / mass(age)


def girth(age, geom):
    """In cm."""
    return 200 * np.pi * infant(age).geoms(geom).size[0][0]


def centre_of_mass(age):
    """Over the soles, standing straight, over the stature."""
    world = infant(age)
    heights, masses = world.bodies().center_of_mass[:, 2], world.bodies().mass
    (head, sole), sizes = world.geoms("head", "left_foot2").position[:, 2], world.geoms("head", "left_foot2").size
    low, top = sole - sizes[1][2], head + sizes[0][0]
    return (heights @ masses / masses.sum() - low) / (top - low)


def test_the_table_of_masses():
    page = Page("guide/growth.md")
    rows = {
        "head, share of the mass": lambda age: share(age, "head"),
        "trunk": lambda age: share(age, *TRUNK),
        "both legs, kg": lambda age: mass(age, *LEGS),
        "one foot with its toes, kg": lambda age: mass(age, "left_foot", "left_toes"),
        "centre of mass over the soles, share of the stature": centre_of_mass,
    }
    for row, value in rows.items():
        page.says(f"\n| {row} |" + " {} |" * len(MONTHS), *(value(age) for age in MONTHS))


def test_girths_of_newborns():
    page = Page("guide/growth.md")
    page.says("newborn body's upper arm is {} cm around", girth(0, "left_uarm1"))
    page.says("its calf {} (", girth(0, "left_lower_leg1"))
    page.says("its head {} (", girth(0, "head"))


def test_legs_of_a_year():
    page = Page("guide/growth.md")
    page.says("Legs of 12 months weigh {} kg, between", mass(12, *LEGS))
    page.says(
        "here it has {}, because the body of 18 months has {}", *(mass(a, "left_foot", "left_toes") for a in (12, 18))
    )


def test_ways_of_nerves():
    page = Page("guide/maturity.md")
    page.says("than its foot: {} and {} m away", *infant(0).bodies("left_hand", "left_foot").nerve_length)
    for claim in (
        "times {} from a hand to the neck",
        "{} from toes to the hip",
        "{} along the spine",
        "and {} in the head",
    ):
        page.tested(claim, "unit/body_nerves_test.cpp")
