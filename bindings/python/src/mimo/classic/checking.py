"""Which members of the original a script uses, and which of them are missing here; without running it."""

from __future__ import annotations

import ast
import importlib
import importlib.util
import inspect
import os
import textwrap
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Dict, List, Mapping, Optional, Set, Tuple

from . import mathematics
from .columns import DATA, MODEL
from .elements import KINDS, OTHERS, SHORT, data_attributes, model_attributes
from .engine import CONSTANTS, FUNCTIONS
from .env import MIMoEnv
from .live import PAGE
from .model import COUNTS, LISTED, DataView, ModelView
from .names import ENGINE, MODULES, OLD_GYM, RENAMED, UTILS_NAME, VIEWER, file_of, folders, is_ours, ours
from .pictures import Renderer
from .sensors import SimpleProprioception, SimpleVestibular, SimpleVision
from .settings import CHOICES, OPTIONS
from .skin import Touch
from .touch import DiscreteTouch, TrimeshTouch

# Members of an environment, and the classes of what they can be.
PARTS: Mapping[str, Tuple[Any, ...]] = {
    "touch": (Touch, TrimeshTouch, DiscreteTouch),
    "vision": (SimpleVision,),
    "vestibular": (SimpleVestibular,),
    "proprioception": (SimpleProprioception,),
    "mujoco_renderer": (Renderer,),
}
ENVIRONMENT = {"env", "environment", "unwrapped", "eval_env", "test_env"}  # usual names of one
_MAKERS = {"make", "make_env"}


@dataclass
class Findings:
    """What a script uses."""

    modules: List[str] = field(default_factory=list)  # of the original
    used: Dict[str, List[int]] = field(default_factory=dict)  # members, with their lines
    missing: List[Tuple[int, str]] = field(default_factory=list)
    five_results: bool = True  # steps are unpacked into five results, as of Gymnasium; or never

    def report(self) -> List[str]:
        """Lines for a reader."""
        lines = [f"modules of the original: {', '.join(self.modules) or 'none'}"]
        lines += [f"uses {name} (line {', '.join(map(str, at))})" for name, at in sorted(self.used.items())]
        lines += [f"missing: line {line}: {name}" for line, name in self.missing]
        return [*lines, f"{len(self.used)} members, {len(self.missing)} missing" + (f"; {PAGE}" * bool(self.missing))]


def examine(source: str, file: str = "<script>") -> Findings:
    """Looks through a script."""
    tree = ast.parse(source, file)
    seen = _Reader(os.path.dirname(os.path.abspath(file)))
    seen.names_of(tree)
    seen.visit(tree)
    found = seen.found
    roots = {name.partition(".")[0] for name in (*seen.modules.values(), *found.used)}
    found.modules = sorted(root for root in roots if is_ours(root) or root in (ENGINE, OLD_GYM))
    found.missing = sorted(set(found.missing))
    counts = {len(it.elts) for it in seen.unpacked}
    found.five_results = 4 not in counts or 5 in counts
    return found


