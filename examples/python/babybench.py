"""Baselines of BabyBench: random actions, or PPO on a reward of the infant's own.

    python babybench.py selftouch --baseline random --steps 10000
    python babybench.py handregard --baseline intrinsic --steps 100000     # needs pip install 'mimo[babybench,train]'

Logs go to the configuration's save_dir, or to --out. Prints the scores.
"""

import argparse

import mimo.babybench

REWARDS = {"self_touch": mimo.babybench.TouchCount, "hand_regard": mimo.babybench.Saliency}


def act_at_random(env, steps):
    env.reset(seed=0)
    env.action_space.seed(0)
    for _ in range(steps):
        *_, truncated, _ = env.step(env.action_space.sample())
        if truncated:
            env.reset()


def learn(env, steps, behavior):
    from stable_baselines3 import PPO

    PPO("MultiInputPolicy", REWARDS[behavior](env), seed=0, verbose=1).learn(steps)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("config", help="selftouch, handregard, or a YAML file")
    parser.add_argument("--baseline", choices=["random", "intrinsic"], default="random")
    parser.add_argument("--steps", type=int, default=10000)
    parser.add_argument("--out", help="folder of the logs")
    parser.add_argument("--blind", action="store_true", help="without eyes and skin, which random actions do not need")
    arguments = parser.parse_args()
    config = mimo.babybench.load(arguments.config)
    if arguments.out:
        config["save_dir"] = arguments.out
    if arguments.blind:
        config.update(vision_active=False, touch_active=False)
    if arguments.baseline == "intrinsic" and config["behavior"] not in REWARDS:
        parser.error(f"there is no reward for behavior {config['behavior']!r}")
    env = mimo.babybench.make(config)
    if arguments.baseline == "random":
        act_at_random(env, arguments.steps)
    else:
        learn(env, arguments.steps, config["behavior"])
    env.close()
    print(mimo.babybench.scores_of(env.log))


if __name__ == "__main__":
    main()
