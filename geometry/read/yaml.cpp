#include "geometry/read/yaml.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace underway {
namespace {

/// What a person would call it: 'found ...'.
std::string describe(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::kNull:
      return "nothing";
    case YamlNode::Kind::kList:
      return "a list of " + std::to_string(node.children.size());
    case YamlNode::Kind::kMapping:
      return "a mapping";
    case YamlNode::Kind::kScalar:
      break;
  }
  return (node.is_quoted ? "the text " : "") + inQuotes(node.text);
}

/// Letters to change, add or drop to make one word of the other.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// ' (did you mean "obstacles"?)', or what there is to choose from.
std::string hintFor(std::string_view key, const std::vector<std::string_view>& known) {
  constexpr std::size_t kLongestWord = 40;
  constexpr std::size_t kFarthest = 2;
  if (key.size() <= kLongestWord)
    for (std::size_t distance = 1; distance <= kFarthest; ++distance)
      for (const std::string_view word : known)
        if (editDistance(key, word) == distance) return " (did you mean " + inQuotes(word) + "?)";
  return "; known here: " + listed({known.begin(), known.end()});
}

/// Infinity or not-a-number, in any of the spellings that YAML and C know.
bool isNotFinite(std::string_view text) {
  std::string word;
  for (const char c : text)
    if (c != '.' && c != '-' && c != '+') word += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return word == "inf" || word == "infinity" || word == "nan";
}

bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// On one line, cut to a sensible length.
std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string line(text.substr(0, kLongest));
  std::replace_if(line.begin(), line.end(), isControl, '?');
  return text.size() > kLongest ? line + "..." : line;
}

}  // namespace

std::string inQuotes(std::string_view text) { return std::string(1, '"').append(shown(text)).append(1, '"'); }

std::string listed(const std::vector<std::string>& words) {
  std::string sentence;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) sentence += i + 1 == words.size() ? " or " : ", ";
    sentence += words[i];
  }
  return sentence;
}

YamlFile::YamlFile(std::filesystem::path file, YamlNode root, ErrorCode code)
    : path_(std::move(file)), root_(std::move(root)), code_(code) {}

YamlValue YamlFile::root() { return {*this, &root_, ""}; }

void YamlFile::refuse(int line, const std::string& what) {
  if (!fault_) fault_ = Error{code_, path_.string() + ":" + std::to_string(line) + ": " + what, {}};
}

std::string YamlValue::key() const {
  if (node_ == nullptr) return {};
  refuseUnlessName(node_->key);
  return node_->key;
}

void YamlValue::refuse(const std::string& what) const {
  if (node_ != nullptr) file_->refuse(node_->line, path_.empty() ? what : path_ + ": " + what);
}

bool YamlValue::is(YamlNode::Kind kind, const char* expected) const {
  if (node_ == nullptr) return false;
  if (node_->kind == kind) return true;
  refuse(std::string("expected ") + expected + ", found " + describe(*node_));
  return false;
}

std::string YamlValue::pathOf(std::string_view key) const {
  return path_.empty() ? shown(key) : path_ + "." + shown(key);
}

YamlValue YamlValue::find(std::string_view key) const {
  if (is(YamlNode::Kind::kMapping, "a mapping"))
    for (const YamlNode& member : node_->children)
      if (member.key == key) return {*file_, &member, pathOf(key)};
  return {*file_, nullptr, pathOf(key)};
}

YamlValue YamlValue::at(std::string_view key) const {
  YamlValue value = find(key);
  if (!value && isMapping()) refuse("key " + inQuotes(key) + " is missing");
  return value;
}

void YamlValue::allowOnly(const std::vector<std::string_view>& known) const {
  if (!is(YamlNode::Kind::kMapping, "a mapping")) return;
  for (const YamlNode& member : node_->children) {
    if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
    file_->refuse(member.line, (path_.empty() ? "" : path_ + ": ") + "unknown key " + inQuotes(member.key) +
                                   hintFor(member.key, known));
    return;
  }
}

std::vector<YamlValue> YamlValue::members() const {
  std::vector<YamlValue> found;
  if (!is(YamlNode::Kind::kMapping, "a mapping")) return found;
  for (const YamlNode& member : node_->children) found.push_back({*file_, &member, pathOf(member.key)});
  return found;
}

std::vector<YamlValue> YamlValue::items() const {
  std::vector<YamlValue> found;
  if (!is(YamlNode::Kind::kList, "a list")) return found;
  found.reserve(node_->children.size());
  for (const YamlNode& item : node_->children)
    found.push_back({*file_, &item, path_ + "[" + std::to_string(found.size()) + "]"});
  return found;
}

std::vector<double> YamlValue::numbers(std::size_t least, std::size_t most) const {
  std::vector<double> values;
  const std::string count = std::to_string(least) + (most > least ? " to " + std::to_string(most) : "");
  const std::string expected = "a list of " + count + " numbers";
  if (is(YamlNode::Kind::kList, expected.c_str())) {
    if (node_->children.size() < least || node_->children.size() > most)
      refuse("expected " + expected + ", found " + describe(*node_));
    else
      for (const YamlValue& item : items()) values.push_back(item.number());
  }
  values.resize(std::max(values.size(), least), 0.0);
  return values;
}

double YamlValue::number(double fallback) const {
  if (!is(YamlNode::Kind::kScalar, "a number")) return fallback;
  const auto refused = [&](const std::string& what) { return refuse(what), fallback; };
  if (node_->is_quoted) return refused("expected a number, found " + describe(*node_));
  if (isNotFinite(node_->text)) return refused("must be a finite number, found " + inQuotes(node_->text));
  std::string_view text = node_->text;
  // YAML allows one plus sign, from_chars none; a sign after it is left for from_chars to refuse.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range)
    return refused(inQuotes(node_->text) + " is beyond what a number can hold");
  if (error != std::errc{} || end != text.data() + text.size())
    return refused("expected a number, found " + inQuotes(node_->text));
  return value;
}

bool YamlValue::flag(bool fallback) const {
  if (!is(YamlNode::Kind::kScalar, "true or false")) return fallback;
  for (const char* word : {"1", "true", "True", "TRUE"})
    if (node_->text == word) return true;
  for (const char* word : {"0", "false", "False", "FALSE"})
    if (node_->text == word) return false;
  refuse("expected true or false (or 1 or 0), found " + describe(*node_));
  return fallback;
}

std::string YamlValue::text(const std::string& fallback) const {
  if (!is(YamlNode::Kind::kScalar, "text")) return fallback;
  refuseUnlessName(node_->text);
  return node_->text;
}

void YamlValue::refuseUnlessName(const std::string& text) const {
  if (text.empty()) refuse("must not be empty");
  if (std::any_of(text.begin(), text.end(), isControl))
    refuse("must not hold control characters, found " + inQuotes(text));
}

}  // namespace underway
