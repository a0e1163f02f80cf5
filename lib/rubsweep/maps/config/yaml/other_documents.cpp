#include "rubsweep/maps/config/yaml/other_documents.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

/// Copies toml++'s tree, whose maps are sorted by key.
class TreeCopy {
 public:
  explicit TreeCopy(int file) : file_(file) {}

  Node copy(const toml::node& from) const {
    Node node{Node::Kind::scalar, place(from.source())};
    if (const toml::table* table = from.as_table()) {
      copy_entries(*table, node);
    } else if (const toml::array* array = from.as_array()) {
      node.kind = Node::Kind::list;
      for (const toml::node& item : *array) node.items.push_back(copy(item));
    } else {
      copy_scalar(from, node);
    }
    return node;
  }

 private:
  SourcePosition place(const toml::source_region& region) const {
    return {-1, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), file_};
  }

  void copy_entries(const toml::table& table, Node& node) const {
    node.kind = Node::Kind::map;
    std::vector<std::pair<Node::Key, const toml::node*>> entries;
    for (const auto& [key, value] : table)
      entries.push_back({{std::string(key.str()), place(key.source())}, &value});
    std::ranges::stable_sort(entries, {}, [](const auto& entry) { return entry.first.place; });
    for (auto& [key, value] : entries) {
      node.keys.push_back(std::move(key));
      node.items.push_back(copy(*value));
    }
  }

  /// Copies a scalar; numbers become the shortest text that reads back the same.
  static void copy_scalar(const toml::node& from, Node& node) {
    if (const auto* number = from.as_floating_point()) {
      node.text = fmt::format("{}", number->get());
    } else if (const auto* integer = from.as_integer()) {
      node.text = fmt::format("{}", integer->get());
    } else if (const auto* flag = from.as_boolean()) {
      node.text = flag->get() ? "true" : "false";
    } else {
      node.text = from.as_string() != nullptr ? from.as_string()->get() : "a date or time";
      node.quoted = true;
    }
  }

  int file_;
};

/// Place of the first key with too many parts, or of the first bracket nested too deeply. For a long key,
/// toml++ would nest one table for each part, and its destructor would overflow the stack. Strings and
/// comments are skipped.
std::optional<SourcePosition> too_deep(std::string_view text, int file) {
  std::size_t parts = 1, brackets = 0, line_begin = 0;
  int line = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '"' || c == '\'') {
      const bool block = text.substr(i, 3) == std::string(3, c);
      for (i += block ? 3 : 1; i < text.size(); ++i) {
        if (text[i] == '\n') line_begin = i + 1, ++line;
        if (c == '"' && text[i] == '\\')
          ++i;
        else if (block ? text.substr(i, 3) == std::string(3, c) : text[i] == c || text[i] == '\n')
          break;
      }
      i += block ? 2 : 0;
    } else {
      if (c == '\n') line_begin = i + 1, ++line;
      const bool of_key =
          std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == ' ' || c == '\t';
      parts = c == '.' ? parts + 1 : of_key ? parts : 1;
      if (c == '[' || c == '{') ++brackets;
      if ((c == ']' || c == '}') && brackets > 0) --brackets;
    }
    if (parts > max_document_depth || brackets > max_document_depth)
      return SourcePosition{-1, line, static_cast<int>(i - line_begin) + 1, file};
  }
  return std::nullopt;
}

std::size_t depth_of(const Node& node) {
  std::size_t depth = 0;
  for (const Node& item : node.items) depth = std::max(depth, depth_of(item) + 1);
  return depth;
}

/// Counts lines and columns of the characters read by the parser, and stores the place of the last one that
/// is not blank.
struct Cursor {
  int line = 1, column = 0;  ///< place of the last character taken
  int seen_line = 1, seen_column = 1;

  void take(char c) {
    ++column;
    if (c == '\n') {
      ++line;
      column = 0;
    } else if (c != ' ' && c != '\t' && c != '\r') {
      seen_line = line;
      seen_column = column;
    }
  }
};

/// Input iterator that reports every character read to a cursor.
class Reader {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Reader(const char* at, Cursor* cursor) : at_(at), cursor_(cursor) {}
  reference operator*() const { return *at_; }
  Reader& operator++() {
    cursor_->take(*at_++);
    return *this;
  }
  Reader operator++(int) {
    Reader before = *this;
    ++*this;
    return before;
  }
  bool operator==(const Reader& other) const { return at_ == other.at_; }
  bool operator!=(const Reader& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Cursor* cursor_;
};

class JsonTreeBuilder {
 public:
  using number_integer_t = nlohmann::json::number_integer_t;
  using number_unsigned_t = nlohmann::json::number_unsigned_t;
  using number_float_t = nlohmann::json::number_float_t;
  using string_t = nlohmann::json::string_t;
  using binary_t = nlohmann::json::binary_t;

