#include "stage/stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <mutex>
#include <utility>

#include "base/fail.h"
#include "base/header.h"
#include "base/numbers.h"
#include "base/pool.h"
#include "common/ranges.h"
#include "rays/frame.h"
#include "rays/painter.h"
#include "stage/arrays.h"
#include "stage/parts.h"
#include "stage/poses.h"

namespace mimo::stage {
namespace {

constexpr std::uint32_t kLargest = ranges::stage_view::width.high;
constexpr std::uint32_t kAllGroups = 0x3f;

// ---- What views may be --------------------------------------------------------------------------------------

// A buffer of so many rows, each `row` long and `stride` from the next.
void check_buffer(const void* buffer, std::size_t length, std::size_t stride, std::size_t row, std::size_t rows,
                  const char* name, std::size_t which) {
  if (buffer == nullptr) {
    require(length == 0, "views[{}]: {} is NULL, but its length is {}", which, name, length);
    return;
  }
  require(stride == 0 || stride >= row, "views[{}]: {}_stride is {}, expected at least {}, a row", which, name, stride,
          row);
  const std::size_t step = stride == 0 ? row : stride;
  constexpr std::size_t kMost = PTRDIFF_MAX / kLargest;
  require(step <= kMost, "views[{}]: {}_stride is {}, but no memory holds that", which, name, stride);
  const std::size_t needed = step * (rows - 1) + row;
  require(length <= PTRDIFF_MAX, "views[{}]: {} has a length of {}, but no memory holds that", which, name, length);
  if (length < needed) {
    fail(Status::kBufferTooSmall, "views[{}]: {} has a length of {}, but {} are needed", which, name, length, needed);
  }
}

void check_camera(const mimo_stage_view& view, std::size_t which) {
  const auto check = [&](const double* numbers, std::size_t count, const char* name) {
    require(numbers != nullptr, "views[{}]: {} is NULL, expected {} numbers", which, name, count);
    for (std::size_t i = 0; i < count; ++i) {
      require(std::abs(numbers[i]) < kFarthest, "views[{}]: {}[{}] is {}, expected a finite number", which, name, i,
              numbers[i]);
    }
  };
  check(view.position, 3, "position");
  check(view.rotation, 9, "rotation");
  if (view.ortho_height != 0) {
    require(view.ortho_height >= 1e-6 && view.ortho_height < kFarthest,
            "views[{}]: ortho_height is {}, expected metres above 0", which, view.ortho_height);
    require(view.focal_x == 0 && view.focal_y == 0,
            "views[{}]: ortho_height is {}, but focal lengths are given, which orthographic cameras do not have", which,
            view.ortho_height);
    return;
  }
  if (view.focal_x == 0 && view.focal_y == 0) {
    require(view.fovy > 0 && view.fovy < 180, "views[{}]: fovy is {}, expected degrees above 0 and below 180", which,
            view.fovy);
    return;
  }
  const auto check_pixels = [&](double value, const char* name, double low, double high, const char* expected) {
    require(value > low && value < high, "views[{}]: {} is {}, expected {}", which, name, value, expected);
  };
  check_pixels(view.focal_x, "focal_x", 1e-3, 1e9, "pixels above 0.001");
  check_pixels(view.focal_y, "focal_y", 1e-3, 1e9, "pixels above 0.001");
  check_pixels(view.center_x, "center_x", -1e6, 1e6, "pixels");
  check_pixels(view.center_y, "center_y", -1e6, 1e6, "pixels");
}

void check_view(const mimo_stage_view& view, std::size_t poses, std::size_t which) {
  require(view.pose < poses, "views[{}]: pose is {}, but there are {} poses", which, view.pose, poses);
  require(view.width >= 1 && view.width <= kLargest, "views[{}]: width is {}, expected 1 to {}", which, view.width,
          kLargest);
  require(view.height >= 1 && view.height <= kLargest, "views[{}]: height is {}, expected 1 to {}", which, view.height,
          kLargest);
  const auto check_bits = [&](std::uint32_t bits, std::uint32_t known, const char* name) {
    if ((bits & ~known) == 0) return;
    fail(Status::kUnsupported, "views[{}]: {} is {:#x}, but this library knows bits of {:#x}", which, name, bits,
         known);
  };
  check_bits(view.render, header::kRender, "render");
  check_bits(view.geom_groups, kAllGroups, "geom_groups");
  check_bits(view.site_groups, kAllGroups, "site_groups");
  check_bits(view.surface_groups, kAllGroups, "surface_groups");
  check_bits(view.tendon_groups, kAllGroups, "tendon_groups");
  render::require_samples(view.samples);
  check_camera(view, which);
  const std::size_t width = view.width, height = view.height;
  check_buffer(view.rgb, view.rgb_bytes, view.rgb_stride, 3 * width, height, "rgb", which);
  check_buffer(view.depth, view.depth_count, view.depth_stride, width, height, "depth", which);
  check_buffer(view.segmentation, view.segmentation_count, view.segmentation_stride, 2 * width, height, "segmentation",
               which);
}

// ---- From views to what renderers take ----------------------------------------------------------------------

render::View camera_of(const mimo_stage_view& view) {
  render::View camera;
  camera.position = Eigen::Map<const Eigen::Vector3d>(view.position);
  camera.rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(view.rotation);
  camera.parallel = view.ortho_height != 0;
  camera.fovy = camera.parallel ? view.ortho_height : view.fovy;
  if (view.focal_x != 0) {
    camera.edges.left = -view.center_x / view.focal_x;
    camera.edges.right = (view.width - view.center_x) / view.focal_x;
    camera.edges.top = view.center_y / view.focal_y;
    camera.edges.bottom = (view.center_y - view.height) / view.focal_y;
  }
  return camera;
}

render::Quality quality_of(const mimo_stage_view& view) {
  render::Quality quality;
  quality.shadows = has_bit(view.render, MIMO_RENDER_SHADOWS);
  quality.reflections = has_bit(view.render, MIMO_RENDER_REFLECTIONS);
  quality.skybox = has_bit(view.render, MIMO_RENDER_SKY);
  quality.haze = has_bit(view.render, MIMO_RENDER_HAZE);
  quality.fog = has_bit(view.render, MIMO_RENDER_FOG);
  quality.samples = static_cast<int>(view.samples);
  return quality;
}

}  // namespace

mimo_stage_view default_view() {
  mimo_stage_view view{};
  view.struct_size = sizeof view;
  view.width = 320;
  view.height = 240;
  view.render = header::kRender & ~MIMO_RENDER_FOG;
  view.geom_groups = view.site_groups = view.surface_groups = view.tendon_groups = render::kUsualGroups;
  view.fovy = 45;
  return view;
}

// ---- Drawing ------------------------------------------------------------------------------------------------

// What one thread draws with.
class Hand {
 public:
  explicit Hand(const Parts& parts) : parts_(&parts), mover_(parts) {}

