// mimo replay --motion: a world follows a movement that is known.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "motion/retarget.h"
#include "programs/world.h"

namespace cli {

struct FollowOptions {
  WorldOptions world;
  RetargetOptions skeleton;
  std::string motion, forces, joints;  // files; "" for none
  bool degrees = false, json = false;
};

// Options that only go with --motion, which is the one that is returned.
CLI::Option* add_follow_options(CLI::App& command, FollowOptions& options);

void follow(const FollowOptions& options);

}  // namespace cli
