#include "rubsweep/maps/config/yaml/json_document.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

/// Line and column of the last character that the parser took and that is no blank.
struct Cursor {
  int line = 1, column = 0;  ///< of the character taken last
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

/// Input iterator that tells a cursor what is read.
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
    // "[json.exception.parse_error.101] parse error at line 3, column 4: what": the place is said before it.
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
