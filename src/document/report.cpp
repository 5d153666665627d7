#include "document/report.h"

#include <algorithm>

#include "base/fail.h"
#include "base/format.h"
#include "document/lines.h"
#include "engine/schema.h"

namespace mimo::document {

void Report::add(pugi::xml_node node, const std::string& what) {
  const auto same = [&](const Entry& entry) { return entry.what == what; };
  const auto found = std::find_if(entries_.begin(), entries_.end(), same);
  if (found == entries_.end()) return entries_.push_back({what, where(node), 1});
  ++found->count;
}

void Report::write(const LogSink& log) const {
  for (const Entry& entry : entries_) {
    const std::string more = entry.count > 1 ? format(" (and {} more)", entry.count - 1) : "";
    log(LogLevel::kWarning, format("{}{}: {}", entry.place, more, entry.what));
  }
}

std::string nobody_knows() { return engine::compiler_name() + " does not know "; }

void refuse_unknown(pugi::xml_node place, const std::string& what) {
  fail(Status::kModel, "{}: {}{}", where(place), nobody_knows(), what);
}

}  // namespace mimo::document
