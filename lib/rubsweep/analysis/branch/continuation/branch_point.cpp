#include "rubsweep/analysis/branch/continuation/branch_point.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/analysis/branch/orbits/multipliers.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::branch::continuation {
namespace {

using batch::csv_number;

/// Lowest and highest value of the parameter on a branch.
std::pair<double, double> interval(const Branch& branch) {
  const auto [low, high] = std::ranges::minmax_element(branch.points, {}, &BranchPoint::parameter);
  return {low->parameter, high->parameter};
}

}  // namespace

std::string branch_comments(const std::string& parameter, const std::vector<Branch>& branches) {
  std::string text = fmt::format("# parameter {}\n", parameter);
  for (std::size_t i = 0; i < branches.size(); ++i) {
    text += fmt::format("# branch {}: order {}, ends {} and {}\n", i, branches[i].order,
                        to_string(branches[i].falling), to_string(branches[i].rising));
  }
  return text;
}

std::string branch_csv(const std::vector<Branch>& branches) {
  std::string text =
      "branch,parameter,arclength,order,stable,unstable_multipliers" + orbits::multiplier_columns() +
      ",amplitude_m,peak_displacement_m,peak_contact_force_n,hits,contact_fraction,feasible,period_turns\n";
  for (std::size_t i = 0; i < branches.size(); ++i) {
    for (const BranchPoint& point : branches[i].points) {
      const orbits::OrbitFacts& facts = point.facts;
      text += fmt::format(
          "{},{},{},{},{},{}{},{},{},{},{},{},{},{}\n", i, csv_number(point.parameter),
          csv_number(point.arclength), branches[i].order, point.stable() ? 1 : 0, point.unstable,
          orbits::multiplier_cells(point.multipliers), csv_number(facts.amplitude_m),
          csv_number(facts.peak_displacement_m), csv_number(facts.peak_contact_force_n), facts.hits,
          csv_number(facts.contact_fraction), facts.feasible ? 1 : 0, csv_number(facts.period_turns));
    }
  }
  return text;
}

std::string branch_events_csv(const std::vector<Branch>& branches) {
  std::string text = "branch,kind,parameter,parameter_error,arclength,order" + orbits::multiplier_columns() +
                     ",amplitude_m,hits,detail\n";
  for (std::size_t i = 0; i < branches.size(); ++i) {
    for (const BranchEvent& event : branches[i].events) {
      text += fmt::format("{},{},{},{},{},{}{},{},{},{}\n", i, to_string(event.kind),
                          csv_number(event.point.parameter), csv_number(event.parameter_error),
                          csv_number(event.point.arclength), branches[i].order,
                          orbits::multiplier_cells(event.point.multipliers),
                          csv_number(event.point.facts.amplitude_m), event.point.facts.hits, event.detail);
    }
  }
  return text;
}

std::string branch_summary(const std::string& parameter, const std::vector<Branch>& branches) {
  std::string text;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    const Branch& branch = branches[i];
    const auto [low, high] = interval(branch);
    const auto stable = std::ranges::count_if(branch.points, &BranchPoint::stable);
    text += fmt::format("branch {}  order {}, {} {:.10g} to {:.10g}, {} points, {} stable, ends {} and {}\n",
                        i, branch.order, parameter, low, high, branch.points.size(), stable,
                        to_string(branch.falling), to_string(branch.rising));
    for (const BranchEvent& event : branch.events) {
      text += fmt::format("  {:<16} {:.12g}", to_string(event.kind), event.point.parameter);
      text += event.detail.empty() ? "\n" : fmt::format("  {}\n", event.detail);
    }
  }
  return text;
}

}  // namespace rubsweep::branch::continuation
