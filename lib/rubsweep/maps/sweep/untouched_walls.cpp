#include "rubsweep/maps/sweep/untouched_walls.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/response/proof/rest_proof.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::sweep {
namespace {

constexpr std::size_t most_speeds = 100;

/// The quiet cell nearest to the wall at one speed; empty where all touch without a kick. `descending`: all
/// unbalances.
std::optional<scene::Cell> nearest_quiet_cell(const Study& study, const scene::PreparedMachine& prepared,
                                              double speed_hz, const std::vector<double>& descending) {
  for (const double unbalance : descending) {
    scene::Cell cell = scene::build_cell(prepared, speed_hz, unbalance_of(study.grid, unbalance));
    if (cell.start == scene::Start::quiet) return cell;
  }
  return std::nullopt;
}

/// No modal amplitude can grow by more than its share of the whole impulse, however the pulse spreads it in
/// time. Not applicable to several pulses, whose shares do not simply add up.
bool never_touches(const scene::Cell& cell, numerics::ModalFormCache& forms) {
  const scene::Scene& scene = cell.scene;
  if (scene.pulses.size() > 1) return false;
  std::vector<double> section = integrate::run::scaled_initial_state(scene);
  for (const scene::Pulse& pulse : scene.pulses) {
    const double impulse_ns = 2 / std::numbers::pi * pulse.force_n * pulse.duration_s;
    const Eigen::VectorXd jump = scene.structure.mass.llt().solve(impulse_ns * pulse.direction) /
                                 integrate::run::state_scale(scene).unit_velocity_m_per_s();
    const auto n = static_cast<std::size_t>(jump.size());
    for (std::size_t i = 0; i < n; ++i) section[n + i] += jump(static_cast<Eigen::Index>(i));
  }
  return response::proof::RestProof(cell, forms).proves(section);
}

/// `forms`: known ones, which no kick changes.
std::string why_untouched(const Study& study, const scene::PreparedMachine& prepared,
                          numerics::ModalFormCache& forms) {
  if (!study.grid.axes.empty()) return "";  // the machine differs from cell to cell
  if (study.machine.start) return "";
  std::vector<double> descending = study.grid.unbalance;
  std::sort(descending.begin(), descending.end(), std::greater<>());
  const std::vector<double>& speeds = study.grid.speed_hz;
  const std::size_t looked_at = std::min(speeds.size(), most_speeds);
  bool any = false;
  for (std::size_t i = 0; i < looked_at; ++i) {
    const double speed_hz = speeds[i * speeds.size() / looked_at];
    const auto cell = nearest_quiet_cell(study, prepared, speed_hz, descending);
    if (!cell) continue;
    if (!never_touches(*cell, forms)) return "";
    any = true;
  }
  if (!any) return "";
  const auto& kick = prepared.machine.kick;
  if (!kick) {
    return "no kick: the cells whose quiet whirl leaves a clearance (whirl ratio below 1) touch nothing and "
           "are all "
           "non_contact; to change that, give kick.force_n and kick.duration_s\n";
  }
  return fmt::format(
      "weak kick: {} N for {} s reach no wall from any cell whose quiet whirl leaves a clearance (whirl "
      "ratio below "
      "1), which are all non_contact; to change that, raise kick.force_n\n",
      kick->force_n, kick->duration_s);
}

}  // namespace

std::string why_walls_stay_untouched(const Study& study, const scene::PreparedMachine& prepared) {
  numerics::ModalFormCache forms;
  return why_untouched(study, prepared, forms);
}

std::optional<double> least_kick_force_n(const Study& study, const scene::PreparedMachine& prepared) {
  const auto& kick = prepared.machine.kick;
  numerics::ModalFormCache forms(std::size_t{256} << 20);
  if (!kick || kick->force_n == 0 || why_untouched(study, prepared, forms).empty()) return std::nullopt;
  const auto may_touch = [&](double force_n) {
    model::Machine machine = prepared.machine;
    machine.kick->force_n = force_n;
    return why_untouched(study, scene::prepare_other_kick(prepared, machine), forms).empty();
  };
  constexpr double most = 1e9, within = 1.01;
  double below_n = kick->force_n, above_n = 2 * below_n;
  while (!may_touch(above_n)) {
    if (above_n > most * kick->force_n) return std::nullopt;
    below_n = above_n;
    above_n *= 2;
  }
  while (above_n > within * below_n) {
    const double middle_n = std::sqrt(below_n * above_n);
    (may_touch(middle_n) ? above_n : below_n) = middle_n;
  }
  return above_n;
}

}  // namespace rubsweep::sweep
