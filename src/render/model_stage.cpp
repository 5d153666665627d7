#include "render/model_stage.h"

#include "compat/mujoco.h"

namespace mimo::render {
namespace {

static_assert(kPlaneShape == +mjGEOM_PLANE && kFieldShape == +mjGEOM_HFIELD && kSphereShape == +mjGEOM_SPHERE &&
              kCapsuleShape == +mjGEOM_CAPSULE && kEllipsoidShape == +mjGEOM_ELLIPSOID &&
              kCylinderShape == +mjGEOM_CYLINDER && kBoxShape == +mjGEOM_BOX && kMeshShape == +mjGEOM_MESH);
static_assert(kFlatTexture == +mjTEXTURE_2D && kCubeTexture == +mjTEXTURE_CUBE && kSkyTexture == +mjTEXTURE_SKYBOX);

const unsigned char* flags(const void* bytes) { return static_cast<const unsigned char*>(bytes); }

Shapes geoms_of(const mjModel& model) {
  Shapes shapes;
  shapes.count = static_cast<int>(model.ngeom);
  shapes.types = model.geom_type;
  shapes.sizes = model.geom_size;
  shapes.colors = model.geom_rgba;
  shapes.materials = model.geom_matid;
  shapes.groups = model.geom_group;
  shapes.data = model.geom_dataid;
  shapes.first_id = 0;
  shapes.prescaled = true;
  return shapes;
}

Shapes sites_of(const mjModel& model) {
  Shapes shapes;
  shapes.count = static_cast<int>(model.nsite);
  shapes.types = model.site_type;
  shapes.sizes = model.site_size;
  shapes.colors = model.site_rgba;
  shapes.materials = model.site_matid;
  shapes.groups = model.site_group;
  return shapes;
}

Textures textures_of(const mjModel& model) {
  Textures textures;
  textures.count = static_cast<int>(model.ntex);
  textures.types = model.tex_type;
  textures.widths = model.tex_width;
  textures.heights = model.tex_height;
  textures.channels = compat::all_channels(model);
  textures.pixels = model.*compat::kPixels;
#if MIMO_MUJOCO_4
  static_assert(mjCOLORSPACE_SRGB == 2);
  textures.color_spaces = model.tex_colorspace;
#endif
  return textures;
}

Lights lights_of(const mjModel& model) {
  Lights lights;
  lights.count = static_cast<int>(model.nlight);
  lights.types = compat::light_types(model);
  lights.directional = compat::directional_lights(model);
  lights.active = flags(model.light_active);
  lights.casts_shadow = flags(model.light_castshadow);
  lights.ambient = model.light_ambient;
  lights.diffuse = model.light_diffuse;
  lights.specular = model.light_specular;
  lights.attenuation = model.light_attenuation;
  lights.cutoff = model.light_cutoff;
  lights.exponent = model.light_exponent;
  return lights;
}

Air air_of(const mjModel& model) {
  const auto& look = model.vis;
  Air air;
  air.near_plane = look.map.znear * model.stat.extent;
  air.far_plane = look.map.zfar * model.stat.extent;
  air.fog_start = look.map.fogstart * model.stat.extent;
  air.fog_length = (look.map.fogend - look.map.fogstart) * model.stat.extent;
  air.haze = look.map.haze;
  air.fog_color = look.rgba.fog;
  air.haze_color = look.rgba.haze;
  air.headlight = look.headlight.active != 0;
  air.ambient = look.headlight.ambient;
  air.diffuse = look.headlight.diffuse;
  air.specular = look.headlight.specular;
  return air;
}

}  // namespace

Materials materials_of(const mjModel& model) {
  Materials materials;
  materials.count = static_cast<int>(model.nmat);
  materials.colors = model.mat_rgba;
  materials.emission = model.mat_emission;
  materials.specular = model.mat_specular;
  materials.shininess = model.mat_shininess;
  materials.reflectance = model.mat_reflectance;
  materials.textures = compat::color_textures(model);
  materials.texture_stride = compat::kTexturesOfMaterial;
  materials.repeats = model.mat_texrepeat;
  materials.uniform = flags(model.mat_texuniform);
  return materials;
}

Meshes meshes_of(const mjModel& model) {
  Meshes meshes;
  meshes.count = static_cast<int>(model.nmesh);
  meshes.first_vertex = model.mesh_vertadr;
  meshes.first_normal = compat::first_normals(model);
  meshes.first_texcoord = model.mesh_texcoordadr;
  meshes.first_triangle = model.mesh_faceadr;
  meshes.triangle_count = model.mesh_facenum;
  meshes.vertices = model.mesh_vert;
  meshes.normals = model.mesh_normal;
  meshes.texcoords = model.mesh_texcoord;
  meshes.triangles = model.mesh_face;
  meshes.normal_triangles = compat::face_normals(model);
  meshes.texcoord_triangles = compat::face_texcoords(model);
  return meshes;
}

Fields fields_of(const mjModel& model) {
  Fields fields;
  fields.count = static_cast<int>(model.nhfield);
  fields.rows = model.hfield_nrow;
  fields.columns = model.hfield_ncol;
  fields.first = model.hfield_adr;
  fields.sizes = model.hfield_size;
  fields.heights = model.hfield_data;
  return fields;
}

Stage stage_of(const mjModel& model) {
  Stage stage;
  stage.geoms = geoms_of(model);
  stage.sites = sites_of(model);
  stage.materials = materials_of(model);
  stage.textures = textures_of(model);
  stage.meshes = meshes_of(model);
  stage.fields = fields_of(model);
  stage.lights = lights_of(model);
  stage.air = air_of(model);
  return stage;
}

Poses poses_of(const mjData& data) {
  return {{data.geom_xpos, data.geom_xmat}, {data.site_xpos, data.site_xmat}, data.light_xpos, data.light_xdir};
}

}  // namespace mimo::render
