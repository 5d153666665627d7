// The worlds of one description at all ages of their infants.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "blueprint/blueprint.h"
#include "growth/growth.h"

namespace mimo::blueprint {

// Who becomes what: nobody (none), all infants (one), or each agent (as many as there are; nothing: it stays).
using Ages = std::vector<std::optional<growth::Growth>>;
using Growths = std::vector<growth::Growth>;  // by agent

// Compiles each combination of ages once and keeps those that worlds live in, and of the others as many as make
// kKept with them, the last ones asked for. Thread-safe.
class WorldsByAge {
 public:
  static constexpr std::size_t kKept = 8;

  // How worlds are described with infants of certain ages, where that is not by letting infants of a scene grow: as
  // recordings do, which hold a document for each age.
  using DescribedAt = std::function<SceneEdit(const Growths&)>;

  // The log is that of the worlds.
  WorldsByAge(const SceneEdit& edit, const env::EnvOptions& options, const LogSink& log, DescribedAt described_at = {})
      : edit_(edit), options_(options), log_(log), described_at_(std::move(described_at)) {}
  const SceneEdit& as_described() const { return edit_; }
  // How they are described with infants of these ages. Throws what growing throws.
  SceneEdit described_at(const Growths& growths) const;
  // All as they are described, but for `ages`; what the compiler has to say goes to `scene_log`. Throws
  // Status::kInvalidArgument for agents that are no infants, and what growing and compiling throw.
  env::CompiledWorldPtr as_described(const Ages& ages, const LogSink& scene_log);
  // As in one of these, but for `ages`.
  env::CompiledWorldPtr grown(const env::CompiledWorld& now, const Ages& ages);

 private:
  struct Member {
    Growths growths;
    env::CompiledWorldPtr compiled;
  };

  env::CompiledWorldPtr find_or_compile(Growths growths, const LogSink& scene_log);
  env::CompiledWorldPtr compile(const Growths& growths, const LogSink& scene_log);
  void share_textures(env::CompiledWorld& compiled);
  env::CompiledWorldPtr find(const Growths& growths);
  void keep(Member member);

  const SceneEdit edit_;
  const env::EnvOptions options_;
  const LogSink log_;
  const DescribedAt described_at_;
  std::mutex mutex_;
  // Of the first model, for all that have the same.
  engine::ModelPtr painted_;
  std::shared_ptr<render::Shelf> textures_;
  std::vector<Member> members_;  // the last one asked for stands last
};

using WorldsByAgePtr = std::shared_ptr<WorldsByAge>;

}  // namespace mimo::blueprint
