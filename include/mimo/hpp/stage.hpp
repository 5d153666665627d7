/**
 * @file mimo/hpp/stage.hpp
 * Pictures of what plain arrays describe. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_STAGE
#define MIMO_HPP_STAGE

#include <vector>

#include "configs.hpp"
#include "handles.hpp"

namespace mimo {
inline namespace v1_0 {

namespace detail {
inline void destroy_stage(mimo_stage *stage) { mimo_stage_destroy(stage); }
}  // namespace detail

/// A part of a stage, its poses or its config: zeros, except for its size.
template <typename Struct>
Struct stage_struct() {
  return detail::described<Struct>();
}

/// What a stage is in, with the library's defaults.
inline mimo_stage_air stage_air() {
  mimo_stage_air air;
  check(mimo_stage_air_init(&air, sizeof air));
  return air;
}

/// A picture without buffers, with the library's defaults.
inline mimo_stage_view stage_view() {
  mimo_stage_view view;
  check(mimo_stage_view_init(&view, sizeof view));
  return view;
}

/// Things that plain arrays describe, drawn without a simulation:
/// @code
///   auto geoms = mimo::stage_struct<mimo_stage_shapes>();
///   geoms.count = 1; geoms.forms = forms; geoms.sizes = sizes; geoms.colors = colors;
///   auto config = mimo::stage_struct<mimo_stage_config>();
///   config.geoms = &geoms;
///   mimo::Stage stage(config);
///   stage.draw(poses, view);
/// @endcode
class Stage : public Handle<mimo_stage, detail::destroy_stage> {
 public:
  explicit Stage(const mimo_stage_config &config) : Handle(make(config)) {}

  /// Replaces the parts that are given.
  void update(const mimo_stage_config &change) { check(mimo_stage_update(get(), &change)); }

  /// One picture.
  void draw(const mimo_stage_poses &poses, const mimo_stage_view &view) {
    const mimo_stage_poses *const one = &poses;
    const mimo_stage_view *const seen = &view;
    check(mimo_stage_draw(get(), &one, 1, &seen, 1));
  }
  /// Many pictures, of many poses: views say by number which of them they show.
  void draw(const std::vector<const mimo_stage_poses *> &poses, const std::vector<const mimo_stage_view *> &views) {
    check(mimo_stage_draw(get(), poses.data(), poses.size(), views.data(), views.size()));
  }

 private:
  static mimo_stage *make(const mimo_stage_config &config) {
    mimo_stage *stage = nullptr;
    check(mimo_stage_create(&config, &stage));
    return stage;
  }
};

}  // namespace v1_0
}  // namespace mimo

#endif
