#include "capi/access_arguments.h"
#include "capi/check.h"
#include "capi/results.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

void check_all(const batch::Batch& batch, const mimo_batch_results& theirs) {
  const env::World& each = batch.world(0);
  check_results(theirs, batch.size() * each.agents().size(), batch.size() * each.term_count());
  check_length<double>(theirs.worlds, "results: worlds");
  const bool any_worlds = theirs.status != nullptr || theirs.was_reset != nullptr || theirs.final_written != nullptr;
  if (any_worlds && theirs.worlds < batch.size()) {
    fail(Status::kBufferTooSmall, "results: worlds is {}, but status, was_reset and final_written need {}",
         theirs.worlds, batch.size());
  }
}

}  // namespace

void check_per_world(const batch::Batch& batch, std::size_t worlds, bool any) {
  require(worlds == batch.size() || (worlds == 0 && !any), "worlds is {}, expected {}", worlds, batch.size());
}

std::uint8_t* blocks_of(const batch::Batch& batch, void* blocks, std::size_t bytes, const char* argument) {
  auto* start = static_cast<std::uint8_t*>(blocks);
  check_buffer(start, bytes, batch.size() * batch.world(0).layout().bytes(), argument);
  return start;
}

batch::Output output_of(const batch::Batch& batch, void* blocks, std::size_t block_bytes,
                        const mimo_batch_results* results) {
  batch::Output output;
  output.blocks = blocks_of(batch, blocks, block_bytes, "blocks");
  if (results == nullptr) return output;
  const mimo_batch_results theirs = read_struct(results, "results");
  check_all(batch, theirs);
  output.reward = theirs.reward;
  output.terminated = theirs.terminated;
  output.truncated = theirs.truncated;
  output.outcome = theirs.outcome;
  output.terms = theirs.terms;
  output.status = theirs.status;
  output.was_reset = theirs.was_reset;
  output.final_blocks = blocks_of(batch, theirs.final_blocks, theirs.final_bytes, "results: final_blocks");
  output.final_written = theirs.final_written;
  return output;
}

const float* actions_of(const batch::Batch& batch, const float* actions, std::size_t count) {
  const std::size_t expected = batch.size() * batch.world(0).action_size();
  require(actions != nullptr || count == 0, "actions is NULL, but action_count is {}", count);
  require(count == expected || count == 0, "action_count is {}, expected {} or 0", count, expected);
  return count == 0 ? nullptr : actions;
}

access::Ids ids_of(const batch::Batch& batch, const access::Quantity& quantity, const std::int32_t* ids,
                   std::size_t count) {
  require(quantity.kind().alike(), "quantity is {}, of which worlds have different numbers; ask each world",
          quantity.constant);
  return ids_of(batch.world(0), quantity, ids, count);
}

}  // namespace mimo::capi
