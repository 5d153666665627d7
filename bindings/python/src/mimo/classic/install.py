"""`import mimo.classic.install` lets scripts for the original run in this process, as `python -m mimo.classic` does."""

from .modules import install

install()
