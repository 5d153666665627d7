// What the eyes see: pictures of the two eye cameras.
#pragma once

#include "body/body.h"
#include "render/renderer.h"
#include "senses/sense.h"

namespace mimo::senses {

struct VisionOptions {
  bool rgb = true;
  bool depth = false;
  bool segmentation = false;
  int width = 256;
  int height = 256;
  double fovy = 0;  // degrees; 0: the camera's own

  bool any() const { return rgb || depth || segmentation; }
};

class Vision : public Sense {
 public:
  // The renderer outlives the sense.
  Vision(const mjModel& model, const body::Body& body, const VisionOptions& options, render::Renderer& renderer);
  Part part() const override { return Part::kVision; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;

 private:
  static constexpr int kNone = -1;
  // One camera and the fields that its picture goes to.
  struct Eye {
    int camera;
    int rgb, depth, segmentation;
  };

  int add(const std::string& name, Type type, const char* unit, double low, double high);
  Eye eye(const mjModel& model, const char* name, int camera);
  template <typename T>
  T* pixels(std::uint8_t* block, int field) const {
    return field == kNone ? nullptr : at<T>(block, static_cast<std::size_t>(field));
  }

  VisionOptions options_;
  render::Renderer& renderer_;
  std::vector<Eye> eyes_;
};

}  // namespace mimo::senses
