#include "explain/explain_rotor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/core/structure/full_reference.hpp"
#include "rubsweep/core/structure/matrix_problems.hpp"
#include "rubsweep/core/structure/stability.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"
#include "rubsweep/maps/sweep/study_warnings.hpp"

namespace rubsweep::apps {
namespace {

std::string name_of(const model::DegreeOfFreedom& one) {
  return fmt::format("{} of node {}", to_string(one.direction), one.node);
}

/// Line that says whether a matrix is symmetric, and if not, where it differs most from its transpose.
std::string explain_symmetry(const model::ShaftMatrices& matrices, std::string_view name,
                             const Eigen::MatrixXd& matrix) {
  if (matrix.isZero(0)) return fmt::format("  {}: none\n", name);
  const structure::Asymmetry found = structure::asymmetry_of(matrix);
  constexpr double rounding = 1e-9;
  if (found.difference <= rounding * matrix.cwiseAbs().maxCoeff())
    return fmt::format("  {}: symmetric\n", name);
  const auto& all = matrices.degrees_of_freedom;
  return fmt::format(
      "  {}: not symmetric, most between {} and {}, by {:.6g}; such a rotor can whirl up by itself\n", name,
      name_of(all[static_cast<std::size_t>(found.row)]), name_of(all[static_cast<std::size_t>(found.column)]),
      found.difference);
}

std::size_t massless(const model::ShaftMatrices& matrices) {
  std::size_t count = 0;
  for (Eigen::Index i = 0; i < matrices.mass.rows(); ++i) {
    if (matrices.mass.row(i).isZero(0)) ++count;
  }
  return count;
}

/// Place of a part behind the word "at"; nothing for a housing, which stands beside the shaft.
template <class Part>
std::string at_place(const Part& part) {
  if constexpr (requires { part.at_housing; })
    if (part.at_housing) return fmt::format(" at housing {}", *part.at_housing);
  if constexpr (requires { part.position_m; }) return fmt::format(" at {:.6g} m", part.position_m);
  return {};
}

std::string explain_coefficients(const model::SupportTable& table, double speed_hz) {
  const structure::SupportCurves curves = structure::curves_of(table);
  std::string text = fmt::format("    at {}:", model::speed_text(speed_hz));
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const bool none = std::ranges::all_of(table.columns[c], [](double value) { return value == 0; });
    if (!none) text += fmt::format(" {} {:.6g}", model::support_coefficients[c], curves[c](speed_hz));
  }
  return text + "\n";
}

std::string explain_plane(const structure::Reduction& reduction, std::size_t plane) {
  const auto& numbers = reduction.mode_number[plane];
  const auto& hz = reduction.frequency_hz[plane];
  std::string modes, attachments;
  for (Eigen::Index j = 0; j < hz.size(); ++j) {
    const auto column = static_cast<std::size_t>(j);
    if (column < numbers.size()) {
      modes += fmt::format("{}{} ({:.5g} Hz)", modes.empty() ? "" : ", ", numbers[column], hz(j));
    } else {
      attachments += fmt::format("{}{:.5g} Hz", attachments.empty() ? "" : ", ", hz(j));
    }
  }
  return fmt::format("modes {}; attachment modes of the stops {}\n", modes,
                     attachments.empty() ? "none" : attachments);
}

std::string explain_faults(const model::RotorKit& kit) {
  std::string text;
  bool turns_differ = false;
  for (const model::Support& support : kit.supports) {
    if (!support.fault || support.fault->impulse_ns == 0) continue;
    const model::BearingFault& fault = *support.fault;
    text += fmt::format(
        "  faulty bearing at {} m: {} impulses of {} N s per revolution at {} degrees, from the kick on\n",
        support.position_m, fault.multiple, fault.impulse_ns, fault.angle_deg);
    turns_differ = turns_differ || fault.multiple != std::floor(fault.multiple);
  }
  if (text.empty()) return text;
  text +=
      "    with impulses nothing is ever proven to rest, and the whirl ratio is that of the motion without "
      "them\n";
  if (turns_differ)
    text += "    revolutions get different impulses: no proof of a period, no exponent, two windows decide\n";
  return text;
}

/// Line about damping that turns with the shaft. The speed above which the whirl is unstable is omitted where
/// supports follow tables, since the supports are then different at every speed.
std::string explain_rotating_damping(const scene::PreparedMachine& prepared, const model::RotorKit& kit,
                                     bool by_tables) {
  if (!model::has_rotating_damping(kit)) return "";
  if (by_tables)
    return fmt::format("  damping that turns with the shaft: ratio {} and so on by mode\n",
                       kit.rotating_damping_ratio.front());
  const double highest_hz = 20 * prepared.reduction->frequency_hz[0](0);
  const auto from_hz = structure::instability_hz(prepared.assembly, highest_hz);
  return fmt::format(
      "  damping that turns with the shaft: ratio {} and so on by mode; the quiet whirl is {}\n",
      kit.rotating_damping_ratio.front(),
      from_hz ? fmt::format("unstable from {} on and grows until it touches", model::speed_text(*from_hz))
              : "stable up to " + model::speed_text(highest_hz, 4));
}

/// Line of the parts that have names; empty where none has.
template <class Part>
std::string explain_names(std::string_view word, const std::vector<Part>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!parts[i].name.empty())
      text += fmt::format("{}{}{}{}", text.empty() ? "" : ", ", i, model::in_brackets(parts[i].name),
                          at_place(parts[i]));
  return text.empty() ? "" : fmt::format("  {}: {}\n", word, text);
}

