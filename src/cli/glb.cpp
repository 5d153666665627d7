#include "cli/glb.h"

#include <algorithm>
#include <cmath>

#include "cli/picture.h"
#include "programs/files.h"

namespace cli {
namespace {

constexpr std::uint32_t kFaces = 6, kBytes = 4;
constexpr std::uint32_t kPartOfFace =
    8;  // a margin is this part of a face: mipmaps of an eighth of the size have no seams

std::uint32_t margin_of(const mimo::Texture& texture) {
  const bool cube = texture.type == MIMO_TEXTURE_CUBE && texture.height == kFaces * texture.width;
  return cube ? texture.width / kPartOfFace : 0;
}

// Numbers of glTF 2.0's specification.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kVertices = 34962, kIndices = 34963;
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;

// Parts begin at multiples of four bytes.
void pad(std::string& bytes, char with) { bytes.append((4 - bytes.size() % 4) % 4, with); }

void put(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xff);
}

void put_chunk(std::string& bytes, std::uint32_t type, const std::string& content) {
  put(bytes, static_cast<std::uint32_t>(content.size()));
  put(bytes, type);
  bytes += content;
}

const char* type_of(std::size_t width) {
  const char* const names[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  return names[width - 1];
}

}  // namespace

mimo::Texture with_margins(mimo::Texture texture) {
  const std::uint32_t edge = texture.width, margin = margin_of(texture), wide = edge + 2 * margin;
  if (margin == 0) return texture;
  mimo::Texture padded{texture.type, wide, kFaces * wide, {}};
  padded.pixels.reserve(std::size_t{kBytes} * wide * padded.height);
  const auto inside = [&](std::uint32_t at) { return std::clamp(at, margin, margin + edge - 1) - margin; };
  for (std::uint32_t row = 0; row < padded.height; ++row) {
    const std::size_t from = std::size_t{row / wide} * edge + inside(row % wide);
    for (std::uint32_t column = 0; column < wide; ++column) {
      const auto pixel = texture.pixels.begin() + static_cast<std::ptrdiff_t>(kBytes * (from * edge + inside(column)));
      padded.pixels.insert(padded.pixels.end(), pixel, pixel + kBytes);
    }
  }
  return padded;
}

std::vector<float> with_margins(std::vector<float> texcoords, const mimo::Texture& texture) {
  const double edge = texture.width, margin = margin_of(texture);
  if (margin == 0) return texcoords;
  const auto inside = [&](double at) { return (margin + at * edge) / (edge + 2 * margin); };
  for (std::size_t i = 0; i + 1 < texcoords.size(); i += 2) {
    const double down = double{texcoords[i + 1]} * kFaces;
    const double face = std::clamp(std::floor(down), 0.0, kFaces - 1.0);
    texcoords[i] = static_cast<float>(inside(texcoords[i]));
    texcoords[i + 1] = static_cast<float>((face + inside(down - face)) / kFaces);
  }
  return texcoords;
}

Glb::Glb() {
  document_["asset"] = {{"version", "2.0"}, {"generator", std::string("mimo ") + mimo_version()}};
  document_["scene"] = 0;
}

std::size_t Glb::add(const char* list, Json element) {
  document_[list].push_back(std::move(element));
  return document_[list].size() - 1;
}

std::size_t Glb::add_view(const void* bytes, std::size_t size, int target) {
  pad(data_, '\0');
  Json view = {{"buffer", 0}, {"byteOffset", data_.size()}, {"byteLength", size}};
  if (target != 0) view["target"] = target;
  data_.append(static_cast<const char*>(bytes), size);
  return add("bufferViews", std::move(view));
}

std::size_t Glb::add_floats(const std::vector<float>& values, std::size_t width, bool vertices) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "glTF's numbers are little-endian");
  const std::size_t view = add_view(values.data(), values.size() * sizeof(float), vertices ? kVertices : 0);
  std::vector<float> least(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width)), most = least;
  for (std::size_t i = 0; i < values.size(); ++i) {
    least[i % width] = std::min(least[i % width], values[i]);
    most[i % width] = std::max(most[i % width], values[i]);
  }
  return add("accessors", {{"bufferView", view},
                           {"componentType", kFloat},
                           {"count", values.size() / width},
                           {"type", type_of(width)},
                           {"min", least},
                           {"max", most}});
}

std::size_t Glb::add_indices(const std::vector<std::uint32_t>& values) {
  const std::size_t view = add_view(values.data(), values.size() * sizeof(std::uint32_t), kIndices);
  return add("accessors",
             {{"bufferView", view}, {"componentType", kUnsignedInt}, {"count", values.size()}, {"type", "SCALAR"}});
}

std::size_t Glb::add_texture(const mimo::Texture& texture, const std::string& name) {
  const std::string png = png_of(texture);
  const std::size_t view = add_view(png.data(), png.size());
  const std::size_t image = add("images", {{"name", name}, {"mimeType", "image/png"}, {"bufferView", view}});
  return add("textures", {{"source", image}});
}

void Glb::write(const std::string& path) const {
  std::string data = data_;
  pad(data, '\0');
  Json document = document_;
  document["buffers"] = Json::array({{{"byteLength", data.size()}}});
  std::string json = document.dump();
  pad(json, ' ');
  std::string file;
  put(file, kMagic);
  put(file, kVersion);
  put(file, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + data.size()));
  put_chunk(file, kJsonChunk, json);
  put_chunk(file, kBinChunk, data);
  write_file(path, file);
}

}  // namespace cli
