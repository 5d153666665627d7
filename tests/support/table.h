// A CSV file of known numbers: a header and rows; no cell contains a comma.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace mimo::test {

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

class Table {
 public:
  class Row {
   public:
    Row(const Table& table, std::size_t index) : table_(&table), index_(index) {}
    const std::string& text(const std::string& column) const { return table_->cell(index_, column); }
    std::vector<double> numbers(const std::string& column) const {
      std::istringstream stream(text(column));
      std::vector<double> values;
      for (double value; stream >> value;) values.push_back(value);
      EXPECT_TRUE(stream.eof()) << column << " holds \"" << text(column) << "\", expected numbers";
      return values;
    }
    double number(const std::string& column) const {
      const std::vector<double> values = numbers(column);
      EXPECT_EQ(values.size(), 1u) << column;
      return values.empty() ? 0 : values[0];
    }
    int integer(const std::string& column) const { return static_cast<int>(number(column)); }
    std::string label() const { return table_->path_ + ", line " + std::to_string(index_ + 2); }

   private:
    const Table* table_;
    std::size_t index_;
  };

  explicit Table(const std::string& path) : path_(path) {
    std::ifstream file(path);
    std::string line;
    if (!next_line(file, line)) ADD_FAILURE() << path << " cannot be read";
    columns_ = split(line, ',');
    while (next_line(file, line)) {
      cells_.push_back(split(line, ','));
      EXPECT_EQ(cells_.back().size(), columns_.size()) << path << ", line " << cells_.size() + 1;
    }
  }

  std::size_t size() const { return cells_.size(); }
  const std::vector<std::string>& columns() const { return columns_; }
  Row operator[](std::size_t index) const { return {*this, index}; }
  std::vector<Row> rows() const {
    std::vector<Row> all;
    for (std::size_t i = 0; i < size(); ++i) all.emplace_back(*this, i);
    return all;
  }

 private:
  // Lines may end as on Windows.
  static bool next_line(std::istream& file, std::string& line) {
    if (!std::getline(file, line)) return false;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return true;
  }

  const std::string& cell(std::size_t row, const std::string& column) const {
    static const std::string none;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i] == column) return cells_[row][i];
    }
    ADD_FAILURE() << path_ << " has no column " << column;
    return none;
  }

  std::string path_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> cells_;
};

}  // namespace mimo::test
