"""Members of a wrapped environment, which Gymnasium's wrappers hide since version 1.0."""

from __future__ import annotations

from typing import Any

import gymnasium
from gymnasium.envs.registration import WrapperSpec


class Members(gymnasium.Wrapper[Any, Any, Any, Any]):
    """The outermost wrapper, which passes on the environment's members."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name == "env":  # missing while a copy is made
            raise AttributeError(name)
        return getattr(self.env.unwrapped, name)


SPEC = WrapperSpec(name="Members", entry_point="mimo.classic.members:Members", kwargs={})
