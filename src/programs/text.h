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

// The same of files, where larger ones are a mistake, and sums and squares of them would end at infinity.
std::optional<double> number_of_file(std::string_view text);
constexpr char kNumberOfFile[] = "a number from -1e12 to 1e12";

// Another sign in place of each that moves the cursor of a terminal, or colours what follows.
std::string one_line(std::string text);

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
