"""What eyes.cu draws, out of a model of MuJoCo: solids, textures with their mipmaps, lights, and the air.

The numbers are those of src/rays (solids.cpp, materials.cpp, lights.cpp, backdrop.cpp) and src/render/surfaces.cpp; the
types are the structs at the top of eyes.cu. Meshes, mirrors and transparent things are left out.
"""

import mujoco
import numpy as np


def _struct(text):
    """Members of four bytes: "name", or "name:3" for three; integers begin with #."""
    members = []
    for member in text.split():
        name, _, count = member.lstrip("#").partition(":")
        members.append((name, np.int32 if member[0] == "#" else np.float32, *([int(count)] if count else [])))
    return np.dtype(members)


SOLID = _struct("#kind size:3 radius rgb:3 emission:3 specular exponent #texture #mapping scale:4 origin:2 fold #geom")
TEXTURE = _struct("#width #height #levels #cube #origin:16")
LIGHT = _struct(
    "#directional #spot #attenuated #bright #shadow #index ambient:3 diffuse:3 specular:3 attenuation:3 cutoff exponent"
)
SCENE = _struct("#solids #lights #width #shadows slope near far sky_limit haze_radius haze_turn haze:3 #sky #ground")
PLANE, SPHERE, CAPSULE, ELLIPSOID, CYLINDER, BOX = 0, 2, 3, 4, 5, 6
FLAT, CUBE = 1, 2
SKY, SRGB = mujoco.mjtTexture.mjTEXTURE_SKYBOX, mujoco.mjtColorSpace.mjCOLORSPACE_SRGB
EFFECTS = ("none", "shadows", "all")  # the last: also the sky and its haze


def _halved(texels):
    a = texels.astype(np.uint32)
    if len(a) == 1:
        return ((a[:, 0::2] + a[:, 1::2] + 1) // 2).astype(np.uint8)
    return ((a[0::2, 0::2] + a[1::2, 0::2] + a[0::2, 1::2] + a[1::2, 1::2] + 2) >> 2).astype(np.uint8)


def _decoded_srgb():
    code = np.arange(256) / 255
    light = np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)
    return np.floor(255 * light + 0.5).astype(np.uint8)


def textures(model):
    """A table, and all texels: of each level, the border of one texel included."""
    table, texels, size = np.zeros(model.ntex, TEXTURE), [], 0
    for i, texture in enumerate(table):
        width, height, channels = model.tex_width[i], model.tex_height[i], model.tex_nchannel[i]
        first = model.tex_adr[i]
        pixels = model.tex_data[first : first + width * height * channels].reshape(height, width, channels)[..., :3]
        if model.tex_colorspace[i] == SRGB:
            pixels = _decoded_srgb()[pixels]
        cube = bool(model.tex_type[i] != mujoco.mjtTexture.mjTEXTURE_2D)
        faces = [pixels]
        if cube:
            faces = [pixels] * 6 if height == width else [pixels[k * width : (k + 1) * width] for k in range(6)]
        texture["width"], texture["height"], texture["cube"] = width, faces[0].shape[0], cube
        while True:
            rows, columns = faces[0].shape[:2]
            texture["origin"][texture["levels"]] = size + columns + 3
            for face in faces:
                wide = np.pad(face, ((1, 1), (1, 1), (0, 0)), mode="edge" if cube else "wrap").astype(np.uint32)
                texels.append((wide[..., 0] | wide[..., 1] << 8 | wide[..., 2] << 16).ravel())
                size += texels[-1].size
            texture["levels"] += 1
            if rows == columns == 1:
                break
            faces = [_halved(face) for face in faces]
    return table, np.concatenate([*texels, np.zeros(8, np.uint32)])


def _power(exponent):
    rounded = round(min(exponent, 1e9))
    return float(rounded) if abs(rounded - exponent) < 1e-4 or exponent > 8 else exponent


def _map_texture(model, solid, material, cube):
    size, kind = solid["size"], solid["kind"]
    unit = {SPHERE: [size[0]] * 3, CAPSULE: [size[0], size[0], size[1]], CYLINDER: [size[0], size[0], size[1]]}
    scale, uniform = unit.get(int(kind), list(size)), model.mat_texuniform[material]
    solid["mapping"], solid["origin"], solid["fold"] = CUBE if cube else FLAT, -0.5, 3e38
    if not cube:
        for k in range(2):
            repeat = model.mat_texrepeat[material][k]
            if kind == PLANE and size[k] > 0:
                repeat /= size[k]
            if uniform and scale[k] > 0:
                repeat *= scale[k]
            solid["scale"][k] = (0.5, -0.5)[k] * (repeat if kind == PLANE else repeat / scale[k])
        return
    for k in range(3):
        factor = scale[k] if uniform else 1.0
        solid["scale"][k] = factor if kind == PLANE else factor / scale[k]
    if kind == CAPSULE:
        solid["fold"], solid["scale"][3] = size[1], (scale[2] if uniform else 1.0) / size[0]


