#include "engine/pictures.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "compat/mujoco.h"

namespace mimo::engine {
namespace {

Bytes decoded(const mjModel& model, int texture) {
  const std::array<std::int32_t, 2> size{model.tex_width[texture], model.tex_height[texture]};
  const auto count = static_cast<std::size_t>(compat::channels(model, texture)) * static_cast<std::size_t>(size[0]) *
                     static_cast<std::size_t>(size[1]);
  Bytes bytes(sizeof size + count);
  std::memcpy(bytes.data(), size.data(), sizeof size);
  std::memcpy(bytes.data() + sizeof size, model.*compat::kPixels + model.tex_adr[texture], count);
  return bytes;
}

}  // namespace

bool takes_decoded() { return MIMO_MUJOCO_4 == 0; }

// By the compiler's own decoder: as textures of a model that has nothing else.
std::vector<Bytes> decode(const std::vector<Asset>& pictures) {
  std::vector<Bytes> all;
  if (pictures.empty()) return all;
  std::string document = "<mujoco><asset>";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    document += "<texture type=\"2d\" name=\"" + std::to_string(i) + "\" file=\"" + pictures[i].name + "\"/>";
  }
  document += "</asset></mujoco>";
  const ModelPtr model = compile(document, pictures, {});
  for (int texture = 0; texture < model->ntex; ++texture) all.push_back(decoded(*model, texture));
  return all;
}

}  // namespace mimo::engine
