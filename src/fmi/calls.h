// What the functions of FMI 2 and FMI 3 do alike. An instance of either is a RunningUnit, and both versions give a
// status the same number.
#pragma once

#include <cstring>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

#include "fmi/unit.h"

namespace cli::fmi {

// Statuses of both versions.
constexpr int kOk = 0, kError = 3;

// Calls work(unit). What it throws cannot leave a function of C: it is logged, and becomes a status.
template <typename Status, typename Work>
Status guarded(void* instance, Work work) {
  auto* unit = static_cast<RunningUnit*>(instance);
  if (unit == nullptr) return Status(kError);
  try {
    work(*unit);
    return Status(kOk);
  } catch (const std::exception& error) {
    unit->log(error.what());
  } catch (...) {
    unit->log("an unknown error");
  }
  return Status(kError);
}

// A unit that logs by `say`, or null, and why is said. folder() is that of its resources.
template <typename Folder, typename Say>
RunningUnit* instantiate(Folder folder, const char* token, Say say) {
  try {
    auto unit = std::make_unique<RunningUnit>(folder(), token == nullptr ? "" : token);
    unit->log = say;
    return unit.release();
  } catch (const std::exception& error) {
    say(error.what());
  } catch (...) {
    say("an unknown error");
  }
  return nullptr;
}

// States of units, which importers keep.

inline const Bytes& bytes_of(const void* state) {
  if (state == nullptr) throw std::runtime_error("the state is NULL");
  return *static_cast<const Bytes*>(state);
}

inline void keep_state(void** state, Bytes bytes) {
  if (*state == nullptr) *state = new Bytes;
  static_cast<Bytes*>(*state)->swap(bytes);
}

inline void free_state(void** state) {
  if (state == nullptr) return;
  delete static_cast<Bytes*>(*state);
  *state = nullptr;
}

inline void write_state(const void* state, void* bytes, std::size_t size) {
  const Bytes& from = bytes_of(state);
  if (size < from.size()) {
    throw std::runtime_error("size is " + std::to_string(size) + ", expected " + std::to_string(from.size()));
  }
  std::memcpy(bytes, from.data(), from.size());
}

}  // namespace cli::fmi
