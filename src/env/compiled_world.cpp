#include "env/compiled_world.h"

#include <array>

#include "base/fail.h"
#include "opengl/renderer.h"
#include "rays/renderer.h"
#include "render/renderer.h"

namespace mimo::env {
namespace {

constexpr std::array<const char*, 5> kNames{"auto", "ray", "osmesa", "gl", "none"};  // as RendererChoice numbers them

std::unique_ptr<render::Renderer> make_rays(const engine::ModelPtr& model, const render::Quality& quality,
                                            const Services& services) {
  rays::Options options(quality);
  const auto textures = [&] { return rays::make_textures(model); };
  const auto assets = [&] {
    for (const std::string& line : rays::omissions(*model)) services.log(LogLevel::kWarning, line);
    return rays::make_assets(model, services.textures == nullptr ? nullptr : services.textures->get(textures));
  };
  options.assets = services.shelf != nullptr ? services.shelf->get(assets) : assets();
  return rays::make_renderer(model, options);
}

}  // namespace

// Which renderer a world gets.

RendererChoice renderer_from(const std::string& name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames[i]) return static_cast<RendererChoice>(i);
  }
  fail(Status::kInvalidArgument, "renderer is \"{}\", expected auto, ray, osmesa, gl or none", name);
}

std::unique_ptr<render::Renderer> make_renderer(const engine::ModelPtr& model, const EnvOptions& options,
                                                const Services& services) {
  const RendererChoice choice = options.renderer;
  const auto by = [&](const opengl::PlatformPtr& platform) {
    return opengl::make_renderer(model, options.quality, services.log, platform);
  };
  if (choice == RendererChoice::kOsmesa) return by(opengl::osmesa());
  if (choice == RendererChoice::kGl) return by(opengl::egl());
  try {
    return make_rays(model, options.quality, services);
  } catch (const Error& error) {
    const bool is_last = choice == RendererChoice::kRay || !opengl::kExists;
    if (is_last || error.status() != Status::kUnsupported) throw;
    services.log(LogLevel::kInfo, "drawing with OSMesa: " + error.message());
    return by(opengl::osmesa());
  }
}

// Skins that worlds share.

SkinPtr Skins::of(std::size_t agent) const {
  const std::lock_guard lock(mutex_);
  return agent < all_.size() ? all_[agent] : nullptr;
}

void Skins::keep(std::size_t agent, const SkinPtr& skin) {
  const std::lock_guard lock(mutex_);
  if (all_.size() <= agent) all_.resize(agent + 1);
  if (all_[agent] == nullptr) all_[agent] = skin;
}

}  // namespace mimo::env
