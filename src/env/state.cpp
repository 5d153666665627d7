#include "env/state.h"

#include "base/fail.h"
#include "base/hash.h"
#include "engine/fingerprint.h"
#include "env/world.h"

namespace mimo::env {
namespace {

constexpr std::uint64_t kMagic = 0x54415453'4f4d494d;  // "MIMOSTAT" where bytes lie as on x86-64
constexpr std::uint64_t kVersion = 1;
constexpr std::size_t kChecksumAt = kStateHeaderBytes - sizeof(std::uint64_t);

// Of everything but itself.
std::uint64_t checksum(Span<const std::uint8_t> state) {
  Hash hash;
  hash.add(state.part(0, kChecksumAt));
  hash.add(state.part(kStateHeaderBytes, state.size() - kStateHeaderBytes));
  return hash.value();
}

}  // namespace

void seal_state(const StateFormat& format, Span<std::uint8_t> state) {
  ByteWriter header(state.part(0, kStateHeaderBytes));
  header.put(kMagic);
  header.put(kVersion);
  header.put(std::uint64_t{format.bytes});
  header.put(format.model);
  header.put(format.layout);
  header.put(checksum({state.data(), state.size()}));
}

Span<const std::uint8_t> open_state(const StateFormat& format, Span<const std::uint8_t> state) {
  require(state.size() >= kStateHeaderBytes, "state: {} bytes are too few for a state", state.size());
  ByteReader header(state);
  require(header.take<std::uint64_t>() == kMagic, "state: these bytes are no state of a world");
  const auto version = header.take<std::uint64_t>();
  require(version == kVersion, "state: its version is {}, expected {}", version, kVersion);
  const auto bytes = header.take<std::uint64_t>();
  const auto model = header.take<std::uint64_t>();
  const auto layout = header.take<std::uint64_t>();
  require(model == format.model, "state: it was saved from another model");
  require(layout == format.layout, "state: it was saved from a world with another task, actuation or other agents");
  require(bytes == format.bytes && state.size() == bytes, "state: it has {} bytes, expected {}", state.size(),
          format.bytes);
  require(header.take<std::uint64_t>() == checksum(state), "state: it is damaged, its checksum is wrong");
  return state.part(kStateHeaderBytes, state.size() - kStateHeaderBytes);
}

// What the world knows beside its physics. `layout`, where given, learns which parts there are; it covers no sense
// that remembers nothing, so that a state also fits a world that looks at it with other senses.
void World::save_parts(ByteWriter& to, Hash* layout) const {
  std::size_t start = 0;
  const auto done = [&](const char* part, const Agent* agent) {
    if (layout != nullptr && to.size() > start) {
      layout->add(std::string(part) + " " + (agent == nullptr ? "" : agent->name));
      layout->add(std::uint64_t{to.size() - start});
    }
    start = to.size();
  };
  to.put(elapsed_);
  done("episode", nullptr);
  random_.save(to);
  done("random", nullptr);
  limits_.save(to);
  done("limits", nullptr);
  for (const Agent& agent : agents_) {
    agent.task->save(to);
    done("task", &agent);
    agent.actuation->save(to);
    done("actuation", &agent);
    for (const auto& sense : agent.senses) {
      sense->save(to);
      done(sense->fields().empty() ? "sense" : sense->fields().front().name.c_str(), &agent);
    }
  }
}

void World::load_parts(ByteReader& from) {
  elapsed_ = from.take<std::uint64_t>();
  random_.load(from);
  limits_.load(from);
  for (const Agent& agent : agents_) {
    agent.task->load(from);
    agent.actuation->load(from);
    for (const auto& sense : agent.senses) sense->load(from);
  }
}

void World::measure_state() {
  ByteWriter counter;
  Hash layout;
  save_parts(counter, &layout);
  parts_backup_.resize(counter.size());
  physics_.save(counter);
  state_.bytes = kStateHeaderBytes + counter.size();
  state_.layout = layout.value();
  state_.model = engine::fingerprint(*shared_model_);
}

void World::save(Span<std::uint8_t> state) const {
  physics_.require_usable();
  ByteWriter body(state.part(kStateHeaderBytes, state_.bytes - kStateHeaderBytes));
  save_parts(body, nullptr);
  physics_.save(body);
  seal_state(state_, state.part(0, state_.bytes));
}

void World::load(Span<const std::uint8_t> state) {
  require_outside_task();
  ByteReader body(open_state(state_, state));
  ByteWriter backup{Span<std::uint8_t>(parts_backup_)};
  save_parts(backup, nullptr);
  try {
    load_parts(body);
    physics_.load(body);  // last, because it alone changes nothing when it refuses
    step_contacts_.begin();
  } catch (...) {
    ByteReader before{Span<const std::uint8_t>(parts_backup_)};
    load_parts(before);
    throw;
  }
}

}  // namespace mimo::env
