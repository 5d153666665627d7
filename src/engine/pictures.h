// Pictures for textures, decoded before a model is compiled.
#pragma once

#include <vector>

#include "engine/model.h"

namespace mimo::engine {

// Whether the compiler takes decoded pictures, which it knows by any extension but ".png". Newer ones keep what they
// have decoded themselves.
bool takes_decoded();

// PNG files as the compiler's own format: width, height, and three bytes a pixel. In the order given.
using Bytes = std::vector<unsigned char>;
std::vector<Bytes> decode(const std::vector<Asset>& pictures);

}  // namespace mimo::engine
