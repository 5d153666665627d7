// What draws pictures. A renderer belongs to one model and may be used by any thread, one at a time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "base/log.h"
#include "engine/model.h"

typedef struct mjData_ mjData;

namespace mimo::render {

// Where a picture is taken from: an eye in the world.
struct View {
  std::array<double, 3> position{};  // world, m
  std::array<double, 9> rotation{};  // row-major; columns are right, up and backward in the world
  double fovy = 60;                  // vertical field of view, degrees
};

// What is wanted; null pointers are not. Row 0 is the top.
struct Picture {
  int width = 0;
  int height = 0;
  std::uint8_t* rgb = nullptr;           // height x width x 3
  float* depth = nullptr;                // height x width, m along the camera's axis; far plane where nothing is
  std::int32_t* segmentation = nullptr;  // height x width, geom id; -1 where nothing is
};

class Renderer {
 public:
  virtual ~Renderer() = default;
  // Draws the poses that `data` holds (as of the last kinematics); writes nothing but the picture.
  // Throws Status::kRender.
  virtual void draw(const mjModel& model, const mjData& data, const View& view, const Picture& picture) = 0;
};

// MuJoCo's own pictures through OSMesa, which is loaded at run time. Throws Status::kUnsupported where it is absent.
std::unique_ptr<Renderer> make_osmesa_renderer(engine::ModelPtr model, const LogSink& log);

// By name: "ray", "osmesa", or "auto": rays where the model allows it, else OSMesa, which is said in the log.
std::unique_ptr<Renderer> make_renderer(const std::string& name, const engine::ModelPtr& model, const LogSink& log);

// The view of a camera of the model, at its current pose; fovy 0 means the camera's own.
View camera_view(const mjModel& model, const mjData& data, int camera, double fovy = 0);

// The view of a free camera that looks at a point; angles in degrees as MuJoCo's free camera.
View orbit_view(const std::array<double, 3>& look_at, double distance, double azimuth, double elevation, double fovy);

}  // namespace mimo::render
