#include "rotor_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "campbell_tables.hpp"
#include "rotor_report_tables.hpp"
#include "rubsweep/analysis/design/design_check.hpp"
#include "rubsweep/analysis/design/lateral_terms.hpp"
#include "rubsweep/analysis/design/unbalance_cases.hpp"
#include "rubsweep/analysis/linear/campbell.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/balance.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/place_arguments.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/working_time.hpp"

namespace rubsweep::apps {
namespace {

/// All files that a rotor report may leave; its page is drawn from the others.
constexpr std::array<std::string_view, 14> report_file_names{
    "config.yaml",       "rotor_parts.csv",    "static_line.csv",       "bearing_loads.csv",
    "critical_map.csv",  "campbell.csv",       "bearing_stiffness.csv", "mode_shapes.csv",
    "lock_speeds.csv",   "stability.csv",      "report_notes.csv",      "deflected_shape.csv",
    "rotor_report.html", "critical_speeds.csv"};

constexpr int campbell_speeds = 101, curve_speeds = 101, map_modes = 4;

/// Tables of a report, remarks on its pictures, and its text for a terminal.
struct Report {
  batch::ResultFiles files;
  std::vector<ReportNote> notes;
  std::string summary;
};

/// The unbalance of the deflected shape and its description.
std::pair<Eigen::VectorXcd, std::string> unbalance_for(const RubtraceArguments& arguments,
                                                       const design::WholeRotor& rotor,
                                                       const model::Machine& machine, double speed_hz) {
  // An eccentricity is that of discs that stand off the axis.
  if (!(model::g_mm_per_metre(machine) > 0)) {
    if (arguments.place.has_unbalance()) {
      throw ConfigError(
          "--eccentricity-m and --unbalance-g-mm: no disc stands off the axis, allowed: at least one "
          "eccentricity_ratio that is not 0");
    }
    const auto cases = rotor.cases(0, speed_hz);
    if (cases.size() < 2) throw ConfigError("rotor: has no unbalance and no mode, allowed: an unbalance");
    return {cases[1].unbalance_kg_m,
            "four times the residual unbalance of API 617 where mode 1 deflects most, as no disc has any"};
  }
  if (!arguments.place.has_unbalance()) {
    const double eccentricity_m = design::analysis_eccentricity_m(machine, speed_hz);
    return {eccentricity_m * rotor.configured_kg(),
            fmt::format("an eccentricity of {:.4g} um, four times the residual unbalance of API 617",
                        1e6 * eccentricity_m)};
  }
  const scene::Unbalance unbalance = unbalance_of(arguments.place, machine);
  const double eccentricity_m = std::get<scene::Eccentricity>(unbalance).value_m;
  return {eccentricity_m * rotor.configured_kg(),
          fmt::format("an eccentricity of {:.4g} um", 1e6 * eccentricity_m)};
}

/// The range of stiffness that has those of the bearings over all speeds two decades inside, or nothing.
std::vector<double> map_stiffness(const model::RotorKit& kit, std::span<const double> speeds_hz) {
  constexpr int per_decade = 20;
  double least = 1e300, most = 0;
  for (const std::size_t bearing : design::bearings_of(kit)) {
    for (const double speed_hz : speeds_hz) {
      const model::Support at = structure::support_at(kit.supports[bearing], speed_hz, "");
      for (const double stiffness : {at.stiffness_x_n_per_m, at.stiffness_y_n_per_m}) {
        if (stiffness > 0) least = std::min(least, stiffness), most = std::max(most, stiffness);
      }
    }
  }
  if (most == 0) return {};
  const int first = static_cast<int>(std::floor(std::log10(least))) - 2,
            last = static_cast<int>(std::ceil(std::log10(most))) + 2;
  std::vector<double> values;
  for (int k = per_decade * first; k <= per_decade * last; ++k)
    values.push_back(std::pow(10.0, static_cast<double>(k) / per_decade));
  return values;
}

void add_critical_map(const model::Machine& machine, const ReportSpeeds& speeds, Report& report) {
  const model::RotorKit& kit = *model::kit_of(machine);
  const std::vector<double> speeds_hz =
      batch::evenly_spaced(speeds.shown.from_hz, speeds.shown.to_hz, curve_speeds);
  const std::vector<double> stiffness = map_stiffness(kit, speeds_hz);
  if (stiffness.empty()) {
    report.notes.push_back(
        {"critical_map", kit.matrices ? "left out: the matrices do not tell the stiffness of the bearings"
                                      : "left out: no support is a bearing"});
    return;
  }
  try {
    report.files["critical_map.csv"] =
        critical_map_csv(design::critical_map(kit, design::stop_stations_m(machine), stiffness, map_modes));
  } catch (const ConfigError& error) {
    report.notes.push_back({"critical_map", fmt::format("left out: {}", error.what())});
    return;
  }
  report.files["bearing_stiffness.csv"] = bearing_stiffness_csv(kit, speeds_hz);
}

/// Adds what only a shaft has: its parts, its static line and its critical speed map.
void add_shaft(const sweep::Study& study, const ReportSpeeds& speeds, const design::WholeRotor& rotor,
               const Eigen::VectorXcd& response, Report& report) {
  const model::Machine& machine = study.machine;
  const model::Machine now = structure::machine_at(machine, speeds.deflected_hz);
  const model::RotorKit& kit = *model::kit_of(now);
  report.files["rotor_parts.csv"] = rotor_parts_csv(machine, study.stop_names);
  const bool given = machine.gravity_m_per_s2 > 0;
  const double gravity = given ? machine.gravity_m_per_s2 : design::standard_gravity_m_per_s2;
  // More stations change no number at the others, and show the curves between them.
  constexpr int more = 60;
  std::vector<double> stations_m = design::stop_stations_m(machine);
  for (int k = 1; k < more && !kit.matrices; ++k) stations_m.push_back(k * model::shaft_length_m(kit) / more);
  const design::StaticLine line = design::static_line(kit, stations_m, gravity);
  if (line.holds) {
    report.files["static_line.csv"] = static_line_csv(line);
    if (!given)
      report.notes.push_back(
          {"static_line",
           fmt::format("gravity_m_per_s2 of the configuration is 0; shown under {} m/s2", gravity)});
    if (!line.sections)
      report.notes.push_back({"static_line",
                              "the matrices do not tell shaft and bearings apart: no shear force "
                              "and no bending moment"});
  } else {
    report.notes.push_back({"static_line", "left out: the bearings alone do not hold the shaft"});
  }
  if (line.holds && !line.loads.empty()) {
    std::vector<double> forces_n;
    for (const design::BearingLoad& load : line.loads) {
      const auto at = std::ranges::find(rotor.bearings(), load.support, &design::Bearing::support);
      forces_n.push_back(
          at == rotor.bearings().end() ? NAN : rotor.bearing_force_n(*at, response, speeds.deflected_hz));
    }
    report.files["bearing_loads.csv"] = bearing_loads_csv(kit, line, forces_n);
    for (std::size_t i = 0; i < line.loads.size(); ++i) {
      const design::BearingLoad& load = line.loads[i];
      report.summary += fmt::format(
          "bearing   {} at {:.6g} m: static load {:.5g} N, {:.4g} N by unbalance at {}\n",
          support_label(kit, load.support), kit.supports[load.support].position_m,
          std::hypot(load.load_n[0], load.load_n[1]), forces_n[i], model::speed_text(speeds.deflected_hz));
    }
  }
  add_critical_map(machine, speeds, report);
}

void add_stability(const design::WholeRotor& rotor, bool shaft, double speed_hz, Report& report) {
  constexpr int couplings = 61;
  const Eigen::Index place = rotor.midspan();
  const double up_to_hz = 2 * speed_hz;
  const auto threshold = design::threshold_n_per_m(rotor.rotor(), speed_hz, up_to_hz, place);
  const Eigen::RowVectorXd x = rotor.rotor().x.row(place);
  const double stiffness = (x * rotor.rotor().full.system.stiffness).dot(x),
               top = threshold && *threshold > 0 ? 1.5 * *threshold : 0.01 * stiffness;
  const std::vector<double> values = batch::evenly_spaced(0, top, couplings);
  const auto decrements = design::over_coupling(rotor.rotor(), speed_hz, up_to_hz, place, values);
  if (decrements.empty()) {
    report.notes.push_back(
        {"stability", fmt::format("no whirl below {:.4g} Hz is forward and lightly damped at {}: "
                                  "no decrement over cross-coupling",
                                  up_to_hz, model::speed_text(speed_hz))});
    return;
  }
  report.files["stability.csv"] = stability_csv(values, decrements);
  const double place_m = rotor.rotor().position_m[static_cast<std::size_t>(place)];
  const std::string at = shaft ? fmt::format("at {:.4g} m", place_m) : "at the disc";
  report.notes.push_back(
      {"stability", fmt::format("cross-coupling {}, at {}", at, model::speed_text(speed_hz))});
  std::string end = "no cross-coupling takes it away";
  if (decrements.front().decrement <= 0) {
    end = "it grows without any cross-coupling";
  } else if (threshold) {
    end = fmt::format("cross-coupling of {:.4g} N/m {} takes it away", *threshold, at);
  }
  report.summary += fmt::format("stability decrement {:.4g} at {}, {}\n", decrements.front().decrement,
                                model::speed_text(speed_hz), end);
}

Report report_of(const RubtraceArguments& arguments, const sweep::Study& study, const ReportSpeeds& speeds) {
  Report report;
  const model::Machine& machine = study.machine;
  const design::WholeRotor rotor(machine);
  const model::RotorKit* kit = model::kit_of(machine);
  const linear::FreeRotor shown =
      kit != nullptr && !kit->matrices ? with_places_between(rotor.rotor()) : rotor.rotor();
  const std::vector<double> diagram_hz =
      batch::evenly_spaced(speeds.shown.from_hz, speeds.shown.to_hz, campbell_speeds);
  CampbellTables campbell = tables_of(linear::campbell(shown, diagram_hz, 2 * speeds.shown.to_hz));
  report.files = {{"campbell.csv", std::move(campbell.campbell_csv)},
                  {"critical_speeds.csv", std::move(campbell.critical_speeds_csv)},
                  {"mode_shapes.csv", std::move(campbell.mode_shapes_csv)},
                  {"lock_speeds.csv", std::move(campbell.lock_speeds_csv)}};
  report.summary = std::move(campbell.summary);
  const auto [unbalance_kg_m, described] = unbalance_for(arguments, rotor, machine, speeds.operating.to_hz);
  const Eigen::VectorXcd response = rotor.response(unbalance_kg_m, speeds.deflected_hz).col(0);
  if (response.allFinite()) {
    report.files["deflected_shape.csv"] = deflected_shape_csv(shown, response);
    report.notes.push_back(
        {"deflected_shape", fmt::format("at {} with {}", model::speed_text(speeds.deflected_hz), described)});
  } else {
    report.notes.push_back({"deflected_shape", fmt::format("left out: {} is a resonance without damping",
                                                           model::speed_text(speeds.deflected_hz))});
  }
  if (kit != nullptr) {
    add_shaft(study, speeds, rotor, response, report);
  } else {
    for (const char* picture : {"rotor", "static_line", "critical_map", "mode_shapes"})
      report.notes.push_back({picture, "left out: a Jeffcott rotor is one disc and has no shaft"});
  }
  add_stability(rotor, kit != nullptr, speeds.operating.to_hz, report);
  for (const ReportNote& one : report.notes)
    if (one.note.starts_with("left out")) report.summary += fmt::format("{} {}\n", one.picture, one.note);
  report.notes.push_back(
      {"operating",
       "operating range, " + model::speed_range_text(speeds.operating.from_hz, speeds.operating.to_hz),
       speeds.operating.from_hz, speeds.operating.to_hz});
  report.files["report_notes.csv"] = report_notes_csv(report.notes);
  return report;
}

}  // namespace

ReportSpeeds report_speeds(const RubtraceArguments& arguments, const sweep::Study& study) {
  constexpr double above = 1.25;
  const RotorReportArguments& asked = arguments.rotor_report.value();
  ReportSpeeds speeds;
  if (asked.operating) {
    require_speed(asked.operating_option, asked.operating->from_hz, study.machine);
    require_speed(asked.operating_option, asked.operating->to_hz, study.machine);
    speeds.operating = *asked.operating;
  } else {
    const auto [low, high] = std::ranges::minmax(study.grid.speed_hz);
    speeds.operating = {low, high};
    structure::refuse_beyond_tables(study.machine, low, high);
  }
  const model::RotorKit* kit = model::kit_of(study.machine);
  const bool tables = kit != nullptr && model::has_tables(*kit);
  speeds.shown = {tables ? model::table_speeds_hz(*kit).low : 0,
                  design::within_tables_hz(study.machine, above * speeds.operating.to_hz)};
  speeds.deflected_hz = arguments.place.speed_hz.value_or(speeds.operating.to_hz);
  return speeds;
}

int run_rotor_report(const RubtraceArguments& arguments, const config::RunConfig& config,
                     const std::filesystem::path& directory) {
  const sweep::Study& study = config.study;
  const ReportSpeeds speeds = report_speeds(arguments, study);
  const ResultDirectory made(directory, report_file_names);
  std::optional<WorkingTime> working(std::in_place, "rubtrace", "computes the rotor report",
                                     !arguments.quiet);
  Report report = report_of(arguments, study, speeds);
  working.reset();
  report.files.emplace("config.yaml", config::print_config(config));
  {
    const InterruptsWait whole_set;
    batch::write_result_files(
        report.files, report_file_names, directory,
        {"rubsweep", config::study_digest(study), batch::caption_lines(config.captions)});
    end_on_interrupts("the files are written, the page is not");
  }
  if (!arguments.quiet) print("{}{}", report.summary, batch::files_line(report.files, directory));
  draw_and_say(arguments.rotor_report->page, "rotor-report", directory, "Rotor report", arguments.quiet);
  return done;
}

}  // namespace rubsweep::apps
