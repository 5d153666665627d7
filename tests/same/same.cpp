// The scenario of tests/capi/same.c, which gives the same hashes in every language.
#include <cstdio>
#include <mimo/mimo.hpp>

namespace {

std::uint64_t hash_of(std::uint64_t hash, const mimo::Block& block) {  // FNV-1a
  for (std::size_t i = 0; i < block.bytes(); ++i) hash = (hash ^ block.data()[i]) * 1099511628211U;
  return hash;
}

void run(const char* scene) {
  mimo::Env env = mimo::make(scene);
  mimo::Block block = env.make_block();
  std::vector<float> actions(env.action_size());
  env.reset(7, block);
  std::uint64_t hash = hash_of(14695981039346656037U, block);
  double sum = 0;
  for (std::size_t step = 0; step < 100; ++step) {
    for (std::size_t i = 0; i < actions.size(); ++i) {
      actions[i] = static_cast<float>(static_cast<int>((7 * step + 3 * i) % 21) - 10) / 10.0F;
    }
    sum += env.step(actions, block).at(0).reward;
    hash = hash_of(hash, block);
  }
  std::printf("%s %016llx %.6f\n", scene, static_cast<unsigned long long>(hash), sum);
}

}  // namespace

int main() {
  for (const char* scene : {"reach", "standup", "selfbody", "benchmark"}) run(scene);
}
