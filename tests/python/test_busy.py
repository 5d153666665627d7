"""Two threads on one object: one works, the other is told so by BusyError, and nothing is harmed."""

import contextlib
import threading

import numpy as np
import pytest

import mimo

STEPS = 40


def hammer(call, wanted=STEPS, most=4000):
    """Calls on two threads at once, until they met; how often calls came through, and how often one was busy."""
    done, busy, odd = [0, 0], [0, 0], []
    start = threading.Barrier(2)

    def run(number):
        start.wait()
        for _ in range(most):
            if done[number] >= wanted and sum(busy):
                return
            try:
                call()
                done[number] += 1
            except mimo.BusyError as error:
                busy[number] += 1
                if error.status != -15 or "in use by another thread" not in str(error):
                    odd.append(error)
            except BaseException as error:
                odd.append(error)
                return

    threads = [threading.Thread(target=run, args=(number,)) for number in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not odd
    return sum(done), sum(busy)


def blind(name="free"):
    return mimo.World(name, vision=False)


def test_a_world_takes_whole_steps():
    with blind() as world, blind() as alone:
        done, busy = hammer(world.step)
        assert busy > 0
        assert done >= STEPS
        for _ in range(done):
            alone.step()
        assert world.time == alone.time
        np.testing.assert_array_equal(world.joints().position, alone.joints().position)


def test_a_batch_takes_whole_steps():
    with mimo.Batch("free", 3, vision=False) as batch:
        done, busy = hammer(batch.step)
        assert busy > 0
        assert batch.world(0).time == pytest.approx(done * 0.01)


def test_reading_while_another_thread_steps():
    """Whole contacts or BusyError, never a complaint about the number of values."""
    with blind("benchmark") as world:
        ends = threading.Event()

        def step():
            while not ends.is_set():
                with contextlib.suppress(mimo.BusyError):
                    world.step()

        thread = threading.Thread(target=step)
        thread.start()
        busy = 0
        try:
            for _ in range(2000):
                try:
                    world.contacts()
                except mimo.BusyError:
                    busy += 1
        finally:
            ends.set()
            thread.join()
        assert busy > 0
        world.contacts()


def test_closed_by_another_thread():
    """The call that runs goes on; what is closed says so."""
    world = blind()
    threads = [threading.Thread(target=world.close)]

    said = []

    def step():
        try:
            for _ in range(10000):
                world.step()
        except mimo.Error as error:
            said.append(type(error))

    threads.append(threading.Thread(target=step))
    for thread in reversed(threads):
        thread.start()
    for thread in threads:
        thread.join()
    assert said == [mimo.ClosedError]


def test_a_batch_that_was_sent_is_busy():
    with mimo.Batch("free", 2, vision=False) as batch:
        view = batch.world(1)
        batch.send()
        for call in (batch.step, batch.send, lambda: view.time, lambda: view.step()):
            with pytest.raises(mimo.BusyError, match="at work"):
                call()
        batch.receive()
        with pytest.raises(mimo.BusyError, match="without mimo_batch_send"):
            batch.receive()
        assert view.time == pytest.approx(0.01)


def test_it_is_a_runtime_error():
    assert issubclass(mimo.BusyError, mimo.Error)
    assert issubclass(mimo.BusyError, RuntimeError)
