#include "gait/table_text.hpp"

#include <spdlog/fmt/fmt.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace underway::gait {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

GaitExpected<double> numberOf(std::string_view text, const std::string& where) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size())
    return tl::unexpected(GaitError{fmt::format("{}: \"{}\" is not a number; correct it", where, text)});
  return number;
}

GaitExpected<std::vector<double>> numbersOf(std::string_view line, std::size_t count,
                                            const std::string& where) {
  std::vector<double> numbers;
  for (const std::string_view part : split(line, ',')) {
    const auto number = numberOf(part, where);
    if (!number) return tl::unexpected(number.error());
    numbers.push_back(*number);
  }
  if (numbers.size() == count) return numbers;
  return tl::unexpected(
      GaitError{fmt::format("{}: {} numbers, where the head names {}", where, numbers.size(), count)});
}

GaitExpected<JointTable> emptyTable(std::string_view head, const std::string& where) {
  const auto names = split(head, ',');
  if (names.front() != "time_s")
    return tl::unexpected(GaitError{where + ": the first line must begin with time_s"});
  try {
    return JointTable({names.begin() + 1, names.end()});
  } catch (const std::invalid_argument& error) {
    return tl::unexpected(GaitError{fmt::format("{}: {}", where, error.what())});
  }
}

}  // namespace

std::string toCsv(const JointTable& table) {
  std::string text = "time_s";
  for (const std::string& joint : table.joints()) text += "," + joint;
  text += "\n";
  for (std::size_t row = 0; row < table.rows(); ++row) {
    text += fmt::format("{}", table.time(row));
    for (const double angle : table.angles(row)) text += fmt::format(",{}", angle);
    text += "\n";
  }
  return text;
}

GaitExpected<JointTable> tableFromCsv(std::string_view text, const std::string& where) {
  if (text.ends_with('\n')) text.remove_suffix(1);
  const auto lines = split(text, '\n');
  auto table = emptyTable(lines.front(), where);
  if (!table) return table;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::string place = fmt::format("{}, line {}", where, i + 1);
    const auto numbers = numbersOf(lines[i], table->joints().size() + 1, place);
    if (!numbers) return tl::unexpected(numbers.error());
    try {
      table->append(numbers->front(), std::span(*numbers).subspan(1));
    } catch (const std::invalid_argument& error) {
      return tl::unexpected(GaitError{fmt::format("{}: {}", place, error.what())});
    }
  }
  return table;
}

std::string toNaoqiJson(const JointTable& table, double first_s) {
  std::vector<std::vector<double>> angles(table.joints().size());
  std::vector<double> times;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    times.push_back(table.time(row) - table.time(0) + first_s);
    for (std::size_t joint = 0; joint < angles.size(); ++joint)
      angles[joint].push_back(table.angles(row)[joint]);
  }
  const nlohmann::ordered_json json{{"names", table.joints()},
                                    {"angleLists", angles},
                                    {"timeLists", std::vector(angles.size(), times)},
                                    {"isAbsolute", true}};
  return json.dump() + "\n";
}

}  // namespace underway::gait
