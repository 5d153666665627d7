// States of any content: refused, and then the world stays as it is to the last bit; or loaded, and the world works.
#include <algorithm>
#include <vector>

#include "base/bytes.h"

extern "C" {
#include "fuzz/input.h"
}

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kHeader = 48;  // as in env/state.h
constexpr std::size_t kChecksumAt = kHeader - sizeof(std::uint64_t);

mimo_env* env;
Bytes good;  // a state as it was saved
Bytes block;

void make_world() {
  PROMISE(mimo_env_make("selfbody", &env) == MIMO_OK);
  block.resize(sizes_of(env).block_bytes);
  mimo_reset_config seeded{};
  seeded.struct_size = sizeof seeded;
  seeded.seeded = 1;
  seeded.seed = 5;
  PROMISE(mimo_env_reset(env, &seeded, nullptr, 0) == MIMO_OK);
  PROMISE(mimo_env_physics_step(env, 20) == MIMO_OK);
  std::size_t bytes = 0;
  CALL(mimo_env_state_size(env, &bytes));
  good.resize(bytes);
  PROMISE(mimo_env_state_save(env, good.data(), good.size()) == MIMO_OK);
}

// Most changes would only meet the checksum, so it is made right again.
void seal(Bytes& state) {
  if (state.size() < kHeader) return;
  mimo::Hash hash;
  hash.add({state.data(), kChecksumAt});
  hash.add({state.data() + kHeader, state.size() - kHeader});
  const std::uint64_t sum = hash.value();
  std::memcpy(state.data() + kChecksumAt, &sum, sizeof sum);
}

Bytes state_from(input& in) {
  const std::uint8_t how = take_byte(&in);
  if (how % 4 == 0) return Bytes(in.data, in.data + in.left);
  Bytes state = good;
  while (in.left > 0) {
    std::uint8_t patch[8];
    const std::size_t at = take_below(&in, static_cast<std::uint32_t>(state.size()));
    take(&in, patch, sizeof patch);
    std::copy_n(patch, std::min(sizeof patch, state.size() - at), state.begin() + static_cast<std::ptrdiff_t>(at));
  }
  if (how % 4 == 1) state.resize(how);
  seal(state);
  return state;
}

Bytes saved() {
  Bytes state(good.size());
  PROMISE(mimo_env_state_save(env, state.data(), state.size()) == MIMO_OK);
  return state;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  input in = {data, size};
  if (env == nullptr) make_world();
  PROMISE(mimo_env_state_load(env, good.data(), good.size(), nullptr) == MIMO_OK);
  const Bytes state = state_from(in);
  if (CALL(mimo_env_state_load(env, state.data(), state.size(), nullptr)) == MIMO_OK) {
    CALL(mimo_env_observe(env, block.data(), block.size()));
    for (int i = 0; i < 3; ++i) {
      CALL(mimo_env_step(env, nullptr, 0, block.data(), block.size(), nullptr));
    }
    double number = -1;
    PROMISE(mimo_env_random(env, &number, 1) == MIMO_OK && number >= 0 && number < 1);
  } else {
    PROMISE(saved() == good);
  }
  return 0;
}
