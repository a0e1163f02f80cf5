#include "rubsweep/config/machine/table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "rubsweep/config/yaml/document.hpp"
#include "rubsweep/config/yaml/text.hpp"
#include "rubsweep/config/yaml/value.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::string_view allowed_table_file = "a file to read, named relative to this one";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Reads a file into a map of columns.
class TableFile {
 public:
  TableFile(const yaml::Value& name, std::string_view text, int file)
      : name_(name), rest_(text), file_(file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
  }

  yaml::Node read() {
    yaml::Node table{yaml::Node::Kind::map, name_.node.place};
    while (next_line()) {
      const std::vector<yaml::Node> cells = cells_of_line();
      if (table.keys.empty()) {
        for (const yaml::Node& cell : cells) {
          table.keys.push_back({cell.text, cell.place});
          table.items.push_back({yaml::Node::Kind::list, cell.place});
        }
      } else if (cells.size() == table.keys.size()) {
        for (std::size_t i = 0; i < cells.size(); ++i) table.items[i].items.push_back(cells[i]);
      } else {
        name_.diagnostics.add(cells.front().place, name_.path,
                              fmt::format("the line has {} cells", cells.size()),
                              fmt::format("{}, as many as there are names", table.keys.size()));
      }
    }
    if (table.keys.empty() || table.items.front().items.empty())
      name_.diagnostics.add({-1, 1, 1, file_}, name_.path, "the file holds no table",
                            "a line of names, then lines of numbers");
    return table;
  }

 private:
  bool next_line() {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find('\n');
      line_ = rest_.substr(0, end);
      rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
      ++number_;
      if (!trimmed(line_).empty() && trimmed(line_).front() != '#') return true;
    }
    return false;
  }

  std::vector<yaml::Node> cells_of_line() const {
    std::vector<yaml::Node> cells;
    for (std::size_t begin = 0;;) {
      const std::size_t end = line_.find(',', begin);
      const std::string_view cell = line_.substr(begin, end == std::string_view::npos ? end : end - begin);
      const std::size_t blanks = std::min(cell.find_first_not_of(" \t\r"), cell.size());
      cells.push_back({yaml::Node::Kind::scalar,
                       {-1, number_, static_cast<int>(begin + blanks) + 1, file_},
                       std::string(trimmed(cell))});
      if (end == std::string_view::npos) return cells;
      begin = end + 1;
    }
  }

  const yaml::Value& name_;
  std::string_view rest_, line_;
  int file_, number_ = 0;
};

}  // namespace

yaml::Node* child(yaml::Node* map, std::string_view name) {
  if (map == nullptr || map->kind != yaml::Node::Kind::map) return nullptr;
  const auto found = std::ranges::find(map->keys, name, &yaml::Node::Key::text);
  return found == map->keys.end() ? nullptr
                                  : &map->items[static_cast<std::size_t>(found - map->keys.begin())];
}

std::optional<yaml::FileBytes> read_named_file(const yaml::Value& name, std::filesystem::path& file) {
  const auto text = read_text(name);
  if (!text) return std::nullopt;
  file = std::filesystem::path(name.diagnostics.file_of(name.node.place)).parent_path() / *text;
  yaml::FileBytes bytes = yaml::read_bytes(file);
  if (bytes.problem.empty() && bytes.text.size() > yaml::max_document_bytes)
    bytes.problem = fmt::format("more than {} bytes", yaml::max_document_bytes);
  if (bytes.problem.empty()) return bytes;
  refuse(name, fmt::format("'{}' cannot be read: {}", yaml::shown(*text), bytes.problem), allowed_table_file);
  return std::nullopt;
}

void resolve_table_file(yaml::Node& table, const std::string& path, yaml::Diagnostics& diagnostics) {
  const auto found = std::ranges::find(table.keys, "file", &yaml::Node::Key::text);
  if (table.kind != yaml::Node::Kind::map || found == table.keys.end()) return;
  const yaml::Node name = table.items[static_cast<std::size_t>(found - table.keys.begin())];
  const yaml::Value value{name, path + ".file", diagnostics};
  if (table.keys.size() > 1) return refuse(value, "is given beside other keys", "file alone");
  std::filesystem::path file;
  const auto bytes = read_named_file(value, file);
  if (!bytes) return;
  const int index = diagnostics.add_file(yaml::shown(file.string(), yaml::max_text_bytes));
  const std::size_t problems = diagnostics.count();
  yaml::Node read = TableFile(value, bytes->text, index).read();
  if (diagnostics.count() == problems) table = std::move(read);
}

}  // namespace rubsweep::config::machine
