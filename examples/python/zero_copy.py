"""Observations of many worlds as tensors, without a copy: by DLPack, to PyTorch where it is installed, else to NumPy.

An observation is good until the second step after it, for its memory is the library's: what is kept longer is cloned.

    python zero_copy.py [--worlds N]
"""

import argparse

import numpy as np

import mimo

try:
    import torch

    from_dlpack, address = torch.from_dlpack, torch.Tensor.data_ptr
except ImportError:
    from_dlpack, address = np.from_dlpack, lambda array: array.ctypes.data


def tensors(observation):
    return {name: from_dlpack(array) for name, array in observation.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--worlds", type=int, default=4)
    arguments = parser.parse_args()
    envs = mimo.make_vec("selfbody", num_envs=arguments.worlds)
    envs.reset(seed=0)
    for _ in range(3):
        observation = envs.step(envs.action_space.sample())[0]
        seen = tensors(observation)
        for name, tensor in seen.items():
            assert address(tensor) == observation[name].ctypes.data  # the same memory
    for name, tensor in seen.items():
        print(f"{name:28} {tuple(tensor.shape)!s:15} {tensor.dtype}, {type(tensor).__module__.split('.')[0]}")
    envs.close()


if __name__ == "__main__":
    main()
