#include "scene/pictures.h"

#include <atomic>
#include <memory>

#include "engine/pictures.h"
#include "scene/resources.h"

namespace mimo::scene {
namespace {

constexpr const char* kEncoded = ".png";
constexpr const char* kDecoded = ".pixels";

bool ends_with(const std::string& name, const std::string& end) {
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

// A decoded resource. Without a lock, which a child forked at the wrong time would find closed for ever.
class Slot {
 public:
  ~Slot() { delete bytes_.load(); }
  const engine::Bytes* get() const { return bytes_.load(); }
  // The first one that is brought stays.
  void keep(engine::Bytes bytes) {
    auto brought = std::make_unique<const engine::Bytes>(std::move(bytes));
    const engine::Bytes* none = nullptr;
    if (bytes_.compare_exchange_strong(none, brought.get())) static_cast<void>(brought.release());
  }

 private:
  std::atomic<const engine::Bytes*> bytes_{nullptr};
};

Slot& slot_of(const engine::Asset& asset) {
  static const auto slots = std::make_unique<Slot[]>(kResourceCount);
  std::size_t i = 0;
  while (kResources[i].data != asset.bytes.data()) ++i;
  return slots[i];
}

}  // namespace

std::string decoded_name(const std::string& name) {
  const std::string end = kEncoded;
  return engine::takes_decoded() && ends_with(name, end) ? name.substr(0, name.size() - end.size()) + kDecoded : name;
}

void decode_pictures(std::vector<engine::Asset>& assets) {
  if (!engine::takes_decoded()) return;
  std::vector<engine::Asset> encoded;
  for (const engine::Asset& asset : assets) {
    if (ends_with(asset.name, kEncoded) && slot_of(asset).get() == nullptr) encoded.push_back(asset);
  }
  std::vector<engine::Bytes> decoded = engine::decode(encoded);
  for (std::size_t i = 0; i < encoded.size(); ++i) slot_of(encoded[i]).keep(std::move(decoded[i]));
  for (engine::Asset& asset : assets) {
    if (!ends_with(asset.name, kEncoded)) continue;
    const engine::Bytes& bytes = *slot_of(asset).get();
    asset = {decoded_name(asset.name), {bytes.data(), bytes.size()}};
  }
}

}  // namespace mimo::scene
