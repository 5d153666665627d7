"""A mujoco.MjModel and its MjData as the arrays of a mimo.Stage, of MuJoCo 2.3 to 4: as they lie, with few copies."""

from __future__ import annotations

import importlib
from typing import Any, Dict, List, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _abi
from .decorations import Extras, Tell
from .skinning import Skinning
from .stage import Arrays, fill
from .stage_columns import POSES

TEXTURES_FROM_CORNERS = (3, 12)  # the version of MuJoCo that began to lay flat textures so
FLAT, SRGB = 0, 2  # mjTEXTURE_2D and mjCOLORSPACE_SRGB: MuJoCo decodes no other textures
COLOR_TEXTURE = 1  # mjTEXROLE_RGB, the column of mat_texid since MuJoCo 3.2
RODS, TRIANGLES = 2, 3  # corners of the elements of surfaces
DEFAULT_COLOR = np.array([0.5, 0.5, 0.5, 1], np.float32)  # stands for the material's
MOVING = ("geom", "site")


def mujoco_of(model: Any) -> Any:
    """The package mujoco that a model comes from."""
    package = type(model).__module__.split(".")[0]
    if type(model).__name__ != "MjModel" or package != "mujoco":
        raise TypeError(f"model is {model!r}, expected a mujoco.MjModel")
    return importlib.import_module(package)


