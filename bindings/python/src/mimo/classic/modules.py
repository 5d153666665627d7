"""Lets `import mimoEnv` and its relatives find this package, and files of a script's checkout beside them."""

from __future__ import annotations

import importlib
import importlib.util
import sys
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any, Dict, List, Optional

from .live import PAGE
from .names import ENGINE, KIT_ENVIRONMENTS, MODULES, OLD_GYM, VERSIONS, VIEWER, file_of, folders, is_ours, ours, public
from .scenes import scene_directory, sitting_position


class Alias(ModuleType):
    """A module of the original: our names; those that it lacks come from a file of that name, if one exists."""

    def __getattr__(self, name: str) -> Any:
        if name == "__version__" and self.__name__ in VERSIONS:
            return VERSIONS[self.__name__]
        if name == "__all__":
            return self._public()
        if name.startswith("__"):
            raise AttributeError(name)
        if name == "SCENE_DIRECTORY":
            return scene_directory(self.__name__)
        if name == "SITTING_POSITION":
            return sitting_position(self.__name__.rpartition(".")[2])
        try:
            found = ours(self.__name__, name)
        except AttributeError:
            found = self._from_file(name)
        self.__dict__[name] = found
        return found

    def _public(self) -> List[str]:
        """The names that `import *` takes: ours, and those of a file of this name."""
        file = self.__dict__.get("_own_names") or (self.read_file() if self.__dict__.get("_own_file") else {})
        own = [name for name in file if not name.startswith("_")]
        return list(dict.fromkeys([*public(self.__name__), *own]))

    def _from_file(self, name: str) -> Any:
        own: Optional[Dict[str, Any]] = self.__dict__.get("_own_names")
        if own is None and self.__dict__.get("_own_file"):
            own = self.read_file()
        if own is not None and name in own:
            return own[name]
        raise AttributeError(f"{self.__name__} has no {name!r} here; {PAGE}")

    def read_file(self) -> Dict[str, Any]:
        """The names that the file of a checkout defines. Its classes belong to this module."""
        name, file = self.__name__, self.__dict__["_own_file"]
        package = name if file.endswith("__init__.py") else name.rpartition(".")[0]
        values: Dict[str, Any] = {"__name__": name, "__file__": file, "__package__": package}
        self.__dict__["_own_names"] = values  # while it is read, too
        with open(file, encoding="utf-8") as source:
            exec(compile(source.read(), file, "exec"), values)
        return values


class Finder(MetaPathFinder, Loader):
    """Finds the original's modules, the stand-in for `mujoco`, and the old `gym`."""

    def find_spec(self, fullname: str, path: Any = None, target: Any = None) -> Optional[ModuleSpec]:
        """Modules that are ours; other files in a checkout's packages are found as usual."""
        root = fullname.partition(".")[0]
        if f"{fullname}.".startswith(f"{KIT_ENVIRONMENTS}.") and file_of(fullname, path or ()):
            return None
        if fullname in MODULES or fullname in (ENGINE, VIEWER) or root == OLD_GYM:
            return importlib.util.spec_from_loader(fullname, self, is_package=True)
        return None

    def create_module(self, spec: ModuleSpec) -> Optional[ModuleType]:
        """The module."""
        if spec.name == ENGINE:
            from .engine import stand_in

            return stand_in(_without_finder(ENGINE))
        if spec.name == VIEWER:
            from .windows import viewer_module

            return viewer_module(_without_finder(VIEWER))
        if spec.name.partition(".")[0] == OLD_GYM:
            from .old_gym import module_of

            return module_of(spec.name)
        return Alias(spec.name, f"Of {', '.join(MODULES[spec.name]) or 'this package'}, for scripts for the original.")

    def exec_module(self, module: ModuleType) -> None:
        """Adds what a checkout has beside it."""
        if not isinstance(module, Alias):
            return
        name = module.__name__
        parent = sys.modules.get(name.rpartition(".")[0])
        path: List[str] = list(getattr(parent, "__path__", [])) if parent is not None else sys.path
        module.__path__ = folders(name, path)
        module.__dict__["_own_file"] = file = file_of(name, path)
        register()
        if file and "." not in name and name != "babybench":
            _with_own_names(module)


def _with_own_names(module: Alias) -> None:
    """Reads a checkout's package file, which registers environments of its own; the original's names stay ours."""
    from .registry import forget, register_again

    forget()
    try:
        module.read_file()
    finally:
        register_again()


def _without_finder(name: str) -> Optional[ModuleType]:
    """The real module, None if it is not installed."""
    finders = [finder for finder in sys.meta_path if isinstance(finder, Finder)]
    for finder in finders:
        sys.meta_path.remove(finder)
    root = name.partition(".")[0]
    stored = {key: sys.modules.pop(key) for key in list(sys.modules) if key in (root, name)}
    try:
        return importlib.import_module(name)
    except ImportError:
        return None
    finally:
        sys.modules.update(stored)
        for finder in reversed(finders):
            sys.meta_path.insert(0, finder)


def register() -> None:
    """Registers the environments of the original and of the competition."""
    importlib.import_module("mimo.classic")
    importlib.import_module("mimo.babybench")


def install() -> None:
    """From now on scripts for the original run: their imports find this package."""
    if any(isinstance(finder, Finder) for finder in sys.meta_path):
        return
    register()
    for name in list(sys.modules):
        if is_ours(name) or name.partition(".")[0] == OLD_GYM:
            del sys.modules[name]
    real = sys.modules.pop(ENGINE, None)
    sys.meta_path.insert(0, Finder())
    if real is not None:
        importlib.import_module(ENGINE)
    from .wrappers import pass_members_on

    pass_members_on()
