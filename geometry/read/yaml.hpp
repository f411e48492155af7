#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/error.hpp"

namespace underway {

/// One piece of a YAML file: nothing, a scalar, a list or a mapping.
struct YamlNode {
  enum class Kind : std::uint8_t { kNull, kScalar, kList, kMapping };
  Kind kind = Kind::kNull;
  bool is_quoted = false;          ///< of a scalar: quoted text is never a number
  int line = 1;                    ///< counted from 1; the key's, for a member of a mapping
  std::string key;                 ///< of a member of a mapping
  std::string text;                ///< of a scalar
  std::vector<YamlNode> children;  ///< of a list or a mapping, in the file's order
};

/// The largest YAML file that is read [bytes].
inline constexpr std::size_t kLargestYaml = std::size_t{64} << 20;

class YamlValue;

/// A parsed YAML file and the first thing found wrong with what it says. Reading goes on after a fault, with
/// fallbacks for values; so code that reads has no checks in between, and asks once, at the end, for `fault`.
class YamlFile {
 public:
  YamlFile(std::filesystem::path file, YamlNode root, ErrorCode code);

  /// Where reading begins. Values point into the file: it must stay where it is as long as they are used.
  [[nodiscard]] YamlValue root();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::optional<Error>& fault() const { return fault_; }
  /// Notes a fault, unless there is one already.
  void refuse(int line, const std::string& what);

 private:
  std::filesystem::path path_;
  YamlNode root_;
  ErrorCode code_;
  std::optional<Error> fault_;
};

/// Parses one YAML document. Refuses syntax errors, keys given twice, anchors and aliases, more than one
/// document, and trees too deep or too large to be meant. Errors: `code`, one sentence with file and line.
[[nodiscard]] Expected<YamlFile> parseYaml(const std::filesystem::path& file, const std::string& text,
                                           ErrorCode code);

/// A place in a YAML file, there or not. Wrong types become faults of the file, with line, key and what was
/// expected; a value that is not there reads as its fallback.
class YamlValue {
 public:
  /// Whether it is there.
  explicit operator bool() const { return node_ != nullptr; }
  [[nodiscard]] bool isMapping() const { return node_ != nullptr && node_->kind == YamlNode::Kind::kMapping; }
  /// Its key in the mapping it is a member of: not empty, no control characters.
  [[nodiscard]] std::string key() const;

  /// A member of a mapping that must be there.
  [[nodiscard]] YamlValue at(std::string_view key) const;
  /// A member of a mapping that need not be there.
  [[nodiscard]] YamlValue find(std::string_view key) const;
  /// Refuses a mapping with other keys than these, and what is no mapping.
  void allowOnly(const std::vector<std::string_view>& known) const;

  [[nodiscard]] std::vector<YamlValue> members() const;  ///< of a mapping, in the file's order
  [[nodiscard]] std::vector<YamlValue> items() const;    ///< of a list
  /// A list of `least` to `most` finite numbers; always at least `least` long, whatever the file holds.
  [[nodiscard]] std::vector<double> numbers(std::size_t least, std::size_t most) const;
  [[nodiscard]] double number(double fallback = 0.0) const;  ///< finite
  [[nodiscard]] bool flag(bool fallback = false) const;      ///< true, false, 1 or 0
  [[nodiscard]] std::string text(
      const std::string& fallback = {}) const;  ///< not empty, no control characters

  /// Notes a fault of this value, if it is there.
  void refuse(const std::string& what) const;

 private:
  friend class YamlFile;
  YamlValue(YamlFile& file, const YamlNode* node, std::string path)
      : file_(&file), node_(node), path_(std::move(path)) {}
  [[nodiscard]] bool is(YamlNode::Kind kind, const char* expected) const;
  void refuseUnlessName(const std::string& text) const;
  [[nodiscard]] std::string pathOf(std::string_view key) const;

  YamlFile* file_;
  const YamlNode* node_;
  std::string path_;  ///< as a person would write it: obstacles[3].size_m
};

/// The text in quotes for a sentence: cut to a sensible length, on one line.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// "a, b or c", for sentences.
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

}  // namespace underway
