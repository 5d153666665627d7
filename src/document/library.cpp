#include "document/library.h"

#include <atomic>
#include <filesystem>
#include <memory>

#include "base/process.h"
#include "document/files.h"
#include "engine/compiler.h"

namespace mimo::document {
namespace {

constexpr const char* kEncoded = ".png";
constexpr const char* kDecoded = ".pixels";

bool ends_with(const std::string& name, const std::string& end) {
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

// A built-in file and what is decoded of it.
struct Picture {
  const unsigned char* file;
  engine::Bytes pixels;
  const Picture* before;
};

// The one that was decoded last. There is no lock, which a child forked at the wrong time would find closed for ever,
// not even that of a table made at its first use.
std::atomic<const Picture*> last_decoded{nullptr};

const AtUnload give_back([] {
  for (const Picture* picture = last_decoded.exchange(nullptr); picture != nullptr;) {
    const std::unique_ptr<const Picture> gone(picture);
    picture = gone->before;
  }
});

const engine::Bytes* find(const Picture* picture, const unsigned char* file) {
  while (picture != nullptr && picture->file != file) picture = picture->before;
  return picture == nullptr ? nullptr : &picture->pixels;
}

const engine::Bytes* find(const unsigned char* file) { return find(last_decoded.load(), file); }

// Of one file that several threads decode at a time, the first that is brought stays.
void keep(const unsigned char* file, engine::Bytes pixels) {
  auto brought = std::make_unique<Picture>(Picture{file, std::move(pixels), last_decoded.load()});
  while (find(brought->before, file) == nullptr) {
    if (last_decoded.compare_exchange_weak(brought->before, brought.get())) return static_cast<void>(brought.release());
  }
}

}  // namespace

Span<const unsigned char> built_in_file(const std::string& path) {
  for (std::size_t i = 0; i < kResourceCount; ++i) {
    if (path == kResources[i].path) return {kResources[i].data, kResources[i].size};
  }
  return {};
}

std::optional<std::string> Library::text(const std::string& path) const {
  if (!built_in()) return read_file(folder_ + "/" + path, Limits{});
  const auto bytes = built_in_file(path);
  if (bytes.empty()) return std::nullopt;
  return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

bool Library::has(const std::string& path) const {
  std::error_code unknown;
  return built_in() ? !built_in_file(path).empty() : std::filesystem::exists(folder_ + "/" + path, unknown);
}

std::string decoded_name(const std::string& name) {
  const std::string end = kEncoded;
  return engine::takes_decoded() && ends_with(name, end) ? name.substr(0, name.size() - end.size()) + kDecoded : name;
}

void decode_pictures(std::vector<engine::Asset>& assets) {
  if (!engine::takes_decoded()) return;
  std::vector<engine::Asset> encoded;
  for (const engine::Asset& asset : assets) {
    if (ends_with(asset.name, kEncoded) && find(asset.bytes.data()) == nullptr) encoded.push_back(asset);
  }
  std::vector<engine::Bytes> decoded = engine::decode(encoded);
  for (std::size_t i = 0; i < encoded.size(); ++i) keep(encoded[i].bytes.data(), std::move(decoded[i]));
  for (engine::Asset& asset : assets) {
    if (!ends_with(asset.name, kEncoded)) continue;
    const engine::Bytes& bytes = *find(asset.bytes.data());
    asset = {decoded_name(asset.name), {bytes.data(), bytes.size()}};
  }
}

}  // namespace mimo::document
