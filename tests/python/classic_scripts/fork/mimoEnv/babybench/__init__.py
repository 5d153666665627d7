from mimoEnv.babybench.nap import BabyBenchEnv, BabyBenchNapEnv  # noqa: F401
