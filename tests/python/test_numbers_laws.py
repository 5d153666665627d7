"""Constants of laws that the guides tell: they stand so in the code, and tests beside it compare what the laws give."""

import pytest
from guide import Page

LAWS = {
    "guide/growth.md": [
        ("| upper arm, forearm, hand: length | *l*^{}, *l*^{}, *l*^{} |", "growth/sizes.cpp"),
        ("| thigh, shank, foot: length | *l*^{}, *l*^{}, *l*^{}, thigh", "growth/sizes.cpp"),
        ("| chest, waist, hips: girth | *w*^{}, *w*^{}, *w*^{} |", "growth/sizes.cpp"),
        ("| upper arm, forearm, hand: girth | *w*^{}, *w*^{}, *w*^{} |", "growth/sizes.cpp"),
        ("| thigh, calf, ankle: girth | *w*^{}, *w*^{}, *w*^{} |", "growth/sizes.cpp"),
        ("| distance of the shoulders | *w*^{}, with *w* of", "growth/sizes.cpp"),
        ("head's weight: {} at birth, {} at 2 months, {} at 6, {} at 18;", "growth/joints.cpp"),
        ("this fades until {} months", "growth/joints.cpp"),
    ],
    "guide/skin.md": [
        ("thin fibres are slower: cold {}/{}, fast pain {}/{} of large", "senses/touch/touch.cpp"),
        ("warm {} m/s, slow pain {} m/s", "senses/touch/touch.cpp"),
        ("| SA1 | min({}, {} (d - {} mm) + {} v)", "receptors/skin.cpp"),
        ("| RA | {} u/(u + {}), u = \\|v\\| - {} mm/s", "receptors/skin.cpp"),
        ("| SA2 | {} + {} s, s in mm along a tangent", "receptors/skin.cpp"),
        ("along a tangent (the same law with half the stiffness), from {} mm on", "receptors/skin.cpp"),
        ("{} (37 - T) + {} (T_air - T), c = {} J", "receptors/skin.cpp", "receptors/skin.h"),
        ("through a contact of {} W/(m^2 K)", "receptors/skin.cpp"),
        ("cold = {} exp(-((T - {})/{})^2) - {} dT/dt", "receptors/skin.cpp"),
        ("warm = {} exp(-((T - {})/{})^2) + {} dT/dt", "receptors/skin.cpp"),
        ("Hertz on soft tissue ({} MPa)", "receptors/skin.cpp"),
        ("| fast | {} (x - 1) ({} + {} exp(-t/1 s))", "receptors/skin.cpp", "receptors/skin.h"),
        ("since x exceeded 1, + {} (T - {}); at most {} |", "receptors/skin.cpp", "receptors/skin.h"),
        (
            "| slow | {} (x - {}) + {} (T - {}) + ({} - T); at most {} |",
            "receptors/skin.cpp",
            "receptors/skin.h",
        ),
    ],
    "guide/touch.md": [
        ("\n| {} | mitten fingers", "senses/touch/surface.cpp"),
        ("\n| {} | the other bones", "senses/touch/surface.cpp"),
        ("\n| {} | palms", "senses/touch/surface.cpp"),
        ("\n| {}, {}, {} | toes; head; feet", "senses/touch/surface.cpp"),
        ("\n| {}, {}, {} | arms; hip and belly; thighs", "senses/touch/surface.cpp"),
        ("\n| {}, {} | chest; lower legs", "senses/touch/surface.cpp"),
    ],
    "guide/reflexes.md": [
        ("`MIMO_REFLEX_PALMAR_GRASP` | {} N on the palm", "reflexes/table.cpp"),
        (
            "not on the back of the hand | fingers and thumb bend while the touch lasts | to {} |",
            "reflexes/table.cpp",
        ),
        (
            "| {} N from below on toes or ball of the foot | toes bend while the touch lasts | to {} |",
            "reflexes/table.cpp",
        ),
        ("`MIMO_REFLEX_ROOTING` | {} N within", "reflexes/table.cpp"),
        ("the head turned by {} degrees", "reflexes/table.cpp"),
        ("legs are lifted in turn, {} s for both", "reflexes/pattern.cpp"),
        ("share of an amplitude: {} (palmar grasp), {} (neck) or {} (all others)", "reflexes/table.cpp"),
        ("grasps and withdrawal {} weeks from conception, rooting {}, Moro {}, stepping {}", "reflexes/table.cpp"),
        ("the otoliths' specific force changes by {} g within {} s", "env/reflexes.cpp"),
    ],
    "guide/muscles.md": [
        ("approaches the action with a time constant of {} ms", "actuation/muscle.cpp"),
        ("rises with {} ms and falls with {} ms", "actuation/muscle.cpp"),
        ("| bump with a shoulder, from {} to {} |", "actuation/muscle.h"),
        ("1 at rest, up to {} when stretched", "actuation/muscle.h"),
        ("from {} at one end of the range of motion to {} at the other", "actuation/muscle.h"),
    ],
    "guide/proprioception.md": [
        ("**Tendon organs**: {} Hz ln(1 + {} f)", "receptors/muscles.cpp"),
        (
            "**Joint receptors**: {} Hz min(1, u) + 10 Hz s du/dt, where u rises, at most {} Hz",
            "receptors/muscles.h",
        ),
        ("Fibres contract with {} s (bag1) and {} s (bag2)", "receptors/muscles.cpp"),
    ],
    "guide/balance.md": [
        ("(0.1, 1, 10, 100 rad/s), good to", "receptors/labyrinth.cpp"),
        ("afferents do: 46.2 and {} (spikes/s)/g", "receptors/labyrinth.cpp"),
        ("The organs are {} head radii beside the middle, {} below it", "receptors/labyrinth.cpp"),
        ("+ (f - g) / 1.54 s dv/dt = 0.173/s c - v / {} s + {} rad/s^2", "receptors/labyrinth.cpp"),
        ("found {}/s for canals of {} s", "receptors/labyrinth.cpp"),
    ],
    "guide/hearing.md": [
        ("A pair of bodies sounds at most once in {} ms. Impacts below", "senses/hearing/soundscape.cpp"),
        ("Up to {} impacts sound at once", "hearing/ears.h"),
        ("the ears are {} degrees to both sides", "hearing/ears.cpp"),
        ("(the sum of its three sides: up to {}, {}, {}, {}, {} m and more)", "sound/impact.cpp"),
        ("a random height for every {} mm", "sound/scrape.cpp"),
        ("slide faster than {} cm/s make noise", "sound/scrape.h"),
    ],
    "guide/maturity.md": [
        ("with w = {} below its peak fp and {} above", "observation/eyesight.cpp"),
        ("Y = {} R + {} G + {} B", "observation/eyesight.cpp"),
        ("cut-off of {} Hz until two months, {} at four and {} from twelve on", "growth/maturity.cpp"),
    ],
}


@pytest.mark.parametrize("page", LAWS)
def test_laws(page):
    parted = []
    for claim, *sources in LAWS[page]:
        try:
            Page(page).coded(claim, *sources)
        except AssertionError as error:  # the next ones are told of, too
            parted.append(str(error))
    assert not parted, "\n".join(parted)
