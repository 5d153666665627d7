"""Environments in processes of their own, started anew."""

import multiprocessing

import gymnasium as gym
import mimoEnv  # noqa: F401


def work(seed, queue):
    env = gym.make("MIMoReach-v0")
    env.reset(seed=seed)
    queue.put((seed, round(float(env.data.body("target").xpos[0]), 6)))


def main():
    for method in ("spawn", "forkserver"):
        context = multiprocessing.get_context(method)
        queue = context.Queue()
        workers = [context.Process(target=work, args=(seed, queue)) for seed in (1, 2)]
        for worker in workers:
            worker.start()
        places = dict(queue.get(timeout=100) for _ in workers)
        for worker in workers:
            worker.join()
        print(method, len(places), places[1] != places[2])


if __name__ == "__main__":
    main()
