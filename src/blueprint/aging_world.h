// A world whose infants may be of another age in its next episode, and the worlds of one description at all ages.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "blueprint/blueprint.h"
#include "env/description.h"
#include "env/world.h"
#include "growth/growth.h"

namespace mimo::blueprint {

// The worlds of one description at all ages of their infants.

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
  // All as described, except `ages`; what the compiler has to say goes to `scene_log`. Throws
  // Status::kInvalidArgument for agents that are no infants, and what growing and compiling throw.
  env::CompiledWorldPtr as_described(const Ages& ages, const LogSink& scene_log);
  // As in one of these, except `ages`.
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

// A world whose infants may be of another age in its next episode: a world of another model takes its place then.

// What worlds of a host have around them.
struct Surroundings {
  env::Identity identity;
  // What the world of a compiled one shares with others. Empty: what comes with the compiled world.
  std::function<env::Services(const env::CompiledWorldPtr& compiled)> services{};
  // Of several worlds, which takes in the bounds of all. Null: the world has a description of its own.
  env::LiveDescription* shared = nullptr;
};

class AgingWorld {
 public:
  // `worlds` may be null where infants never change.
  AgingWorld(WorldsByAgePtr worlds, env::CompiledWorldPtr compiled, Surroundings around);
  // By itself, in the state that another world is in.
  AgingWorld(const AgingWorld& original, const env::Identity& identity);
  AgingWorld(const AgingWorld&) = delete;
  AgingWorld& operator=(const AgingWorld&) = delete;

  env::World& world() const { return *world_; }  // until an episode with other infants
  const env::CompiledWorldPtr& compiled() const { return compiled_; }
  const WorldsByAgePtr& worlds() const { return worlds_; }
  const env::LiveDescription& description() const { return *description_; }

  // The compiled world with infants of these ages, else as they are now.
  env::CompiledWorldPtr with(const Ages& ages) const { return worlds_->grown(*compiled_, ages); }
  // Throws where worlds of another compiled one are not like this one in all but bounds.
  void require_alike(const env::CompiledWorldPtr& next) const;

  // An episode starts, with infants of these ages.
  void reset(const Ages& ages, const std::uint64_t* seed, std::uint8_t* block);
  // An episode starts in a world of another compiled one. Throws what a reset throws, and what require_alike does, and
  // then everything is as it was.
  void reset_as(const env::CompiledWorldPtr& next, const std::uint64_t* seed, std::uint8_t* block);
  // Agents become these; an episode starts where they are others than now.
  void grow(const Growths& growths);

 private:
  std::unique_ptr<env::World> make(const env::CompiledWorldPtr& compiled) const;
  void replace_world(std::unique_ptr<env::World> next, const std::uint64_t* seed, std::uint8_t* block);

  WorldsByAgePtr worlds_;
  env::CompiledWorldPtr compiled_;
  Surroundings around_;
  std::unique_ptr<env::World> world_;
  std::optional<env::LiveDescription> own_;
  env::LiveDescription* description_;
};

}  // namespace mimo::blueprint
