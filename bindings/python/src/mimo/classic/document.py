"""Constants of a model that the library does not hand out, from its MJCF document."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from ..constants import Kind
from ..world import World
from .rotations import quaternion_of

Numbers = NDArray[np.float64]
Attributes = Dict[str, str]
MOTORS = ("general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "adhesion")
EQUALITIES = ("connect", "weld", "joint", "tendon", "distance", "flex")  # MuJoCo's numbers of types
JOINTS = ("free", "ball", "slide", "hinge")
GEOMS = ("plane", "hfield", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh", "sdf")
SENSORS = ("touch", "accelerometer", "velocimeter", "gyro", "force", "torque", "magnetometer", "rangefinder")
ANGLES = ("euler", "axisangle", "zaxis", "xyaxes", "quat")


class Row(NamedTuple):
    """One element: its tag, and its attributes with those of its default classes."""

    tag: str
    at: Mapping[str, str]
    body: int

    def number(self, name: str, standard: float = 0.0) -> float:
        """A number."""
        return float(self.at[name].split()[0]) if name in self.at else standard

    def numbers(self, name: str, standard: Sequence[float]) -> Numbers:
        """Several numbers; missing ones at the end are the standard ones."""
        given = [float(it) for it in self.at.get(name, "").split()]
        return np.array([*given, *standard[len(given) :]])


class Document:
    """The elements of a scene in MuJoCo's order, with the attributes that apply to them."""

    def __init__(self, text: str) -> None:
        self.root = ET.fromstring(text)
        self._defaults = self._classes()
        compiler: Attributes = {}
        for one in self.root.findall("compiler"):
            compiler.update(one.attrib)
        self.degrees = compiler.get("angle", "degree") == "degree"
        self.sequence = compiler.get("eulerseq", "xyz")
        self.bodies: List[Row] = [Row("body", {"name": "world"}, 0)]
        self._of_bodies: Dict[str, List[Row]] = {tag: [] for tag in ("joint", "geom", "site", "camera")}
        roots = self.root.findall("worldbody")
        self._add([child for part in roots for child in part], 0, "main")
        kinds = ("joint", "geom", "site", "camera")
        self.joints, self.geoms, self.sites, self.cameras = (self._by_body(tag) for tag in kinds)
        self.actuators = self._section("actuator", MOTORS, "actuator")
        self.sensors = self._section("sensor", None, "sensor")
        self.equalities = self._section("equality", EQUALITIES, "equality")
        self.materials = self._section("asset", ("material",), "material")
        self.textures = self._section("asset", ("texture",), "texture")
        self.tendons = self._section("tendon", ("fixed", "spatial"), "tendon")
        self.keys = self._section("keyframe", ("key",), "key")

    def merged(self, tag: str) -> Attributes:
        """The attributes of all sections with this tag, such as `option`; later ones count."""
        merged: Attributes = {}
        for one in self.root.findall(tag):
            merged.update(one.attrib)
        return merged

    def radians(self, value: Any) -> Any:
        """An angle of the document in radians."""
        return np.radians(value) if self.degrees else value

    def orientation(self, row: Row) -> Numbers:
        """The quaternion of an element in its body's frame."""
        kind = next((it for it in ANGLES if it in row.at), None)
        if kind is None:
            return np.array([1.0, 0, 0, 0])
        values = row.numbers(kind, ())
        if kind in ("euler", "axisangle"):
            values[-1 if kind == "axisangle" else slice(None)] = self.radians(
                values[-1 if kind == "axisangle" else slice(None)]
            )
        return quaternion_of(kind, values, self.sequence)

    def matches(self, world: World) -> bool:
        """Whether the order here is that of the world: the names of its bodies, joints and geoms."""
        kinds = ((Kind.BODY, self.bodies), (Kind.JOINT, self.joints), (Kind.GEOM, self.geoms))
        for kind, rows in kinds:
            names = [world.name(kind, number) for number in range(world.count(kind))]
            if names != [row.at.get("name", "") for row in rows]:
                return False
        return True

    # ---- Bodies ---------------------------------------------------------------------------------------------------

    def _add(self, elements: Sequence[ET.Element], body: int, childclass: str) -> None:
        for element in elements:
            if element.tag == "body":
                own = element.get("childclass", childclass)
                self.bodies.append(Row("body", dict(element.attrib), body))
                self._add(list(element), len(self.bodies) - 1, own)
            elif element.tag == "freejoint":
                self._of_bodies["joint"].append(Row("joint", {**element.attrib, "type": "free"}, body))
            elif element.tag in self._of_bodies:
                self._of_bodies[element.tag].append(self._row(element, element.tag, childclass, body))

    def _by_body(self, tag: str) -> List[Row]:
        return sorted(self._of_bodies[tag], key=lambda row: row.body)  # the sort keeps the order within a body

    def _section(self, section: str, tags: Optional[Tuple[str, ...]], kind: str) -> List[Row]:
        elements = [child for part in self.root.findall(section) for child in part]
        return [self._row(it, kind, "main", 0) for it in elements if tags is None or it.tag in tags]

    def _row(self, element: ET.Element, kind: str, childclass: str, body: int) -> Row:
        chosen = element.get("class", childclass)
        return Row(element.tag, {**self._defaults.get((chosen, kind), {}), **element.attrib}, body)

    # ---- Defaults -------------------------------------------------------------------------------------------------

    def _classes(self) -> Dict[Tuple[str, str], Attributes]:
        """The attributes that a class gives to a kind of element, with those of the classes around it."""
        made: Dict[Tuple[str, str], Attributes] = {}
        main: Dict[str, Attributes] = {}  # the outermost class grows from one section to the next
        for top in self.root.findall("default"):
            names = {"main", top.get("class", "main")}
            for name, kind, attributes in _settings(top, "main", main):
                for one in names if name == "main" else (name,):
                    made.setdefault((one, kind), {}).update(attributes)
            main = {kind: attributes for (name, kind), attributes in made.items() if name == "main"}
        return made


def _settings(element: ET.Element, name: str, outer: Mapping[str, Attributes]) -> Iterator[Tuple[str, str, Attributes]]:
    own = {kind: dict(attributes) for kind, attributes in outer.items()}
    for child in element:
        if child.tag != "default":
            kind = "actuator" if child.tag in MOTORS else child.tag
            own.setdefault(kind, {}).update(child.attrib)
    for kind, attributes in own.items():
        yield name, kind, attributes
    for child in element:
        if child.tag == "default":
            yield from _settings(child, child.get("class", "main"), own)
