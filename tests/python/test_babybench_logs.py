"""mimo.babybench: files of others. Each is read, or refused in one line that names it; none does anything else."""

import contextlib
import io
import pickle
import random
import subprocess

import numpy as np
import pytest

from mimo import babybench
from mimo.babybench import logs, reports
from mimo.babybench.pickled import loads

PLAIN = [
    {"steps": 3, "right_hand_touches": [1, 2], "share": 0.5, "name": "ä", "raw": b"\xff", "none": None, "on": True},
    (1, (2,), ()),
    [-5, 2**40, np.float32(0.1), np.int64(7), np.bool_(True)],
    [np.arange(6).reshape(2, 3), np.asfortranarray(np.arange(6.0).reshape(2, 3)), np.arange(12).reshape(3, 4)[:, ::2]],
    [np.array(["ab", "ä"]), np.array([b"x"]), np.zeros((0, 3)), np.array(3.0), np.array([1, 2], ">i4")],
]


def same(found, meant):
    assert type(found) is type(meant)
    if isinstance(meant, (np.ndarray, np.generic)):
        np.testing.assert_array_equal(found, meant, strict=isinstance(meant, np.ndarray) and meant.dtype.isnative)
    elif isinstance(meant, (list, tuple)):
        assert len(found) == len(meant)
        for one, other in zip(found, meant):
            same(one, other)
    elif isinstance(meant, dict):
        same(list(found.items()), list(meant.items()))
    else:
        assert found == meant


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_logs_are_read_as_pickle_reads_them(protocol):
    same(loads(pickle.dumps(PLAIN, protocol)), PLAIN)
    array = loads(pickle.dumps(np.arange(3), protocol))
    array[0] = 5  # its own memory


class Calls:
    """Pickled, it is a call."""

    def __init__(self, *reduced):
        self.reduced = reduced

    def __reduce__(self):
        return self.reduced


def pointers():
    """An array of the file's bytes that claims to hold objects, which numpy would follow as pointers."""
    told = pickle.dumps(np.array([0x4141414141414141, 0x4141414141414141], np.int64), 2)
    return told.replace(b"i8", b"O8")


