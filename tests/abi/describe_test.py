"""interface/describe.py names what it cannot describe: each case breaks a header and reads the message."""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "interface"))

import api  # noqa: E402
import describe  # noqa: E402
from targets import bindings_page  # noqa: E402

FUNCTION = "MIMO_API mimo_status mimo_env_update(mimo_env *env) MIMO_NOEXCEPT;"
STRUCT = (
    "/** An example. */\ntypedef struct mimo_example {{\n{}\n}} mimo_example;\n\n"
    "/** Simulated seconds since the last reset. */"
)
TIME = "/** Simulated seconds since the last reset. */"

# Header, what is replaced in it, by what, and the message.
CASES = {
    "a type of another width on each platform": (
        "access.h",
        FUNCTION,
        FUNCTION.replace("mimo_env *env", "mimo_env *env, long count"),
        'access.h: mimo_env_update: parameter count: the type "long" cannot be described',
    ),
    "a result of an unknown type": (
        "access.h",
        FUNCTION,
        FUNCTION.replace("mimo_status", "bool"),
        'access.h: mimo_env_update: its result: the type "bool" cannot be described',
    ),
    "a struct by value": (
        "access.h",
        FUNCTION,
        FUNCTION.replace("mimo_env *env", "mimo_env *env, mimo_env_config config"),
        'access.h: mimo_env_update: parameter config: the type "mimo_env_config" cannot be described',
    ),
    "a parameter without a name": (
        "access.h",
        FUNCTION,
        FUNCTION.replace("mimo_env *env", "mimo_env *env, ..."),
        'access.h: mimo_env_update: a parameter "..." without a name, or an array, cannot be described',
    ),
    "a comment about another parameter": (
        "access.h",
        " * @param quantity    may have MIMO_NOW.",
        " * @param amount      may have MIMO_NOW.",
        "access.h: mimo_env_get: its comment speaks of amount, which it does not have",
    ),
    "no comment": ("env.h", TIME, "", "env.h: mimo_env_time: it has no comment"),
    "a bit-field": (
        "env.h",
        TIME,
        STRUCT.format("uint32_t struct_size; /**< Size. */\n  uint32_t bits : 3; /**< Bits. */"),
        "env.h: mimo_example.bits: a bit-field cannot be described",
    ),
    "padding": (
        "env.h",
        TIME,
        STRUCT.format("uint32_t struct_size; /**< Size. */\n  double value; /**< Value. */"),
        "env.h: mimo_example.value: there is padding before it, at offset 4",
    ),
    "padding at the end": (
        "env.h",
        TIME,
        STRUCT.format("double value; /**< Value. */\n  uint32_t count; /**< Count. */"),
        "env.h: mimo_example: it ends with padding, at offset 12, or has no members",
    ),
    "an array of an unknown length": (
        "env.h",
        TIME,
        STRUCT.format("double values[COUNT]; /**< Values. */"),
        'env.h: mimo_example.values: the array "[COUNT]" cannot be described',
    ),
    "a struct within a struct": (
        "env.h",
        TIME,
        STRUCT.format("struct { double value; /**< Value. */ } inner; /**< Inner. */"),
        'env.h: mimo_example.inner: the type "struct mimo_example::@0" cannot be described',
    ),
    "an enumeration": (
        "env.h",
        TIME,
        "/** Words. */\nenum mimo_words { MIMO_WORD };\n\n" + TIME,
        "env.h: mimo_words: a enum cannot be described; there are constants, structs and functions",
    ),
    "a variable": (
        "env.h",
        TIME,
        "/** A number. */\nextern int32_t mimo_number;\n\n" + TIME,
        "env.h: mimo_number: a variable cannot be described; there are constants, structs and functions",
    ),
    "a type that is an unknown one": (
        "env.h",
        TIME,
        "/** A number. */\ntypedef long mimo_number;\n\n" + TIME,
        'env.h: mimo_number: a typedef of "long" cannot be described',
    ),
    "a constant that is an expression": (
        "env.h",
        TIME,
        "#define MIMO_LATER sizeof(double) /**< Later. */\n\n" + TIME,
        'env.h: MIMO_LATER: the value "sizeof(double)" is no number and no string',
    ),
    "a constant of no enumeration": (
        "env.h",
        TIME,
        "#define MIMO_LATER 7 /**< Later. */\n\n" + TIME,
        "env.h: MIMO_LATER belongs to no enumeration of notes.toml, and is not in constants.alone",
    ),
    "a sense that agents do not have": (
        "agent.h",
        "  uint32_t hearing; ",
        "  uint32_t listening; ",
        "mimo_agent_config lacks hearing, a sense by notes.toml",
    ),
    "a flag of two bits": (
        "env.h",
        "#define MIMO_DISABLE_GRAVITY 0x2u",
        "#define MIMO_DISABLE_GRAVITY 0x3u",
        "notes.toml: Disable: its flags are not single bits: [1, 3, 4]",
    ),
    "one value twice": (
        "experimental/engine.h",
        "#define MIMO_JACOBIAN_SPARSE 2",
        "#define MIMO_JACOBIAN_SPARSE 1",
        "notes.toml: Jacobian: its constants are not different whole numbers: [0, 1, 1]",
    ),
}


