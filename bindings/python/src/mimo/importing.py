"""What is done with a module of another package as soon as the program has imported it."""

from __future__ import annotations

import importlib.util
import sys
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec
from typing import Any, Callable, Optional

Action = Callable[[], None]


def when_imported(name: str, action: Action) -> None:
    """Calls the action now if the program has imported the module, otherwise when it does.

    What waits for the same module with the same action already is not made twice.
    """
    if name in sys.modules:
        action()
    elif not any(isinstance(one, _Waiting) and (one.name, one.action) == (name, action) for one in sys.meta_path):
        sys.meta_path.insert(0, _Waiting(name, action))


def wait_no_longer(name: str, action: Action) -> None:
    """Undoes when_imported where the module was not imported yet."""
    for finder in list(sys.meta_path):
        if isinstance(finder, _Waiting) and (finder.name, finder.action) == (name, action):
            sys.meta_path.remove(finder)


class _Waiting(MetaPathFinder):
    """Finds one module as Python does, and acts after its import; then it is gone."""

    def __init__(self, name: str, action: Action) -> None:
        self.name, self.action = name, action

    def find_spec(self, fullname: str, path: Any = None, target: Any = None) -> Optional[ModuleSpec]:
        if fullname != self.name:
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(fullname)
        loader: Any = None if spec is None else spec.loader
        if loader is None:
            return spec
        execute = loader.exec_module

        def execute_and_act(module: Any) -> None:
            execute(module)
            self.action()

        loader.exec_module = execute_and_act
        return spec
