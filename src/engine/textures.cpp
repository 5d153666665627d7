#include "engine/textures.h"

#include <algorithm>

#include "compat/mujoco.h"
#include "engine/guard.h"

namespace mimo::engine {
namespace {

bool have_the_same(const mjModel& a, const mjModel& b) {
  const auto same = [&](auto* mjModel::*array, int count) { return std::equal(a.*array, a.*array + count, b.*array); };
  return a.ntex == b.ntex && a.ntexdata == b.ntexdata && same(&mjModel::tex_type, a.ntex) &&
         same(&mjModel::tex_height, a.ntex) && same(&mjModel::tex_width, a.ntex) && same(&mjModel::tex_adr, a.ntex) &&
         same(compat::kPixels, a.ntexdata);
}

// All but the textures' bytes; null where MuJoCo does not lay out its models as we know it.
mjModel* copy_without_textures(const mjModel& model) {
  mjModel source = model;
  const auto* end = static_cast<const mjtByte*>(compat::behind_pixels(model));
  source.nbuffer -= static_cast<int>(end - model.*compat::kPixels);
  source.ntexdata = 0;
  mjModel* copy = nullptr;
  const Complaint complaint = guarded([&] { copy = mj_copyModel(nullptr, &source); });
  return complaint.failed ? nullptr : copy;
}

}  // namespace

ModelPtr with_textures_of(const ModelPtr& owner, ModelPtr model) {
  if (model == owner || model->ntexdata == 0 || !have_the_same(*owner, *model)) return model;
  mjModel* slim = copy_without_textures(*model);
  if (slim == nullptr) return model;
  slim->nbuffer = model->nbuffer;  // as it says of itself it is the same, for MuJoCo that copies it, and for states
  slim->ntexdata = model->ntexdata;
  slim->*compat::kPixels = (*owner).*compat::kPixels;
  return ModelPtr(slim, [owner](mjModel* one) { mj_deleteModel(one); });
}

bool share_textures(const mjModel& one, const mjModel& other) { return one.*compat::kPixels == other.*compat::kPixels; }

}  // namespace mimo::engine
