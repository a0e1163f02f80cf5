#include "rubline/line_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/report/map_summary.hpp"
#include "rubsweep/maps/report/study_columns.hpp"

namespace rubsweep::apps {

using namespace line;

namespace {

using batch::csv_number;

/// First columns of every row that belongs to a point.
std::string key_of(const LinePoint& point, std::span<const LineCell> cells) {
  return fmt::format("{},{}", to_string(point.pass), csv_number(cells[point.cell].value));
}

void add_section(const LinePoint& point, const std::string& key, std::string& text) {
  const std::string order = point.row.order ? fmt::format("{}", *point.row.order) : "";
  for (std::size_t i = 0; i < point.motion->section.size(); ++i) {
    const SectionPoint& at = point.motion->section[i];
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", key, csv_number(point.row.speed_hz),
                        to_string(point.row.motion_class), order, i, csv_number(at.displacement_m.x()),
                        csv_number(at.displacement_m.y()), csv_number(at.velocity_m_per_s.x()),
                        csv_number(at.velocity_m_per_s.y()));
  }
}

void add_spectrum(const LinePoint& point, double clearance_m, const std::string& key, std::string& text) {
  const response::spectrum::FullSpectrum& spectrum = point.motion->spectrum;
  const int last = largest_cascade_order * spectrum.turns;
  const int low = std::max(spectrum.first_line(), -last), high = std::min(spectrum.last_line(), last);
  double largest_m = 0;
  for (int k = low; k <= high; ++k)
    if (k != 0) largest_m = std::max(largest_m, spectrum.amplitude(k));
  const double floor_m = std::max(response::motion::significant_share_of_largest * largest_m,
                                  response::motion::significant_share_of_clearance * clearance_m);
  for (int k = low; k <= high; ++k) {
    if (spectrum.amplitude(k) <= floor_m) continue;
    text +=
        fmt::format("{},{},{},{},{}\n", key, csv_number(point.row.speed_hz), csv_number(spectrum.order(k)),
                    csv_number(spectrum.order(k) * point.row.speed_hz), csv_number(spectrum.amplitude(k)));
  }
}

}  // namespace

LineTables tables_of(std::span<const LinePoint> points, std::span<const LineCell> cells,
                     std::string_view along) {
  LineTables tables;
  const sweep::Grid units = cells.empty() ? sweep::Grid{} : cells.front().study->grid;
  tables.line_csv = fmt::format("{}# along {}\npass,value,{}{}\n", report::map_comments(), along,
                                report::map_header(), report::unit_header(units));
  tables.bifurcation_csv = "pass,value,speed_hz,class,order,point,x_m,y_m,vx_m_per_s,vy_m_per_s\n";
  tables.cascade_csv = "pass,value,speed_hz,order,frequency_hz,amplitude_m\n";
  for (const LinePoint& point : points) {
    const std::string key = key_of(point, cells);
    tables.line_csv +=
        fmt::format("{},{}{}\n", key, report::map_line(point.row), report::unit_cells(point.row, units));
    if (!point.motion) continue;
    add_section(point, key, tables.bifurcation_csv);
    add_spectrum(point, cells[point.cell].study->machine.stops.front().clearance_m, key, tables.cascade_csv);
  }
  return tables;
}

std::string line_summary(std::span<const LinePoint> points, std::span<const LineCell> cells) {
  std::string text;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    const std::string name = report::motion_name(points[begin].row);
    while (end < points.size() && points[end].pass == points[begin].pass &&
           report::motion_name(points[end].row) == name)
      ++end;
    text += fmt::format("{:<9} {:.6g} to {:.6g}  {}\n", to_string(points[begin].pass),
                        cells[points[begin].cell].value, cells[points[end - 1].cell].value, name);
  }
  return text;
}

}  // namespace rubsweep::apps
