#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace underway {

/// The first fault found while a document is read, as "segments[3].from.x is missing". Empty: none so far.
class Fault {
 public:
  void note(const std::string& path, std::string_view what) {
    if (sentence_.empty()) sentence_ = (path.empty() ? "the document" : path) + " " + std::string(what);
  }
  [[nodiscard]] const std::string& sentence() const { return sentence_; }

 private:
  std::string sentence_;
};

/// A value inside a JSON document that knows its path and reads itself strictly. What cannot be read is noted
/// in the Fault and taken for 0, "" or an empty array: read everything, then look at the Fault once.
class JsonReader {
 public:
  using Json = nlohmann::json;

  JsonReader(const Json& document, Fault& fault) : JsonReader(&document, {}, fault) {}

  [[nodiscard]] JsonReader operator[](std::string_view key) const;
  /// The element of an array; the index must be below size().
  [[nodiscard]] JsonReader element(std::size_t index) const;
  /// Number of elements. Refuses what is no array and arrays longer than `most`.
  [[nodiscard]] std::size_t size(std::size_t most) const;

  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] bool isNull() const { return value_ != nullptr && value_->is_null(); }

  /// A number of a magnitude up to `largest`.
  [[nodiscard]] double number(double largest) const;
  [[nodiscard]] std::optional<double> numberOrNull(double largest) const;
  [[nodiscard]] std::uint64_t count(std::uint64_t largest) const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool flag() const;

  void refuse(std::string_view what) const { fault_->note(path_, what); }

 private:
  JsonReader(const Json* value, std::string path, Fault& fault)
      : value_(value), path_(std::move(path)), fault_(&fault) {}

  const Json* value_;  // null when the value is missing, which has been noted
  std::string path_;
  Fault* fault_;
};

}  // namespace underway
