from gymnasium.envs.registration import register

register(id="MIMoBench-v0", entry_point="mimoEnv.envs:MIMoDummyEnv", max_episode_steps=6000)
register(id="MIMoItch-v0", entry_point="mimoEnv.envs:MIMoItchEnv", max_episode_steps=30)
