#include "render/visual_scene.h"

#include <algorithm>
#include <iterator>

#include "base/fail.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "compat/mujoco.h"
#include "engine/guard.h"

namespace mimo::render {
namespace {

// Upper bound of what mjv_updateScene shows with default options. A full list would lose geoms, and MuJoCo would note
// a warning in mjData.
int most_shown(const mjModel& model) {
  constexpr int kCatenary = 64;  // pieces of a hanging tendon, at most
  return model.nskin + model.ngeom + model.nsite + 2 * model.nwrap + kCatenary * model.ntendon + 2 * model.nu +
         model.nsensor + 16;
}

// With the roundings of mjv_updateCamera, so that a view of a camera gives MuJoCo's own picture to the byte.
mjvGLCamera gl_camera(const mjModel& model, const View& view) {
  const auto near = static_cast<float>(model.vis.map.znear * model.stat.extent);
  const auto half = static_cast<float>(view.fovy * static_cast<float>(kPi / 360));
  const auto top = static_cast<float>(view.parallel ? view.fovy / 2 : near * fixed::tan(half));
  mjvGLCamera camera{};
  for (int i = 0; i < 3; ++i) {
    camera.pos[i] = static_cast<float>(view.position[i]);
    camera.up[i] = static_cast<float>(view.rotation(i, 1));
    camera.forward[i] = static_cast<float>(-view.rotation(i, 2));
  }
  camera.frustum_top = top;
  camera.frustum_bottom = -top;
  camera.frustum_near = near;
  camera.frustum_far = static_cast<float>(model.vis.map.zfar * model.stat.extent);
  compat::set_lens(camera, view.parallel, 0);
  if (!view.edges.given()) return camera;
  const auto at_near = [near](double slope) { return near * static_cast<float>(slope); };
  camera.frustum_top = at_near(view.edges.top);
  camera.frustum_bottom = at_near(view.edges.bottom);
  camera.frustum_center = at_near((view.edges.left + view.edges.right) / 2);
  compat::set_lens(camera, false, at_near((view.edges.right - view.edges.left) / 2));
  return camera;
}

}  // namespace

VisualScene::VisualScene(const mjModel& model, const Quality& quality, Shown shown) {
  mjv_defaultOption(&option_);
  if (shown == Shown::kExtras) {
    std::fill(std::begin(option_.geomgroup), std::end(option_.geomgroup), mjtByte{0});
    std::fill(std::begin(option_.sitegroup), std::end(option_.sitegroup), mjtByte{0});
    option_.flags[mjVIS_RANGEFINDER] = 0;
  }
  mjv_defaultScene(&scene_);
  const engine::Complaint complaint = engine::guarded([&] { mjv_makeScene(&model, &scene_, most_shown(model)); });
  if (complaint.failed) {
    mjv_freeScene(&scene_);
    fail(Status::kOutOfMemory, "no memory for the renderer's scene: {}", complaint.error.data());
  }
  scene_.flags[mjRND_SHADOW] = quality.shadows;
  scene_.flags[mjRND_REFLECTION] = quality.reflections;
  scene_.flags[mjRND_SKYBOX] = quality.skybox;
  scene_.flags[mjRND_HAZE] = quality.haze;
  scene_.flags[mjRND_FOG] = quality.fog;
  geoms_.reserve(static_cast<std::size_t>(scene_.maxgeom));
}

VisualScene::~VisualScene() { mjv_freeScene(&scene_); }

void VisualScene::update(const mjModel& model, const mjData& data, const View& view) {
  // MuJoCo averages two cameras, for left and right. They are set before the update, which centres infinite planes on
  // them: else the previous picture's camera would show in the next.
  scene_.camera[0] = scene_.camera[1] = gl_camera(model, view);
  parallel_ = view.parallel;
  // It writes to mjData only when the list is full (see most_shown), and takes mjData* for that.
  mjData* unchanged = const_cast<mjData*>(&data);
  const engine::Complaint complaint =
      engine::guarded([&] { mjv_updateScene(&model, unchanged, &option_, nullptr, nullptr, mjCAT_ALL, &scene_); });
  if (complaint.failed) fail(Status::kRender, "the scene cannot be drawn: {}", complaint.error.data());

  geoms_.clear();
  for (int i = 0; i < scene_.ngeom; ++i) {
    geoms_.push_back(scene_.geoms[i].objtype == mjOBJ_GEOM ? scene_.geoms[i].objid : -1);
  }
}

void VisualScene::show_ids(bool ids) { scene_.flags[mjRND_SEGMENT] = scene_.flags[mjRND_IDCOLOR] = ids; }

}  // namespace mimo::render
