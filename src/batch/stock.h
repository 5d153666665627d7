// One of a batch's models, and what its worlds have in common.
#pragma once

#include <memory>
#include <vector>

#include "batch/studio.h"
#include "env/kit.h"

namespace mimo::batch {

struct Stock {
  Stock(env::KitPtr of, std::size_t threads, const void* batch) : kit(std::move(of)), studio(*kit, threads, batch) {}

  env::KitPtr kit;
  Studio studio;
};

using StockPtr = std::shared_ptr<Stock>;
using Kits = std::vector<env::KitPtr>;

}  // namespace mimo::batch