  // Other parts take the place of those that it has; false where its memory does not fit them.
  bool adopt(const Parts& parts) {
    if (parts.assets() != parts_->assets() || size_of(parts) != size_of(*parts_)) return false;
    parts_ = &parts;
    mover_.adopt(parts);
    return true;
  }

  // Forgets the last poses, whose memory the host may have changed.
  void begin() { at_ = nullptr; }

  void draw(const mimo_stage_poses& poses, const mimo_stage_view& view, const rays::Painter& painter, Pool* pool) {
    if (at_ != &poses) mover_.take(poses);
    at_ = &poses;
    mover_.gather_extras(view);
    make_room(mover_.extras().size());
    const render::View camera = camera_of(view);
    const render::Quality quality = quality_of(view);
    frame_->prepare(mover_.shown(view), mover_.places(), mover_.extras(), camera,
                    static_cast<double>(view.width) / view.height, quality);
    render::Picture picture;
    picture.width = static_cast<int>(view.width);
    picture.height = static_cast<int>(view.height);
    picture.rgb = view.rgb;
    picture.row_bytes = view.rgb_stride;
    picture.depth = view.depth;
    picture.depth_row = view.depth_stride;
    if (view.segmentation != nullptr) {
      ids_.resize(std::max(ids_.size(), static_cast<std::size_t>(view.width) * view.height));
      picture.segmentation = ids_.data();
    }
    painter.draw(*frame_, camera, picture, quality.samples, pool);
    if (view.segmentation != nullptr) write_objects(view);
  }

 private:
  // What the memory of a frame depends on, beside the extras.
  static std::array<std::size_t, 3> size_of(const Parts& parts) {
    const std::vector<unsigned char>& shadows = parts.lights().casts_shadow;
    return {parts.geoms().forms.size(), parts.sites().forms.size(),
            shadows.size() - static_cast<std::size_t>(std::count(shadows.begin(), shadows.end(), 0))};
  }

  void make_room(std::size_t extras) {
    if (frame_ != nullptr && extras <= room_) return;
    room_ = extras + extras / 2;
    frame_.reset();
    frame_ = std::make_unique<rays::Frame>(parts_->view(), room_, *parts_->assets());
  }

