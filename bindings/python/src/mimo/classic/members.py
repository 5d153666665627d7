"""Gymnasium's wrappers hide the members of what they wrap, since its version 1.0; scripts expect them."""

from __future__ import annotations

from typing import Any

import gymnasium
from gymnasium.envs.registration import WrapperSpec


class Members(gymnasium.Wrapper[Any, Any, Any, Any]):
    """The outermost wrapper: what neither it nor another one has is the environment's own."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name == "env":  # not there yet while a copy is made
            raise AttributeError(name)
        return getattr(self.env.unwrapped, name)


SPEC = WrapperSpec(name="Members", entry_point="mimo.classic.members:Members", kwargs={})
