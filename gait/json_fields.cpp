#include "gait/json_fields.hpp"

#include <algorithm>
#include <cmath>

namespace underway::gait {
namespace {

const nlohmann::json kNothing;

}  // namespace

JsonFields::JsonFields(const nlohmann::json& object, std::string where)
    : json_(object), where_(std::move(where)) {
  if (!json_.is_object()) fault_ = GaitError{where_ + " is not an object; write {...}"};
}

const nlohmann::json& JsonFields::at(const char* key) {
  known_.emplace_back(key);
  if (!json_.is_object()) return kNothing;
  const auto found = json_.find(key);
  if (found == json_.end()) {
    refuse(key, "is missing; add it");
    return kNothing;
  }
  return *found;
}

double JsonFields::number(const char* key) {
  const nlohmann::json& value = at(key);
  if (value.is_number() && std::isfinite(value.get<double>())) return value.get<double>();
  refuse(key, "must be a number");
  return 0.0;
}

double JsonFields::positive(const char* key) {
  const double value = number(key);
  if (value <= 0.0) refuse(key, "must be above 0");
  return value;
}

std::string JsonFields::text(const char* key) {
  const nlohmann::json& value = at(key);
  if (value.is_string() && !value.get<std::string>().empty()) return value.get<std::string>();
  refuse(key, "must be a text");
  return {};
}

std::vector<double> JsonFields::numbers(const char* key, std::size_t count) {
  const nlohmann::json& value = at(key);
  const auto isNumber = [](const nlohmann::json& item) {
    return item.is_number() && std::isfinite(item.get<double>());
  };
  if (value.is_array() && value.size() == count && std::ranges::all_of(value, isNumber))
    return value.get<std::vector<double>>();
  refuse(key, "must be a list of " + std::to_string(count) + " numbers");
  return std::vector<double>(count);
}

JsonFields JsonFields::object(const char* key) { return {at(key), where_ + ", " + key}; }

void JsonFields::take(const JsonFields& part) {
  if (!fault_) fault_ = part.fault();
}

void JsonFields::refuse(const std::string& key, const std::string& what) {
  if (!fault_) fault_ = GaitError{where_ + ": " + key + " " + what};
}

std::optional<GaitError> JsonFields::fault() const {
  if (fault_) return fault_;
  for (const auto& [key, value] : json_.items())
    if (std::ranges::find(known_, key) == known_.end())
      return GaitError{where_ + ": " + nlohmann::json(key).dump() + " is not known; remove it"};
  return std::nullopt;
}

GaitExpected<nlohmann::json> parseJson(std::string_view text, const std::string& where) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::string_view read = text.substr(0, error.byte);
    return tl::unexpected(GaitError{where + ":" + std::to_string(1 + std::ranges::count(read, '\n')) +
                                    ": is not JSON; correct it"});
  } catch (const nlohmann::json::exception&) {  // 1e999 is JSON, but no double
    return tl::unexpected(GaitError{where + " holds a number that is too large; give finite numbers"});
  }
}

}  // namespace underway::gait
