#include "rubsweep/core/structure/coupling_loads.hpp"

#include <complex>

#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::structure {
namespace {

using Complex = std::complex<double>;

/// Adds the force and moment of a joint to the end after it, and the opposite ones to the end before it.
void push_ends(Eigen::VectorXcd& load, Eigen::Index before, Complex force, Complex moment) {
  load(before) -= force;
  load(before + 1) -= moment;
  load(before + 2) += force;
  load(before + 3) += moment;
}

/// Offset and tilt of the axis behind a coupling relative to the axis before it.
struct Misalignment {
  Complex offset_m, lean_rad;
};

Misalignment standing(const model::Coupling& coupling) {
  return {phasor(coupling.parallel_misalignment_m, coupling.parallel_misalignment_angle_deg),
          phasor(coupling.angular_misalignment_rad, coupling.angular_misalignment_angle_deg)};
}

}  // namespace

Eigen::VectorXcd misalignment_load(const BeamShaft& shaft, const model::RotorKit& kit) {
  Eigen::VectorXcd load = Eigen::VectorXcd::Zero(shaft.coordinates());
  for (const auto& coupling : kit.couplings) {
    // A joint whose ends are held a distance d apart acts on each of them with stiffness times d.
    push_ends(
        load, shaft.deflection(coupling.position_m),
        phasor(coupling.lateral_stiffness_n_per_m * coupling.parallel_offset_m, coupling.parallel_phase_deg),
        phasor(coupling.angular_stiffness_nm_per_rad * coupling.angular_offset_rad,
               coupling.angular_phase_deg));
  }
  return load;
}

Eigen::VectorXcd standing_misalignment_load(const BeamShaft& shaft, const model::RotorKit& kit) {
  Eigen::VectorXcd load = Eigen::VectorXcd::Zero(shaft.coordinates());
  for (const auto& coupling : kit.couplings) {
    const Misalignment apart = standing(coupling);
    push_ends(load, shaft.deflection(coupling.position_m),
              -coupling.lateral_stiffness_n_per_m * apart.offset_m,
              -coupling.angular_stiffness_nm_per_rad * apart.lean_rad);
  }
  return load;
}

Eigen::VectorXcd position_at_rest(const BeamShaft& shaft, const Eigen::VectorXcd& load) {
  const Eigen::Index n = shaft.coordinates();
  Eigen::MatrixXd stiffness(2 * n, 2 * n);
  for (std::size_t to = 0; to < 2; ++to) {
    for (std::size_t by = 0; by < 2; ++by) {
      auto block =
          stiffness.block(static_cast<Eigen::Index>(to) * n, static_cast<Eigen::Index>(by) * n, n, n);
      block = shaft.support_stiffness[to][by];
      if (to == by) block += shaft.elastic;
    }
  }
  Eigen::VectorXd both(2 * n);
  both << load.real(), load.imag();
  const Eigen::VectorXd position = numerics::dense::solve(stiffness, both);
  Eigen::VectorXcd at_rest(n);
  at_rest.real() = position.head(n);
  at_rest.imag() = position.tail(n);
  return at_rest;
}

Eigen::VectorXcd twice_per_turn_load(const BeamShaft& shaft, const model::RotorKit& kit,
                                     const Eigen::VectorXcd& at_rest) {
  Eigen::VectorXcd load = Eigen::VectorXcd::Zero(shaft.coordinates());
  for (const auto& coupling : kit.couplings) {
    const Eigen::Index w = shaft.deflection(coupling.position_m);
    const Misalignment apart = standing(coupling);
    const Complex axis = phasor(1, 2 * coupling.stiff_axis_phase_deg);
    const Complex stretched = at_rest(w + 2) - at_rest(w) + apart.offset_m,
                  bent = at_rest(w + 3) - at_rest(w + 1) + apart.lean_rad;
    push_ends(
        load, w,
        -coupling.lateral_asymmetry_ratio * coupling.lateral_stiffness_n_per_m * axis * std::conj(stretched),
        -coupling.angular_asymmetry_ratio * coupling.angular_stiffness_nm_per_rad * axis * std::conj(bent));
  }
  return load;
}

}  // namespace rubsweep::structure
