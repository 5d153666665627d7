// Where MuJoCo 2.2 and 4.0 call a thing otherwise, or keep it elsewhere. Only guard, fingerprint, flexes, the check of
// a host's model and what a step does before its constraints are solved also ask which of the two this is compiled for.
#pragma once

#include <mujoco/mjxmacro.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string>

#define MIMO_MUJOCO_4 (mjVERSION_HEADER >= 4000000)

// The list of mjModel's sizes, of <mujoco/mjxmacro.h>.
#if MIMO_MUJOCO_4
#define MIMO_MODEL_SIZES MJMODEL_SIZES
#else
#define MIMO_MODEL_SIZES MJMODEL_INTS
#endif

namespace mimo::compat {

// Where red (0), green or blue is in a pixel of a texture; of fewer channels the first is grey.
inline int channel_of(int channels, int color) { return channels < 3 ? 0 : color; }

// A soft body, which 2.2 does not have: lines, a sheet, or one that fills space.
struct Flex {
  int dimensions, first_vertex, vertices, elements, shells, material;
  const int *element, *texels, *shell;  // dimensions + 1 corners; the shell is the triangles around what fills space
  const float *texcoords, *rgba;        // texture coordinates: null for none
  double radius;
  bool flat;
};

// The sensor of a camera and the lens before it, which 2.2 does not have: lengths in m, across and up.
struct Sensor {
  std::array<double, 2> size, focal, principal;
  bool given() const { return size[0] > 0 && size[1] > 0; }
};

#if MIMO_MUJOCO_4

inline constexpr auto kLockFlags = &mjModel::eq_active0;  // where resets lead to
inline constexpr auto kPixels = &mjModel::tex_data;
inline constexpr auto kPixelsName = "tex_data";
inline const void* behind_pixels(const mjModel& model) { return model.tex_pathadr; }  // with its alignment

// Boxes around geoms, a centre and half sides each: of geoms, and of the trees of bodies, whose frame is another. There
// boxes grow with the radius around the geom: a box that is too large costs time only. A ball's is as large as it is.
template <typename Own>
void set_box(mjModel& model, int geom, const double* half_sides, double growth, Own&& own) {
  std::copy_n(half_sides, 3, own(&mjModel::geom_aabb, 6 * static_cast<int>(model.ngeom)) + 6 * geom + 3);
  double* boxes = own(&mjModel::bvh_aabb, 6 * static_cast<int>(model.nbvhstatic));
  const int body = model.geom_bodyid[geom], first = model.body_bvhadr[body], count = model.body_bvhnum[body];
  const bool ball = count == 1 && model.geom_type[geom] == mjGEOM_SPHERE;
  for (int i = 6 * first; i < 6 * (first + count); ++i) {
    if (i % 6 >= 3) boxes[i] = ball ? half_sides[i % 6 - 3] : boxes[i] + std::max(growth, 0.0);
  }
}
// How far a radian of a ball's rotations moves its surface: what asks whether bodies are at rest.
template <typename Own>
void set_ball_length(mjModel& model, int body, double radius, Own&& own) {
  std::fill_n(own(&mjModel::dof_length, static_cast<int>(model.nv)) + model.body_dofadr[body] + 3, 3, radius);
}
template <typename Visit>
void visit_bounds(const mjModel& model, Visit&& visit) {
  visit("a box around a geom", &mjModel::geom_aabb, 6 * static_cast<int>(model.ngeom));
  visit("a box around geoms", &mjModel::bvh_aabb, 6 * static_cast<int>(model.nbvhstatic));
  visit("a length that a joint turns", &mjModel::dof_length, static_cast<int>(model.nv));
}

// What of a document makes room for contacts and constraints.
inline std::string room(const char*, const std::string&) { return "memory of <size>"; }

// The name of a size that is more than an int holds, in which sizes are counted here; NULL where none is. The arena and
// the buffer are counted in bytes, by MuJoCo only.
inline const char* too_large(const mjModel& model) {
#define X(name)                                                                                 \
  if (static_cast<const void*>(&model.name) != &model.narena &&                                 \
      static_cast<const void*>(&model.name) != &model.nbuffer && model.name > mjtSize{INT_MAX}) \
    return #name;
  MIMO_MODEL_SIZES
#undef X
  return nullptr;
}

// The flags by which a step goes.
inline void apply_locks(const mjModel& model, mjData& data) {
  std::copy_n(model.eq_active0, model.neq, data.eq_active);
}

inline int channels(const mjModel& model, int texture) { return model.tex_nchannel[texture]; }
inline bool is_directional(const mjModel& model, int light) { return model.light_type[light] == mjLIGHT_DIRECTIONAL; }

// Arrays of what is drawn: bytes of a pixel (null: 3), the texture of each material's colour and how far it is from one
// to the next, types of lights or else (null) whether they are directional.
inline const int* all_channels(const mjModel& model) { return model.tex_nchannel; }
inline constexpr int kTexturesOfMaterial = mjNTEXROLE;
inline const int* color_textures(const mjModel& model) { return model.mat_texid + mjTEXROLE_RGB; }
inline const int* light_types(const mjModel& model) { return model.light_type; }
inline const unsigned char* directional_lights(const mjModel&) { return nullptr; }

inline constexpr int kFlexGeom = mjGEOM_FLEX;
inline int flex_count(const mjModel& model) { return static_cast<int>(model.nflex); }
inline Flex flex(const mjModel& model, int id) {
  const int data = model.flex_elemdataadr[id], texture = model.flex_texcoordadr[id];
  return {model.flex_dim[id],
          model.flex_vertadr[id],
          model.flex_vertnum[id],
          model.flex_elemnum[id],
          model.flex_shellnum[id],
          model.flex_matid[id],
          model.flex_elem + data,
          model.flex_elemtexcoord + data,
          model.flex_shell + model.flex_shelldataadr[id],
          texture < 0 ? nullptr : model.flex_texcoord + 2 * texture,
          model.flex_rgba + 4 * id,
          model.flex_radius[id],
          model.flex_flatskin[id] != 0};
}
inline const double* flex_vertices(const mjData& data) { return data.flexvert_xpos; }

inline Sensor sensor(const mjModel& model, int camera) {
  const float *size = model.cam_sensorsize + 2 * camera, *intrinsic = model.cam_intrinsic + 4 * camera;
  return {{size[0], size[1]}, {intrinsic[0], intrinsic[1]}, {intrinsic[2], intrinsic[3]}};
}
inline bool is_orthographic(const mjModel& model, int camera) {
  return model.cam_projection[camera] == mjPROJ_ORTHOGRAPHIC;
}
inline bool is_free_orthographic(const mjModel& model) { return model.vis.global.orthographic != 0; }
// A camera of OpenGL whose picture is so wide; 0: as wide as its shape says.
inline void set_lens(mjvGLCamera& camera, bool orthographic, float width) {
  camera.orthographic = orthographic;
  camera.frustum_width = width;
}

// Corners of meshes' faces, counted from the mesh's first: of normals and of texture coordinates.
inline const int* face_normals(const mjModel& model) { return model.mesh_facenormal; }
inline const int* face_texcoords(const mjModel& model) { return model.mesh_facetexcoord; }
inline const int* first_normals(const mjModel& model) { return model.mesh_normaladr; }

inline void add_file(mjVFS& files, const char* name, const void* bytes, std::size_t size, int& result) {
  result = mj_addBufferVFS(&files, name, bytes, static_cast<int>(size));
}

// The model of a document among the files, NULL and why in `text` where it is wrong. Threads of the compiler would take
// the host's signals, and end the process where no thread can be had: it works in ours.
inline mjModel* load(const char* document, const mjVFS* files, char* text, int size) {
  mjSpec* spec = mj_parseXML(document, files, text, size);
  if (spec == nullptr) return nullptr;
  spec->compiler.usethread = 0;
  mjModel* model = mj_compile(spec, files);
  if (model == nullptr || mjs_isWarning(spec)) std::snprintf(text, size, "%s", mjs_getError(spec));
  mj_deleteSpec(spec);
  return model;
}

// Room on the stack until release: what take_stack gave since mark is free then.
using StackMark = std::size_t;
inline StackMark mark_stack(mjData& data) {
  mj_markStack(&data);
  return 0;
}
inline void release_stack(mjData& data, StackMark) { mj_freeStack(&data); }
inline void* take_stack(mjData& data, std::size_t bytes) { return mj_stackAllocByte(&data, bytes, alignof(mjtNum)); }
// Memory of one's own as the stack of a copy of mjData.
inline void give_stack(mjData& data, double* memory, int count) {
  data.arena = memory;
  data.narena = static_cast<mjtSize>(static_cast<std::size_t>(count) * sizeof(double));
  data.pstack = data.pbase = data.parena = 0;
}

inline int& iterations(mjData& data) { return data.solver_niter[0]; }
inline int iterations(const mjData& data) {
  return *std::max_element(data.solver_niter, data.solver_niter + std::max(1, std::min(data.nisland, +mjNISLAND)));
}
inline int& entries(mjData& data) { return data.solver_nnz[0]; }

// A row of the inertia's lower triangle, from the diagonal to the left.
template <typename Visit>
void visit_inertia(const mjModel& model, const mjData& data, int dof, Visit&& visit) {
  const int first = model.M_rowadr[dof];
  for (int at = first + model.M_rownnz[dof] - 1; at >= first; --at) visit(model.M_colind[at], data.M[at]);
}

// What else kinematics writes, and what else a step starts from.
template <typename Visit>
void visit_more_poses(const mjModel& model, Visit&& visit) {
  visit(&mjData::xiquat, static_cast<int>(4 * model.nbody));
  visit(&mjData::geom_xquat, static_cast<int>(4 * model.ngeom));
  visit(&mjData::site_xquat, static_cast<int>(4 * model.nsite));
}
template <typename Data, typename Visit>
void visit_more_state(const mjModel& model, Data& data, Visit&& visit) {
  visit("history", data.history, static_cast<int>(model.nhistory));
  visit("plastic", data.plastic, static_cast<int>(model.nplastic));
  visit("plugin_state", data.plugin_state, static_cast<int>(model.npluginstate));
}

// What MuJoCo's solver alone makes use of: which constraints belong together.
inline void leave_out_islands(mjOption& option) { option.disableflags |= mjDSBL_ISLAND; }

// Sensors of acceleration are computed once a step, and this one says whether that has been.
inline void expect_accelerations(mjData& data) { data.flg_rnepost = false; }

inline double ray_mesh(const mjModel& model, const mjData& data, int geom, const double* from, const double* along) {
  return mj_rayMesh(&model, &data, geom, from, along, nullptr);
}
inline double ray_field(const mjModel& model, const mjData& data, int geom, const double* from, const double* along) {
  return mj_rayHfield(&model, &data, geom, from, along, nullptr);
}
inline double ray_shape(const mjModel& model, const mjData& data, int geom, const double* from, const double* along) {
  return mju_rayGeom(data.geom_xpos + 3 * geom, data.geom_xmat + 9 * geom, model.geom_size + 3 * geom, from, along,
                     model.geom_type[geom], nullptr);
}

#else

inline constexpr auto kLockFlags = &mjModel::eq_active;
inline constexpr auto kPixels = &mjModel::tex_rgb;
inline constexpr auto kPixelsName = "tex_rgb";
inline const void* behind_pixels(const mjModel& model) { return model.mat_texid; }

template <typename Own>
void set_box(mjModel&, int, const double*, double, Own&&) {}
template <typename Own>
void set_ball_length(mjModel&, int, double, Own&&) {}
template <typename Visit>
void visit_bounds(const mjModel&, Visit&&) {}

inline std::string room(const char* size, const std::string& limit) { return std::string(size) + " above " + limit; }

inline const char* too_large(const mjModel&) { return nullptr; }  // they are ints

inline void apply_locks(const mjModel&, mjData&) {}

inline int channels(const mjModel&, int) { return 3; }
inline bool is_directional(const mjModel& model, int light) { return model.light_directional[light] != 0; }

inline const int* all_channels(const mjModel&) { return nullptr; }
inline constexpr int kTexturesOfMaterial = 1;
inline const int* color_textures(const mjModel& model) { return model.mat_texid; }
inline const int* light_types(const mjModel&) { return nullptr; }
inline const unsigned char* directional_lights(const mjModel& model) { return model.light_directional; }

inline constexpr int kFlexGeom = -1;
inline int flex_count(const mjModel&) { return 0; }
inline Flex flex(const mjModel&, int) { return {}; }
inline const double* flex_vertices(const mjData&) { return nullptr; }

inline Sensor sensor(const mjModel&, int) { return {}; }
inline bool is_orthographic(const mjModel&, int) { return false; }
inline bool is_free_orthographic(const mjModel&) { return false; }
inline void set_lens(mjvGLCamera&, bool, float) {}

inline const int* face_normals(const mjModel& model) { return model.mesh_face; }
inline const int* face_texcoords(const mjModel& model) { return model.mesh_face; }
inline const int* first_normals(const mjModel& model) { return model.mesh_vertadr; }

inline void add_file(mjVFS& files, const char* name, const void* bytes, std::size_t size, int& result) {
  result = mj_makeEmptyFileVFS(&files, name, static_cast<int>(size));
  if (result == 0) std::memcpy(files.filedata[files.nfile - 1], bytes, size);
}

inline mjModel* load(const char* document, const mjVFS* files, char* text, int size) {
  return mj_loadXML(document, files, text, size);
}

using StackMark = int;
inline StackMark mark_stack(mjData& data) { return data.pstack; }
inline void release_stack(mjData& data, StackMark mark) { data.pstack = mark; }
inline void* take_stack(mjData& data, std::size_t bytes) {
  return mj_stackAlloc(&data, static_cast<int>((bytes + sizeof(mjtNum) - 1) / sizeof(mjtNum)));
}
inline void give_stack(mjData& data, double* memory, int count) {
  data.stack = memory;
  data.nstack = count;
  data.pstack = 0;
}

inline int& iterations(mjData& data) { return data.solver_iter; }
inline int iterations(const mjData& data) { return data.solver_iter; }
inline int& entries(mjData& data) { return data.solver_nnz; }

template <typename Visit>
void visit_inertia(const mjModel& model, const mjData& data, int dof, Visit&& visit) {
  int address = model.dof_Madr[dof];
  for (int other = dof; other >= 0; other = model.dof_parentid[other]) visit(other, data.qM[address++]);
}

template <typename Visit>
void visit_more_poses(const mjModel&, Visit&&) {}
template <typename Data, typename Visit>
void visit_more_state(const mjModel&, Data&, Visit&&) {}

inline void leave_out_islands(mjOption&) {}
inline void expect_accelerations(mjData&) {}

inline double ray_mesh(const mjModel& model, const mjData& data, int geom, const double* from, const double* along) {
  return mj_rayMesh(&model, &data, geom, from, along);
}
inline double ray_field(const mjModel& model, const mjData& data, int geom, const double* from, const double* along) {
  return mj_rayHfield(&model, &data, geom, from, along);
}
inline double ray_shape(const mjModel& model, const mjData& data, int geom, const double* from, const double* along) {
  return mju_rayGeom(data.geom_xpos + 3 * geom, data.geom_xmat + 9 * geom, model.geom_size + 3 * geom, from, along,
                     model.geom_type[geom]);
}

#endif

}  // namespace mimo::compat
