"""Ray: worlds in actors on many machines, and RLlib that trains on them. Needs the extra [ray].

    mimo.ray.connect()                                            # to the cluster, or a new one on this machine
    envs = mimo.ray.make_vec("reach", num_envs=64, actors=8)      # as mimo.make_vec, in eight processes
    config = mimo.ray.configure(PPOConfig(), "reach", num_envs=64, runners=8)   # RLlib

Every machine needs this package, of the same version.
"""

from __future__ import annotations

try:
    import ray as _ray  # noqa: F401
except ImportError as error:
    raise ImportError("mimo.ray needs Ray: pip install 'mimo[ray]'") from error

from .cluster import connect
from .rllib import configure, register
from .vector import VectorEnv, make_vec

__all__ = ["VectorEnv", "configure", "connect", "make_vec", "register"]
