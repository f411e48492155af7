#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gait/error.hpp"

namespace underway::gait {

/// Reads the fields of a JSON object and remembers the first thing wrong. Reading goes on after a fault with
/// 0 or an empty text, so that code that reads asks once, at the end. Only gait's own sources include this.
class JsonFields {
 public:
  /// `where` names the object in sentences: "gaits/nominal.json" or "gaits/nominal.json, times".
  JsonFields(const nlohmann::json& object, std::string where);

  [[nodiscard]] double number(const char* key);  ///< finite
  [[nodiscard]] double positive(const char* key);
  [[nodiscard]] std::string text(const char* key);  ///< not empty
  [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count);
  [[nodiscard]] const nlohmann::json& at(const char* key);
  /// A field that is an object; its faults become ours when it is finished with `take`.
  [[nodiscard]] JsonFields object(const char* key);
  void take(const JsonFields& part);
  /// A fault of a value that is of the right type.
  void refuse(const std::string& key, const std::string& what);

  /// The first fault, or that of a field that nobody asked for.
  [[nodiscard]] std::optional<GaitError> fault() const;

 private:
  const nlohmann::json& json_;
  std::string where_;
  std::vector<std::string> known_;
  std::optional<GaitError> fault_;
};

/// The parsed text. Errors: no JSON object, with the place where reading stopped.
[[nodiscard]] GaitExpected<nlohmann::json> parseJson(std::string_view text, const std::string& where);

}  // namespace underway::gait
