"""Constants of laws that the guides tell: they stand so in the code, and tests beside it compare what the laws give."""

import pytest
from guide import Page

LAWS = {
    "guide/growth.md": [
        ("| upper arm, forearm, hand: length | *l*^{}, *l*^{}, *l*^{} |", "growth/proportions.cpp"),
        ("| thigh, shank, foot: length | *l*^{}, *l*^{}, *l*^{}, thigh", "growth/proportions.cpp"),
        ("| chest, waist, hips: girth | *w*^{}, *w*^{}, *w*^{} |", "growth/proportions.cpp"),
        ("| upper arm, forearm, hand: girth | *w*^{}, *w*^{}, *w*^{} |", "growth/proportions.cpp"),
        ("| thigh, calf, ankle: girth | *w*^{}, *w*^{}, *w*^{} |", "growth/proportions.cpp"),
        ("| distance of the shoulders | *w*^{}, with *w* of", "growth/proportions.cpp"),
        ("head's weight: {} at birth, {} at 2 months, {} at 6, {} at 18;", "growth/strength.cpp"),
        ("this fades until {} months", "growth/tone.cpp"),
    ],
    "guide/skin.md": [
        ("thin fibres are slower: cold {}/{}, fast pain {}/{} of large", "senses/touch/skin_sense.cpp"),
        ("warm {} m/s, slow pain {} m/s", "senses/touch/skin_sense.cpp"),
        ("| SA1 | min({}, {} (d - {} mm) + {} v)", "receptors/touch_afferents.cpp"),
        ("| RA | {} u/(u + {}), u = \\|v\\| - {} mm/s", "receptors/touch_afferents.cpp"),
        ("| SA2 | {} + {} s, s in mm along a tangent", "receptors/touch_afferents.cpp"),
        ("along a tangent (the same law with half the stiffness), from {} mm on", "receptors/touch_afferents.cpp"),
        ("{} (37 - T) + {} (T_air - T), c = {} J", "receptors/skin_temperature.cpp", "receptors/skin_temperature.h"),
        ("through a contact of {} W/(m^2 K)", "receptors/skin_temperature.cpp"),
        ("cold = {} exp(-((T - {})/{})^2) - {} dT/dt", "receptors/thermoreceptors.cpp"),
        ("warm = {} exp(-((T - {})/{})^2) + {} dT/dt", "receptors/thermoreceptors.cpp"),
        ("Hertz on soft tissue ({} MPa)", "receptors/nociceptors.cpp"),
        ("| fast | {} (x - 1) ({} + {} exp(-t/1 s))", "receptors/nociceptors.cpp", "receptors/nociceptors.h"),
        ("since x exceeded 1, + {} (T - {}); at most {} |", "receptors/nociceptors.cpp", "receptors/nociceptors.h"),
        (
            "| slow | {} (x - {}) + {} (T - {}) + ({} - T); at most {} |",
            "receptors/nociceptors.cpp",
            "receptors/nociceptors.h",
        ),
    ],
    "guide/touch.md": [
        ("\n| {} | mitten fingers", "senses/touch/spacing.cpp"),
        ("\n| {} | the other bones", "senses/touch/spacing.cpp"),
        ("\n| {} | palms", "senses/touch/spacing.cpp"),
        ("\n| {}, {}, {} | toes; head; feet", "senses/touch/spacing.cpp"),
        ("\n| {}, {}, {} | arms; hip and belly; thighs", "senses/touch/spacing.cpp"),
        ("\n| {}, {} | chest; lower legs", "senses/touch/spacing.cpp"),
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
        ("the otoliths' specific force changes by {} g within {} s", "env/stimuli.cpp"),
    ],
    "guide/muscles.md": [
        ("approaches the action with a time constant of {} ms", "actuation/muscle.cpp"),
        ("rises with {} ms and falls with {} ms", "actuation/muscle.cpp"),
        ("| bump with a shoulder, from {} to {} |", "actuation/muscle_curves.h"),
        ("1 at rest, up to {} when stretched", "actuation/muscle_curves.h"),
        ("from {} at one end of the range of motion to {} at the other", "actuation/muscle_curves.h"),
    ],
    "guide/proprioception.md": [
        ("**Tendon organs**: {} Hz ln(1 + {} f)", "receptors/tendon_organ.cpp"),
        (
            "**Joint receptors**: {} Hz min(1, u) + 10 Hz s du/dt, where u rises, at most {} Hz",
            "receptors/joint_receptor.h",
        ),
        ("Fibres contract with {} s (bag1) and {} s (bag2)", "receptors/spindle.cpp"),
    ],
    "guide/balance.md": [
        ("(0.1, 1, 10, 100 rad/s), good to", "receptors/maculae.cpp"),
        ("afferents do: 46.2 and {} (spikes/s)/g", "receptors/maculae.cpp"),
        ("The organs are {} head radii beside the middle, {} below it", "receptors/labyrinth.cpp"),
        ("+ (f - g) / 1.54 s dv/dt = 0.173/s c - v / {} s + {} rad/s^2", "receptors/gravity_estimate.cpp"),
        ("found {}/s for canals of {} s", "receptors/gravity_estimate.cpp"),
    ],
    "guide/hearing.md": [
        ("A pair of bodies sounds at most once in {} ms. Impacts below", "senses/hearing/soundscape.cpp"),
        ("Up to {} impacts sound at once", "hearing/ears.h"),
        ("the ears are {} degrees to both sides", "hearing/head.cpp"),
        ("(the sum of its three sides: up to {}, {}, {}, {}, {} m and more)", "sound/ringing.cpp"),
        ("a random height for every {} mm", "sound/scrape.cpp"),
        ("slide faster than {} cm/s make noise", "sound/scrape.h"),
    ],
    "guide/maturity.md": [
        ("with w = {} below its peak fp and {} above", "observation/eyesight.cpp"),
        ("Y = {} R + {} G + {} B", "observation/eyesight.cpp"),
        ("cut-off of {} Hz until two months, {} at four and {} from twelve on", "growth/eyesight.cpp"),
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