  // Numbers become pairs of an id and a type. Pixels side by side are mostly of one object.
  void write_objects(const mimo_stage_view& view) const {
    const std::size_t stride = view.segmentation_stride == 0 ? std::size_t{2} * view.width : view.segmentation_stride;
    std::int32_t last = -1;
    std::array<int, 2> object = mover_.object(last);
    for (std::size_t row = 0; row < view.height; ++row) {
      const std::int32_t* from = ids_.data() + row * view.width;
      std::int32_t* to = view.segmentation + row * stride;
      for (std::size_t column = 0; column < view.width; ++column, to += 2) {
        if (from[column] != last) object = mover_.object(last = from[column]);
        to[0] = object[0];
        to[1] = object[1];
      }
    }
  }

  const Parts* parts_;
  Mover mover_;
  const mimo_stage_poses* at_ = nullptr;
  std::size_t room_ = 0;  // for extras
  std::unique_ptr<rays::Frame> frame_;
  std::vector<std::int32_t> ids_;
};

class Stage::Inside {
 public:
  Inside(const Given& given, std::size_t threads, LogSink log)
      : parts_(std::make_unique<const Parts>(given)), log_(std::move(log)), hands_(threads) {
    if (threads > 1) pool_ = std::make_unique<Pool>(threads);
    tell_omissions();
  }

  void update(const Given& given) {
    auto parts = std::make_unique<const Parts>(*parts_, given);
    for (auto& hand : hands_) {
      if (hand != nullptr && !hand->adopt(*parts)) hand.reset();
    }
    parts_ = std::move(parts);
    tell_omissions();
  }

  void draw(Span<const mimo_stage_poses> poses, Span<const mimo_stage_view> views);

 private:
  class Pictures;

  void tell_omissions() {
    if (!log_) return;
    for (std::string& line : parts_->omissions()) {
      if (std::find(told_.begin(), told_.end(), line) != told_.end()) continue;
      log_(LogLevel::kWarning, line);
      told_.push_back(std::move(line));
    }
  }

  Hand& hand(std::size_t thread) {
    if (hands_[thread] == nullptr) hands_[thread] = std::make_unique<Hand>(*parts_);
    return *hands_[thread];
  }

  std::unique_ptr<const Parts> parts_;
  LogSink log_;
  std::vector<std::string> told_;
  rays::Painter painter_;
  std::unique_ptr<Pool> pool_;                // null: the calling thread does it all
  std::vector<std::unique_ptr<Hand>> hands_;  // one for each thread; null until it draws
};

// Each view is a piece of work for one thread.
class Stage::Inside::Pictures final : public Job {
 public:
  Pictures(Inside& stage, Span<const mimo_stage_poses> poses, Span<const mimo_stage_view> views)
      : stage_(stage), poses_(poses), views_(views) {}

  void run(std::size_t item, std::size_t thread) noexcept override {
    try {
      draw(item, thread, nullptr);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
  }
  void draw(std::size_t item, std::size_t thread, Pool* pool) {
    const mimo_stage_view& view = views_[item];
    stage_.hand(thread).draw(poses_[view.pose], view, stage_.painter_, pool);
  }
  void finish() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  Inside& stage_;
  Span<const mimo_stage_poses> poses_;
  Span<const mimo_stage_view> views_;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

void Stage::Inside::draw(Span<const mimo_stage_poses> poses, Span<const mimo_stage_view> views) {
  for (std::size_t i = 0; i < poses.size(); ++i) check_poses(*parts_, poses[i], i);
  for (std::size_t i = 0; i < views.size(); ++i) check_view(views[i], poses.size(), i);
  for (auto& hand : hands_) {
    if (hand != nullptr) hand->begin();
  }
  Pictures pictures(*this, poses, views);
  if (pool_ != nullptr && views.size() >= pool_->threads()) {
    pool_->run(pictures, views.size());
    return pictures.finish();
  }
  for (std::size_t i = 0; i < views.size(); ++i) pictures.draw(i, 0, pool_.get());
}

Stage::Stage(const Given& given, std::size_t threads, LogSink log)
    : inside_(std::make_unique<Inside>(given, threads, std::move(log))) {}

Stage::~Stage() = default;

void Stage::update(const Given& given) { inside_->update(given); }

void Stage::draw(Span<const mimo_stage_poses> poses, Span<const mimo_stage_view> views) { inside_->draw(poses, views); }

}  // namespace mimo::stage
