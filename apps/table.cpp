#include "apps/table.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

#include "apps/terminal.hpp"

namespace underway {
namespace {

/// Number of characters: bytes that do not continue one.
std::size_t widthOf(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(const Cell& cell, std::size_t width, Table::Align align, bool with_colours) {
  const std::string blanks(width - widthOf(cell.text), ' ');
  const bool coloured = with_colours && !cell.colour.empty();
  const std::string text =
      coloured ? "\x1b[" + std::string(cell.colour) + "m" + cell.text + "\x1b[0m" : cell.text;
  return align == Table::Align::kLeft ? text + blanks : blanks + text;
}

}  // namespace

void Table::add(std::vector<Cell> row) {
  if (row.size() != columns_.size())
    throw std::invalid_argument("a row has as many cells as the table has columns");
  for (Cell& cell : row) cell.text = printable(cell.text);
  rows_.push_back(std::move(row));
}

std::string Table::text(bool with_colours) const {
  std::vector<std::vector<Cell>> lines(1);
  for (const Column& column : columns_) lines[0].push_back({column.heading, "1"});
  lines.insert(lines.end(), rows_.begin(), rows_.end());
  std::vector<std::size_t> widths(columns_.size(), 0);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], widthOf(line[i].text));
  std::string text;
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      text += (i == 0 ? "" : "  ") + padded(line[i], widths[i], columns_[i].align, with_colours);
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string fixed(double number, int decimals) {
  std::array<char, 400> buffer{};  // the longest double has 309 digits before the point
  std::snprintf(buffer.data(), buffer.size(), "%.*f", std::clamp(decimals, 0, 17), number);
  return buffer.data();
}

}  // namespace underway
