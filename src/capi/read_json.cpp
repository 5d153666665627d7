#include "capi/read_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mimo::capi {
namespace {

constexpr std::size_t kDeepest = 32;

// Puts together what nlohmann's parser reads.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return add({}); }
  bool boolean(bool value) override {
    ReadJson json;
    json.kind = ReadJson::Kind::kFlag;
    json.natural = value ? 1 : 0;
    return add(std::move(json));
  }
  bool number_integer(std::int64_t value) override {
    ReadJson json;
    json.kind = ReadJson::Kind::kNegative;
    json.negative = value;
    json.real = static_cast<double>(value);
    return add(std::move(json));
  }
  bool number_unsigned(std::uint64_t value) override {
    ReadJson json;
    json.kind = ReadJson::Kind::kNatural;
    json.natural = value;
    json.real = static_cast<double>(value);
    return add(std::move(json));
  }
  bool number_float(double value, const std::string& /*text*/) override {
    ReadJson json;
    json.kind = ReadJson::Kind::kReal;
    json.real = value;
    return add(std::move(json));
  }
  bool string(std::string& value) override {
    ReadJson json;
    json.kind = ReadJson::Kind::kText;
    json.text = std::move(value);
    return add(std::move(json));
  }
  bool binary(nlohmann::json::binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(ReadJson::Kind::kObject); }
  bool key(std::string& value) override {
    open_.back()->names.push_back(std::move(value));
    return true;
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t /*size*/) override { return open(ReadJson::Kind::kList); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const nlohmann::json::exception& /*why*/) override {
    return false;
  }

  ReadJson whole;

 private:
  bool add(ReadJson json) {
    if (open_.empty()) {
      whole = std::move(json);
    } else {
      open_.back()->parts.push_back(std::move(json));
    }
    return true;
  }
  bool open(ReadJson::Kind kind) {
    if (open_.size() == kDeepest) return false;
    ReadJson json;
    json.kind = kind;
    ReadJson* const parent = open_.empty() ? nullptr : open_.back();
    add(std::move(json));
    open_.push_back(parent == nullptr ? &whole : &parent->parts.back());
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::vector<ReadJson*> open_;  // each in the one before, which grows only after this one is closed
};

}  // namespace

const ReadJson* ReadJson::find(const char* name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : &parts[static_cast<std::size_t>(found - names.begin())];
}

std::optional<ReadJson> read_json(const std::string& text) {
  Builder builder;
  if (!nlohmann::json::sax_parse(text, &builder)) return std::nullopt;
  return std::move(builder.whole);
}

}  // namespace mimo::capi
