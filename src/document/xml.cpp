#include "document/xml.h"

#include <algorithm>
#include <cstring>
#include <sstream>

#include "base/fail.h"
#include "base/format.h"

namespace mimo::document {
namespace {

std::size_t line_of(const std::string& text, std::ptrdiff_t offset) {
  const auto end = text.begin() + std::min<std::ptrdiff_t>(offset, static_cast<std::ptrdiff_t>(text.size()));
  return static_cast<std::size_t>(std::count(text.begin(), end, '\n')) + 1;
}

struct StringWriter : pugi::xml_writer {
  std::string text;
  void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

// MuJoCo's parser and this room's functions go down into elements by recursion: a document that is deeper than any
// real one would overflow the stack.
constexpr int kDeepest = 256;

bool too_deep(pugi::xml_node root) {
  int depth = 0;
  for (pugi::xml_node node = root; node;) {
    if (node.first_child()) {
      node = node.first_child();
      if (++depth > kDeepest) return true;
      continue;
    }
    while (node && node != root && !node.next_sibling()) {
      node = node.parent();
      --depth;
    }
    node = node == root ? pugi::xml_node() : node.next_sibling();
  }
  return false;
}

// The node itself, or the first behind it that is an element.
pugi::xml_node element_from(pugi::xml_node node) {
  while (node && node.type() != pugi::node_element) node = node.next_sibling();
  return node;
}

pugi::xml_node first_element(pugi::xml_node parent) { return element_from(parent.first_child()); }
pugi::xml_node next_element(pugi::xml_node node) { return element_from(node.next_sibling()); }

void must(bool done) {
  if (!done) throw std::bad_alloc();
}

bool same(const char* one, const char* two) { return std::strcmp(one, two) == 0; }

// Whether two nodes hold the same, down to the last one.
bool same(pugi::xml_node one, pugi::xml_node two) {
  if (one.type() != two.type() || !same(one.name(), two.name()) || !same(one.value(), two.value())) return false;
  pugi::xml_attribute mine = one.first_attribute(), theirs = two.first_attribute();
  for (; mine && theirs; mine = mine.next_attribute(), theirs = theirs.next_attribute()) {
    if (!same(mine.name(), theirs.name()) || !same(mine.value(), theirs.value())) return false;
  }
  pugi::xml_node child = one.first_child(), other = two.first_child();
  for (; child && other; child = child.next_sibling(), other = other.next_sibling()) {
    if (!same(child, other)) return false;
  }
  return !mine && !theirs && !child && !other;
}

}  // namespace

pugi::xml_document parse(const std::string& text, const std::string& origin, Root root) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
  if (!result) {
    fail(Status::kModel, "{}, line {}: {}", origin, line_of(text, result.offset), result.description());
  }
  require_shallow(document, origin);
  const std::string name = document.document_element().name();
  const bool is_mujoco = name == "mujoco" || name == "mujocoinclude";
  if (root == Root::kMujoco && !is_mujoco) {
    fail(Status::kModel, "{}: the root element is <{}>, but MJCF has <mujoco>", origin, name);
  }
  if (!is_mujoco && (name == "include" || !first_element(document.document_element()))) {
    fail(Status::kModel, "{}: the root element is <{}>, which holds nothing to include", origin, name);
  }
  if (const pugi::xml_node second = next_element(document.document_element())) {
    fail(Status::kModel, "{}: <{}> stands beside the root element, which is <{}>", origin, second.name(), name);
  }
  return document;
}

void require_shallow(const pugi::xml_document& document, const std::string& origin) {
  if (too_deep(document)) fail(Status::kModel, "{}: elements are nested more than {} deep", origin, kDeepest);
}

std::string print(const pugi::xml_document& document) {
  StringWriter writer;
  document.save(writer, "  ", pugi::format_default | pugi::format_no_declaration);
  return std::move(writer.text);
}

bool is(pugi::xml_node node, const char* name) { return std::strcmp(node.name(), name) == 0; }

bool is_one_of(pugi::xml_node node, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return is(node, name); });
}

pugi::xml_node append(pugi::xml_node parent, const char* name) {
  pugi::xml_node node = parent.append_child(name);
  must(!node.empty());
  return node;
}

pugi::xml_node prepend(pugi::xml_node parent, const char* name) {
  pugi::xml_node node = parent.prepend_child(name);
  must(!node.empty());
  return node;
}

pugi::xml_node insert_before(pugi::xml_node place, const char* name) {
  pugi::xml_node node = place.parent().insert_child_before(name, place);
  must(!node.empty());
  return node;
}

pugi::xml_node section(pugi::xml_node root, const char* name) {
  const pugi::xml_node found = root.child(name);
  return found.empty() ? append(root, name) : found;
}

void copy_into(pugi::xml_node parent, pugi::xml_node node) { must(same(parent.append_copy(node), node)); }

void copy_before(pugi::xml_node place, pugi::xml_node node) {
  must(same(place.parent().insert_copy_before(node, place), node));
}

pugi::xml_document copy(const pugi::xml_document& document) {
  pugi::xml_document twin;
  twin.reset(document);
  must(same(twin, document));
  return twin;
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
  pugi::xml_attribute attribute = node.attribute(name);
  if (attribute.empty()) attribute = node.append_attribute(name);
  must(attribute.set_value(value.c_str()));
}

void set(pugi::xml_node node, const char* name, Span<const double> values) { set(node, name, join(values, " ")); }

std::vector<double> numbers(pugi::xml_attribute attribute) {
  const std::string text = attribute.value();
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r' || *at == '+')) ++at;
    if (at == end) return values;
    double value = 0;
    const auto result = read_double(at, end, value);
    if (result.ec != std::errc()) fail(Status::kModel, "{}=\"{}\": expected numbers", attribute.name(), text);
    values.push_back(value);
    at = result.ptr;
  }
}

}  // namespace mimo::document
