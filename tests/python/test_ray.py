"""Ray, on clusters of local nodes of which one is killed: worlds in actors, RLlib, Tune. `./dev test --ray` runs it."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

ray = pytest.importorskip("ray", reason="Ray (extra [ray]) is not installed")
rllib = pytest.importorskip("ray.rllib.algorithms.ppo", reason="RLlib (extra [ray]) or PyTorch is not installed")
import test_tasks  # noqa: E402
from ray import cloudpickle  # noqa: E402
from ray.cluster_utils import Cluster  # noqa: E402
from ray.rllib.env.env_context import EnvContext  # noqa: E402

import mimo  # noqa: E402
import mimo.ray.actors  # noqa: E402

for own in (test_tasks, sys.modules[__name__]):
    cloudpickle.register_pickle_by_value(own)  # actors cannot import what lies with the tests

NODE = {"num_cpus": 2, "object_store_memory": 80 * 2**20}


@pytest.fixture(scope="module")
def cluster():
    whole = Cluster(initialize_head=True, head_node_args=NODE)
    mimo.ray.connect(whole.address, logging_level="ERROR")
    yield whole
    ray.shutdown()
    whole.shutdown()


@pytest.fixture
def other(cluster):
    """A node that may be killed."""
    node = cluster.add_node(**NODE)
    cluster.wait_for_nodes()
    yield node
    if node in cluster.worker_nodes:
        cluster.remove_node(node, allow_graceful=False)


def assert_same(one, two):
    if isinstance(one, dict):
        assert one.keys() == two.keys()
        for name in one:
            assert_same(one[name], two[name])
    elif isinstance(one, (list, tuple)) or (isinstance(one, np.ndarray) and one.dtype.hasobject):
        assert len(one) == len(two)
        for a, b in zip(one, two):
            assert_same(a, b)
    else:
        np.testing.assert_array_equal(one, two)


def places(envs):
    """Node and process of each actor."""
    return ray.get([part._actor.__ray_call__.remote(own_place) for part in envs._parts])


def own_place(_):
    return ray.get_runtime_context().get_node_id(), os.getpid()


def kill(cluster, node, actors):
    """Kills a node; the processes on it end by themselves, soon after."""
    cluster.remove_node(node, allow_graceful=False)
    deadline = time.monotonic() + 60
    while any(Path(f"/proc/{process}").exists() for lost, process in actors if lost == node.node_id):
        assert time.monotonic() < deadline
        time.sleep(0.1)


@pytest.mark.parametrize("options", [{"flatten": True, "kept_every": 7}, {"autoreset_mode": "SameStep"}])
def test_worlds_continue_when_a_node_is_lost(options, cluster, other):
    plain = {name: value for name, value in options.items() if name != "kept_every"}
    here = mimo.make_vec("reach", 5, max_steps=20, **plain)
    there = mimo.ray.make_vec("reach", 5, actors=3, max_steps=20, **options)
    actors = places(there)
    assert other.node_id in {node for node, _ in actors}
    assert_same(there.reset(seed=3), here.reset(seed=3))
    actions = np.random.default_rng(0).uniform(-1, 1, (50, *here.action_space.shape))
    for step, action in enumerate(actions):
        if step == 33:
            kill(cluster, other, actors)
        assert_same(there.step(action), here.step(action))
    assert other.node_id not in {node for node, _ in places(there)}
    mask = np.array([True, False, True, False, True])
    assert_same(there.reset(seed=9, options={"reset_mask": mask}), here.reset(seed=9, options={"reset_mask": mask}))
    there.close()


def test_goals_and_ages(cluster, other):
    envs = mimo.ray.make_vec("reach", 3, actors=2, task=test_tasks.ReachUp(), flatten=True, ages=[3, 12])
    plain = mimo.make_vec("reach", 3, task=test_tasks.ReachUp(), flatten=True, ages=[3, 12])
    assert_same(envs.reset(seed=1), plain.reset(seed=1))  # also where world 2 begins the ages anew
    observation, reward, *_ = envs.step(np.zeros((3, 8)))
    rows = envs.compute_reward(observation["achieved_goal"], observation["desired_goal"], {})
    np.testing.assert_array_equal(rows, reward)
    envs.close()


def test_errors_are_one_line(cluster, other, monkeypatch):
    for options, message in (
        ({"scene": "reech"}, "scene is 'reech', expected one of .*; did you mean 'reach'"),
        ({"scene": "CartPole-v1"}, "scene is 'CartPole-v1', expected one of"),
        ({"touc": True}, "unexpected keyword argument 'touc'; did you mean 'touch'"),
        ({"threads": 2}, "unexpected keyword argument 'threads': an actor has as many as `cpus`"),
        ({"actors": 5}, "actors is 5, expected 1 to 4"),
        ({"age": -3}, "age"),  # found out by the actors
    ):
        with pytest.raises((ValueError, TypeError), match=message) as said:
            mimo.ray.make_vec(**{"scene": "reach", "num_envs": 4, **options})
        assert "\n" not in str(said.value)
        if "actors" not in options:
            with pytest.raises((ValueError, TypeError), match=message.split(":")[0]):
                mimo.ray.configure(rllib.PPOConfig(), **{"scene": "reach", "num_envs": 4, **options}).build_algo()
    envs = mimo.ray.make_vec("reach", 2, actors=2)
    envs.reset(seed=0)
    for actions, message in (
        (np.zeros((3, 8)), "have the shape"),
        (np.full((2, 8), np.nan), "world 0 is not a number"),
    ):
        with pytest.raises(ValueError, match=message):
            envs.step(actions)
    with pytest.raises(RuntimeError, match="no step was sent"):
        envs.receive()
    monkeypatch.setattr(mimo.ray.actors, "PATIENCE", 2.0)
    with pytest.raises(RuntimeError, match=r"no room in the cluster for worlds 0 to 1 .* asks for 64 CPUs"):
        mimo.ray.make_vec("reach", 2, cpus=64)
    envs.close()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"runners": 2, "actors": 2}, "runners is 2 and actors is 2"),
        ({"runners": 3}, "num_envs is 8, expected a multiple of runners, 3"),
        ({"actors": 9}, "actors is 9, expected 0 to 8"),
        ({"flatten": False}, "flatten is False"),
    ],
)
def test_impossible_configurations_are_refused(options, message):
    with pytest.raises(ValueError, match=message):
        mimo.ray.configure(rllib.PPOConfig(), "reach", num_envs=8, **options)


def test_a_missing_cluster_is_refused(monkeypatch):
    monkeypatch.setattr(ray, "is_initialized", lambda: False)
    with pytest.raises(ConnectionError, match=r"address is '127.0.0.1:1': no Ray cluster is there"):
        mimo.ray.connect("127.0.0.1:1")
    with pytest.raises(ValueError, match="address is 'somewhere', expected HOST:PORT"):
        mimo.ray.connect("somewhere")


def test_a_python_on_a_path_with_a_space_is_warned_of(monkeypatch):
    """Ray 2 runs `bash -c "exec PYTHON ..."` without quotes for actors that have a runtime environment."""
    monkeypatch.setattr(ray, "is_initialized", lambda: False)
    monkeypatch.setattr(sys, "executable", "/a space/python")
    with pytest.warns(UserWarning, match="'/a space/python', at the space"), pytest.raises(ConnectionError):
        mimo.ray.connect("127.0.0.1:1")


def test_worlds_of_a_seed_are_the_same_with_any_number_of_runners():
    given = {"scene": "reach", "actors": 0, "cpus": 1, "options": {"flatten": True}}

    def first(runner, runners):
        context = EnvContext({**given, "num_envs": 4 // max(runners, 1)}, worker_index=runner, num_workers=runners)
        return mimo.ray.rllib.rllib_env(context).reset(seed=5 + runner)[0]  # what RLlib gives for the seed 5

    whole = first(0, 0)
    np.testing.assert_array_equal(np.concatenate([first(1, 2), first(2, 2)]), whole)
    assert len(np.unique(whole, axis=0)) == 4


def built(**options):
    config = rllib.PPOConfig().training(train_batch_size=128, minibatch_size=64, num_epochs=2)
    config.resources(placement_strategy="SPREAD")
    given = {"num_envs": 6, "seed": 5, "max_steps": 25, **options}
    return mimo.ray.configure(config, "reach", **given).build_algo()


def worlds_of(algorithm):
    envs = algorithm.env_runner.env
    while not isinstance(envs, mimo.ray.VectorEnv):
        envs = envs.env
    return envs


def weights(algorithm):
    return np.concatenate([np.ravel(value) for value in algorithm.get_module().get_state().values()])


def test_learning_does_not_depend_on_actors_or_their_loss(cluster, other):
    learned = []
    for actors in (0, 3):
        algorithm = built(actors=actors)
        for iteration in range(3):
            if actors and iteration == 1:
                kill(cluster, other, places(worlds_of(algorithm)))
            algorithm.train()
        learned.append(weights(algorithm))
        algorithm.stop()
    np.testing.assert_array_equal(*learned)
    algorithm = built(seed=6)
    for _ in range(3):
        algorithm.train()
    assert not np.array_equal(weights(algorithm), learned[0])
    algorithm.stop()


def test_runners_learn_on_when_one_is_lost_and_from_checkpoints(cluster, other, tmp_path):
    algorithm = built(runners=3)
    algorithm.train()
    runners = algorithm.env_runner_group.foreach_env_runner(own_place, local_env_runner=False)
    assert other.node_id in {node for node, _ in runners}
    kill(cluster, other, runners)
    results = [algorithm.train() for _ in range(3)]
    assert results[-1]["num_env_steps_sampled_lifetime"] > results[0]["num_env_steps_sampled_lifetime"] >= 128
    path = algorithm.save_to_path(str(tmp_path / "kept"))
    kept, steps = weights(algorithm), results[-1]["num_env_steps_sampled_lifetime"]
    algorithm.stop()
    again = built(runners=1)  # on what is left
    again.restore_from_path(path)
    np.testing.assert_array_equal(weights(again), kept)
    assert again.train()["num_env_steps_sampled_lifetime"] >= steps + 128
    assert not np.array_equal(weights(again), kept)
    again.stop()


def cluster_py(root, folder, *arguments):
    small = ["--worlds", "4", "--rollout", "128", "--max-steps", "25", "--out", folder]
    command = [sys.executable, root / "examples/python/cluster.py", *small, *arguments]
    clean = {name: value for name, value in os.environ.items() if not name.startswith("RAY_ADDRESS")}
    return subprocess.Popen(
        [str(part) for part in command], env=clean, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )


def ended(process):
    """Returns what a process printed until it ended; one that does not end is killed, with what it printed told."""
    try:
        return process.communicate(timeout=240)[0]
    except subprocess.TimeoutExpired:
        process.kill()
        pytest.fail(f"it did not end within 240 s: {process.communicate()[0]}")


def test_the_example_on_two_nodes_of_which_one_is_lost(root, tmp_path):
    arguments = ["--local-nodes", "2", "--steps", "640", "--lose-node-at", "256"]
    process = cluster_py(root, tmp_path, *arguments)
    told = ended(process)
    assert process.returncode == 0, told
    lines = told.splitlines()
    assert "a node is lost" in lines
    assert lines[-1].startswith("seed 0: ")
    assert int(lines[-1].split()[2]) >= 640


def test_the_example_resumes(root, tmp_path):
    arguments = ["--local-nodes", "1", "--steps", "2560"]
    process = cluster_py(root, tmp_path, *arguments)
    watch = threading.Timer(240, process.kill)  # its lines end then
    watch.start()
    assert any("step 1280:" in line for line in process.stdout)
    watch.cancel()
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=120)
    process = cluster_py(root, tmp_path, *arguments)
    told = ended(process)
    assert process.returncode == 0, told
    assert f"{tmp_path / 'cluster'}: goes on" in told
    steps = [int(line.split(":")[0].split()[-1]) for line in told.splitlines() if ", step " in line]
    assert steps[0] > 128, told  # not from the beginning
    assert steps[-1] >= 2560


def test_the_example_reports_errors_in_one_line(root, tmp_path):
    for arguments, message in (
        (["--task", "reech"], "scene is 'reech', expected one of"),
        (["--address", "127.0.0.1:1"], "address is '127.0.0.1:1': no Ray cluster is there"),
        (["--worlds", "3"], "num_envs is 3, expected a multiple of runners, 2"),
    ):
        process = cluster_py(root, tmp_path, *arguments)
        told = process.communicate(timeout=60)[0]
        assert process.returncode == 1
        assert [line for line in told.splitlines() if line.startswith("cluster.py: " + message)] == told.splitlines()[
            -1:
        ]