def solids(model, table):
    made = np.zeros(model.ngeom, SOLID)
    for i, solid in enumerate(made):
        kind, size, material = int(model.geom_type[i]), model.geom_size[i], model.geom_matid[i]
        radius = {PLANE: 0, SPHERE: size[0], CAPSULE: size[0] + size[1], ELLIPSOID: size.max()}
        radius |= {CYLINDER: np.hypot(size[0], size[1]), BOX: np.linalg.norm(size)}
        solid["kind"], solid["size"], solid["geom"], solid["radius"] = kind, size, i, radius[kind]
        own = model.geom_rgba[i]
        usual = material >= 0 and (own == [0.5, 0.5, 0.5, 1]).all()
        solid["rgb"] = (model.mat_rgba[material] if usual else own)[:3]
        solid["texture"], solid["specular"], shininess = -1, 0.5, 0.5
        if material >= 0:
            solid["emission"] = model.mat_emission[material] * solid["rgb"]
            solid["specular"], shininess = model.mat_specular[material], model.mat_shininess[material]
            solid["texture"] = model.mat_texid[material][mujoco.mjtTextureRole.mjTEXROLE_RGB]
        solid["exponent"] = _power(128.0 * shininess)
        if solid["texture"] >= 0:
            _map_texture(model, solid, material, bool(table[solid["texture"]]["cube"]))
    return made


def lights(model):
    """The headlight, then the scene's."""
    head, active = model.vis.headlight, np.flatnonzero(model.light_active)
    made = np.zeros(1 + len(active), LIGHT)
    made[0]["directional"], made[0]["index"] = 1, -1
    made[0]["ambient"], made[0]["diffuse"], made[0]["specular"] = head.ambient, head.diffuse, head.specular
    for light, i in zip(made[1:], active):
        light["index"], light["shadow"] = i, model.light_castshadow[i]
        for name in ("ambient", "diffuse", "specular", "attenuation"):
            light[name] = getattr(model, "light_" + name)[i]
        light["directional"] = model.light_type[i] == mujoco.mjtLightType.mjLIGHT_DIRECTIONAL
        if not light["directional"]:
            light["spot"] = model.light_cutoff[i] < 180
            light["cutoff"] = np.cos(np.radians(float(model.light_cutoff[i])))
            light["exponent"] = _power(float(model.light_exponent[i]))
            light["attenuated"] = tuple(model.light_attenuation[i]) != (1, 0, 0)
    made["bright"] = (made["specular"] > 0).any(1)
    return made


def scene(model, width, effects):
    """The struct Scene, and what its arrays are: solids, textures, texels, lights."""
    table, texels = textures(model)
    things, lamps, air = solids(model, table), lights(model), np.zeros(1, SCENE)
    air["solids"], air["lights"], air["width"], air["shadows"] = len(things), len(lamps), width, effects != "none"
    air["slope"] = np.tan(np.radians(model.cam_fovy[0]) / 2)
    air["near"], air["far"] = model.vis.map.znear * model.stat.extent, model.vis.map.zfar * model.stat.extent
    air["sky"] = air["ground"] = -1
    if effects == "all":
        air["sky"] = next((i for i in range(model.ntex) if model.tex_type[i] == SKY), -1)
        endless = (model.geom_type == PLANE) & (model.geom_size[:, :2] == 0).all(1)
        air["ground"] = np.flatnonzero(endless)[0] if endless.any() else -1
        radius = model.vis.map.haze
        alpha = np.arctan2(1, radius)
        air["sky_limit"], air["haze_radius"], air["haze"] = 0.7 * air["far"], radius, model.vis.rgba.haze[:3]
        air["haze_turn"] = np.sqrt(0.5) * radius * np.sin(alpha) / np.sin(0.75 * np.pi - alpha)
    return air, things, table, texels, lamps


def poses(worlds):
    """Places and turns of geoms, cameras and lights: float32, world by world."""
    names = ("geom_xpos", "geom_xmat", "cam_xpos", "cam_xmat", "light_xpos", "light_xdir")
    return [np.ascontiguousarray(np.stack([getattr(data, name) for data in worlds]), np.float32) for name in names]
