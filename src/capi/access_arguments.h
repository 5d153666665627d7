// Arguments of named access, and of calls on batches: checked, and in the form that the rooms want.
#pragma once

#include <cstdint>

#include "access/access.h"
#include "batch/batch.h"
#include "capi/check.h"
#include "mimo/experimental.h"
#include "observation/field.h"

namespace mimo::capi {

// What functions of named access are given, of worlds and of batches.

// A quantity, and whether the values of now are meant.
struct Request {
  const access::Quantity& quantity;
  bool now;
};
// Throws Status::kUnsupported for one that this library does not know, kInvalidArgument for one that has no now.
Request request_from(std::int32_t quantity);
// The same for writing, where there is only now.
const access::Quantity& writable_from(std::int32_t quantity);

const access::Kind& kind_from(std::int32_t kind);
observation::ReceptorQuantity receptor_quantity_from(std::int32_t quantity);

// Ids as given; NULL with count 0 means all of the quantity's kind.
access::Ids ids_of(const env::World& world, const access::Quantity& quantity, const std::int32_t* ids,
                   std::size_t count);

// What calls of a batch are given: checked, and told as the batch wants it.

// A mask, or seeds: NULL, or one for each world.
void check_per_world(const batch::Batch& batch, std::size_t worlds, bool any);

// Blocks of all worlds, one after the other; NULL with 0 bytes where they are optional.
std::uint8_t* blocks_of(const batch::Batch& batch, void* blocks, std::size_t bytes, const char* argument);

batch::Output output_of(const batch::Batch& batch, void* blocks, std::size_t block_bytes,
                        const mimo_batch_results* results);

// Null without actions.
const float* actions_of(const batch::Batch& batch, const float* actions, std::size_t count);

// Ids for all worlds, of a quantity of which each has as many.
access::Ids ids_of(const batch::Batch& batch, const access::Quantity& quantity, const std::int32_t* ids,
                   std::size_t count);

// The values of all worlds: const if the caller gives them.
template <typename T>
void check_values(const batch::Batch& batch, const access::Quantity& quantity, const access::Ids& ids, T* values,
                  std::size_t count) {
  require(values != nullptr || count == 0, "values is NULL, but value_count is {}", count);
  const std::size_t expected = batch.size() * access::width(batch.world(0), quantity, ids);
  if constexpr (std::is_const_v<T>) {
    check_given(count, expected, "value_count");
  } else {
    check_exact(count, expected, "value_count");
  }
}

}  // namespace mimo::capi
