#include "planner/json_reader.hpp"

#include <cmath>

namespace underway {
namespace {

constexpr std::size_t kLongestText = 4096;

/// As printed in a sentence: 100000, not 100000.000000.
std::string shortText(double number) { return nlohmann::json(number).dump(); }

}  // namespace

JsonReader JsonReader::operator[](std::string_view key) const {
  const std::string path = path_.empty() ? std::string(key) : path_ + "." + std::string(key);
  if (value_ == nullptr) return {nullptr, path, *fault_};
  if (!value_->is_object()) {
    refuse("must be an object");
    return {nullptr, path, *fault_};
  }
  const auto found = value_->find(key);
  if (found != value_->end()) return {&*found, path, *fault_};
  fault_->note(path, "is missing");
  return {nullptr, path, *fault_};
}

JsonReader JsonReader::element(std::size_t index) const {
  return {&value_->at(index), path_ + "[" + std::to_string(index) + "]", *fault_};
}

std::size_t JsonReader::size(std::size_t most) const {
  if (value_ == nullptr) return 0;
  if (!value_->is_array()) {
    refuse("must be an array");
    return 0;
  }
  if (value_->size() <= most) return value_->size();
  refuse("has " + std::to_string(value_->size()) + " elements; at most " + std::to_string(most) +
         " are read");
  return 0;
}

bool JsonReader::has(std::string_view key) const {
  return value_ != nullptr && value_->is_object() && value_->contains(key);
}

double JsonReader::number(double largest) const {
  if (value_ == nullptr) return 0.0;
  const double number = value_->is_number() ? value_->get<double>() : std::nan("");
  if (std::isfinite(number) && std::abs(number) <= largest) return number;
  refuse(std::isfinite(number) ? "must be between -" + shortText(largest) + " and " + shortText(largest)
                               : std::string("must be a finite number"));
  return 0.0;
}

std::optional<double> JsonReader::numberOrNull(double largest) const {
  if (isNull()) return std::nullopt;
  return number(largest);
}

std::uint64_t JsonReader::count(std::uint64_t largest) const {
  if (value_ == nullptr) return 0;
  if (value_->is_number_unsigned() && value_->get<std::uint64_t>() <= largest)
    return value_->get<std::uint64_t>();
  refuse("must be a whole number between 0 and " + std::to_string(largest));
  return 0;
}

bool JsonReader::flag() const {
  if (value_ == nullptr) return false;
  if (value_->is_boolean()) return value_->get<bool>();
  refuse("must be true or false");
  return false;
}

std::string JsonReader::text() const {
  if (value_ == nullptr) return {};
  if (value_->is_string() && value_->get_ref<const std::string&>().size() <= kLongestText)
    return value_->get<std::string>();
  refuse("must be a text of at most " + std::to_string(kLongestText) + " bytes");
  return {};
}

}  // namespace underway