std::string explain_names(const model::RotorKit& kit) {
  return explain_names("discs", kit.discs) + explain_names("point masses", kit.point_masses) +
         explain_names("housings", kit.housings) + explain_names("supports", kit.supports) +
         explain_names("sensors", kit.sensors);
}

std::string explain_shaft(const model::RotorKit& kit) {
  return fmt::format(
      "rotor: kit, shaft of {:.6g} m in {} or more Timoshenko elements, {} discs, {} supports, {} "
      "couplings{}{}\n",
      model::shaft_length_m(kit), kit.elements, kit.discs.size(), kit.supports.size(), kit.couplings.size(),
      kit.bow ? ", residual bow" : "", kit.torsion ? ", torsion against the drive (1 coordinate)" : "");
}

/// Line about couplings whose stiffness depends on the direction of bending.
std::string explain_second_harmonic(const scene::PreparedMachine& prepared) {
  if (prepared.assembly.second_n.size() == 0) return "";
  return "  couplings that are stiffer along one axis: a force twice per revolution, whatever the unbalance; "
         "the whirl ratio is that of both together\n"
         "    left out: how the vibration itself modulates their stiffness\n";
}

std::string explain_kit(const scene::PreparedMachine& prepared, const model::RotorKit& kit, bool by_tables) {
  const structure::Reduction& reduction = *prepared.reduction;
  std::string text = (kit.matrices ? explain_matrices(kit) : explain_shaft(kit)) + explain_names(kit);
  text += explain_rotating_damping(prepared, kit, by_tables);
  text += explain_second_harmonic(prepared);
  const std::string faults = explain_faults(kit);
  text += faults;
  text += "  reduced in x to " + explain_plane(reduction, 0);
  text += "  reduced in y to " + explain_plane(reduction, 1);
  text += "  the attachment modes make the static compliance between the stops exact\n";
  text += fmt::format(
      "  receptance from the stops{} to stops and sensors, at rest and turning with the force: within {:.2g} "
      "of that of the full matrices up to {} Hz; at resonance, and from unbalance, loads and kick, within "
      "{:.2g}\n",
      faults.empty() ? "" : " and faulty bearings", reduction.receptance_error, kit.modes_up_to_hz,
      reduction.receptance_error / structure::share_beside);
  if (reduction.growth_error > 0)
    text += fmt::format(
        "  free vibrations that grow: rate and frequency within {:.2g} of those of the full matrices\n",
        reduction.growth_error);
  text += reduction.automatic ? fmt::format("  number of modes: auto, the smallest within {}\n",
                                            structure::receptance_tolerance)
                              : std::string("  number of modes: as configured\n");
  if (const std::string many = sweep::describe_many_modes(prepared); !many.empty())
    text += "    " + many + "\n";
  return text +
         "left out: modes that no stop and no sensor sees and that nothing couples with one they see, and "
         "those above the last one listed\n";
}

