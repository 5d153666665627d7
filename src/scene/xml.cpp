#include "base/format.h"
#include "scene/xml.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "base/fail.h"

namespace mimo::scene {
namespace {

std::size_t line_of(const std::string& text, std::ptrdiff_t offset) {
  const auto end = text.begin() + std::min<std::ptrdiff_t>(offset, static_cast<std::ptrdiff_t>(text.size()));
  return static_cast<std::size_t>(std::count(text.begin(), end, '\n')) + 1;
}

struct StringWriter : pugi::xml_writer {
  std::string text;
  void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

void must(bool done) {
  if (!done) throw std::bad_alloc();
}

}  // namespace

pugi::xml_document parse(const std::string& text, const std::string& origin) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
  if (!result) {
    fail(Status::kModel, "{}, line {}: {}", origin, line_of(text, result.offset), result.description());
  }
  const std::string root = document.document_element().name();
  if (root != "mujoco" && root != "mujocoinclude") {
    fail(Status::kModel, "{}: the root element is <{}>, but MJCF has <mujoco>", origin, root);
  }
  return document;
}

std::string print(const pugi::xml_document& document) {
  StringWriter writer;
  document.save(writer, "  ", pugi::format_default | pugi::format_no_declaration);
  return std::move(writer.text);
}

pugi::xml_node append(pugi::xml_node parent, const char* name) {
  pugi::xml_node node = parent.append_child(name);
  must(!node.empty());
  return node;
}

void copy_into(pugi::xml_node parent, pugi::xml_node node) { must(!parent.append_copy(node).empty()); }

void set(pugi::xml_node node, const char* name, const std::string& value) {
  pugi::xml_attribute attribute = node.attribute(name);
  if (attribute.empty()) attribute = node.append_attribute(name);
  must(attribute.set_value(value.c_str()));
}

void set(pugi::xml_node node, const char* name, Span<const double> values) {
  set(node, name, fmt::format("{}", fmt::join(values.begin(), values.end(), " ")));
}

std::vector<double> numbers(pugi::xml_attribute attribute) {
  const std::string text = attribute.value();
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r' || *at == '+')) ++at;
    if (at == end) return values;
    double value = 0;
    const auto result = std::from_chars(at, end, value);
    if (result.ec != std::errc()) fail(Status::kModel, "{}=\"{}\": expected numbers", attribute.name(), text);
    values.push_back(value);
    at = result.ptr;
  }
}

}  // namespace mimo::scene
