#include "bench/work_precision_report.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <variant>

#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::bench {
namespace {

using batch::csv_number;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string per_turn(long count, int turns) {
  return fmt::format("{:.1f}", static_cast<double>(count) / turns);
}

double share(const LabelAgreement& labels) {
  return labels.compared > 0 ? static_cast<double>(labels.agreed) / labels.compared : none;
}

std::string stepper_name(const Variant& variant) {
  return variant.stepper ? std::string(integrate::adaptive::row_of(*variant.stepper).word) : "";
}

}  // namespace

std::string cell_name(const scene::Place& place) {
  return std::visit(overloaded{[&](const scene::WhirlRatio& ratio) {
                                 return fmt::format("{:.6g} Hz whirl {:.6g}", place.speed_hz, ratio.value);
                               },
                               [&](const scene::Eccentricity& eccentricity) {
                                 return fmt::format("{:.6g} Hz e {:.6g} m", place.speed_hz,
                                                    eccentricity.value_m);
                               }},
                    place.unbalance);
}

std::string variant_name(const Variant& variant) {
  std::string name(to_string(variant.method));
  if (variant.stepper) name.append(" ").append(stepper_name(variant));
  name += fmt::format(" {}", to_string(variant.contact));
  if (variant.relative_tolerance) name += fmt::format(" {:.0e}", *variant.relative_tolerance);
  return name;
}

std::string reference_sentence(const std::string& cell, const Reference& reference) {
  if (reference.long_double) {
    return fmt::format(
        "{}: reference in long double by Runge-Kutta-Fehlberg 7(8) at {:.0e}, right to {:.1e}; the exact "
        "solver "
        "is {:.1e} from adaptive rkf78 and {:.1e} from adaptive dopri5 at {:.0e}\n",
        cell, static_cast<double>(long_double_tolerance), uncertainty(reference), reference.against_rkf78,
        reference.against_dopri5, reference_tolerance);
  }
  return fmt::format(
      "{}: reference {}, {:.1e} from adaptive rkf78 and {:.1e} from adaptive dopri5 at {:.0e}\n", cell,
      reference.closed_forms
          ? "by closed forms alone"
          : fmt::format("by closed forms in flight and rkf78 at {:.0e} in contact", reference_tolerance),
      reference.against_rkf78, reference.against_dopri5, reference_tolerance);
}

std::string work_precision_comments(const WorkPrecisionOptions& options) {
  return fmt::format(
      "# times: processor time, median of up to {} runs of {} revolutions from the start of the kick, "
      "variants in turn; "
      "ratios count\n"
      "# state_error: after {} revolutions, largest component in (clearance, clearance omega)\n"
      "# reference: long_double, or exact (the exact solver in double, where there is no other); "
      "reference_error: what is known of its error\n"
      "# label_agreement: share of cells of the map with class and order of the reference\n"
      "# steps, switches, rhs_calls: of one run\n",
      options.repeats, options.turns, options.error_turns);
}

std::string status_of(const WorkPrecisionLine& line) {
  std::string words;
  const auto add = [&words](std::string_view word) { words.append(words.empty() ? "" : ";").append(word); };
  if (line.measurement.outcome != integrate::run::Outcome::ok) add(to_string(line.measurement.outcome));
  if (line.labels && line.labels->cut) add("labels_cut");
  if (line.labels_too_slow) add("labels_too_slow");
  return words.empty() ? "ok" : words;
}

std::string work_precision_csv(const std::vector<WorkPrecisionLine>& lines) {
  std::string text =
      "cell,method,stepper,contact,tolerance,microseconds_per_revolution,state_error,label_agreement,steps,"
      "switches,rhs_calls,status,reference,reference_error\n";
  for (const WorkPrecisionLine& line : lines) {
    const Measurement& m = line.measurement;
    const std::array<std::string, 14> cells{line.cell,
                                            std::string(to_string(m.variant.method)),
                                            stepper_name(m.variant),
                                            std::string(to_string(m.variant.contact)),
                                            csv_number(m.variant.relative_tolerance.value_or(none)),
                                            csv_number(m.microseconds_per_revolution.value_or(none)),
                                            csv_number(m.state_error.value_or(none)),
                                            line.labels ? csv_number(share(*line.labels)) : "",
                                            fmt::format("{}", m.effort.steps),
                                            fmt::format("{}", m.effort.switches),
                                            fmt::format("{}", m.effort.rhs_calls),
                                            status_of(line),
                                            line.reference.long_double ? "long_double" : "exact",
                                            csv_number(uncertainty(line.reference))};
    text += batch::csv_row(cells) + "\n";
  }
  return text;
}

std::string work_precision_table(const std::vector<WorkPrecisionLine>& lines, int turns) {
  std::string text, cell, failures;
  for (const WorkPrecisionLine& line : lines) {
    const Measurement& m = line.measurement;
    if (line.cell != cell) {
      cell = line.cell;
      text += fmt::format("\n{:<41} {:>10} {:>10} {:>8} {:>9} {:>9} {:>10}\n", cell, "us / rev", "error",
                          "labels", "steps", "switches", "rhs");
    }
    const std::string labels =
        line.labels ? fmt::format("{}/{}", line.labels->agreed, line.labels->compared) : "-";
    const bool ran = m.microseconds_per_revolution.has_value();
    text += fmt::format("{:<41} {:>10} {:>10} {:>8} {:>9} {:>9} {:>10}\n", variant_name(m.variant),
                        ran ? fmt::format("{:.2f}", *m.microseconds_per_revolution) : "failed",
                        m.state_error ? fmt::format("{:.1e}", *m.state_error) : "-", labels,
                        ran ? per_turn(m.effort.steps, turns) : "-",
                        ran ? per_turn(m.effort.switches, turns) : "-",
                        ran ? per_turn(m.effort.rhs_calls, turns) : "-");
    if (const std::string status = status_of(line); status != "ok")
      failures += fmt::format("  {}: {}: {}\n", line.cell, variant_name(m.variant), status);
  }
  if (!failures.empty()) text += "\nnot ok:\n" + failures;
  return text;
}

}  // namespace rubsweep::bench
