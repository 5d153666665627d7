// What draws pictures: views, pictures and their quality. A renderer belongs to one model and may be used by any
// thread, one at a time.
#pragma once

#include <Eigen/Core>
#include <any>
#include <cstdint>
#include <memory>
#include <mutex>

#include "base/pinhole.h"

typedef struct mjData_ mjData;
typedef struct mjModel_ mjModel;

namespace mimo::render {

// Where a picture is taken from: an eye in the world.
struct View {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // world, m
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();  // columns are right, up and backward in the world
  double fovy = 60;       // vertical field of view, degrees; of an orthographic camera the height that it shows, m
  bool parallel = false;  // it is orthographic: all rays go ahead
  // Of a pinhole that is not before the middle of square pixels: slopes (over depth) of the picture's edges, which then
  // count instead of fovy and the picture's shape.
  struct Edges {
    double left = 0, right = 0, bottom = 0, top = 0;
    bool given() const { return right > left && top > bottom; }
  } edges;

  // Of a view without edges: from the middle of the picture to its upper edge, as a slope, or of parallel rays in
  // metres.
  double half_height() const;
};

// What is wanted; null pointers are not. Row 0 is the top.
struct Picture {
  int width = 0;
  int height = 0;
  std::uint8_t* rgb = nullptr;           // height x width x 3
  float* depth = nullptr;                // height x width, m along the camera's axis; far plane where nothing is
  std::int32_t* segmentation = nullptr;  // height x width, geom id; -1 where nothing is
  // From one row to the next: bytes, and numbers; 0: as the width says. Only rays draw with others.
  std::size_t row_bytes = 0, depth_row = 0, segmentation_row = 0;
};

// How good pictures are, against what they cost. MuJoCo's switches of these names, and as it sets them.
struct Quality {
  bool shadows = true;
  bool reflections = true;
  bool skybox = true;
  bool haze = true;  // the strip of haze that MuJoCo draws at the horizon of an endless plane
  bool fog = false;
  int samples = 0;  // a pixel, for smooth edges: 1, 4, 16 or 64; 0: one ray, or what the model tells OpenGL
  int threads = 1;  // that draw one picture, the caller's among them; OpenGL has its own. Pictures do not differ.
};

// Throws for a number of samples that is not known.
void require_samples(std::int64_t samples);

class Renderer {
 public:
  virtual ~Renderer() = default;
  // Draws the poses that `data` holds (as of the last kinematics); writes nothing but the picture.
  // Throws Status::kRender.
  virtual void draw(const mjModel& model, const mjData& data, const View& view, const Picture& picture) = 0;
};

// What renderers of one model share, see shelf.h.
class Shelf;
std::shared_ptr<Shelf> make_shelf();

// The view of a camera of the model, at its current pose; fovy 0 means the camera's own, or its sensor and lens.
View camera_view(const mjModel& model, const mjData& data, int camera, double fovy = 0);
// The same wherever the camera is: how wide it sees.
View lens_of(const mjModel& model, int camera, double fovy);

// The view of a free camera that looks at a point; angles in degrees as MuJoCo's free camera.
View orbit_view(const Eigen::Vector3d& look_at, double distance, double azimuth, double elevation, double fovy);

// From where somebody wants to look: by a camera of the model, or by a free one.

struct Viewpoint {
  int camera = -1;  // of the model; -1: the free one, which looks at a point
  double fovy = 0;  // degrees; 0: the camera's own, for the free one the model's
  Eigen::Vector3d look_at = Eigen::Vector3d::Zero();
  double distance = 1;
  double azimuth = 0, elevation = 0;  // degrees, as MuJoCo's free camera
};

// Cameras of the model are where `data` has them.
View view_from(const mjModel& model, const mjData& data, const Viewpoint& from);

// Where the world's points appear in a picture.

// How a view maps what it sees onto a picture of so many pixels.
Pinhole pinhole_of(const View& view, double width, double height);

// Pixels right and pixels down from the picture's upper left corner, and the depth, m: negative behind the camera.
Eigen::Vector3d project(const View& view, double width, double height, const Eigen::Vector3d& point);

// Where renderers of one model find what they can share, made by the first that asks.

// For renderers of one kind; thread-safe.
class Shelf {
 public:
  // What `make` gives, or gave.
  template <typename Make>
  auto get(Make&& make) {
    const std::lock_guard lock(mutex_);
    if (!assets_.has_value()) assets_ = make();
    return std::any_cast<decltype(make())>(assets_);
  }

 private:
  std::mutex mutex_;
  std::any assets_;
};

}  // namespace mimo::render
