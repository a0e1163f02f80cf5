#include "rubsweep/report/map_csv.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "rubsweep/batch/csv_table.hpp"

namespace rubsweep::report {
namespace {

using batch::csv_number;
using sweep::Row;

struct Column {
  std::string_view name;
  std::string (*text)(const Row&);
};

template <class Value>
std::string integer(const std::optional<Value>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

std::string word(std::string_view text) { return std::string(text); }

/// Text of something that is only known where a motion was measured.
template <class Get>
std::string measured(const Row& row, Get get) {
  return row.measures ? get(*row.measures) : std::string();
}

using response::motion::Measures;

std::string hits_per_revolution(const Measures& m) {
  return csv_number(static_cast<double>(m.contact.hits) / m.turns);
}

/// Columns in the order of the file.
constexpr std::array columns{
    Column{"speed_hz", [](const Row& r) { return csv_number(r.speed_hz); }},
    Column{"whirl_ratio", [](const Row& r) { return csv_number(r.whirl_ratio); }},
    Column{"eccentricity_m", [](const Row& r) { return csv_number(r.eccentricity_m); }},
    Column{"class", [](const Row& r) { return word(to_string(r.motion_class)); }},
    Column{"order", [](const Row& r) { return integer(r.order); }},
    Column{"orbit",
           [](const Row& r) {
             return measured(r, [](const Measures& m) { return m.orbit ? word(to_string(*m.orbit)) : ""; });
           }},
    Column{"whirl",
           [](const Row& r) {
             return measured(r, [](const Measures& m) { return m.whirl ? word(to_string(*m.whirl)) : ""; });
           }},
    Column{"proof", [](const Row& r) { return r.proof ? word(to_string(*r.proof)) : std::string(); }},
    Column{"robust", [](const Row& r) { return r.robust ? word(*r.robust ? "yes" : "no") : std::string(); }},
    Column{"comb_spacing",
           [](const Row& r) {
             return measured(
                 r, [](const Measures& m) { return m.comb_spacing ? csv_number(*m.comb_spacing) : ""; });
           }},
    Column{"hits_per_revolution", [](const Row& r) { return measured(r, hits_per_revolution); }},
    Column{"contact_fraction",
           [](const Row& r) {
             return measured(r, [](const Measures& m) { return csv_number(m.contact.contact_fraction); });
           }},
    Column{"peak_displacement_m",
           [](const Row& r) {
             return measured(r, [](const Measures& m) { return csv_number(m.contact.peak_displacement_m); });
           }},
    Column{"peak_contact_force_n",
           [](const Row& r) {
             return measured(r, [](const Measures& m) { return csv_number(m.contact.peak_contact_force_n); });
           }},
    Column{"amplitude_1x_forward_m",
           [](const Row& r) {
             return measured(r, [](const Measures& m) { return csv_number(m.amplitude_1x_forward_m); });
           }},
    Column{"amplitude_1x_backward_m",
           [](const Row& r) {
             return measured(r, [](const Measures& m) { return csv_number(m.amplitude_1x_backward_m); });
           }},
    Column{"dominant_order",
           [](const Row& r) {
             return measured(
                 r, [](const Measures& m) { return m.dominant ? csv_number(m.dominant->order) : ""; });
           }},
    Column{"dominant_amplitude_m",
           [](const Row& r) {
             return measured(
                 r, [](const Measures& m) { return m.dominant ? csv_number(m.dominant->amplitude_m) : ""; });
           }},
    Column{"floquet_modulus",
           [](const Row& r) { return r.floquet_modulus ? csv_number(*r.floquet_modulus) : std::string(); }},
    Column{"lyapunov_per_revolution",
           [](const Row& r) {
             return r.lyapunov_per_revolution ? csv_number(*r.lyapunov_per_revolution) : std::string();
           }},
    Column{"last_contact_revolution", [](const Row& r) { return integer(r.last_contact_revolution); }},
    Column{"revolutions", [](const Row& r) { return fmt::format("{}", r.revolutions); }},
    Column{"status", [](const Row& r) { return r.status; }},
    Column{"start", [](const Row& r) { return r.start ? word(to_string(*r.start)) : std::string(); }},
};

}  // namespace

std::string map_header() {
  std::vector<std::string> names;
  for (const Column& column : columns) names.emplace_back(column.name);
  return batch::csv_row(names);
}

std::string map_line(const Row& row) {
  std::vector<std::string> cells;
  for (const Column& column : columns) cells.push_back(column.text(row));
  return batch::csv_row(cells);
}

std::string map_comments(const std::string& version, const std::string& digest) {
  return fmt::format(
      "# rubsweep {}\n"
      "# digest {}\n"
      "# units: SI, named in the columns; orders and ratios are pure numbers; forward whirl is positive\n",
      version, digest);
}

}  // namespace rubsweep::report