std::string explain_rotating_damping(const model::JeffcottRotor& rotor) {
  if (rotor.rotating_damping_ratio == 0) return "";
  return fmt::format(
      "  damping that turns with the shaft: ratio {}; from {} on the quiet whirl is unstable and "
      "grows until it touches\n",
      rotor.rotating_damping_ratio,
      model::speed_text(rotor.natural_frequency_hz *
                        (1 + rotor.damping_ratio / rotor.rotating_damping_ratio)));
}

}  // namespace

std::string explain_rotor(const scene::PreparedMachine& prepared, bool by_tables) {
  return std::visit(
      overloaded{
          [](const model::JeffcottRotor& rotor) {
            return fmt::format(
                       "rotor: Jeffcott, moves in x and y (2 coordinates), {} kg, {} Hz, damping ratio "
                       "{}\n",
                       rotor.mass_kg, rotor.natural_frequency_hz, rotor.damping_ratio) +
                   explain_rotating_damping(rotor);
          },
          [&](const model::RotorKit& kit) { return explain_kit(prepared, kit, by_tables); }},
      prepared.machine.rotor);
}

std::string explain_matrices(const model::RotorKit& kit) {
  const model::ShaftMatrices& matrices = *kit.matrices;
  std::set<std::string_view> on_shaft, beside;
  for (const model::DegreeOfFreedom& one : matrices.degrees_of_freedom)
    (one.position_m ? on_shaft : beside).insert(one.node);
  std::string text = fmt::format(
      "rotor: matrices of {} degrees of freedom at {} nodes along {:.6g} m{}, {:.6g} kg; {} supports beside "
      "them\n",
      matrices.degrees_of_freedom.size(), on_shaft.size(), model::shaft_length_m(matrices),
      beside.empty() ? "" : fmt::format(" and {} bodies", beside.size()), model::rotor_mass_kg(matrices),
      kit.supports.size());
  if (const std::size_t count = massless(matrices); count > 0)
    text += fmt::format("  mass: positive definite, but for {} degrees of freedom without any\n", count);
  text += explain_symmetry(matrices, "stiffness", matrices.stiffness);
  text += explain_symmetry(matrices, "damping", matrices.damping);
  text += fmt::format("  gyroscopic: {}\n",
                      matrices.gyroscopic.isZero(0) ? "none" : "skew-symmetric, times the speed");
  return text;
}

std::string explain_tables(const model::Machine& machine, std::vector<double> speeds_hz) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr || !model::has_tables(*kit)) return "";
  std::ranges::sort(speeds_hz);
  std::vector<double> shown{speeds_hz.front(), speeds_hz[speeds_hz.size() / 2], speeds_hz.back()};
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  std::string text = "supports that follow the speed (N/m, N s/m, kg), a cell has those of its own speed:\n";
  for (std::size_t i = 0; i < kit->supports.size(); ++i) {
    const auto& table = kit->supports[i].table;
    if (!table) continue;
    text += fmt::format("  support {}{}{}: table of {} speeds from {}, monotone cubics between\n", i,
                        model::in_brackets(kit->supports[i].name), at_place(kit->supports[i]),
                        table->speed_hz.size(),
                        model::speed_range_text(table->speed_hz.front(), table->speed_hz.back()));
    for (const double speed_hz : shown) text += explain_coefficients(*table, speed_hz);
  }
  return text;
}

std::string describe_sparse_tables(const model::Machine& machine) {
  const model::RotorKit* kit = model::kit_of(machine);
  std::string text;
  for (std::size_t i = 0; kit != nullptr && i < kit->supports.size(); ++i) {
    const auto& table = kit->supports[i].table;
    if (table && table->speed_hz.size() < model::SupportTable::enough_points)
      text += fmt::format(
          "{}.table: has {} speeds, which leaves the curve between them to chance; {} or "
          "more are better\n",
          model::support_path(*kit, i), table->speed_hz.size(), model::SupportTable::enough_points);
  }
  return text;
}

}  // namespace rubsweep::apps
