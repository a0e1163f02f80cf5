#include "rubsweep/maps/config/machine/table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "rubsweep/maps/config/machine/ansys_bearing.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "rubsweep/maps/table/encoding.hpp"
#include "rubsweep/maps/table/rows.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::string_view allowed_table_file = "a file to read, named relative to this one";

/// Columns of a text by their keys; words of a column that is none of the known ones are comments.
class TableFile {
 public:
  TableFile(const yaml::Value& name, const KeyOf& key_of, int file)
      : name_(name), key_of_(key_of), file_(file) {}

  yaml::Node read(std::string_view bytes) const {
    yaml::Node read{yaml::Node::Kind::map, name_.node.place};
    try {
      const std::string text = table::utf8_of(bytes);
      if (const auto bearing = key_of_({"kxx"}).key.empty() ? std::nullopt : read_ansys_bearing(text, file_))
        return *bearing;
      const table::Layout layout = table::layout_of(
          text, [&](const table::Heading& heading) { return !key_of_(heading).key.empty(); });
      name_columns(layout, read);
      table::Rows rows(text, layout);
      while (rows.next()) add_row(rows, layout, read);
      drop_comments(layout, read);
      if (read.items.front().items.empty()) throw table::Fault{1, 1, no_table, table_form};
    } catch (const table::Fault& fault) {
      name_.diagnostics.add(place_of(fault.line, fault.column), name_.path, fault.wrong, fault.allowed);
    }
    return read;
  }

 private:
  static constexpr const char* no_table = "the file holds no table";
  static constexpr const char* table_form = "a line of names, then lines of numbers";

  yaml::SourcePosition place_of(std::size_t line, std::size_t column) const {
    return {-1, static_cast<int>(line), static_cast<int>(column), file_};
  }

  void name_columns(const table::Layout& layout, yaml::Node& read) const {
    for (const table::Column& column : layout.columns) {
      const ColumnKey key = key_of_(column.heading);
      const auto place = place_of(layout.names_line, column.column);
      if (!key.wrong.empty()) name_.diagnostics.add(place, name_.path, key.wrong, key.allowed);
      read.keys.push_back({key.key.empty() ? column.heading.name : key.key, place});
      read.items.push_back({yaml::Node::Kind::list, place});
    }
  }

  void add_row(table::Rows& rows, const table::Layout& layout, yaml::Node& read) const {
    if (rows.is_empty()) return;
    const auto& cells = rows.cells();
    if (cells.size() < layout.columns.size())
      return name_.diagnostics.add(place_of(rows.line(), 1), name_.path,
                                   fmt::format("the line has {} cells", cells.size()),
                                   fmt::format("{}, as many as there are names", layout.columns.size()));
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
      std::string text(cells[i]);
      // A number whose decimals do not look as those before it is a fault.
      if (rows.is_number(i)) {
        const double number = rows.number(i);
        if (text.find_first_of(",Dd") != std::string::npos) text = fmt::format("{}", number);
      }
      read.items[i].items.push_back(
          {yaml::Node::Kind::scalar, place_of(rows.line(), rows.place_of(i)), text});
    }
  }

  void drop_comments(const table::Layout& layout, yaml::Node& read) const {
    for (std::size_t i = layout.columns.size(); i-- > 0;) {
      const auto& cells = read.items[i].items;
      const bool words = std::ranges::any_of(cells, [](const yaml::Node& cell) {
        return !cell.text.empty() && !table::number_in(cell.text, {});
      });
      const bool empty = std::ranges::all_of(cells, [](const yaml::Node& cell) { return cell.text.empty(); });
      const bool comment = key_of_(layout.columns[i].heading).key.empty() && (words || empty);
      if (!comment || read.items.size() == 1) continue;
      read.keys.erase(read.keys.begin() + static_cast<std::ptrdiff_t>(i));
      read.items.erase(read.items.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  const yaml::Value& name_;
  const KeyOf& key_of_;
  int file_;
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

void resolve_table_file(yaml::Node& table, const std::string& path, const KeyOf& key_of,
                        yaml::Diagnostics& diagnostics) {
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
  yaml::Node read = TableFile(value, key_of, index).read(bytes->text);
  if (diagnostics.count() == problems) table = std::move(read);
}

}  // namespace rubsweep::config::machine
