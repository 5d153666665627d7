#include "document/report.h"

#include <algorithm>
#include <cctype>

#include "base/fail.h"
#include "base/format.h"
#include "document/xml.h"
#include "engine/compiler.h"

namespace mimo::document {
namespace {

constexpr const char* kNote = "mimo:line";

// Lines of a text by offsets into it, counted from 1.
class LineTable {
 public:
  explicit LineTable(const std::string& text) {
    for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 1)) ends_.push_back(i);
  }
  std::size_t line(std::ptrdiff_t offset) const {
    const auto end =
        std::lower_bound(ends_.begin(), ends_.end(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
    return static_cast<std::size_t>(end - ends_.begin()) + 1;
  }

 private:
  std::vector<std::size_t> ends_;
};

// The note of the element that begins on a line of a text, or before it where none does; "" if there is none.
std::string note_at(std::size_t line, const std::string& xml, const std::vector<std::string>& notes) {
  const pugi::xml_document document = parse(xml, "the composed document", Root::kMujoco);
  const LineTable table(xml);
  std::size_t index = 0;
  std::string found;
  walk(document.document_element(), [&](pugi::xml_node node) {
    if (index < notes.size() && table.line(node.offset_debug()) <= line) found = notes[index];
    ++index;
  });
  return found;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// MuJoCo writes "line 12" and "line = 12, column = -1".
struct Mention {
  std::size_t begin = std::string::npos, end = 0;
  std::size_t line = 0;
};

Mention mention_in(const std::string& message) {
  for (const std::string words : {", line ", ", line = "}) {
    const std::size_t begin = message.rfind(words);
    std::size_t end = begin == std::string::npos ? begin : begin + words.size();
    if (begin == std::string::npos || end >= message.size() || !is_digit(message[end])) continue;
    Mention found{begin, end, 0};
    for (; found.end < message.size() && is_digit(message[found.end]); ++found.end) {
      found.line = found.line * 10 + static_cast<std::size_t>(message[found.end] - '0');
    }
    const std::string column = ", column = -1";
    if (message.compare(found.end, column.size(), column) == 0) found.end += column.size();
    return found;
  }
  return {};
}

}  // namespace

void note_lines(pugi::xml_document& document, const std::string& text, const std::string& file) {
  const LineTable table(text);
  std::vector<std::size_t> lines;  // first, as notes change what offsets are taken from
  walk(document.document_element(), [&](pugi::xml_node node) { lines.push_back(table.line(node.offset_debug())); });
  std::size_t index = 0;
  walk(document.document_element(),
       [&](pugi::xml_node node) { set(node, kNote, file + ", line " + std::to_string(lines[index++])); });
}

std::string where(pugi::xml_node node) {
  for (; node; node = node.parent()) {
    if (node.attribute(kNote)) return node.attribute(kNote).value();
  }
  return "the scene";
}

bool is_note(pugi::xml_attribute attribute) { return std::string(attribute.name()) == kNote; }

std::vector<std::string> take_lines(pugi::xml_node root) {
  std::vector<std::string> notes;
  walk(root, [&](pugi::xml_node node) {
    notes.emplace_back(node.attribute(kNote).value());
    node.remove_attribute(kNote);
  });
  return notes;
}

std::string with_users_lines(const std::string& message, const std::string& xml,
                             const std::vector<std::string>& notes) {
  const Mention mention = mention_in(message);
  if (mention.begin == std::string::npos) return message;
  const std::string note = note_at(mention.line, xml, notes);
  std::string rest = message;
  rest.erase(mention.begin, mention.end - mention.begin);
  return note.empty() ? rest : note + ": " + rest;
}

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
