#include "rubsweep/fit/measured_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <exception>
#include <numbers>
#include <utility>

#include "rubsweep/batch/input_file.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/table/encoding.hpp"
#include "rubsweep/table/rows.hpp"

namespace rubsweep::fit {
namespace {

struct Unit {
  std::string_view written, ending;
  double size;
};

constexpr std::array<Unit, 15> units{{{"s", "_s", 1},
                                      {"ms", "_s", 1e-3},
                                      {"us", "_s", 1e-6},
                                      {"m", "_m", 1},
                                      {"mm", "_m", 1e-3},
                                      {"um", "_m", 1e-6},
                                      {"mil", "_m", 25.4e-6},
                                      {"Hz", "_hz", 1},
                                      {"rpm", "_hz", 1.0 / 60},
                                      {"1/min", "_hz", 1.0 / 60},
                                      {"rev/min", "_hz", 1.0 / 60},
                                      {"rad/s", "_hz", 0.5 / std::numbers::pi},
                                      {"deg", "_deg", 1},
                                      {"\u00b0", "_deg", 1},
                                      {"rad", "_deg", 180 / std::numbers::pi}}};

/// Name of a column as the programs have it, and how many of its units one of these is; of an unknown unit
/// the name stays without one, and is not found.
std::pair<std::string, double> own_name(const table::Heading& heading) {
  std::string name;
  for (const char c : heading.name)
    name += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (name == "time") name = "t";
  if (heading.unit.empty()) return {name, 1};
  const auto unit = std::ranges::find(units, table::plain_unit(heading.unit), &Unit::written);
  if (unit == units.end()) return {name + " [" + heading.unit + ']', 1};
  if (!name.ends_with(unit->ending)) name += unit->ending;
  return {name, unit->size};
}

}  // namespace

MeasuredTable::MeasuredTable(const std::filesystem::path& file, std::string_view needed) : path_(file) {
  std::exception_ptr fault;
  try {
    own_.emplace(file);
    own_->column(needed);
    return;
  } catch (const IoError&) {
    fault = std::current_exception();
  }
  own_.reset();
  if (!read_of_somebody(needed)) std::rethrow_exception(fault);
}

bool MeasuredTable::read_of_somebody(std::string_view needed) {
  std::string text;
  table::Layout layout;
  std::vector<double> sizes;
  std::vector<std::size_t> places;
  try {
    text = table::utf8_of(batch::read_input(path_));
    layout = table::layout_of(text);
  } catch (const table::Fault&) {
    return false;  // what the reader of the programs said is told
  }
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    if (layout.columns[i].is_text) continue;
    auto [name, size] = own_name(layout.columns[i].heading);
    header_.push_back(std::move(name));
    sizes.push_back(size);
    places.push_back(i);
  }
  if (std::ranges::count(header_, needed) != 1) return false;
  try {
    table::Rows rows(text, layout);
    while (rows.next()) {
      if (rows.is_empty()) continue;
      lines_.push_back(rows.line());
      rows_.emplace_back();
      for (std::size_t k = 0; k < places.size(); ++k)
        rows_.back().push_back(places[k] < rows.cells().size() ? sizes[k] * rows.number(places[k]) : NAN);
    }
  } catch (const table::Fault& fault) {
    throw ConfigError(fmt::format("{}:{}:{}: {}, allowed: {}", path_.string(), fault.line, fault.column,
                                  fault.wrong, fault.allowed));
  }
  return true;
}

std::size_t MeasuredTable::column(std::string_view name) const {
  if (own_) return own_->column(name);
  const auto found = std::ranges::find(header_, name);
  if (found != header_.end() && std::ranges::count(header_, name) == 1)
    return static_cast<std::size_t>(found - header_.begin());
  throw IoError(fmt::format("{}: has no column '{}', or two of them, only: {}", path_.string(), name,
                            fmt::join(header_, ", ")));
}

bool MeasuredTable::next() {
  if (own_) return own_->next();
  if (row_ == rows_.size()) return false;
  ++row_;
  return true;
}

double MeasuredTable::number(std::size_t column) const {
  return own_ ? own_->number(column) : rows_[row_ - 1][column];
}

batch::CsvReader::RowPosition MeasuredTable::place() const {
  return own_ ? own_->place() : batch::CsvReader::RowPosition{0, lines_[row_ - 1]};
}

}  // namespace rubsweep::fit
