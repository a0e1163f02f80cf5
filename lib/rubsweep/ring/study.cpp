#include "rubsweep/ring/study.hpp"

#include <algorithm>
#include <array>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::ring {
namespace {

ChartPoint point_of(const NormalForm& form, const Eigen::VectorXcd& values) {
  const auto fastest = std::max_element(values.begin(), values.end(),
                                        [](const auto& a, const auto& b) { return a.real() < b.real(); });
  return {signature(form, values), fastest->real(), std::abs(fastest->imag())};
}

void set(Load& load, Parameter parameter, double value) {
  constexpr std::array members{&Load::angle_deg, &Load::inclination_deg, &Load::radial_stiffness_n_per_m,
                               &Load::tangential_stiffness_n_per_m};
  load.*members.at(static_cast<std::size_t>(parameter) - 1) = value;
}

void fill(ChartLine& line, System system, const std::vector<double>& speeds_rad_per_s) {
  const NormalForm form = normal_form(system);
  std::vector<Signature> signatures;
  for (const double speed : speeds_rad_per_s) {
    line.points.push_back(point_of(form, eigenvalues(form, speed)));
    signatures.push_back(line.points.back().signature);
  }
  add_onsets(find_changes(form, speeds_rad_per_s, signatures), {}, form.has_friction, line.onsets);
  if (!form.has_friction) return;
  system.friction_coefficient = 0;
  add_onsets(find_changes(normal_form(system), speeds_rad_per_s), {}, false, line.onsets, true);
  std::ranges::stable_sort(line.onsets, {}, &Onset::speed_rad_per_s);
}

ChartLine evaluate_line(const System& system, const ChartAxis& axis, double value,
                        const std::vector<double>& speeds_rad_per_s) {
  ChartLine line{value, {}, {}, "ok"};
  try {
    fill(line, with_parameter(system, axis, value), speeds_rad_per_s);
  } catch (const ConfigError&) {
    line = {value, {}, {}, "singular_mass"};
  } catch (const SolverError&) {
    line = {value, {}, {}, "not_converged"};
  }
  return line;
}

}  // namespace

System with_parameter(System system, const ChartAxis& axis, double value) {
  if (axis.parameter == Parameter::friction_coefficient) {
    system.friction_coefficient = value;
  } else if (axis.load) {
    set(system.loads.at(*axis.load), axis.parameter, value);
  } else {
    for (Load& load : system.loads) set(load, axis.parameter, value);
  }
  return system;
}

std::vector<std::optional<ChartLine>> run_chart(const System& system, const ChartAxis& axis,
                                                const std::vector<double>& speeds_rad_per_s, int threads,
                                                const std::function<void(const ChartLine&)>& on_line,
                                                const std::atomic<bool>& stop) {
  std::vector<std::optional<ChartLine>> lines(axis.values.size());
  batch::parallel_run(
      lines.size(), threads,
      [&](std::size_t i) { lines[i] = evaluate_line(system, axis, axis.values[i], speeds_rad_per_s); },
      [&](std::size_t i) { on_line(*lines[i]); }, stop);
  return lines;
}

}  // namespace rubsweep::ring
