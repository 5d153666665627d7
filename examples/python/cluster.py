"""PPO of RLlib on one machine or on a cluster, by the same command. Needs the extra [ray] and PyTorch.

    python cluster.py --steps 200000                       # on this machine, or on the cluster that it belongs to
    python cluster.py --address HOST:6379 --steps 200000   # on another one
    python cluster.py --local-nodes 2 --steps 4000         # on two nodes that only pretend to be machines

Tune runs all seeds, keeps checkpoints in OUT, and starts a seed again from its last one where its machine is lost.
Started again with the same OUT, the program goes on where it was. With several machines OUT lies where all can write.
"""

import argparse
import contextlib
import os
import sys
from pathlib import Path

os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # else a runner's small products take all cores

import ray
from ray import tune
from ray.rllib.algorithms.ppo import PPO, PPOConfig

import mimo.ray

STEPS = "num_env_steps_sampled_lifetime"
STORE = 100 * 2**20  # bytes of shared memory that a local node may take


def configured(options):
    """Where the worlds are, and what PPO does; networks and rates are RLlib's own."""
    config = PPOConfig().training(train_batch_size=options.rollout, minibatch_size=min(128, options.rollout))
    config.resources(placement_strategy="SPREAD")  # over machines
    return mimo.ray.configure(
        config,
        options.task,
        num_envs=options.worlds,
        runners=options.runners,
        actors=options.actors,
        seed=tune.grid_search(list(range(options.seeds))),
        max_steps=options.max_steps,
    )


def tuner(options, config, callbacks):
    """A new one, or that of which OUT tells."""
    folder = options.out.resolve() / "cluster"
    if tune.Tuner.can_restore(str(folder)):
        print(f"{folder}: goes on", flush=True)
        return tune.Tuner.restore(
            str(folder), PPO, resume_unfinished=True, resume_errored=True, param_space=config.to_dict()
        )
    run = tune.RunConfig(
        name=folder.name,
        storage_path=str(folder.parent),
        stop={STEPS: options.steps},
        checkpoint_config=tune.CheckpointConfig(checkpoint_frequency=5, checkpoint_at_end=True, num_to_keep=2),
        failure_config=tune.FailureConfig(max_failures=3),
        callbacks=callbacks,
        verbose=0,
    )
    # What actors take is not in what a trial asks for.
    once = max(1, int(ray.cluster_resources().get("CPU", 1)) // (1 + options.runners + options.actors))
    how = tune.TuneConfig(max_concurrent_trials=once)
    return tune.Tuner(PPO, param_space=config.to_dict(), run_config=run, tune_config=how)


class Told(tune.Callback):
    """A line for each rollout; and the loss of a local node, where one was asked for."""

    def __init__(self, lose_at=None, lose=None):
        self.lose_at, self.lose = lose_at, lose

    def on_trial_result(self, iteration, trials, trial, result, **more):
        steps = int(result[STEPS])
        earned = result["env_runners"].get("episode_return_mean", float("nan"))
        print(f"seed {result['config']['seed']}, step {steps}: return {earned:.4g}", flush=True)
        if self.lose and steps >= self.lose_at:
            self.lose, lose = None, self.lose
            print("a node is lost", flush=True)
            lose()

    def __getstate__(self):  # kept with the experiment, where there is no node to lose
        return {"lose_at": None, "lose": None}


@contextlib.contextmanager
def cluster(options):
    """Connects; gives a function that loses one of the local nodes, if there are any."""
    if not options.local_nodes:
        mimo.ray.connect(options.address, logging_level="ERROR")
        yield None
        return
    from ray.cluster_utils import Cluster

    node = {"num_cpus": 1 + options.runners + options.actors, "object_store_memory": STORE}  # one can do it all
    local = Cluster(initialize_head=True, head_node_args=node)
    try:
        others = [local.add_node(**node) for _ in range(options.local_nodes - 1)]
        mimo.ray.connect(local.address, logging_level="ERROR")
        yield (lambda: local.remove_node(others[-1], allow_graceful=False)) if others else None
    finally:
        ray.shutdown()
        local.shutdown()


def parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--task", default="reach")
    parser.add_argument("--steps", type=int, default=200_000, help="of all worlds of a seed together")
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--worlds", type=int, default=16, help="of a seed")
    parser.add_argument(
        "--runners", type=int, default=None, help="processes with worlds and policy: 2 without --actors"
    )
    parser.add_argument("--actors", type=int, default=0, help="processes with worlds; results do not depend on them")
    parser.add_argument("--rollout", type=int, default=2048, help="steps between updates")
    parser.add_argument("--max-steps", type=int, default=0, help="of an episode; 0: the task's own")
    parser.add_argument("--address", help="of a cluster: HOST:PORT; without it that of this machine, or a new one")
    parser.add_argument("--local-nodes", type=int, default=0, help="makes a cluster of so many nodes on this machine")
    parser.add_argument("--lose-node-at", type=int, default=None, help="with --local-nodes: kills one at this step")
    parser.add_argument("--out", type=Path, default=Path("runs"))
    options = parser.parse_args()
    if options.lose_node_at is not None and options.local_nodes < 2:
        parser.error("--lose-node-at needs --local-nodes 2 or more: one stays")
    if options.runners is None:
        options.runners = 0 if options.actors else 2
    return options


def main():
    options = parse()
    try:
        config = configured(options)  # refuses here what it would refuse on other machines
        with cluster(options) as lose:
            results = tuner(options, config, [Told(options.lose_node_at, lose)]).fit()
    except (ValueError, TypeError, ConnectionError) as error:
        sys.exit(f"cluster.py: {error}")
    for result in sorted(results, key=lambda one: one.config["seed"]):
        told = result.metrics
        earned, seconds = told["env_runners"].get("episode_return_mean", float("nan")), told["time_total_s"]
        steps = int(told[STEPS])
        print(f"seed {told['config']['seed']}: {steps} steps, return {earned:.4g}, {steps / seconds:.0f} steps/s")
    if results.errors:
        sys.exit(f"cluster.py: {len(results.errors)} seeds failed, the first with: {results.errors[0]}")


if __name__ == "__main__":
    main()
