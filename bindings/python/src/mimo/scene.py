"""Scenes: a room, objects and infants, from which worlds are made."""

from __future__ import annotations

import copy
import ctypes
import json
import os
from functools import wraps
from typing import (
    TYPE_CHECKING,
    Any,
    Callable,
    Dict,
    Iterator,
    List,
    Mapping,
    MutableMapping,
    Optional,
    Sequence,
    Tuple,
    TypeVar,
    Union,
    cast,
)

from . import _abi
from ._handle import Handle
from ._library import LIB, check, defaults, log_to_python, result, text, told_before, utf8
from ._strict import Strict
from .ages import growth_from
from .arguments import number_of, real_number, several, vector
from .behaviour import Behaviour, behaviour_of
from .constants import NOW, Place, Proprioception, Quantity, Reflex, Status, Touch, Vestibular
from .errors import NotFoundError
from .maturity import Maturity, maturity_from
from .option_types import SENSES
from .options import (
    AgentOptions,
    CameraOptions,
    DocumentOptions,
    FieldOptions,
    GrowthOptions,
    LimitOptions,
    ModelOptions,
    Numbers,
    ObjectOptions,
    Options,
    WorldOptions,
    enums,
    fill,
    refuse_unknown,
)
from .own_sense import BoundSense, Sense
from .own_task import Bound, WorldTask
from .tasks import Task

if TYPE_CHECKING:
    from typing_extensions import Unpack

_Step = Tuple[str, Tuple[Any, ...], Dict[str, Any]]
Edit = TypeVar("Edit", bound=Callable[..., Any])
# Methods that change a scene. Copies, pickles and recordings repeat their calls, so a file may name them.
EDITS: Dict[str, Callable[..., Any]] = {}
FILES = (".xml", ".mjcf")


def scenes() -> List[str]:
    """Names of the built-in scenes."""
    return _names(LIB.mimo_scene_name)


def faces() -> List[str]:
    """Names of the faces of the built-in bodies."""
    return _names(LIB.mimo_face_name)


def materials() -> List[str]:
    """Names of the materials for Scene.set_material."""
    return _names(LIB.mimo_material_name)


def rooms() -> List[str]:
    """Names of the rooms for Scene.set_room."""
    return _names(LIB.mimo_room_name)


def tasks() -> List[str]:
    """Names of the built-in tasks."""
    return _names(LIB.mimo_task_name)


def _names(by_index: Any) -> List[str]:
    names: List[str] = []
    while (name := by_index(len(names))) is not None:
        names.append(text(name))
    return names


def _add_senses(config: _abi.AgentConfig, options: AgentOptions, off: List[str]) -> None:
    """Adds senses that are off by default, or all receptors, to the senses that are on."""
    which = options.get("senses", "usual")
    names = [which] if isinstance(which, str) else list(which)
    known = ["usual", "all", *off]
    if not set(names) <= set(known):
        raise ValueError(f"senses is {which!r}, expected {', '.join(map(json.dumps, known))}, or a list of these")
    for sense in off:
        if not {sense, "all"}.isdisjoint(names) and sense not in options:
            setattr(config, sense, sum(SENSES[sense]))
    if "all" not in names:
        return
    config.proprioception |= Proprioception.ALL
    if config.vestibular:
        config.vestibular |= sum(Vestibular)
    if config.touch:
        config.touch |= sum(Touch) - Touch.FORCE - Touch.NORMAL_FORCE  # mutually exclusive
    config.reflexes |= Reflex.FELT


def _edit(method: Edit) -> Edit:
    """Remembers the successful calls of a method, with absolute paths of files."""

    @wraps(method)
    def remembered(self: "Scene", *arguments: Any, **options: Any) -> Any:
        if options.get("file") is not None:
            options["file"] = os.path.abspath(options["file"])
        given = method(self, *arguments, **options)
        self._steps.append((method.__name__, arguments, options))
        return given

    EDITS[method.__name__] = remembered
    return cast(Edit, remembered)


