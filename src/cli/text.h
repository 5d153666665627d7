// Text for people: printf-style strings and tables, and the numbers that they write.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

#if defined(__MINGW32__)  // whose formats are those of Windows, unless one asks for the standard's
__attribute__((format(gnu_printf, 1, 2)))
#elif defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
std::string
text(const char* format, ...);

// A number written out, "+1" too, the same way whatever the locale; none where it is not finite or something follows.
std::optional<double> finite_number(std::string_view text);

// Rows of cells, printed in columns: the first `left` columns flush left, the others flush right.
class Table {
 public:
  explicit Table(std::size_t left) : left_(left) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  void print(std::ostream& out) const;

 private:
  std::size_t left_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace cli