class _Reader(ast.NodeVisitor):
    def __init__(self, folder: str) -> None:
        self.folder, self.found = folder, Findings()
        self.modules: Dict[str, str] = {}  # names in the script that are modules
        self.things: Dict[str, str] = {}  # names in the script that are "model", "data", "env", ...
        self.unpacked: List[Any] = []
        self.derived: Set[str] = set()  # what the script's own environments define
        self.senses: Set[str] = set()  # what its own classes of senses define
        self._inside: List[bool] = []  # whether `self` is an environment

    # ---- Names ----------------------------------------------------------------------------------------------------

    def names_of(self, tree: ast.AST) -> None:
        """Finds modules, and variables that are a model, data, or an environment."""
        for node in ast.walk(tree):
            if isinstance(node, ast.Import):
                for one in node.names:
                    name = one.name if one.asname else one.name.partition(".")[0]
                    self.modules[one.asname or name] = name
                    self._of_module(node.lineno, one.name, "")
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                for one in node.names:
                    whole = f"{node.module}.{one.name}"
                    if whole in MODULES or one.name in RENAMED:
                        self.modules[one.asname or one.name] = whole if whole in MODULES else UTILS_NAME
                    else:
                        self._of_module(node.lineno, node.module, one.name)
            elif isinstance(node, ast.ClassDef) and _is_environment(node):
                self.derived |= _own_names(node)
            elif isinstance(node, ast.ClassDef) and node.bases:
                self.senses |= _own_names(node)
        for _ in range(2):  # a name of a name
            for node in ast.walk(tree):
                if isinstance(node, ast.Assign) and len(node.targets) == 1:
                    self._bind(node.targets[0], node.value)

    def _bind(self, target: ast.expr, value: ast.expr) -> None:
        if isinstance(target, ast.Tuple):
            if isinstance(value, ast.Call) and isinstance(value.func, ast.Attribute) and value.func.attr == "step":
                self.unpacked.append(target)
            if isinstance(value, ast.Tuple) and len(value.elts) == len(target.elts):
                for one, its in zip(target.elts, value.elts):
                    self._bind(one, its)
        elif isinstance(target, ast.Name):
            kind = self._kind(value)
            if kind in ("model", "data", "env", *PARTS):
                self.things[target.id] = kind

    def _kind(self, node: Optional[ast.expr]) -> str:
        """What an expression is: "env", "model", "data", "model.body", ..., or ""."""
        if isinstance(node, ast.Name):
            return self.things.get(node.id) or ("env" if node.id in ENVIRONMENT else "") or self._self(node.id)
        if isinstance(node, ast.Call):
            return self._called(node)
        if isinstance(node, ast.Attribute):
            inner = self._kind(node.value)
            if node.attr in ENVIRONMENT:
                return "env"
            if inner == "env":
                return node.attr if node.attr in ("model", "data", *PARTS) else ""
            if inner == "model" and node.attr == "opt":
                return "opt"
            return f"data.{node.attr}" if inner == "data" and node.attr == "contact" else ""
        return ""

    def _self(self, name: str) -> str:
        return "env" if name == "self" and self._inside and self._inside[-1] else ""

    def _called(self, node: ast.Call) -> str:
        if not isinstance(node.func, ast.Attribute):
            return "env" if isinstance(node.func, ast.Name) and node.func.id in _MAKERS else ""
        if node.func.attr in _MAKERS and not self._kind(node.func.value):
            return "env"
        inner = self._kind(node.func.value)
        kind = SHORT.get(node.func.attr, node.func.attr)
        return f"{inner}.{kind}" if inner in ("model", "data") and (kind in KINDS or kind in OTHERS) else ""

    # ---- Uses -----------------------------------------------------------------------------------------------------

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        """Within an environment of the script's own `self` is one."""
        self._inside.append(_is_environment(node))
        self.generic_visit(node)
        self._inside.pop()

    def visit_Attribute(self, node: ast.Attribute) -> None:
        """Notes a member."""
        self.generic_visit(node)
        if isinstance(node.value, ast.Name) and node.value.id in self.modules:
            module = self.modules[node.value.id]
            if f"{module}.{node.attr}" not in MODULES:
                self._of_module(node.lineno, module, node.attr)
            return
        kind = self._kind(node.value)
        if kind:
            self._of_thing(node.lineno, kind, node.attr)

    def visit_Assign(self, node: ast.Assign) -> None:
        """Notes what is written."""
        for target in node.targets:
            self._written(target)
        self.generic_visit(node)

    def visit_AugAssign(self, node: ast.AugAssign) -> None:
        """Notes what is written."""
        self._written(node.target)
        self.generic_visit(node)

    def _written(self, target: ast.expr) -> None:
        if isinstance(target, ast.Tuple):
            for one in target.elts:
                self._written(one)
        while isinstance(target, ast.Subscript):
            target = target.value
        if not isinstance(target, ast.Attribute):
            return
        kind, name = self._kind(target.value), target.attr
        column = _column(kind, name)
        if column is not None and column.write is None:
            self.found.missing.append((target.lineno, f"{kind}.{name} = ... ({column.instead})"))
        if kind == "opt" and name != "gravity" and name in {*OPTIONS, *CHOICES, "timestep"}:
            self.found.missing.append((target.lineno, f"model.opt.{name} = ... (write it in the scene's document)"))

    def _of_module(self, line: int, module: str, name: str) -> None:
        if (not is_ours(module) and module != ENGINE) or module == VIEWER:
            return
        whole = f"{module}.{name}" if name else module
        if name == "*" or name.startswith("__"):
            return
        self._uses(whole, line)
        if not (_engine_has(name) if module == ENGINE else self._module_has(module, name)):
            self.found.missing.append((line, whole))

    def _module_has(self, module: str, name: str) -> bool:
        parts = module.split(".")
        path = [self.folder, ".", *folders(parts[0])] if len(parts) == 1 else [os.path.join(self.folder, *parts[:-1])]
        beside = file_of(module, [*path, *[os.path.join(place, *parts[1:-1]) for place in folders(parts[0])]])
        if module not in MODULES:
            return bool(beside)
        if not name or name in ("SCENE_DIRECTORY", "SITTING_POSITION"):
            return True
        try:
            ours(module, name)
        except AttributeError:
            return bool(beside) or f"{module}.{name}" in MODULES
        return True

    def _uses(self, member: str, line: int) -> None:
        lines = self.found.used.setdefault(member, [])
        if line not in lines:
            lines.append(line)

    def _of_thing(self, line: int, kind: str, name: str) -> None:
        if name.startswith("__"):
            return
        if kind == "env" and (name in self.derived or name not in {*_members(), *PARTS} or name in ENVIRONMENT):
            return  # of the script's own, or of a wrapper
        if kind in PARTS and name in self.senses:
            return
        self._uses(f"{kind}.{name}", line)
        if not _has(kind, name):
            self.found.missing.append((line, f"{kind}.{name}"))


