// Where elements were written (file and line stay with them in an attribute), and reports about changes to it.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "base/log.h"

namespace mimo::document {

// Where elements were written: file and line stay with them through includes and composition, in an attribute of our
// own that no other program sees.

// Notes for every element of a document just parsed from `text` where it stands.
void note_lines(pugi::xml_document& document, const std::string& text, const std::string& file);

// "room.xml, line 12": where a node stands, or the nearest one around it of which that is known; else "the scene".
std::string where(pugi::xml_node node);

// Whether an attribute is such a note.
bool is_note(pugi::xml_attribute attribute);

// Removes the notes. Returns them, one for each element in the document's order, "" where there was none.
std::vector<std::string> take_lines(pugi::xml_node root);

// A message of the compiler's with the user's file and line in place of those of the composed text.
std::string with_users_lines(const std::string& message, const std::string& xml, const std::vector<std::string>& notes);

// Reports to a document's author about changes.

// Warnings of one kind are one message, whose place is the first.
class Report {
 public:
  void add(pugi::xml_node node, const std::string& what);
  void write(const LogSink& log) const;

 private:
  struct Entry {
    std::string what, place;
    int count;
  };
  std::vector<Entry> entries_;
};

// "MuJoCo 2.2.2 does not know "
std::string nobody_knows();

// Throws Status::kModel: the MuJoCo that runs does not know that.
[[noreturn]] void refuse_unknown(pugi::xml_node place, const std::string& what);

}  // namespace mimo::document
