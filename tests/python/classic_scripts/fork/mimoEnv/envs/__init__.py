from mimoEnv.envs.dummy import MIMoDummyEnv  # noqa: F401
from mimoEnv.envs.itch import MIMoItchEnv  # noqa: F401