class ModelArrays:
    """The parts of a stage that shows a model. What `refresh` writes anew are the few arrays that are copies."""

    def __init__(self, mujoco: Any, model: Any) -> None:
        self._mujoco, self._model = mujoco, model
        self._version = tuple(int(part) for part in mujoco.__version__.split(".")[:2])
        self.skinning = Skinning(model)
        self.flexes = getattr(model, "nflex", 0)
        self._textures = np.full(model.nmat, -1, np.int32)
        self._lamps = np.zeros(model.nlight, np.int32)
        self._colors = {one: np.empty_like(getattr(model, f"{one}_rgba")) for one in MOVING}
        self._still = {one: model.body_weldid[getattr(model, f"{one}_bodyid")] == 0 for one in MOVING}
        self.refresh()

    def refresh(self, textures: bool = True, transparent: bool = False, static: bool = True) -> None:
        """Takes over what has changed in the model. The arguments are MjvOption's flags of these names."""
        model = self._model
        if textures:
            texid = model.mat_texid
            self._textures[:] = texid[:, COLOR_TEXTURE] if texid.ndim == 2 else texid
        else:
            self._textures.fill(-1)
        lamps = getattr(model, "light_type", None)
        self._lamps[:] = model.light_directional if lamps is None else lamps
        for one in MOVING:
            self._paint(one, transparent, static)

    def _paint(self, one: str, transparent: bool, static: bool) -> None:
        colors, still = self._colors[one], self._still[one]
        np.copyto(colors, getattr(self._model, f"{one}_rgba"))
        if transparent and not still.all():
            materials = getattr(self._model, f"{one}_matid")
            painted = (materials >= 0) & (colors == DEFAULT_COLOR).all(axis=1)
            colors[painted] = self._model.mat_rgba[materials[painted]]
            colors[~still, 3] *= self._model.vis.map.alpha
        if not static:
            colors[still, 3] = 0
        np.maximum(colors[:, 3], 0, out=colors[:, 3])  # some hide things by an alpha of -1, which OpenGL takes as 0

    def parts(self) -> Dict[str, Arrays]:
        """All parts; those of what the model has none of are left out."""
        model = self._model
        counts = {"meshes": model.nmesh, "fields": model.nhfield, "textures": model.ntex, "materials": model.nmat}
        counts.update(tendons=model.ntendon, lights=model.nlight, surfaces=self.flexes + model.nskin)
        parts = {name: getattr(self, name)() for name, count in counts.items() if count}
        return {"geoms": self.shapes("geom"), "sites": self.shapes("site"), "air": self.air(), **parts}

    def shapes(self, one: str) -> Arrays:
        """Geoms or sites."""
        model, kinds = self._model, self._mujoco.mjtObj
        shapes = {
            "object_type": int(kinds.mjOBJ_GEOM if one == "geom" else kinds.mjOBJ_SITE),
            "forms": getattr(model, f"{one}_type"),
            "sizes": getattr(model, f"{one}_size"),
            "colors": self._colors[one],
            "materials": getattr(model, f"{one}_matid"),
            "groups": getattr(model, f"{one}_group"),
        }
        data = getattr(model, f"{one}_dataid", None)
        return shapes if data is None else {**shapes, "data": data}

    def meshes(self) -> Arrays:
        """Meshes, with the normals and texture coordinates of their corners."""
        model = self._model
        return {
            "vertex_counts": model.mesh_vertnum,
            "normal_counts": model.mesh_normalnum,
            "texcoord_counts": model.mesh_texcoordnum,
            "triangle_counts": model.mesh_facenum,
            "vertices": model.mesh_vert,
            "normals": model.mesh_normal,
            "texcoords": model.mesh_texcoord if model.mesh_texcoord.size else None,
            "triangles": model.mesh_face,
            "normal_triangles": model.mesh_facenormal,
            "texcoord_triangles": model.mesh_facetexcoord,
        }

    def fields(self) -> Arrays:
        """Height fields."""
        model = self._model
        sizes, heights = model.hfield_size, model.hfield_data
        return {"rows": model.hfield_nrow, "columns": model.hfield_ncol, "sizes": sizes, "heights": heights}

    def textures(self) -> Arrays:
        """Textures."""
        model = self._model
        bytes_before_3_2 = getattr(model, "tex_rgb", None)
        spaces = getattr(model, "tex_colorspace", None)
        return {
            "types": model.tex_type,
            "widths": model.tex_width,
            "heights": model.tex_height,
            "channels": getattr(model, "tex_nchannel", None),
            "pixels": model.tex_data if bytes_before_3_2 is None else bytes_before_3_2,
            "srgb": None if spaces is None else (spaces == SRGB) & (model.tex_type == FLAT),
        }

    def materials(self) -> Arrays:
        """Materials."""
        model = self._model
        names = ("emission", "specular", "shininess", "reflectance")
        return {
            "colors": model.mat_rgba,
            **{name: getattr(model, f"mat_{name}") for name in names},
            "textures": self._textures,
            "repeats": model.mat_texrepeat,
            "uniform": model.mat_texuniform,
            "from_corner": self._version >= TEXTURES_FROM_CORNERS,
        }

    def tendons(self) -> Arrays:
        """Tendons."""
        model, kind = self._model, int(self._mujoco.mjtObj.mjOBJ_TENDON)
        colors, groups = model.tendon_rgba, model.tendon_group
        width, materials = model.tendon_width, model.tendon_matid
        return {"object_type": kind, "widths": width, "colors": colors, "materials": materials, "groups": groups}

    def lights(self) -> Arrays:
        """Lights."""
        model = self._model
        names = ("active", "ambient", "diffuse", "specular", "attenuation", "cutoff", "exponent")
        lights = {name: getattr(model, f"light_{name}") for name in names}
        return {"types": self._lamps, "casts_shadow": model.light_castshadow, **lights}

    def air(self) -> Arrays:
        """What of the model concerns the picture as a whole."""
        vis, extent = self._model.vis, self._model.stat.extent
        places, colors, light = vis.map, vis.rgba, vis.headlight
        return {
            "headlight": light.active,
            "near_plane": places.znear * extent,
            "far_plane": places.zfar * extent,
            "fog_start": places.fogstart * extent,
            "fog_end": places.fogend * extent,
            "haze": places.haze,
            "sun_reach": places.shadowclip * extent,
            "fog_color": colors.fog[:3],
            "haze_color": colors.haze[:3],
            "ambient": light.ambient,
            "diffuse": light.diffuse,
            "specular": light.specular,
        }

    def surfaces(self) -> Arrays:
        """Flexes and then skins, all of group 0; `shown_surfaces` hides them."""
        model, kinds = self._model, self._mujoco.mjtObj
        flexes = [self._flex(i) for i in range(self.flexes)]
        skins = [self._skin(i) for i in range(model.nskin)]
        rest = np.empty((self.vertex_count, 3))
        if self.flexes:
            still = self._mujoco.MjData(model)
            self._mujoco.mj_forward(model, still)
            rest[: model.nflexvert] = still.flexvert_xpos
        rest[self.vertex_count - self.skinning.count :] = model.skin_vert
        every = flexes + skins
        objects = [(i, int(kinds.mjOBJ_FLEX)) for i in range(self.flexes)] if self.flexes else []
        objects += [(i, int(kinds.mjOBJ_SKIN)) for i in range(model.nskin)]
        joined = {name: np.concatenate([one[name] for one in every]) for name in ("elements", "texcoord_elements")}
        numbers = {name: np.array([one[name] for one in every], np.int32) for name in ("corners", "vertex_counts")}
        return {
            **joined,
            **numbers,
            "element_counts": [len(one["elements"]) // one["corners"] for one in every],
            "texcoord_counts": [len(one["texcoords"]) for one in every],
            "texcoords": np.concatenate([one["texcoords"] for one in every]),
            "vertices": rest,
            **{name: [one[name] for one in every] for name in ("radii", "sheets", "flat", "colors", "materials")},
            "groups": np.zeros(len(every), np.int32),
            "objects": objects,
        }

    @property
    def vertex_count(self) -> int:
        """Of all surfaces."""
        return (self._model.nflexvert if self.flexes else 0) + self.skinning.count

    def _flex(self, i: int) -> Dict[str, Any]:
        model, width = self._model, int(self._model.flex_dim[i])
        corners = RODS if width == 1 else TRIANGLES
        if width == 3:
            start, count, source = model.flex_shelldataadr[i], model.flex_shellnum[i] * corners, model.flex_shell
        else:
            start, count, source = model.flex_elemdataadr[i], model.flex_elemnum[i] * corners, model.flex_elem
        elements = source.reshape(-1)[start : start + count]
        texcoords, laid = self._flex_texture(i, width, elements)
        return {
            "corners": corners,
            "vertex_counts": model.flex_vertnum[i],
            "elements": elements,
            "texcoords": texcoords,
            "texcoord_elements": laid,
            "radii": model.flex_radius[i],
            "sheets": width == 2,
            "flat": bool(model.flex_flatskin[i]),
            "colors": model.flex_rgba[i],
            "materials": model.flex_matid[i],
        }

    def _flex_texture(self, i: int, width: int, elements: NDArray[np.int32]) -> Tuple[Any, Any]:
        model, first = self._model, int(self._model.flex_texcoordadr[i])
        nothing = np.zeros((0, 2), np.float32), np.zeros(len(elements), np.int32)
        if first < 0 or width == 1:
            return nothing
        later = [int(adr) for adr in model.flex_texcoordadr if adr > first]
        texcoords = model.flex_texcoord[first : min(later, default=len(model.flex_texcoord))]
        laid = getattr(model, "flex_elemtexcoord", None)
        if width == 2 and laid is not None:
            start = model.flex_elemdataadr[i]
            return texcoords, laid.reshape(-1)[start : start + len(elements)]
        return (texcoords, elements) if len(texcoords) > elements.max(initial=-1) else nothing

    def _skin(self, i: int) -> Dict[str, Any]:
        model, count, first = self._model, int(self._model.skin_vertnum[i]), int(self._model.skin_texcoordadr[i])
        start = model.skin_faceadr[i]
        elements = model.skin_face[start : start + model.skin_facenum[i]].reshape(-1)
        texcoords = model.skin_texcoord[first : first + count] if first >= 0 else np.zeros((0, 2), np.float32)
        return {
            "corners": TRIANGLES,
            "vertex_counts": count,
            "elements": elements,
            "texcoords": texcoords,
            "texcoord_elements": elements if first >= 0 else np.zeros(len(elements), np.int32),
            "radii": model.skin_inflate[i],
            "sheets": False,
            "flat": False,
            "colors": model.skin_rgba[i],
            "materials": model.skin_matid[i],
        }


class Snapshot:
    """Where all things of a model were when `take` was called, as MuJoCo's scene keeps them until its next update."""

    def __init__(self, mujoco: Any, model: Any, arrays: ModelArrays, tell: Tell) -> None:
        counts = {"geom": model.ngeom, "site": model.nsite}
        self._copied: List[Tuple[NDArray[Any], str]] = []
        given: Dict[str, Any] = {}
        for one, count in counts.items():
            given[f"{one}_positions"] = self._keep(f"{one}_xpos", (count, 3))
            given[f"{one}_rotations"] = self._keep(f"{one}_xmat", (count, 9))
        given["light_positions"] = self._keep("light_xpos", (model.nlight, 3))
        given["light_directions"] = self._keep("light_xdir", (model.nlight, 3))
        if model.ntendon:
            given["tendon_first"] = self._keep("ten_wrapadr", (model.ntendon,), np.int32)
            given["tendon_points"] = self._keep("ten_wrapnum", (model.ntendon,), np.int32)
            given["path_points"] = self._keep("wrap_xpos", (model.nwrap, 6))
            given["path_objects"] = self._keep("wrap_obj", (model.nwrap, 2), np.int32)
        self._skinning, flexible = arrays.skinning, arrays.vertex_count - arrays.skinning.count
        vertices = given["vertices"] = np.zeros((arrays.vertex_count, 3))
        if flexible:
            self._copied.append((vertices[:flexible], "flexvert_xpos"))
        self._skin = vertices[flexible:]
        self.struct = _abi.StagePoses()
        self._kept = fill(self.struct, "poses", POSES, given)
        self.extras = Extras(mujoco, self.struct, tell)

    def _keep(self, name: str, shape: Tuple[int, ...], kind: Any = np.float64) -> NDArray[Any]:
        buffer = np.zeros(shape, kind)
        self._copied.append((buffer, name))
        return buffer

    def take(self, data: Any) -> None:
        """Copies the poses."""
        for buffer, name in self._copied:
            given = getattr(data, name)
            if given.shape != buffer.shape:
                message = f"data belongs to another model: its {name} has the shape {given.shape}"
                raise ValueError(f"{message}, expected {buffer.shape}")
            np.copyto(buffer, given)
        if len(self._skin):
            self._skinning.move(data, self._skin)
