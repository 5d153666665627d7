"""What tests of the program `mimo` have in common: it is run in an empty folder, and what it wrote is read.

The path of the program is in the environment as MIMO_PROGRAM. Python's standard library is all that is needed.
"""
import ctypes
import os
import pathlib
import struct
import subprocess
import tempfile
import unittest
import zlib

PROGRAM = os.environ.get("MIMO_PROGRAM", "mimo")
BENCH = str(pathlib.Path(PROGRAM).with_name("mimo-bench"))  # lies beside it in build folders
SOURCES = pathlib.Path(__file__).resolve().parent.parent.parent
GOLDEN = SOURCES / "tests/golden"
# Of the scene that the program shows without further words.
COUNTS = {"nq": 68, "nv": 65, "nu": 44, "bodies": 26, "joints": 50, "geoms": 39, "cameras": 2}


def can_load(*names):
    """Whether one of these libraries is there."""
    for name in names:
        try:
            ctypes.CDLL(name)
            return True
        except OSError:
            pass
    return False


needs_renderer = unittest.skipUnless(can_load("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"),
                                     "OSMesa is not installed")
# As src/recording/hdf5.cpp looks for it.
needs_hdf5 = unittest.skipUnless(can_load("libhdf5_serial.so.103", "libhdf5.so.103", "libhdf5_serial.so.310",
                                          "libhdf5.so.310", "libhdf5.so.200", "libhdf5.so.320", "libhdf5_serial.so",
                                          "libhdf5.so"), "HDF5 is not installed")


def read_png(path):
    """Width, height, bits, channels and the rows of a PNG as bytes."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "not a PNG"
    at, compressed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            compressed += body
        at += 12 + length
    channels = {0: 1, 2: 3, 6: 4}[color]
    return width, height, bits, channels, unfilter(zlib.decompress(compressed), height, channels * bits // 8)


def unfilter(raw, height, pixel):
    stride = len(raw) // height - 1
    rows, above = [], bytes(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            a = line[x - pixel] if x >= pixel else 0
            b = above[x]
            c = above[x - pixel] if x >= pixel else 0
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            line[x] = (line[x] + (0, a, b, (a + b) // 2, nearest)[kind]) & 255
        rows.append(bytes(line))
        above = line
    return rows


def read_npy(path):
    """Type, shape and values of a .npy file."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x93NUMPY\x01\x00", "not a .npy file"
    length, = struct.unpack("<H", data[8:10])
    assert (10 + length) % 64 == 0
    header = eval(data[10:10 + length].decode(), {})
    code = {"<f4": "f", "<i4": "i"}[header["descr"]]
    count = header["shape"][0] * header["shape"][1]
    return header["descr"], header["shape"], struct.unpack("<%d%s" % (count, code), data[10 + length:])


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def mimo(self, *arguments, code=0, env=None):
        """Runs the program in an empty folder; returns its standard output, or the error line if it should fail."""
        return self.run_program(PROGRAM, *arguments, code=code, env=env)

    def run_program(self, program, *arguments, code=0, env=None):
        done = subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, cwd=self.folder, env=dict(os.environ, **(env or {})))
        self.assertEqual(done.returncode, code, done.stderr)
        if code == 0:
            self.assertEqual(done.stderr, "")
            return done.stdout
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"\Amimo[^\n]*: [^\n]+\n\Z", "not one line")
        return done.stderr

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def files(self):
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*") if p.is_file())
