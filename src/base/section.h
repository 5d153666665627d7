// A part of a state that has a name: what saves it, and what takes it back.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "base/bytes.h"

namespace mimo {

struct Section {
  std::string name;           // "physics", "delay/anna/touch/force"
  std::uint32_t version = 1;  // of its bytes; what has a lower one is read as well
  std::uint64_t kind = 0;     // what has to be the same for the bytes to mean anything: a hash of sizes and names
  bool essential = true;      // without it there is no going on; else it is a memory, which may start afresh

  // Always the same number of bytes.
  std::function<void(ByteWriter& to)> save;
  // A load that throws may leave it half loaded; what was there before is then loaded again.
  std::function<void(ByteReader& from)> load;
  // Where given, it throws for what load would not take, and load does not throw.
  std::function<void(ByteReader& from)> check;
  // Of a memory: starts afresh.
  std::function<void()> forget;
};

}  // namespace mimo
