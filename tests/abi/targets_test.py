"""What interface/targets makes of types, comments and members that C says in one word, and what it refuses."""

import dataclasses
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "interface"))

import api  # noqa: E402
from targets import _prose, _rust_structs, _rust_words, _wasm32, matlab, python  # noqa: E402

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

    def test_wasm32_aligns_doubles_between_pointers_of_four_bytes(self):
        # Two uint32, two pointers and a size_t are 20 bytes; the doubles behind them begin at multiples of 8.
        action = self.interface.struct("mimo_action")
        self.assertEqual(_wasm32.layout(self.interface, action), (40, [0, 4, 8, 12, 16, 24, 32]))

    def test_short_names_of_constants_are_names(self):
        prose = _prose.Prose(self.interface, lambda name: f"<{name}>")
        self.assertEqual(prose.text("Default _LINEAR.", "TouchResponse"), "Default <MIMO_RESPONSE_LINEAR>.")
        self.assertEqual(prose.text("Default _BODY.", "TouchFrame"), "Default <MIMO_FRAME_BODY>.")  # not MIMO_BODY
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

    def with_member(self, member):
        structs = [
            self.grown(it.name, member) if it.name == "mimo_agent_config" else it for it in self.interface.structs
        ]
        return dataclasses.replace(self.interface, structs=structs)

    def test_python_has_pointers_of_ctypes(self):
        types = {
            "const char *const *": "POINTER(c_char_p)",
            "const mimo_layout **": "POINTER(c_void_p)",
            "const mimo_growth *const *": "POINTER(POINTER(Growth))",
            "mimo_log_fn": "LogFn",
            "mimo_status": "c_int32",
            "size_t": "c_size_t",
        }
        self.assertEqual({name: python.ctype(self.interface, name) for name in types}, types)

    def test_python_tells_single_numbers_from_arrays(self):
        told = {
            it: python.parameter_types(self.interface, self.interface.function(it))
            for it in ("mimo_env_width", "mimo_env_get")
        }
        self.assertEqual(told["mimo_env_width"], ["c_void_p", "c_int32", "c_void_p", "c_size_t", "POINTER(c_size_t)"])
        self.assertEqual(told["mimo_env_get"], ["c_void_p", "c_int32", "c_void_p", "c_size_t", "c_void_p", "c_size_t"])

    def test_python_s_names_of_functions_and_constants(self):
        names = {
            "MIMO_TOUCH_FORCE": "Touch.FORCE",
            "MIMO_NOW": "NOW",
            "mimo_scene_set_touch": "Scene.set_touch",
            "mimo_face_name": "faces()",
            "mimo_env_config": "PhysicsOptions",
            "mimo_env_destroy": "mimo_env_destroy",
        }
        self.assertEqual({name: python.python_name(self.interface, name) for name in names}, names)

    def test_python_refuses_members_that_it_cannot_set(self):
        with self.assertRaisesRegex(ValueError, r"mimo_agent_config\.weights, a const double \*"):
            python.options(self.with_member(POINTER))
        with self.assertRaisesRegex(
            ValueError, r"mimo_agent_config\.lambda would be 'lambda' in Python, which is a keyword"
        ):
            python.options(self.with_member(dataclasses.replace(POINTER, name="lambda", type="double")))

    def test_python_has_new_members_bits_and_quantities(self):
        new = api.Member("smell", "uint32_t", 0, 4, "1: it smells; 0 (default): it does not.", range=[0, 1])
        options = python.options(self.with_member(new))
        self.assertIn('    smell: bool\n    """True: it smells; False (default): it does not."""', options)
        quantity = api.Constant("MIMO_GEOM_SMELL", 999, "Geom: 1. Writable.", "access.h", "Quantity", "1.1", "stable")
        self.interface.constants.append(quantity)
        self.interface.enum("Quantity").constants.append("MIMO_GEOM_SMELL")
        self.assertIn("    smell = WritableValues(Quantity.GEOM_SMELL)", python.selections(self.interface))
        self.assertIn("    GEOM_SMELL = 999", python.constants(self.interface))


if __name__ == "__main__":
    unittest.main()