REFUSED = {
    "program": (pickle.dumps(Calls(subprocess.call, (["true"],))), "subprocess.call, expected numbers"),
    "builtin": (pickle.dumps(Calls(eval, ("1",))), "eval, expected numbers"),
    "objects": (pickle.dumps(np.array([None, []], object)), "an array of 'O8'"),
    "pointers": (pointers(), "an array of 'O8'"),
    "structures": (pickle.dumps(np.zeros(2, [("a", "O"), ("b", "i4")])), "an array of 'V12'|an array of 'V16'"),
    "times": (pickle.dumps(np.zeros(2, "M8[s]")), "an array of 'M8'"),
    "a type": (pickle.dumps([np.dtype("f8")]), "the type of an array"),
    "an object": (pickle.dumps(io.BytesIO(b"")), "_io.BytesIO, expected numbers"),
    "a class": (pickle.dumps(Calls), "Calls, expected numbers"),
    "nothing": (b"", "not a log"),
    "text": (b"nothing", "not a log"),
    "a length of 2^62": (b"\x80\x04\x8e" + (2**62).to_bytes(8, "little") + b"x.", "but only 2 remain"),
    "a place of 2^31": (b"\x80\x04]r\xff\xff\xff\x7f0j\xff\xff\xff\x7e.", "do not fit together"),
    "a long number": (pickle.dumps(10**5000), "a whole number of 16610 bits, expected at most 64"),
    "a long decimal": (b"I" + b"9" * 5000 + b"\n.", "not a log"),
    "a cut array": (pickle.dumps(np.arange(9.0), 4).replace(b"C\x48", b"C\x08"), "not a log"),
    "no letters": (pickle.dumps(np.array(["ab"]), 4).replace(b"a\0\0\0b\0\0\0", b"\xff" * 8), "no letters"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_anything_else_is_refused(name, tmp_path):
    data, line = REFUSED[name]
    path = tmp_path / "evil.pkl"
    path.write_bytes(data)
    with pytest.raises(ValueError, match=line) as raised:
        logs.read(path)
    assert str(raised.value).startswith(f"{path} is not a log: ")
    assert "\n" not in str(raised.value)


def test_an_object_type_in_the_state_of_a_plain_one():
    """A type of numbers whose state says that it holds objects."""
    told = pickle.dumps(np.arange(2.0), 0).decode("latin1")
    assert "NNNI-1\nI-1\nI0\n" in told
    with pytest.raises(ValueError, match="an array of structures"):
        loads(told.replace("NNNI-1\nI-1\nI0\n", "NNNI-1\nI-1\nI63\n").encode("latin1"))


@pytest.mark.filterwarnings("ignore:invalid escape sequence")  # of texts that a change has made
def test_damaged_logs_are_read_or_refused():
    """Whatever is read can be printed: it is of the plain types only."""
    chance, read = random.Random(1), 0
    wholes = [pickle.dumps(PLAIN, protocol) for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
    for _ in range(3000):
        data = bytearray(chance.choice(wholes))
        for _ in range(chance.randint(1, 4)):
            data[chance.randrange(len(data))] = chance.randrange(256)
        with contextlib.suppress(ValueError):
            assert repr(loads(bytes(data)))
            read += 1
    assert read > 50


def test_deep_logs_are_read():
    found = loads(b"]" * 20001 + b"a" * 20000 + b".")
    depth = 0
    while found:
        found, depth = found[0], depth + 1
    assert depth == 20000


@pytest.mark.parametrize(
    ("entry", "line"),
    [
        ({"steps": "many"}, "steps of episode 1 is 'many', expected a count"),
        ({"steps": 2**62}, "steps of episode 1 is 4611686018427387904, expected a count"),
        ({"steps": float("nan")}, "steps of episode 1 is nan, expected a count"),
        ({"steps": 1, "right_eye_right_hand": -1}, "right_eye_right_hand of episode 1 is -1, expected a count"),
        ({"steps": 1, "right_hand_touches": 7}, "right_hand_touches of episode 1 is 7, expected numbers of geoms"),
        (
            {"steps": 1, "right_hand_touches": np.array(7)},
            "right_hand_touches of episode 1 is .*7.*, expected numbers of geoms",
        ),
        ({"steps": 1, "right_hand_touches": ["x"]}, r"right_hand_touches of episode 1 is \['x'\], expected numbers"),
    ],
)
def test_entries_that_count_nothing(entry, line, tmp_path):
    logs.write(tmp_path / "training.pkl", [{"steps": 2}, entry])
    with pytest.raises(ValueError, match=f"training.pkl is not a log: {line}"):
        reports.scores_in(tmp_path)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("[" * 20000, "nested too deeply"),
        ("frame_skip: " + "9" * 5000, "is not YAML: Exceeds the limit|frame_skip is 9"),  # older Pythons read it
        ("save_dir: 2001-99-99", "is not YAML: month must be in 1..12"),
        ("a: [1\n", "is not YAML: while parsing"),
        ("\0", "is not YAML"),
        (
            "a: &a [x, x]\n"
            + "".join(
                f"{n}: &{n} [*{p}, *{p}]\n" for p, n in zip("abcdefghijklmnopqrstuvw", "bcdefghijklmnopqrstuvwx")
            ),
            "config has 'a', but no switch",
        ),
        ("scene: &a [x, [&b [*a, *a], *b, *b]]\n", r"scene is \['x', \[\["),
    ],
    ids=["deep", "long number", "date", "open", "zero", "names for names", "lists of lists"],
)
def test_yaml_without_a_configuration_is_refused(text, line, tmp_path):
    (tmp_path / "evil.yml").write_text(text)
    with pytest.raises(ValueError, match=line) as raised:
        babybench.load(tmp_path / "evil.yml")
    assert len(str(raised.value)) < 3000
    assert "\n" not in str(raised.value)
