#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace underway {

/// A text in a table, coloured or not.
struct Cell {
  std::string text;
  std::string_view colour = {};  ///< an ANSI colour's number as text ("34"), or empty
};

/// Rows of text under aligned headings. Widths count characters of UTF-8, not bytes.
class Table {
 public:
  enum class Align { kLeft, kRight };
  struct Column {
    std::string heading;
    Align align = Align::kLeft;
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// As many cells as there are columns; throws std::invalid_argument otherwise.
  void add(std::vector<Cell> row);

  /// Lines that end in a newline, without blanks before it.
  [[nodiscard]] std::string text(bool with_colours) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
};

/// With a fixed number of decimals: "0.120".
[[nodiscard]] std::string fixed(double number, int decimals);

}  // namespace underway
