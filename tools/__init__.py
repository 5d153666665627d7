"""The program behind ./dev: builds, tests, packages and checks this repository."""