class Describe(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.headers = Path(temporary.name) / "mimo"
        shutil.copytree(ROOT / "include/mimo", self.headers)

    def test_names_what_it_cannot_describe(self):
        for name, (header, old, new, message) in CASES.items():
            with self.subTest(name):
                path = self.headers / header
                text = path.read_text()
                self.assertEqual(text.count(old), 1)
                path.write_text(text.replace(old, new))
                try:
                    with self.assertRaises(describe.Undescribable) as raised:
                        describe.describe(self.headers)
                finally:
                    path.write_text(text)
                self.assertEqual(str(raised.exception), message)

    def test_reads_what_is_new(self):
        """A function, a struct and a flag that a header has more stand in the description, as it says them."""
        env = self.headers / "env.h"
        new = (
            "#define MIMO_DISABLE_LIMIT 0x8u /**< No limits. */\n\n/** A pair. */\ntypedef struct mimo_pair {\n"
            "  uint32_t struct_size; /**< Size. */\n  uint32_t off; /**< MIMO_DISABLE_ bits. */\n"
            "  const char *const *names; /**< Names. */\n  double values[3]; /**< Values,\n  m. */\n} mimo_pair;\n\n"
            "/**\n * Pairs.\n *\n * Twice.\n * @param pair receives it:\n *             both.\n * Errors: none.\n */\n"
            "MIMO_API mimo_status mimo_env_pair(const mimo_env *env, mimo_pair *pair) MIMO_NOEXCEPT;\n\n"
        )
        env.write_text(env.read_text().replace(TIME, new + TIME))
        found = describe.describe(self.headers)
        constant = next(one for one in found["constants"] if one["name"] == "MIMO_DISABLE_LIMIT")
        self.assertEqual((constant["value"], constant["group"], constant["doc"]), (8, "Disable", "No limits."))
        struct = next(one for one in found["structs"] if one["name"] == "mimo_pair")
        self.assertEqual((struct["size"], struct["first_size"], struct["sized"]), (40, 40, True))
        self.assertEqual(
            [(one["name"], one["type"], one["offset"], one["size"], one["array"]) for one in struct["members"]],
            [
                ("struct_size", "uint32_t", 0, 4, 0),
                ("off", "uint32_t", 4, 4, 0),
                ("names", "const char *const *", 8, 8, 0),
                ("values", "double", 16, 24, 3),
            ],
        )
        self.assertEqual(struct["members"][1]["enum"], "Disable")
        self.assertEqual(struct["members"][3]["doc"], "Values, m.")
        function = next(one for one in found["functions"] if one["name"] == "mimo_env_pair")
        self.assertEqual(function["doc"], "Pairs.\n\nTwice.\n\nErrors: none.")
        self.assertEqual(
            [(one["name"], one["type"], one["doc"]) for one in function["parameters"]],
            [("env", "const mimo_env *", ""), ("pair", "mimo_pair *", "receives it: both.")],
        )

    def test_members_belong_to_the_sense_whose_name_they_begin_with(self):
        """And limit_threshold to the one that notes.toml names, so that replays with other senses take all of them."""
        header = self.headers / "agent.h"
        last = "  uint32_t voice; "
        more = "  uint32_t hearing_example; /**< New. */\n  uint32_t reserved; /**< 0. */\n"
        header.write_text(header.read_text().replace(last, more + last))
        config = next(one for one in describe.describe(self.headers)["structs"] if one["name"] == "mimo_agent_config")
        senses = {one["name"]: one.get("sense") for one in config["members"]}
        self.assertEqual(senses["hearing_example"], "hearing")
        self.assertEqual(senses["touch_scale"], "touch")
        self.assertEqual(senses["limit_threshold"], "proprioception")
        self.assertEqual((senses["voice"], senses["actuation"]), (None, None))

    def test_names_what_a_binding_lacks(self):
        interface = api.load()
        new = api.Function("mimo_env_pair", "mimo_status", [], "Pairs.", "env.h", "stable", "1.1", "LIBMIMO_1.1")
        interface.functions.append(new)
        with self.assertRaises(describe.Undescribable) as raised:
            bindings_page.table(interface)
        languages = ["C++", "Python", "Rust", "C#", "MATLAB", "JavaScript"]
        lacking = [f"{language} lacks mimo_env_pair, and notes.toml has no reason for that" for language in languages]
        self.assertEqual(str(raised.exception).splitlines(), lacking)


if __name__ == "__main__":
    unittest.main()
