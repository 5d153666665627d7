// Small helpers over pugixml, which reports a failed allocation by an empty node, or by a copy that is not whole.
#pragma once

#include <initializer_list>
#include <new>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "base/span.h"

namespace mimo::document {

// What the root of a document may be called: <mujoco> or <mujocoinclude>; of an included file, whose content alone
// counts, anything but <include>.
enum class Root { kMujoco, kAny };

// Parses a document; `origin` is for messages. Throws Status::kModel.
pugi::xml_document parse(const std::string& text, const std::string& origin, Root root);

// Throws Status::kModel for a document that is deeper than functions can go down.
void require_shallow(const pugi::xml_document& document, const std::string& origin);

std::string print(const pugi::xml_document& document);

// Whether an element has that name, or one of these.
bool is(pugi::xml_node node, const char* name);
bool is_one_of(pugi::xml_node node, std::initializer_list<const char*> names);

pugi::xml_node append(pugi::xml_node parent, const char* name);
pugi::xml_node prepend(pugi::xml_node parent, const char* name);
pugi::xml_node insert_before(pugi::xml_node place, const char* name);
// A document's first section of that name, made if there is none.
pugi::xml_node section(pugi::xml_node root, const char* name);
// Copies of all that a node or document holds.
void copy_into(pugi::xml_node parent, pugi::xml_node node);
void copy_before(pugi::xml_node place, pugi::xml_node node);
pugi::xml_document copy(const pugi::xml_document& document);

// Sets an attribute, in place of one of that name.
void set(pugi::xml_node node, const char* name, const std::string& value);
void set(pugi::xml_node node, const char* name, Span<const double> values);

// Numbers of an attribute, independent of the locale. Throws Status::kModel if it holds anything else.
std::vector<double> numbers(pugi::xml_attribute attribute);

// Calls visit(node) for a node and all elements below it.
template <typename Visit>
void walk(pugi::xml_node node, Visit&& visit) {
  visit(node);
  for (pugi::xml_node child = node.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();  // the visitor may replace or remove the child
    if (child.type() == pugi::node_element) walk(child, visit);
    child = next;
  }
}

}  // namespace mimo::document
