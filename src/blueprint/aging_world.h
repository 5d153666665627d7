// A world whose infants may be of another age in its next episode: a world of another model takes its place then.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "blueprint/worlds_by_age.h"
#include "env/description.h"
#include "env/world.h"

namespace mimo::blueprint {

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
