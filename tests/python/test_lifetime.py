"""Interrupts, threads, the end of Python: nothing is destroyed under a call, no buffer too early."""

import gc
import os
import subprocess
import sys
import textwrap
import threading
import weakref

import numpy as np
import pytest

import mimo
from mimo._library import LIB

SMALL = "vision=False, touch=False"
WORK = ["world.physics_step(20)", "batch.step()", "batch.send(); batch.receive()", "one.reset()"]


def run(program):
    """What a program that needs one or two seconds said; one that crashes or hangs fails the test."""
    code = textwrap.dedent(program).replace("SMALL", SMALL)
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert (told.returncode, told.stderr) == (0, "")
    return told.stdout


def test_python_ends_while_a_task_is_at_work():
    """Nobody receives the step that was sent, and its task takes longer than Python's end."""
    program = """
        import time
        import mimo

        class Slow(mimo.WorldTask):
            def evaluate(self, world, moment):
                time.sleep(0.05)
                return mimo.Judgement(1.0)

        scene = mimo.Scene("free")
        scene.add_agent(SMALL)
        scene.set_task(Slow())
        batch = mimo.Batch(scene, 4, threads=2)
        batch.reset(seeds=[1, 2, 3, 4])
        batch.send()
        print("end")
    """
    assert run(program) == "end\n"


@pytest.fixture
def interrupted_send(monkeypatch):
    """Ctrl-C at the worst moment: the step was sent, and the line after it is not reached."""
    send = LIB.mimo_batch_send

    def interrupted(*arguments):
        assert send(*arguments) == 0
        monkeypatch.setattr(LIB, "mimo_batch_send", send)
        raise KeyboardInterrupt

    monkeypatch.setattr(LIB, "mimo_batch_send", interrupted)


@pytest.mark.usefixtures("interrupted_send")
def test_memory_of_an_interrupted_send_is_kept():
    batch, twin = mimo.Batch("reach", 4), mimo.Batch("reach", 4)
    actions = np.linspace(-1, 1, 32, dtype=np.float32).reshape(4, 8)
    for each in (batch, twin):
        each.reset(seeds=1)
    blocks = batch.layout.new_block(4)
    memory = weakref.ref(blocks.base)
    try:  # not pytest.raises: it would keep the frames, and they the arrays
        batch.send(actions, blocks)
    except KeyboardInterrupt:
        interrupted = True
    del blocks
    gc.collect()
    assert interrupted
    assert memory() is not None
    junk = [np.full((4, 8), 9, np.float32) for _ in range(1000)]  # where the actions were, had they been freed
    assert batch.receive().reward.tolist() == twin.step(actions).reward.tolist()
    assert np.shares_memory(batch.observation["proprioception/position"], memory())  # it was sensed last
    batch.step(actions)
    assert memory() is None
    assert len(junk) == 1000


@pytest.mark.usefixtures("interrupted_send")
def test_after_an_interrupted_send_a_reset_goes_on():
    envs, twin = mimo.make_vec("reach", num_envs=2), mimo.make_vec("reach", num_envs=2)
    envs.reset(seed=1)
    with pytest.raises(KeyboardInterrupt):
        envs.send(np.ones((2, 8)))
    first, second = envs.reset(seed=2)[0], twin.reset(seed=2)[0]
    np.testing.assert_array_equal(first["proprioception/position"], second["proprioception/position"])
    assert envs.step(np.zeros((2, 8)))[1].tolist() == twin.step(np.zeros((2, 8)))[1].tolist()


def test_interrupts_at_any_moment():
    told = run(
        """
        import gc, signal
        import numpy as np, mimo

        envs = mimo.make_vec("reach", num_envs=4)
        envs.reset(seed=1)
        interrupts = 0
        for attempt in range(60):
            signal.signal(signal.SIGALRM, signal.default_int_handler)
            try:
                signal.setitimer(signal.ITIMER_REAL, 0.0005 + 0.0003 * (attempt % 17))
                while True:
                    if attempt % 2:
                        envs.step(np.ones((4, 8)))
                    else:
                        envs.send(np.ones((4, 8), np.float32))
                        envs.receive()
            except KeyboardInterrupt:
                interrupts += 1
            junk = [np.ones((4, 8), np.float32) for _ in range(100)]
            gc.collect()
            envs.reset(seed=attempt)
        print(interrupts, np.isfinite(envs.step(np.ones((4, 8)))[1]).all())
        """
    )
    assert told == "60 True\n"


@pytest.mark.parametrize("what", WORK)
def test_python_ends_while_daemon_threads_work(what):
    told = run(
        f"""
        import threading, time
        import mimo

        world, batch = mimo.World("benchmark", SMALL), mimo.Batch("benchmark", 4, threads=2, SMALL)
        one = batch.world(0)
        world.reset(seed=1); batch.reset(seeds=1)

        def work():
            while True:
                {what}

        threading.Thread(target=work, daemon=True).start()
        time.sleep(0.2)
        print("done")
        """
    )
    assert told == "done\n"


def test_python_ends_while_a_step_is_in_flight():
    program = """
        import mimo

        envs = mimo.make_vec("benchmark", num_envs=8, SMALL)
        envs.reset(seed=1)
        envs.send(envs.action_space.sample())
        kept = envs if KEPT else None
        envs.batch._itself = envs.batch  # a cycle: it is left to the end
        """
    for kept in ("True", "False"):
        assert run(program.replace("KEPT", kept)) == ""


@pytest.mark.parametrize("kind", ["world", "batch", "world of a batch"])
def test_close_during_a_call_of_another_thread(kind):
    options = {"vision": False, "touch": False}
    owner = mimo.World("benchmark", **options) if kind == "world" else mimo.Batch("benchmark", 2, **options)
    used = owner.world(0) if kind == "world of a batch" else owner
    owner.reset(1)
    handle = weakref.ref(owner._handle)
    started, said = threading.Event(), []

    def work():
        try:
            while True:
                started.set()
                used.step() if kind == "batch" else used.physics_step(50)
        except mimo.ClosedError as error:
            said.append(str(error))

    thread = threading.Thread(target=work)
    thread.start()
    started.wait()
    owner.close()
    owner.close()
    thread.join(60)
    assert said == [f"this {type(used).__name__} is closed"]
    assert handle() is None  # and freed
    assert owner.closed
    assert used.closed


def test_a_closed_object_says_so():
    batch = mimo.Batch("reach", 2)
    world, hand = batch.world(1), batch.bodies("right_fingers")
    batch.close()
    for call in (batch.step, world.step, lambda: hand.position, batch.save, lambda: batch.world(0), world.render):
        with pytest.raises(mimo.ClosedError, match="is closed"):
            call()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_forked_child_does_not_touch_its_parent_s_worlds():
    assert "child 0" in run(
        """
        import os, mimo
        world = mimo.World("reach"); world.reset(seed=1)
        child = os.fork()
        if child == 0:
            del world
            os._exit(0)
        print("child", os.waitpid(child, 0)[1])
        world.step()
        """
    )
