// A stage of plain arrays, and its pictures.
#include "stage/stage.h"

#include <vector>

#include "capi/check.h"
#include "capi/handed.h"
#include "capi/objects.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

// A part of a config, read by its own size.
template <typename T>
class Part {
 public:
  Part(const T* theirs, const char* name) : given_(theirs != nullptr) {
    if (given_) ours_ = read_struct(theirs, name);
  }
  const T* get() const { return given_ ? &ours_ : nullptr; }

 private:
  bool given_;
  T ours_{};
};

// As long as this lives, what it gives does.
struct Parts {
  explicit Parts(const mimo_stage_config& config)
      : geoms(config.geoms, "geoms"),
        sites(config.sites, "sites"),
        meshes(config.meshes, "meshes"),
        fields(config.fields, "fields"),
        textures(config.textures, "textures"),
        materials(config.materials, "materials"),
        surfaces(config.surfaces, "surfaces"),
        tendons(config.tendons, "tendons"),
        lights(config.lights, "lights"),
        air(config.air, "air") {}

  stage::Given given() const {
    return {geoms.get(),     sites.get(),    meshes.get(),  fields.get(), textures.get(),
            materials.get(), surfaces.get(), tendons.get(), lights.get(), air.get()};
  }

  Part<mimo_stage_shapes> geoms, sites;
  Part<mimo_stage_meshes> meshes;
  Part<mimo_stage_fields> fields;
  Part<mimo_stage_textures> textures;
  Part<mimo_stage_materials> materials;
  Part<mimo_stage_surfaces> surfaces;
  Part<mimo_stage_tendons> tendons;
  Part<mimo_stage_lights> lights;
  Part<mimo_stage_air> air;
};

// The structs behind an array of pointers.
template <typename T>
std::vector<T> read_all(const T* const* theirs, std::size_t count, const char* argument) {
  std::vector<T> ours;
  for (const T* one : array(theirs, count, argument)) {
    require(one != nullptr, "{}[{}] is NULL", argument, ours.size());
    ours.push_back(read_struct(one, argument));
  }
  return ours;
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_stage_air_init(mimo_stage_air* air, size_t size) noexcept {
  return guard([&] { write_struct(air, size, stage::default_air(), "air"); });
}

mimo_status mimo_stage_view_init(mimo_stage_view* view, size_t size) noexcept {
  return guard([&] { write_struct(view, size, stage::default_view(), "view"); });
}

mimo_status mimo_stage_create(const mimo_stage_config* config, mimo_stage** stage) noexcept {
  return guard([&] {
    mimo_stage*& result = out(stage, "stage");
    require(config != nullptr, "config is NULL");
    const mimo_stage_config ours = read_struct(config, "config");
    require(ours.threads <= 256, "threads is {}, expected 1 to 256, or 0 for 1", ours.threads);
    const Parts parts(ours);
    const std::size_t threads = ours.threads == 0 ? 1 : ours.threads;
    result = wrap<mimo_stage>(std::make_unique<StageObject>(parts.given(), threads, log_sink(ours.log, ours.log_user)));
  });
}

void mimo_stage_destroy(mimo_stage* stage) noexcept { destroy(stage); }

mimo_status mimo_stage_update(mimo_stage* stage, const mimo_stage_config* config) noexcept {
  return guard(stage, [&] {
    stage::Stage& inside = open(stage).stage;
    require(config != nullptr, "config is NULL");
    const mimo_stage_config ours = read_struct(config, "config");
    require(ours.threads == 0, "threads is {}, expected 0: a stage keeps its threads", ours.threads);
    require(ours.log == nullptr, "log is given, expected NULL: a stage keeps its log");
    const Parts parts(ours);
    inside.update(parts.given());
  });
}

mimo_status mimo_stage_draw(mimo_stage* stage, const mimo_stage_poses* const* poses, size_t pose_count,
                            const mimo_stage_view* const* views, size_t view_count) noexcept {
  return guard(stage, [&] {
    stage::Stage& inside = open(stage).stage;
    require(pose_count > 0, "pose_count is 0, expected at least 1");
    inside.draw(read_all(poses, pose_count, "poses"), read_all(views, view_count, "views"));
  });
}

}  // extern "C"
