#include "curves_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "rubsweep/analysis/branch/orbits/multipliers.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {

using namespace branch;
using namespace branch::curves;

namespace {

using batch::csv_number;

std::string place_cells(const orbits::PlanePoint& place) {
  return csv_number(place.first) + ',' + csv_number(place.second);
}

std::string ends(const Curve& curve) {
  return fmt::format("{} and {}", to_string(curve.backward), to_string(curve.forward));
}

template <class Value>
std::string interval(const Curve& curve, const Value& value) {
  const auto [low, high] = std::ranges::minmax(curve.points, {}, value);
  return fmt::format("{:.10g} to {:.10g}", value(low), value(high));
}

}  // namespace

std::string curve_comments(const std::string& parameter, const std::string& curve_parameter,
                           const std::vector<CurveFrom>& curves) {
  std::string text = fmt::format("# parameter {}\n# curve_parameter {}\n", parameter, curve_parameter);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve& curve = curves[i].curve;
    text += fmt::format("# curve {}: {}, order {}, ends {}\n", i, to_string(curve.kind), curve.order,
                        ends(curve));
  }
  return text;
}

std::string curves_csv(const std::vector<CurveFrom>& curves) {
  std::string text = "curve,kind,branch,event,parameter,curve_parameter,error,arclength,order" +
                     orbits::multiplier_columns() + ",amplitude_m,hits,contact_fraction,feasible\n";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto& [curve, branch, event] = curves[i];
    for (const CurvePoint& point : curve.points) {
      text += fmt::format("{},{},{},{},{},{},{},{}{},{},{},{},{}\n", i, to_string(curve.kind), branch, event,
                          place_cells(point.place), csv_number(point.error), csv_number(point.arclength),
                          curve.order, orbits::multiplier_cells(point.multipliers),
                          csv_number(point.facts.amplitude_m), point.facts.hits,
                          csv_number(point.facts.contact_fraction), point.facts.feasible ? 1 : 0);
    }
  }
  return text;
}

std::string meetings_csv(const std::vector<CurveFrom>& curves) {
  std::string text = "curve,kind,meeting,parameter,curve_parameter,arclength_error,arclength,order" +
                     orbits::multiplier_columns() + ",amplitude_m,hits\n";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve& curve = curves[i].curve;
    for (const Meeting& meeting : curve.meetings) {
      const CurvePoint& point = meeting.point;
      text += fmt::format("{},{},{},{},{},{},{}{},{},{}\n", i, to_string(curve.kind), to_string(meeting.kind),
                          place_cells(point.place), csv_number(meeting.error), csv_number(point.arclength),
                          curve.order, orbits::multiplier_cells(point.multipliers),
                          csv_number(point.facts.amplitude_m), point.facts.hits);
    }
  }
  return text;
}

std::string curves_summary(const std::string& parameter, const std::string& curve_parameter,
                           const std::vector<CurveFrom>& curves) {
  std::string text;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve& curve = curves[i].curve;
    text += fmt::format(
        "curve {}   {} of order {}, {} {}, {} {}, {} points, ends {}\n", i, to_string(curve.kind),
        curve.order, parameter, interval(curve, [](const CurvePoint& point) { return point.place.first; }),
        curve_parameter, interval(curve, [](const CurvePoint& point) { return point.place.second; }),
        curve.points.size(), ends(curve));
    for (const Meeting& meeting : curve.meetings) {
      text += fmt::format("  {:<20} {:.12g}, {:.12g}\n", to_string(meeting.kind), meeting.point.place.first,
                          meeting.point.place.second);
    }
  }
  return text;
}

}  // namespace rubsweep::apps
