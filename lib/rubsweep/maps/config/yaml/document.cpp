#include "rubsweep/maps/config/yaml/document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

struct Refusal {
  SourcePosition place;
  std::string wrong;
  std::string allowed;
};

struct Extent {
  std::size_t nodes = 1;
  std::size_t depth = 1;  // depth of maps and lists, the node itself included
  std::size_t bytes = 0;  // size of copied scalars
};

Extent extent_of(const Node& node) {
  Extent extent{1, node.kind == Node::Kind::list || node.kind == Node::Kind::map ? 1U : 0U, node.text.size()};
  for (const Node& item : node.items) {
    const Extent inner = extent_of(item);
    extent.nodes += inner.nodes;
    extent.bytes += inner.bytes;
    extent.depth = std::max(extent.depth, inner.depth + 1);
  }
  return extent;
}

/// Origin of a text: a file of the configuration, or an override.
struct Source {
  int override_index;
  int file;
};

SourcePosition place_of(const YAML::Mark& mark, const Source& source) {
  return source.override_index < 0
             ? SourcePosition{-1, std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1, source.file}
             : SourcePosition{source.override_index, 1, 1};
}

/// Builds the tree from yaml-cpp's events. YAML::Load does not suffice: it shares aliased nodes, so that an
/// override of one node would also change the other. It also ignores a second document and has no limits.
class YamlTreeBuilder : public YAML::EventHandler {
 public:
  explicit YamlTreeBuilder(const Source& source) : source_(source) {}

  Node take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) refuse(mark, "a second YAML document begins", "one document");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    complete(Node{Node::Kind::null, at(mark)}, anchor, {1, 0});
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_tag(mark, tag);
    complete(Node{Node::Kind::scalar, at(mark), value, tag == "!"}, anchor, {1, 0});
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) refuse(mark, "an alias stands inside the value it names", "");
    count(at(mark), extent_of(found->second));
    complete(found->second, 0, {0, 0});
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, Node::Kind::list);
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, Node::Kind::map);
  }
  void OnMapEnd() override { close(); }

 private:
  SourcePosition at(const YAML::Mark& mark) const { return place_of(mark, source_); }

  [[noreturn]] void refuse(const YAML::Mark& mark, std::string wrong, std::string allowed) const {
    throw Refusal{at(mark), std::move(wrong), std::move(allowed)};
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    refuse(mark, fmt::format("the tag '{}' is not supported", shown(tag)), "values without a tag");
  }

  void count(const SourcePosition& place, const Extent& extent) {
    nodes_ += extent.nodes;
    copied_bytes_ += extent.bytes;
    if (copied_bytes_ > max_document_bytes)
      throw Refusal{place, "aliases copy too much text", fmt::format("at most {} bytes", max_document_bytes)};
    if (nodes_ > max_document_nodes) {
      throw Refusal{place, "too many values", fmt::format("at most {}", max_document_nodes)};
    }
    if (open_.size() + extent.depth > max_document_depth) {
      throw Refusal{place, "nested too deep", fmt::format("at most {} levels", max_document_depth)};
    }
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Node::Kind kind) {
    refuse_tag(mark, tag);
    count(at(mark), {1, 1});
    open_.emplace_back(Node{kind, at(mark)}, anchor);
  }

  void close() {
    auto [node, anchor] = std::move(open_.back());
    open_.pop_back();
    complete(std::move(node), anchor, {0, 0});
  }

  void complete(Node node, YAML::anchor_t anchor, const Extent& extent) {
    count(node.place, extent);
    if (anchor != 0) {
      const Extent copy = extent_of(node);  // the anchor keeps a copy
      count(node.place, {copy.nodes, 0, copy.bytes});
      anchors_.insert_or_assign(anchor, node);
    }
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Node& parent = open_.back().first;
    const bool is_map = parent.kind == Node::Kind::map;
    if (is_map && parent.keys.size() == parent.items.size()) {
      if (node.kind != Node::Kind::scalar) {
        throw Refusal{node.place, "a key is not a name", "a name before ':'"};
      }
      if (node.text == "<<" && !node.quoted) {
        throw Refusal{node.place, "the merge key << is not supported",
                      "the keys themselves, or base: FILE for those of another file"};
      }
      parent.keys.push_back({std::move(node.text), node.place});
      return;
    }
    if (is_map && node.kind == Node::Kind::null) refuse_decimal_comma(parent);
    // yaml-cpp gives a missing value the place of the next token.
    if (is_map && node.kind == Node::Kind::null) node.place = parent.keys.back().place;
    parent.items.push_back(std::move(node));
  }

  /// Refuses a key that is a number without a value and follows a number, as in `{mass_kg: 0,8}`: YAML reads
  /// mass_kg: 0 and a key 8.
  static void refuse_decimal_comma(const Node& map) {
    if (map.items.empty() || map.items.back().kind != Node::Kind::scalar || map.items.back().quoted) return;
    const std::string& whole = map.items.back().text;
    const std::string& part = map.keys.back().text;
    const auto number = [](std::string_view text) { return parse_number(text).error == NumberError::none; };
    if (!number(whole) || part.empty() || part.front() < '0' || part.front() > '9' || !number(part)) return;
    throw Refusal{map.items.back().place,
                  fmt::format("{},{} is two values: a comma parts them", shown(whole), shown(part)),
                  fmt::format("a decimal point, {}.{}", shown(whole), shown(part))};
  }

  Source source_;
  int documents_ = 0;
  std::size_t nodes_ = 0, copied_bytes_ = 0;
  Node root_;
  std::vector<std::pair<Node, YAML::anchor_t>> open_;
  std::map<YAML::anchor_t, Node> anchors_;
};

