// What a document's author is told of what was changed in it.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "base/log.h"

namespace mimo::document {

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