  JsonTreeBuilder(const Cursor& cursor, int file) : cursor_(cursor), file_(file) {}

  bool null() { return add({Node::Kind::null, here()}); }
  bool boolean(bool value) { return add({Node::Kind::scalar, here(), value ? "true" : "false"}); }
  bool number_integer(number_integer_t value) { return number(fmt::format("{}", value)); }
  bool number_unsigned(number_unsigned_t value) { return number(fmt::format("{}", value)); }
  bool number_float(number_float_t value, const string_t&) { return number(fmt::format("{}", value)); }
  bool string(const string_t& value) { return add({Node::Kind::scalar, here(), value, true}); }
  bool binary(const binary_t&) { return false; }
  bool key(const string_t& name) {
    open_.back().keys.push_back({name, here()});
    return true;
  }
  bool start_object(std::size_t) { return open(Node::Kind::map); }
  bool start_array(std::size_t) { return open(Node::Kind::list); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) {
    // Removes the place from "[json.exception.parse_error.101] parse error at line 3, column 4: what".
    const std::string text = error.what();
    const std::size_t colon = text.find(": ");
    problem =
        fmt::format("no JSON: {}", shown(colon == std::string::npos ? text : text.substr(colon + 2), 200));
    return false;
  }

  std::string problem;
  Node root;

 private:
  SourcePosition here() const { return {-1, cursor_.seen_line, cursor_.seen_column, file_}; }
  bool number(std::string text) { return add({Node::Kind::scalar, here(), std::move(text)}); }

  bool count() {
    if (++nodes_ <= max_document_nodes && open_.size() <= max_document_depth) return true;
    problem = fmt::format("too many values, or too deep ones: more than {} in {} levels", max_document_nodes,
                          max_document_depth);
    return false;
  }

  bool add(Node node) {
    (open_.empty() ? root : open_.back().items.emplace_back()) = std::move(node);
    return count();
  }

  bool open(Node::Kind kind) {
    open_.push_back({kind, here()});
    return count();
  }

  bool close() {
    Node done = std::move(open_.back());
    open_.pop_back();
    (open_.empty() ? root : open_.back().items.emplace_back()) = std::move(done);
    return true;
  }

  const Cursor& cursor_;
  int file_;
  std::size_t nodes_ = 0;
  std::vector<Node> open_;
};

}  // namespace

std::optional<Node> parse_toml(std::string_view text, std::string_view path, Diagnostics& diagnostics,
                               int file) {
  const SourcePosition top{-1, 1, 1, file};
  if (text.size() > max_document_bytes) {
    diagnostics.add(top, path, "the file is too large", fmt::format("at most {} bytes", max_document_bytes));
    return std::nullopt;
  }
  const auto refuse_extent = [&](const SourcePosition& place) {
    diagnostics.add(place, path, "too many values, or too deep ones",
                    fmt::format("at most {} values in {} levels", max_document_nodes, max_document_depth));
    return std::nullopt;
  };
  if (const auto place = too_deep(text, file)) return refuse_extent(*place);
  try {
    Node root = TreeCopy(file).copy(toml::parse(text));
    if (count_nodes(root) <= max_document_nodes && depth_of(root) <= max_document_depth) return root;
    return refuse_extent(top);
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    diagnostics.add({-1, static_cast<int>(at.line), static_cast<int>(at.column), file}, path,
                    fmt::format("no TOML: {}", shown(error.description(), 200)), "a TOML document");
  }
  return std::nullopt;
}

std::optional<Node> parse_json(std::string_view text, std::string_view path, Diagnostics& diagnostics,
                               int file) {
  if (text.size() > max_document_bytes) {
    diagnostics.add({-1, 1, 1, file}, path, "the file is too large",
                    fmt::format("at most {} bytes", max_document_bytes));
    return std::nullopt;
  }
  Cursor cursor;
  JsonTreeBuilder builder(cursor, file);
  const Reader begin(text.data(), &cursor), end(text.data() + text.size(), &cursor);
  if (nlohmann::json::sax_parse(begin, end, &builder)) return std::move(builder.root);
  diagnostics.add({-1, cursor.seen_line, cursor.seen_column, file}, path, builder.problem, "a JSON document");
  return std::nullopt;
}

}  // namespace rubsweep::config::yaml
