"""`model.opt`, `model.stat` and `model.vis`: settings of a model, which belong to its document except gravity."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Dict

import numpy as np

from .catalog import Catalog
from .elements import refuse
from .live import PAGE, Live

# MuJoCo's options: the document's attributes and their defaults.
OPTIONS: Dict[str, Any] = {
    "iterations": 100,
    "tolerance": 1e-8,
    "noslip_iterations": 0,
    "impratio": 1.0,
    "density": 0.0,
    "viscosity": 0.0,
    "wind": (0.0, 0.0, 0.0),
    "magnetic": (0.0, -0.5, 0.0),
}
# ... and those with names, by MuJoCo's numbers.
CHOICES: Dict[str, Any] = {
    "integrator": ("Euler", "RK4", "implicit", "implicitfast"),
    "cone": ("pyramidal", "elliptic"),
    "jacobian": ("dense", "sparse", "auto"),
    "solver": ("PGS", "CG", "Newton"),
}
_STANDARD_CHOICES = {"integrator": "Euler", "cone": "pyramidal", "jacobian": "auto", "solver": "Newton"}


class OptionView:
    """`model.opt`: gravity (m/s^2) can be set; the rest belongs to the document."""

    def __init__(self, catalog: Catalog) -> None:
        self.__dict__["_it"] = catalog

    @property
    def gravity(self) -> Live:
        """Gravity of this world, m/s^2."""
        world = self._it.world
        return self._it.stage.array(lambda: world.gravity, lambda new, old: setattr(world, "gravity", new))

    @property
    def timestep(self) -> float:
        """Time step of the physics, s."""
        return self._it.world.timestep

    @cached_property
    def _stated(self) -> Dict[str, str]:
        return self._it.document.merged("option")

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") or (name not in OPTIONS and name not in CHOICES):
            refuse("model.opt", name)
        given = self._stated.get(name)
        if name in CHOICES:
            return CHOICES[name].index(given or _STANDARD_CHOICES[name])
        standard = OPTIONS[name]
        if isinstance(standard, tuple):
            values = standard if given is None else [float(it) for it in given.split()]
            return self._it.stage.array(lambda: np.array(values), None, self._refusal(name))
        return standard if given is None else type(standard)(float(given))

    def __setattr__(self, name: str, value: Any) -> None:
        if name == "gravity":
            self.gravity[...] = value
        else:
            before = getattr(self, name)  # refuses unknown names
            if not np.array_equal(before, value):
                raise AttributeError(self._refusal(name))

    def _refusal(self, name: str) -> str:
        return (
            f"model.opt.{name} is a constant here: write <option {name}=.../> in the scene's document; only gravity "
            f"can be set; {PAGE}"
        )


class StatisticView:
    """`model.stat`: extent and centre (m), as the document states them."""

    def __init__(self, catalog: Catalog) -> None:
        self.__dict__["_it"] = catalog

    def __getattr__(self, name: str) -> Any:
        if name not in ("extent", "center"):
            refuse("model.stat", name)
        given = self._it.document.merged("statistic").get(name)
        if given is None:
            refuse("model.stat of a document without a <statistic>", name)
        values = np.array([float(it) for it in given.split()])
        return float(values[0]) if name == "extent" else values

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"model.stat.{name} is a constant here: write it in the document's <statistic>; {PAGE}")


class PictureSizes:
    """`model.vis.global_`: the largest picture, which scripts enlarge. Here pictures may have any size."""

    def __init__(self, catalog: Catalog) -> None:
        stated = {name: value for it in catalog.document.root.iter("global") for name, value in it.attrib.items()}
        sizes = {"offwidth": int(stated.get("offwidth", 640)), "offheight": int(stated.get("offheight", 480))}
        self.__dict__.update(sizes)

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in self.__dict__:
            refuse("model.vis.global_", name)
        self.__dict__[name] = int(value)


class VisualView:
    """`model.vis`: `global_` alone."""

    def __init__(self, catalog: Catalog) -> None:
        self.__dict__["_it"] = catalog

    @cached_property
    def global_(self) -> PictureSizes:
        """The largest picture."""
        return PictureSizes(self._it)

    def __getattr__(self, name: str) -> Any:
        refuse("model.vis", name)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"model.vis.{name} cannot be assigned; {PAGE}")