void refuse_unreadable(std::string_view text, const Source& source) {
  if (text.size() > max_document_bytes) {
    throw Refusal{place_of({}, source), "too large", fmt::format("at most {} bytes", max_document_bytes)};
  }
  const auto offset = first_unreadable_byte(text);
  if (!offset) return;
  YAML::Mark mark;
  mark.line = static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(*offset), '\n'));
  // Without a line end rfind gives npos, and npos + 1 is 0, the begin of the first line.
  mark.column = static_cast<int>(*offset - (text.substr(0, *offset).rfind('\n') + 1));
  const char byte = text[*offset];
  throw Refusal{place_of(mark, source),
                fmt::format("byte 0x{:02x} is {}", static_cast<unsigned char>(byte),
                            is_control(byte) ? "a control character" : "not UTF-8"),
                "UTF-8 text"};
}

Node parse(std::string_view text, const Source& source) {
  refuse_unreadable(text, source);
  // Without an explicit end of the document, yaml-cpp accepts a missing closing quote.
  std::istringstream stream(std::string(text) + (text.ends_with('\n') ? "...\n" : "\n...\n"));
  YAML::Parser parser(stream);
  YamlTreeBuilder builder(source);
  while (parser.HandleNextDocument(builder)) {
  }
  return builder.take_root();
}

/// Cause of a YAML error that the user cannot see, such as a tab or a no-break space.
struct InvisibleCause {
  YAML::Mark mark;
  std::string wrong, allowed;
};

/// Whether YAML expects a blank or nothing after `before`: at the begin of a line, or after a sign such as a
/// colon. Inside a text any character is allowed.
bool wants_a_blank(std::string_view before) {
  const std::size_t last = before.find_last_not_of(" \t");
  return last == std::string_view::npos ||
         std::string_view(":-,[{").find(before[last]) != std::string_view::npos;
}

/// First tab in an indentation, or first character that looks like a blank but is no blank in YAML. Searches
/// up to the line in which the parser stopped.
std::optional<InvisibleCause> invisible_cause(std::string_view text, const YAML::Mark& error) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  YAML::Mark mark;
  for (; mark.line <= std::max(error.line, 0) && !text.empty(); ++mark.line) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t first = line.find_first_not_of(" \t"), tab = line.find('\t');
    if (first == std::string_view::npos || line[first] == '#') continue;
    if (tab < first) {
      mark.column = static_cast<int>(tab);
      return InvisibleCause{mark, "not valid YAML: a tab indents this line", "blanks"};
    }
    const auto blank = find_foreign_blank(line);
    if (!blank || !wants_a_blank(line.substr(0, *blank))) continue;
    mark.column = static_cast<int>(*blank);
    return InvisibleCause{
        mark, fmt::format("not valid YAML: {} is not a blank", describe_character(line.substr(*blank))),
        "blanks"};
  }
  return std::nullopt;
}

std::string describe(const YAML::Exception& error) {
  if (error.msg == YAML::ErrorMsg::DOC_IN_SCALAR) return "not valid YAML: a quote is not closed";
  return "not valid YAML: " + shown(error.msg, 200);
}

}  // namespace

Node* entry(Node& map, std::string_view name) {
  const auto found = std::ranges::find(map.keys, name, &Node::Key::text);
  return found == map.keys.end() ? nullptr : &map.items[static_cast<std::size_t>(found - map.keys.begin())];
}

const Node* entry(const Node& map, std::string_view name) { return entry(const_cast<Node&>(map), name); }

std::size_t count_nodes(const Node& node) { return extent_of(node).nodes; }

std::optional<Node> parse_document(std::string_view text, int override_index, std::string_view path,
                                   Diagnostics& diagnostics, int file) {
  const Source source{override_index, file};
  try {
    return parse(text, source);
  } catch (const Refusal& refusal) {
    diagnostics.add(refusal.place, path, refusal.wrong, refusal.allowed);
  } catch (const YAML::Exception& error) {
    if (const auto cause = invisible_cause(text, error.mark)) {
      diagnostics.add(place_of(cause->mark, source), path, cause->wrong, cause->allowed);
      return std::nullopt;
    }
    diagnostics.add(place_of(error.mark, source), path, describe(error), "");
  }
  return std::nullopt;
}

}  // namespace rubsweep::config::yaml
