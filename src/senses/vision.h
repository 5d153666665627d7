// Pictures as observations: what the eyes see, and other cameras of the model.
#pragma once

#include <string>
#include <vector>

#include "body/body.h"
#include "mimo/agent.h"
#include "observation/sense.h"
#include "render/renderer.h"

namespace mimo::senses {

struct VisionOptions {
  std::uint32_t wanted = MIMO_VISION_RGB;  // MIMO_VISION_ bits
  int width = 256;
  int height = 256;
  double fovy = 0;       // degrees; 0: the camera's own
  double foveation = 0;  // of colour; 0: none
};

// A camera of the model, and what its fields are called.
struct Lens {
  std::string path;  // "vision/eye_left"
  int camera;
};

// The infant's eyes; all cameras that another agent carries. Throws Status::kNotFound where there are none.
std::vector<Lens> eyes(const mjModel& model, const body::Body& body);

class Vision : public observation::Sense {
 public:
  // The renderer outlives the sense.
  Vision(const mjModel& model, const std::vector<Lens>& lenses, const VisionOptions& options,
         render::Renderer& renderer);
  observation::Share share() const override { return observation::Share::kVision; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

 private:
  static constexpr int kNone = -1;
  // One camera and the fields that its picture goes to.
  struct View {
    int camera;
    int rgb, depth, segmentation;
  };

  int add(const std::string& name, observation::Type type, const char* unit, double low, double high);
  View view(const mjModel& model, const Lens& lens);
  template <typename T>
  T* pixels(std::uint8_t* block, int field) const {
    return field == kNone ? nullptr : at<T>(block, static_cast<std::size_t>(field));
  }

  VisionOptions options_;
  render::Renderer& renderer_;
  std::vector<View> views_;
};

}  // namespace mimo::senses
