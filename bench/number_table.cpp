#include "bench/number_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

namespace underway::bench {
namespace {

std::vector<std::string> cellsOf(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

Expected<std::vector<std::vector<double>>> readNumbers(const std::filesystem::path& file,
                                                       std::span<const std::string> columns) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line))
    return fail(ErrorCode::kInvalidMap, file.string() + ": cannot be read, or is empty");
  const std::vector<std::string> names = cellsOf(line);
  std::vector<std::size_t> at;
  for (const std::string& column : columns) {
    const auto found = std::find(names.begin(), names.end(), column);
    if (found == names.end())
      return fail(ErrorCode::kInvalidMap, fmt::format("{}:1: has no column {}", file.string(), column));
    at.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  std::vector<std::vector<double>> rows;
  for (std::size_t number = 2; std::getline(in, line); ++number) {
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.empty()) continue;
    rows.emplace_back();
    for (std::size_t c = 0; c < at.size(); ++c) {
      const std::string cell = at[c] < cells.size() ? cells[at[c]] : "";
      double value = 0.0;
      const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (error != std::errc() || end != cell.data() + cell.size())
        return fail(ErrorCode::kInvalidMap, fmt::format("{}:{}: column {} is no number: '{}'", file.string(),
                                                        number, columns[c], cell));
      rows.back().push_back(value);
    }
  }
  return rows;
}

}  // namespace underway::bench
