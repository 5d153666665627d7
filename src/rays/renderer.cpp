#include "rays/renderer.h"

#include <algorithm>
#include <utility>

#include "base/fail.h"
#include "base/format.h"
#include "base/pool.h"
#include "engine/model.h"
#include "rays/extras.h"
#include "rays/frame.h"
#include "rays/painter.h"
#include "render/model_stage.h"

namespace mimo::rays {
namespace {

constexpr int kMostLampType = 2;  // cones, parallel light, points: the others of MuJoCo 4 are pictures

std::unique_ptr<Extras> extras_of(const mjModel& model, const Assets& assets) {
  return Extras::any(model) ? std::make_unique<Extras>(model, assets.surfaces) : nullptr;
}

class RayRenderer final : public render::Renderer {
 public:
  RayRenderer(engine::ModelPtr model, const Options& options)
      : model_(std::move(model)),
        assets_(options.assets ? options.assets : make_assets(model_)),
        painter_(options.simd),
        quality_(options),
        extras_(extras_of(*model_, *assets_)),
        frame_(render::stage_of(*model_), extras_ == nullptr ? 0 : extras_->most(), *assets_) {
    render::require_samples(options.samples);
    if (options.threads > 1) pool_ = std::make_unique<Pool>(static_cast<std::size_t>(options.threads));
  }

  void draw(const mjModel& model, const mjData& data, const render::View& view,
            const render::Picture& picture) override {
    if (picture.width < 1 || picture.height < 1) {
      fail(Status::kRender, "a picture of {} x {} pixels was asked for", picture.width, picture.height);
    }
    if (extras_ != nullptr) extras_->update(model, data, view);
    const Span<const Extra> extras = extras_ == nullptr ? Span<const Extra>() : extras_->now();
    frame_.prepare(render::stage_of(model), render::poses_of(data), extras, view,
                   static_cast<double>(picture.width) / picture.height, quality_);
    painter_.draw(frame_, view, picture, quality_.samples, pool_.get());
  }

 private:
  engine::ModelPtr model_;
  std::shared_ptr<const Assets> assets_;
  Painter painter_;
  render::Quality quality_;
  std::unique_ptr<Extras> extras_;  // null where the model has none
  Frame frame_;
  std::unique_ptr<Pool> pool_;  // null: the calling thread does it all
};

}  // namespace

std::shared_ptr<const Textures> make_textures(const engine::ModelPtr& model) {
  return std::make_shared<const Textures>(render::stage_of(*model).textures);
}

std::shared_ptr<const Assets> make_assets(const engine::ModelPtr& model, std::shared_ptr<const Textures> textures) {
  if (textures == nullptr) textures = make_textures(model);
  const auto triangles = std::make_shared<const Meshes>(render::stage_of(*model));
  return std::make_shared<const Assets>(std::move(textures), triangles, triangles,
                                        std::make_shared<const std::vector<MovingSurface>>(surfaces_of(model)));
}

std::vector<std::string> omissions(const mjModel& model) {
  std::vector<std::string> lines;
  const render::Lights lights = render::stage_of(model).lights;
  int shining = model.vis.headlight.active != 0 ? 1 : 0;
  for (int i = 0; i < lights.count; ++i) {
    if (!lights.active[i]) continue;
    const std::string own = engine::name(model, engine::Kind::kLight, i);
    const std::string light = own.empty() ? format("light {}", i) : format("light \"{}\"", own);
    if (lights.types != nullptr && lights.types[i] > kMostLampType) {
      lines.push_back(
          format("{} is drawn as a cone, since the ray renderer does not know its type {}", light, lights.types[i]));
    }
    if (++shining > kMaxLights) {
      lines.push_back(format("{} is not drawn: a picture has at most {} lights", light, kMaxLights));
    }
  }
  if (std::count(model.sensor_type, model.sensor_type + model.nsensor, +mjSENS_RANGEFINDER) > 0) {
    lines.push_back("beams of range finders are not drawn");
  }
  return lines;
}

std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr model, const Options& options) {
  return std::make_unique<RayRenderer>(std::move(model), options);
}

}  // namespace mimo::rays
