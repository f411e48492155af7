#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>

#include "geometry/read/yaml.hpp"

namespace underway {
namespace {

constexpr std::size_t kDeepest = 32;           // our deepest file nests six levels
constexpr std::size_t kMostNodes = 4'000'000;  // some 250,000 obstacles; about 0.4 GB

int lineOf(const YAML::Mark& mark) { return mark.line + 1; }

[[noreturn]] void refuse(const YAML::Mark& mark, const std::string& what) {
  throw YAML::ParserException(mark, what);
}

/// Builds the tree from the parser's events. Faults leave through the parser as its own exceptions do.
class TreeBuilder : public YAML::EventHandler {
 public:
  [[nodiscard]] YamlNode takeRoot() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) refuse(mark, "a second document begins; keep one document in the file");
  }
  void OnDocumentEnd() override {}
  void OnAnchor(const YAML::Mark& mark, const std::string&) override { refuseAlias(mark); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuseAlias(mark); }
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { add(mark, {}); }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& text) override {
    if (isKeyNext()) {
      open_.back().key = text;
      open_.back().key_line = lineOf(mark);
      open_.back().has_key = true;
      return;
    }
    YamlNode node;
    node.kind = YamlNode::Kind::kScalar;
    node.is_quoted = tag == "!";
    node.text = text;
    add(mark, std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    open(mark, YamlNode::Kind::kList);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    open(mark, YamlNode::Kind::kMapping);
  }
  void OnMapEnd() override {
    refuseKeysGivenTwice(open_.back().node);
    close();
  }

 private:
  /// A list or mapping whose end has not come yet.
  struct Open {
    YamlNode node;
    YAML::Mark mark;
    std::string key;
    int key_line = 1;
    bool has_key = false;
  };

  [[noreturn]] static void refuseAlias(const YAML::Mark& mark) {
    refuse(mark, "anchors and aliases are not read here; write the value out");
  }

  static void refuseKeysGivenTwice(const YamlNode& mapping) {
    std::vector<const YamlNode*> members;
    members.reserve(mapping.children.size());
    for (const YamlNode& member : mapping.children) members.push_back(&member);
    std::stable_sort(members.begin(), members.end(),
                     [](const YamlNode* a, const YamlNode* b) { return a->key < b->key; });
    const auto twice =
        std::adjacent_find(members.begin(), members.end(),
                           [](const YamlNode* a, const YamlNode* b) { return a->key == b->key; });
    if (twice == members.end()) return;
    const YamlNode& second = **std::next(twice);
    YAML::Mark mark;
    mark.line = second.line - 1;
    refuse(mark, "key " + inQuotes(second.key) + " is given twice (first on line " +
                     std::to_string((*twice)->line) + "); keep one of them");
  }

  [[nodiscard]] bool isKeyNext() const {
    return !open_.empty() && open_.back().node.kind == YamlNode::Kind::kMapping && !open_.back().has_key;
  }

  void open(const YAML::Mark& mark, YamlNode::Kind kind) {
    if (isKeyNext()) refuse(mark, "a key must be a word, not a list or a mapping");
    if (open_.size() >= kDeepest)
      refuse(mark, "nested more than " + std::to_string(kDeepest) + " levels deep");
    open_.push_back({});
    open_.back().node.kind = kind;
    open_.back().mark = mark;
  }

  void close() {
    const YAML::Mark mark = open_.back().mark;
    YamlNode node = std::move(open_.back().node);
    open_.pop_back();
    add(mark, std::move(node));
  }

  void add(const YAML::Mark& mark, YamlNode node) {
    if (isKeyNext()) refuse(mark, "a key is empty; give it a name");
    if (++nodes_ > kMostNodes) refuse(mark, "holds more than " + std::to_string(kMostNodes) + " values");
    node.line = lineOf(mark);
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& parent = open_.back();
    if (parent.has_key) {
      node.key = std::move(parent.key);
      node.line = parent.key_line;
      parent.has_key = false;
    }
    parent.node.children.push_back(std::move(node));
  }

  YamlNode root_;
  std::vector<Open> open_;
  std::size_t nodes_ = 0;
  int documents_ = 0;
};

}  // namespace

Expected<YamlFile> parseYaml(const std::filesystem::path& file, const std::string& text, ErrorCode code) {
  const auto refuse_at = [&](int line, const std::string& what) {
    return fail(code, file.string() + ":" + std::to_string(line) + ": " + what);
  };
  if (text.size() > kLargestYaml)
    return refuse_at(1, "holds " + std::to_string(text.size()) + " bytes; at most " +
                            std::to_string(kLargestYaml) + " are read as YAML");
  if (text.find('\0') != std::string::npos) return refuse_at(1, "holds binary data, not YAML text");
  TreeBuilder builder;
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) return refuse_at(1, "the file is empty");
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    return refuse_at(std::max(1, lineOf(error.mark)), error.msg);
  } catch (const std::exception& error) {
    return refuse_at(1, std::string("cannot be parsed as YAML: ") + error.what());
  }
  return YamlFile(file, builder.takeRoot(), code);
}

}  // namespace underway
