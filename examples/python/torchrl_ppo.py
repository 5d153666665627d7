"""PPO of TorchRL, on worlds in one process. Needs the packages torchrl and torch.

TorchRL takes environments of many worlds that begin anew when it says so: autoreset_mode="Disabled".

    python torchrl_ppo.py [--task reach] [--worlds N] [--rollout N] [--updates N]
"""

import argparse

import torch
from tensordict.nn import AddStateIndependentNormalScale, TensorDictModule, TensorDictSequential
from torch import nn
from torchrl.collectors import Collector
from torchrl.envs import GymWrapper, TransformedEnv
from torchrl.envs.transforms import ObservationNorm, RewardSum
from torchrl.modules import ProbabilisticActor, TanhNormal, ValueOperator
from torchrl.objectives import ClipPPOLoss
from torchrl.objectives.value import GAE

import mimo

EPOCHS, BATCHES, RATE = 10, 8, 3e-4


def make(task, worlds):
    envs = mimo.make_vec(task, num_envs=worlds, flatten=True, normalize_actions=True, autoreset_mode="Disabled")
    scaled = ObservationNorm(in_keys=["observation"], standard_normal=True)
    envs = TransformedEnv(GymWrapper(envs), scaled)
    scaled.init_stats(num_iter=200, reduce_dim=(0, 1), cat_dim=1)  # of random actions
    scaled.scale.clamp_(min=1e-2)  # what did not move then
    return envs.append_transform(RewardSum())


def layers(seen, out):
    return nn.Sequential(nn.Linear(seen, 64), nn.Tanh(), nn.Linear(64, 64), nn.Tanh(), nn.Linear(64, out))


def actor_and_critic(envs):
    seen, done = envs.observation_spec["observation"].shape[-1], envs.action_spec.shape[-1]
    mean = TensorDictModule(layers(seen, done), in_keys=["observation"], out_keys=["loc"])
    spread = TensorDictModule(
        AddStateIndependentNormalScale(done, scale_lb=0.1), in_keys=["loc"], out_keys=["loc", "scale"]
    )
    actor = ProbabilisticActor(
        TensorDictSequential(mean, spread),
        in_keys=["loc", "scale"],
        distribution_class=TanhNormal,
        return_log_prob=True,
        spec=envs.action_spec_unbatched,
    )
    return actor, ValueOperator(layers(seen, 1), in_keys=["observation"])


def improve(loss, optimizer, rows):
    for _ in range(EPOCHS):
        for part in torch.randperm(len(rows)).chunk(BATCHES):
            parts = loss(rows[part])
            optimizer.zero_grad()
            sum(parts[name] for name in ("loss_objective", "loss_critic", "loss_entropy")).backward()
            nn.utils.clip_grad_norm_(loss.parameters(), 0.5)
            optimizer.step()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--task", default="reach")
    parser.add_argument("--worlds", type=int, default=16)
    parser.add_argument("--rollout", type=int, default=128, help="steps of each world before an update")
    parser.add_argument("--updates", type=int, default=50)
    arguments = parser.parse_args()
    torch.manual_seed(0)
    envs = make(arguments.task, arguments.worlds)
    envs.set_seed(0)
    actor, critic = actor_and_critic(envs)
    loss = ClipPPOLoss(actor, critic, entropy_coeff=0.0, normalize_advantage=True)
    gain = GAE(gamma=0.99, lmbda=0.95, value_network=critic)
    optimizer = torch.optim.Adam(loss.parameters(), lr=RATE)
    batch = arguments.worlds * arguments.rollout
    collector = Collector(envs, actor, frames_per_batch=batch, total_frames=batch * arguments.updates)
    for update, kept in enumerate(collector):
        with torch.no_grad():
            gain(kept)
        improve(loss, optimizer, kept.reshape(-1))
        print(f"update {update + 1}: mean reward {kept['next', 'reward'].mean():.4f}")
    collector.shutdown()


if __name__ == "__main__":
    main()