class Scene(Handle):
    """A description of a room, objects and infants, from which worlds are made.

    It starts from a built-in scene, an MJCF file, an MJCF text, or (without arguments) an empty world. Worlds do not
    change when their scene is changed or closed afterwards. Scenes can be pickled and copied, which reads files again.
    `max_pixels` and the like limit MJCF documents; with `confined` their files must lie in their own folder.
    """

    def __init__(
        self,
        name: Optional[str] = None,
        *,
        file: Optional[Union[str, "os.PathLike[str]"]] = None,
        xml: Optional[str] = None,
        model_dir: Optional[Union[str, "os.PathLike[str]"]] = None,
        **limits: Unpack[DocumentOptions],
    ) -> None:
        refuse_unknown(limits, DocumentOptions, Scene.__init__)
        for start, given in (("name", name), ("file", file), ("xml", xml)):
            if given == "":
                raise ValueError(f"{start} is '', expected a value, or no argument for an empty world")
        self._start: Dict[str, Any] = {
            "name": name,
            "file": None if file is None else os.path.abspath(file),
            "xml": xml,
            "model_dir": None if model_dir is None else os.path.abspath(model_dir),
        }
        self._steps: List[_Step] = []
        self._agents = 0
        self._growths: List[Dict[str, Any]] = []  # options of growth, per infant
        self._task: Optional[Bound] = None
        self._own_senses: List[BoundSense] = []
        config = defaults(_abi.SceneConfig)
        for key, value in self._start.items():
            setattr(config, key, utf8(value, key))
        fill(config, limits, DocumentOptions)
        self._start.update(limits)
        config.log = log_to_python
        handle = ctypes.c_void_p()
        check(LIB.mimo_scene_create(config, handle))
        self._own(handle.value, LIB.mimo_scene_destroy)

    @_edit
    def add_agent(self, **options: Unpack[AgentOptions]) -> int:
        """Adds an infant and returns its number. Defaults are those of the scene's task."""
        number: int = result(ctypes.c_size_t, LIB.mimo_scene_add_agent, self._handle, self._agent_config(options))
        self._agents += 1
        self._growths.append(_growth_in(options))
        return number

    @_edit
    def add_agents(self, **options: Unpack[AgentOptions]) -> int:
        """Adds all infants that the scene names, or one if it names none; returns their number."""
        count: int = result(ctypes.c_size_t, LIB.mimo_scene_add_agents, self._handle, self._agent_config(options))
        self._agents += count
        self._growths += [_growth_in(options)] * count
        return count

    def _agent_config(self, options: AgentOptions) -> _abi.AgentConfig:
        config = defaults(_abi.AgentConfig)
        off = [sense for sense in SENSES if not getattr(config, sense)]
        standard = {sense: sum(SENSES[sense]) if sense in off else getattr(config, sense) for sense in SENSES}
        check(LIB.mimo_scene_default_agent(self._handle, config, ctypes.sizeof(config)))
        growth = _growth_in(options)
        agent = {name: value for name, value in options.items() if name not in growth and name != "senses"}
        fill(config, agent, AgentOptions, standard)
        _add_senses(config, options, off)
        if growth:
            config.growth = ctypes.pointer(growth_from(growth))
        given = options.keys() & {"position", "orientation"}
        if given and "place" not in options:
            config.place = Place.ROOT
        if given == {"orientation"} and self._agents > 0 and not any(config.position):  # all its places are taken
            raise ValueError(f"orientation: the scene has no place for infant number {self._agents + 1}; give position")
        return config

    def behaviour(self) -> Behaviour:
        """What the infant is to do, of a scene whose task is "behaviour"; NotFoundError for another scene."""
        raw = _abi.Behaviour()
        check(LIB.mimo_scene_behaviour(self._handle, raw))
        return behaviour_of(raw)

    @_edit
    def set_room(self, name: str) -> None:
        """Adds a room (floor, sky, light) to a scene without one; see mimo.rooms."""
        check(LIB.mimo_scene_set_room(self._handle, utf8(name)))

    @_edit
    def set_touch(self, body: Optional[str], spacing: float, agent: int = 0) -> None:
        """Sets the spacing (m) of touch sensors on a body; 0: no skin; body None: everywhere."""
        check(LIB.mimo_scene_set_touch(self._handle, number_of("agent", agent, 64), utf8(body), spacing))

    @_edit
    def read_joint(self, joint: str, agent: int = 0) -> None:
        """Adds a hinge or slide to an agent's proprioception; the first call removes all others."""
        check(LIB.mimo_scene_read_joint(self._handle, number_of("agent", agent, 64), utf8(joint)))

    @_edit
    def limit_sense(self, path: str, *, agent: int = 0, **limits: Unpack[LimitOptions]) -> None:
        """Limits a sense ("touch") or a field ("vision/eye_left") of an agent.

        `gain` is a factor, `noise` the standard deviation of Gaussian noise in the field's unit, `signal_noise` that of
        noise relative to the value; `delay` is in seconds. Pictures keep half the contrast at `blur` cycles per
        degree.
        """
        check(LIB.mimo_scene_limit_sense(self._handle, number_of("agent", agent, 64), utf8(path), _limits(limits)))

    @_edit
    def limit_motor(self, path: str = "", *, agent: int = 0, **limits: Unpack[LimitOptions]) -> None:
        """Limits a motor ("act:left_elbow"), the motors of a part of the body ("left_arm"), or all motors.

        The limits are those of limit_sense except `blur`; they apply to actions on their way to motors.
        """
        check(LIB.mimo_scene_limit_motor(self._handle, number_of("agent", agent, 64), utf8(path), _limits(limits)))

    @_edit
    def set_room_temperature(self, celsius: float) -> None:
        """Sets the temperature of the room and of everything without its own; the default is 24 degrees Celsius."""
        check(LIB.mimo_scene_set_room_temperature(self._handle, celsius))

    @_edit
    def set_temperature(self, body: str, celsius: float) -> None:
        """Sets the temperature of a body and its children."""
        check(LIB.mimo_scene_set_temperature(self._handle, utf8(body), celsius))

    @_edit
    def set_sources(self, count: int, seconds: float) -> None:
        """Sets how many bodies can play at once (default 4), and how much sound each can queue (default 4 s)."""
        check(LIB.mimo_scene_set_sources(self._handle, number_of("count", count), seconds))

    @_edit
    def direct_source(self, body: str, place: Numbers, axis: Numbers, directivity: float) -> None:
        """Sets the point from which a body plays, and its direction, in the body's frame.

        At an angle a from the axis the sound pressure has the factor 1 - directivity + directivity cos(a): 0 is
        omnidirectional, 0.5 a cardioid, 1 a figure of eight.
        """
        point, direction = vector("place", place, 3), vector("axis", axis, 3)
        check(
            LIB.mimo_scene_direct_source(
                self._handle,
                utf8(body),
                point.ctypes.data,
                direction.ctypes.data,
                real_number("directivity", directivity),
            )
        )

    @_edit
    def set_material(self, body: str, material: str) -> None:
        """Sets a body's material, one of mimo.materials(): "copper", "hardwood", ..."""
        check(LIB.mimo_scene_set_material(self._handle, utf8(body), utf8(material)))

    @_edit
    def set_maturity(self, maturity: Optional[Maturity], agent: int = 0) -> None:
        """Sets the maturity of an infant's eyes and nerves; None: by its age and the option `maturity`.

        Delays of limit_sense and limit_motor replace these delays.
        """
        raw = maturity_from(maturity)
        check(LIB.mimo_scene_set_maturity(self._handle, number_of("agent", agent, 64), raw))

    @_edit
    def set_sensory_delay(self, body: Optional[str], seconds: float, agent: int = 0) -> None:
        """Sets the delay (s) of touch and proprioception of a body; None: all bodies.

        It replaces the delay by age; delays of limit_sense take precedence.
        """
        number = number_of("agent", agent, 64)
        check(LIB.mimo_scene_set_sensory_delay(self._handle, number, utf8(body), real_number("seconds", seconds)))

    @_edit
    def add_object(self, name: str, **options: Unpack[ObjectOptions]) -> None:
        """Adds a rigid object; by default a red ball of 4 cm radius and 0.1 kg."""
        config = defaults(_abi.ObjectConfig)
        config.name = utf8(name)
        fill(config, options, ObjectOptions)
        check(LIB.mimo_scene_add_object(self._handle, config))

    @_edit
    def add_camera(self, name: str, **options: Unpack[CameraOptions]) -> None:
        """Adds a camera to the observation, as "vision/NAME", "vision/NAME_depth" and "vision/NAME_segmentation".

        Without `look_at`, `name` is a camera of the scene or of an infant ("anna/eye_left"). With it, the call makes a
        camera at `position` that looks at that point; `body` carries it, None: it stands still.
        """
        config = defaults(_abi.CameraConfig)
        config.name = utf8(name)
        fill(config, options, CameraOptions)
        config.placed = "look_at" in options
        check(LIB.mimo_scene_add_camera(self._handle, config))

    @_edit
    def add_field(
        self,
        name: str,
        quantity: Union[Quantity, str],
        elements: Union[str, Sequence[str]] = (),
        *,
        now: bool = False,
        relative_to: Optional[str] = None,
    ) -> None:
        """Adds a field to the observation: a quantity of elements (bodies, joints, ... by name).

        Poses and velocities belong to the start of the last physics step, with `now` to the step's end; they are in the
        world's frame, or in the moving frame of the body `relative_to`.
        """
        config = defaults(_abi.FieldConfig)
        config.name = utf8(name)
        fill(config, {"quantity": quantity, "relative_to": relative_to}, FieldOptions)
        config.quantity |= NOW if now else 0
        names = [utf8(element) for element in several("elements", elements)]
        config.elements, config.element_count = (ctypes.c_char_p * len(names))(*names), len(names)
        check(LIB.mimo_scene_add_field(self._handle, config))

    @_edit
    def add_model(self, name: str, **options: Unpack[ModelOptions]) -> None:
        """Adds an MJCF document with one body (file or xml) as an object; its names get the prefix "name/"."""
        config = defaults(_abi.ModelConfig)
        config.name = utf8(name)
        fill(config, options, ModelOptions)
        check(LIB.mimo_scene_add_model(self._handle, config))

    @_edit
    def weld(self, body: str, other: Optional[str] = None, pose: Optional[Numbers] = None) -> None:
        """Fastens a body to another (None: the world), in a pose (x y z, w x y z) in its frame or as they start."""
        numbers = None if pose is None else vector("pose", pose, 7)  # a position and a quaternion
        place = None if numbers is None else numbers.ctypes.data
        check(LIB.mimo_scene_weld(self._handle, utf8(body, "body"), utf8(other, "other"), place))

    @_edit
    def lock(self, joint: str, value: float) -> None:
        """Holds a hinge or slide (rad or m), and starts it there."""
        check(LIB.mimo_scene_lock(self._handle, utf8(joint), real_number("value", value)))

    @_edit
    def set_pose(self, joint: str, value: float) -> None:
        """Sets the initial position of a hinge or slide (rad or m)."""
        check(LIB.mimo_scene_set_pose(self._handle, utf8(joint), real_number("value", value)))

    @_edit
    def set_task(self, task: Optional[WorldTask]) -> None:
        """Sets the task of worlds made from now on, which runs inside their steps; None removes it."""
        bound = None if task is None else Bound(task)
        if bound is None:
            check(LIB.mimo_scene_set_task(self._handle, None))
        else:
            bound.tell(self._handle)
        self._task = bound

    @_edit
    def load_sense(self, path: Union[str, "os.PathLike[str]"], agent: int = 0) -> None:
        """Gives an agent of worlds made from now on the sense of a shared library, whose code runs.

        Its fields come after those of all infants and cameras; its parameters are in `parameters`.
        """
        place = utf8(os.path.abspath(path), "path")
        check(LIB.mimo_scene_load_sense(self._handle, number_of("agent", agent, 64), place))

    @_edit
    def add_sense(self, sense: Sense, agent: int = 0) -> None:
        """Gives an agent of worlds made from now on a sense in Python, which fills fields after each observation."""
        bound = BoundSense(sense)
        check(LIB.mimo_scene_add_sense(self._handle, number_of("agent", agent, 64), bound.table()))
        self._own_senses.append(bound)

    @property
    def parameters(self) -> "Parameters":
        """Parameters of tasks and loaded senses: scene.parameters["reach/success_reward"] = 10."""
        return Parameters(self)

    @property
    def xml(self) -> str:
        """The whole scene as one MJCF document, as MuJoCo will compile it."""
        buffer = ctypes.create_string_buffer(result(ctypes.c_size_t, LIB.mimo_scene_xml, self._handle, None, 0) + 1)
        check(LIB.mimo_scene_xml(self._handle, buffer, len(buffer), None))
        return text(buffer.value)

    def save(self, folder: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the scene as `scene.xml`, with its textures and meshes in `assets`, for any program with MuJoCo.

        Makes the folder if it is missing; does not overwrite files with other content.
        """
        check(LIB.mimo_scene_save(self._handle, utf8(os.fspath(folder), "folder")))

    @property
    def agent_count(self) -> int:
        """The number of infants."""
        return self._agents

    @property
    def source(self) -> str:
        """Its origin: the name of a built-in scene, the path of a file, "xml", or "nothing"."""
        return self._start["name"] or self._start["file"] or ("xml" if self._start["xml"] else "nothing")

    def __repr__(self) -> str:
        return f"<mimo.Scene {self.source}: {self._agents} infants>"

    def copy(self) -> "Scene":
        """A copy, made by the same calls; messages are not logged again."""
        with told_before():
            return copy.deepcopy(self)

    @_edit
    def _set_parameter(self, name: str, value: float) -> None:
        check(LIB.mimo_scene_set_parameter(self._handle, utf8(name), value))

    def make_call(self, method: str, arguments: Sequence[Any], options: Mapping[str, Any]) -> None:
        """Repeats a call that another scene remembers."""
        if method not in EDITS:
            raise ValueError(f"call is {method!r}, expected one of {', '.join(EDITS)}")
        EDITS[method](self, *arguments, **options)

    def __reduce__(self) -> Tuple[Any, ...]:
        return _rebuilt, (self._start, copy.deepcopy(self._steps))


def _growth_in(options: Mapping[str, Any]) -> Dict[str, Any]:
    return {name: value for name, value in options.items() if name in enums(GrowthOptions)}


def _limits(options: LimitOptions) -> _abi.Limits:
    limits = defaults(_abi.Limits)
    fill(limits, options, LimitOptions)
    return limits


def _rebuilt(start: Dict[str, Any], steps: List[_Step]) -> Scene:
    scene = Scene(**start)
    for method, arguments, options in steps:
        scene.make_call(method, arguments, options)
    return scene


class Parameters(Strict, MutableMapping[str, float]):
    """Parameters of a scene's tasks and loaded senses, by name, for worlds made from now on."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene

    def __getitem__(self, name: str) -> float:
        return float(result(ctypes.c_double, LIB.mimo_scene_get_parameter, self._scene._handle, utf8(name)))

    def __contains__(self, name: object) -> bool:  # __getitem__ raises no KeyError
        return name in list(self)

    def get(self, name: str, default: Any = None) -> Any:
        """The value, or the default where there is no parameter of that name."""
        try:
            return self[name]
        except NotFoundError:
            return default

    def __setitem__(self, name: str, value: float) -> None:
        self._scene._set_parameter(name, value)

    def __delitem__(self, name: str) -> None:
        raise TypeError("parameters cannot be removed")

    def __iter__(self) -> Iterator[str]:
        return (text(described.name) for described in self._all())

    def __len__(self) -> int:
        return len(self._all())

    def _all(self) -> List[_abi.Parameter]:
        count = int(result(ctypes.c_size_t, LIB.mimo_parameter_count))
        return [*map(_described, range(count)), *_of_senses(self._scene)]

    def describe(self, name: str) -> str:
        """One line about a parameter: what it is, its default and its range."""
        for it in self._all():
            if text(it.name) == name:
                return f"{text(it.description)} (default {it.standard:g}, {it.low:g} to {it.high:g})"
        self[name]  # raises and lists the existing names
        raise AssertionError(name)


def _described(index: int) -> _abi.Parameter:
    parameter = _abi.Parameter()
    check(LIB.mimo_parameter_describe(index, parameter))
    return parameter


def _of_senses(scene: Scene) -> List[_abi.Parameter]:
    all_of_them: List[_abi.Parameter] = []
    while True:
        parameter = _abi.Parameter()
        status = LIB.mimo_scene_sense_parameter(scene._handle, len(all_of_them), parameter)
        if status == Status.NOT_FOUND:
            return all_of_them
        check(status)
        all_of_them.append(parameter)


def start_of(scene: Any) -> Scene:
    """A built-in scene by its name; errors explain how to pass a file."""
    if isinstance(scene, os.PathLike):
        raise TypeError(f"scene is {scene!r}, expected a name or a mimo.Scene; for a file use mimo.Scene(file=...)")
    try:
        return Scene(scene)
    except NotFoundError as error:
        if isinstance(scene, str) and (os.path.basename(scene) != scene or os.path.splitext(scene)[1] in FILES):
            error.args = (f"{error}; for a file use mimo.Scene(file={scene!r})",)
        raise


def prepare(scene: Union[str, Scene], options: Options) -> Tuple[Scene, Dict[str, Any]]:
    """A scene with its infants, and the remaining options, which are for its worlds."""
    agent, world, parameters = _sorted(options)
    if isinstance(scene, Scene):
        if agent:
            raise TypeError(f"{', '.join(agent)}: a mimo.Scene takes these in its add_agent")
        return _with_parameters(scene.copy(), parameters), world
    made = start_of(scene)
    made.add_agents(**agent)
    return _with_parameters(made, parameters), world


def _sorted(options: Mapping[str, Any]) -> Tuple[Dict[str, Any], Dict[str, Any], Mapping[str, float]]:
    refuse_unknown(options, Options)
    if isinstance(options.get("task"), type):
        raise TypeError(f"task is the class {options['task'].__name__}, expected a name")
    if isinstance(options.get("task"), Task):
        raise TypeError("task is a mimo.Task, expected a name; make, make_vec and ParallelEnv take a mimo.Task")
    agent = {key: value for key, value in options.items() if key in enums(AgentOptions)}
    world = {key: value for key, value in options.items() if key in enums(WorldOptions)}
    return agent, world, options.get("parameters", {})


def _with_parameters(scene: Scene, parameters: Mapping[str, float]) -> Scene:
    for name, value in parameters.items():
        scene.parameters[name] = value
    return scene