def _is_environment(node: ast.ClassDef) -> bool:
    bases = [base.id if isinstance(base, ast.Name) else getattr(base, "attr", "") for base in node.bases]
    return any(name.startswith(("MIMo", "BabyBench")) and name.endswith("Env") for name in bases)


def _own_names(node: ast.ClassDef) -> Set[str]:
    names = {it.name for it in node.body if isinstance(it, ast.FunctionDef)}
    for one in ast.walk(node):
        if isinstance(one, ast.Attribute) and isinstance(one.ctx, ast.Store) and isinstance(one.value, ast.Name):
            names.add(one.attr)
    return names


@lru_cache(maxsize=None)
def _members() -> Set[str]:
    """The members of an environment, also those that its constructor makes."""
    made = ast.parse(textwrap.dedent(inspect.getsource(MIMoEnv)))
    return {*dir(MIMoEnv), *_own_names(made.body[0])}  # type: ignore[arg-type]


def _engine_has(name: str) -> bool:
    if (
        not name
        or name == "viewer"
        or name in FUNCTIONS
        or name in CONSTANTS
        or name in mathematics.FUNCTIONS
        or name in ("Renderer", "MjModel", "MjData")
    ):
        return True
    if name in mathematics.CLASSES or importlib.util.find_spec(ENGINE) is None:
        return name in mathematics.CLASSES
    return not name.startswith("mj_") and hasattr(importlib.import_module(ENGINE), name)


def _column(kind: str, name: str) -> Any:
    owner, _, element = kind.partition(".")
    table = {"model": MODEL, "data": DATA}.get(owner)
    if table is None:
        return None
    if not element:
        return table.get(name)
    attributes = model_attributes(element) if owner == "model" else data_attributes(element)
    return table.get(attributes.get(name, ""))


def _has(kind: str, name: str) -> bool:
    if kind in PARTS:
        return any(hasattr(it, name) or name in _constructed(it) for it in PARTS[kind])
    if kind == "model":
        return name in {*MODEL, *KINDS, *OTHERS, *SHORT, *COUNTS, *LISTED, "opt", "stat", "vis"} or hasattr(
            ModelView, name
        )
    if kind == "data":
        return name in {*DATA, *KINDS, *OTHERS, *SHORT} or hasattr(DataView, name)
    if kind == "opt":
        return name in {*OPTIONS, *CHOICES, "gravity", "timestep"}
    if kind == "data.contact":
        return name in ("geom", "geom1", "geom2", "pos", "dist", "frame")
    return kind == "env" or name in ("id", "name") or _column(kind, name) is not None


def _constructed(kind: Any) -> Set[str]:
    """What the constructors of a class and of its bases make."""
    bodies = (ast.parse(textwrap.dedent(inspect.getsource(it))).body[0] for it in kind.__mro__[:-1])
    return {name for body in bodies for name in _own_names(body)}  # type: ignore[arg-type]
