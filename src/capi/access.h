// What functions of named access are given, of worlds and of batches.
#pragma once

#include <cstdint>

#include "access/access.h"
#include "observation/receptor.h"

namespace mimo::capi {

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

}  // namespace mimo::capi
