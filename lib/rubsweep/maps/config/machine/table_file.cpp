#include "rubsweep/maps/config/machine/table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "rubsweep/maps/config/yaml/text.hpp"
#include "rubsweep/maps/table/layout.hpp"
#include "rubsweep/maps/table/rows.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr unsigned lines_of_speed = 3;
constexpr std::array<std::size_t, lines_of_speed> numbers_of_line{2, 4, 4};

struct Line {
  std::size_t number = 0;
  std::string_view text;
  std::vector<std::string_view> cells = table::cells_of(text, ' ');

  bool has_numbers(std::size_t count) const {
    return cells.size() == count && std::ranges::all_of(cells, [](std::string_view cell) {
             return std::isfinite(table::number_in(cell, {' '}).value_or(NAN));
           });
  }
  bool counts() const {
    return cells.size() <= 3 && has_numbers(cells.size()) &&
           text.find_first_not_of("0123456789 \t") == std::string_view::npos;
  }
  table::Fault fault(std::string wrong, std::string allowed) const {
    return {number, 1, std::move(wrong), std::move(allowed)};
  }
  /// Flag of units at a place of this line: true (also where the flag is left out) if ANSYS converts from US
  /// customary units or rpm.
  bool flag(std::size_t place) const {
    if (place < cells.size() && cells[place] != "0" && cells[place] != "1")
      throw fault(fmt::format("'{}' is no flag of units", cells[place]), "0 or 1");
    return place >= cells.size() || cells[place] == "1";
  }
};

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = table::take_line(text);
    if (line.find_first_not_of(" \t") != std::string_view::npos) lines.push_back({number, line});
  }
  return lines;
}

constexpr std::string_view allowed_table_file = "a file to read, named relative to this one";

/// Reads the columns of a text by their keys. A column that has an unknown name and holds words is a comment.
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
      // All numbers of a column must have the same decimal sign.
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

std::optional<yaml::Node> read_ansys_bearing(std::string_view text, int file) {
  constexpr std::ptrdiff_t most_titles = 3;
  const std::vector<Line> lines = lines_of(text);
  const auto count = std::ranges::find_if(lines, &Line::counts);
  if (lines.end() - count <= std::ptrdiff_t{lines_of_speed} || count - lines.begin() > most_titles) return {};
  for (std::size_t k = 0; k < lines_of_speed; ++k)
    if (!count[static_cast<std::ptrdiff_t>(k) + 1].has_numbers(numbers_of_line[k])) return {};
  const bool in_pounds = count->flag(1), in_rpm = count->flag(2);
  yaml::Node read{yaml::Node::Kind::map, {-1, static_cast<int>(count->number), 1, file}};
  const auto add_columns = [&](std::initializer_list<std::string_view> names, std::string_view unit) {
    for (const std::string_view name : names) {
      read.keys.push_back({fmt::format("{}_{}", name, unit), read.place});
      read.items.push_back({yaml::Node::Kind::list, read.place});
    }
  };
  add_columns({"speed"}, in_rpm ? "rpm" : "rad_per_s");
  add_columns({"kxx", "kxy", "kyx", "kyy"}, in_pounds ? "lbf_per_in" : "n_per_m");
  add_columns({"cxx", "cxy", "cyx", "cyy"}, in_pounds ? "lbf_s_per_in" : "ns_per_m");
  std::size_t found = 0;
  for (auto line = count + 1; line != lines.end(); ++line, ++found) {
    const std::size_t kind = found % lines_of_speed;
    if (!line->has_numbers(numbers_of_line[kind]))
      throw line->fault("is no line of a bearing of ANSYS", fmt::format("{} numbers", numbers_of_line[kind]));
    for (std::size_t k = kind == 0 ? 1 : 0; k < line->cells.size(); ++k) {
      const auto byte = static_cast<int>(line->cells[k].data() - line->text.data()) + 1;
      read.items[kind == 0 ? 0 : 4 * kind - 3 + k].items.push_back(
          {yaml::Node::Kind::scalar,
           {-1, static_cast<int>(line->number), byte, file},
           fmt::format("{}", *table::number_in(line->cells[k], {' '}))});
    }
  }
  if (static_cast<double>(found) / lines_of_speed != *table::number_in(count->cells[0], {' '}))
    throw count->fault(fmt::format("counts {} speeds, and {} lines follow", count->cells[0], found),
                       "three lines for each speed");
  return read;
}

yaml::Node* child(yaml::Node* map, std::string_view name) {
  return map == nullptr ? nullptr : yaml::entry(*map, name);
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
  if (yaml::entry(table, "file") == nullptr) return;
  const yaml::Node name = *yaml::entry(table, "file");
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
