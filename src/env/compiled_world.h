// Everything that worlds are made of, when a scene has been compiled for certain ages of its infants.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "base/log.h"
#include "engine/model.h"
#include "env/options.h"
#include "render/renderer.h"
#include "senses/touch/skin.h"

namespace mimo::env {

using SkinPtr = std::shared_ptr<const senses::touch::Skin>;

// The skins of a model's agents, which its worlds have in common. Thread-safe.
class Skins {
 public:
  // Null until a renderer is set.
  SkinPtr of(std::size_t agent) const;
  // The first one that is brought stays.
  void keep(std::size_t agent, const SkinPtr& skin);

 private:
  mutable std::mutex mutex_;
  std::vector<SkinPtr> all_;
};

// What a world does not make itself, and may share with others of the same model.
struct Services {
  std::shared_ptr<render::Shelf> shelf;        // what renderers of one model have in common; null: each has its own
  std::shared_ptr<render::Shelf> textures;     // the textures, also in common with other models; null: as the shelf
  std::shared_ptr<Skins> skins;                // null: each world makes its own
  std::shared_ptr<render::Renderer> renderer;  // draws for a world; null: it makes its own
  LogSink log;
};

struct CompiledWorld {
  engine::ModelPtr model;
  std::vector<AgentOptions> agents;
  EnvOptions options;
  Services services;
};
using CompiledWorldPtr = std::shared_ptr<const CompiledWorld>;

// Makes the renderer that the options ask for; the shelf belongs to this very model. Throws Status::kUnsupported where
// it does not work here.
std::unique_ptr<render::Renderer> make_renderer(const engine::ModelPtr& model, const EnvOptions& options,
                                                const Services& services);

}  // namespace mimo::env
