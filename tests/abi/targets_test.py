"""What interface/targets makes of types, comments and members that C says in one word, and what it refuses."""

import dataclasses
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "interface"))

import api  # noqa: E402
from targets import _prose, _rust_structs, _rust_words, matlab  # noqa: E402

POINTER = api.Member("weights", "const double *", 0, 8, "Weights of the joints.")


class Targets(unittest.TestCase):
    def setUp(self):
        self.interface = api.load()

    def grown(self, name, member):
        struct = self.interface.struct(name)
        return dataclasses.replace(struct, members=[*struct.members, member])

    def test_rust_has_pointers_of_c(self):
        types = {
            "const char *const *": "*const *const c_char",
            "const mimo_layout **": "*mut *const mimo_layout",
            "mimo_env **": "*mut *mut mimo_env",
            "size_t": "usize",
        }
        self.assertEqual({name: _rust_words.rust_type(name) for name in types}, types)

    def test_short_names_of_constants_are_names(self):
        prose = _prose.Prose(self.interface, lambda name: f"<{name}>")
        self.assertEqual(prose.text("Default _LINEAR.", "TouchResponse"), "Default <MIMO_RESPONSE_LINEAR>.")
        self.assertEqual(prose.text("Default: VELOCITY; an SI unit.", "Vestibular"), "Default: VELOCITY; an SI unit.")
        self.assertEqual(prose.text("unused with _PLACE_SCENE"), "unused with <MIMO_PLACE_SCENE>")

    def test_comments_say_what_is_experimental(self):
        self.assertEqual(_prose.described(POINTER), "Weights of the joints.")
        young = dataclasses.replace(POINTER, stability="experimental")
        self.assertEqual(_prose.described(young), "Weights of the joints.\n\nExperimental.")

    def test_null_is_what_is_not_set(self):
        self.assertEqual(_prose.without_null("A face; NULL: neutral."), "A face; unless set: neutral.")
        self.assertEqual(_prose.without_null('NULL or "" (default): none.'), '"" (default): none.')

    def test_matlab_refuses_members_that_it_cannot_convert(self):
        with self.assertRaisesRegex(ValueError, r"mimo_agent_config\.weights, a const double \*"):
            matlab.listed(self.grown("mimo_agent_config", POINTER))

    def test_rust_refuses_members_that_it_cannot_set(self):
        with self.assertRaisesRegex(ValueError, r"weights, a const double \*"):
            _rust_structs.Configs(self.interface).config(self.grown("mimo_agent_config", POINTER))

    def test_contacts_say_how_many_values_they_have(self):
        self.assertEqual(matlab.each(self.interface, "MIMO_CONTACT_FRAME"), 9)
        self.assertEqual(matlab.each(self.interface, "MIMO_BODY_MASS"), 0)
        self.interface.constant("MIMO_CONTACT_FRAME").doc = "The frame of a contact."
        with self.assertRaisesRegex(ValueError, "MIMO_CONTACT_FRAME"):
            matlab.each(self.interface, "MIMO_CONTACT_FRAME")


if __name__ == "__main__":
    unittest.main()
