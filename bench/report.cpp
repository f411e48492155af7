#include "bench/report.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

namespace underway::bench {
namespace {

/// "AMD EPYC, 2 cores", as far as the system tells.
std::string machine() {
  std::string processor = "unknown processor";
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos) {
      processor = line.substr(line.find(": ") + 2);
      break;
    }
  return processor + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores";
}

}  // namespace

std::string toJson(const Report& report) {
  using Json = nlohmann::ordered_json;
  Json rows = Json::array();
  for (const Row& row : report.rows) {
    Json one{{"what", row.what}, {"value", row.value}, {"unit", row.unit}};
    one["peer"] = row.peer ? Json(row.peer->name) : Json(nullptr);
    one["peer_value"] = row.peer ? Json(row.peer->value) : Json(nullptr);
    one["ratio"] = row.ratio ? Json(*row.ratio) : Json(nullptr);
    one["goal"] = row.goal.empty() ? Json(nullptr) : Json(row.goal);
    one["met"] = row.met ? Json(*row.met) : Json(nullptr);
    one["seed"] = row.seed;
    one["samples"] = row.samples;
    rows.push_back(one);
  }
  return Json{{"bench", report.name}, {"machine", machine()}, {"rows", rows}}.dump(1) + "\n";
}

double quantile(std::vector<double> numbers, double p) {
  if (numbers.empty()) throw std::invalid_argument("a quantile of no numbers");
  std::sort(numbers.begin(), numbers.end());
  return numbers[static_cast<std::size_t>(std::llround(p * static_cast<double>(numbers.size() - 1)))];
}

}  // namespace underway::bench
