// What MuJoCo's compiler knows of MJCF: elements, where they may stand, and their attributes.
#pragma once

#include <map>
#include <set>
#include <string>

namespace mimo::engine {

struct SchemaElement {
  std::set<std::string, std::less<>> attributes;
  std::map<std::string, SchemaElement, std::less<>> children;
  bool nests = false;  // may hold itself, like <body>
};

// The element <mujoco>, asked of the MuJoCo that runs; the same object every time.
const SchemaElement& schema();

// Whether a MuJoCo 2 runs, whose documents newer versions do not all understand, nor it theirs.
bool is_mujoco_2();

// How many bytes a model can have: MuJoCo 2 counts them in an int, and crashes where that wraps.
double most_model_bytes();

// "MuJoCo 2.2.2", the one that runs.
std::string compiler_name();

}  // namespace mimo::engine
