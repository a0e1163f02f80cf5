#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/integrate/exact/modes/modal_terms.hpp"
#include "rubsweep/core/integrate/exact/modes/step_flows.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "rubsweep/core/numerics/matrix_vector.hpp"
#include "rubsweep/core/numerics/modal_form.hpp"

namespace rubsweep::integrate::exact::modes {

/// Largest number of coordinates in an exact run: a kit with 40 modes in each plane and one of torsion, and
/// six stops, each with an attachment mode in each plane and a casing.
inline constexpr int most_exact_coordinates = 2 * (40 + 6) + 1 + 2 * 6;

/// Matrix types of an exact run with N coordinates. Its state is (u, u'), 2N numbers, with lengths in units
/// of the scene's length scale and time in seconds. If N is known only at run time, it is bounded, so that
/// temporaries of the time loop need no allocation.
template <int N>
struct ExactTypes {
  static constexpr int states = N == Eigen::Dynamic ? Eigen::Dynamic : 2 * N;
  static constexpr int most = N == Eigen::Dynamic ? most_exact_coordinates : N;
  using Vector = Eigen::Matrix<double, N, 1, Eigen::ColMajor, most, 1>;
  using Part = Eigen::Array<double, N, 1, Eigen::ColMajor, most, 1>;   ///< an array with one number per pair
  using Pairs = Eigen::Array<double, N, 4, Eigen::ColMajor, most, 4>;  ///< uu, uv, vu, vv per pair
  using State = Eigen::Matrix<double, states, 1, Eigen::ColMajor, 2 * most, 1>;
  using Row = Eigen::Matrix<double, 1, states, Eigen::RowMajor, 1, 2 * most>;
  using Flow = Eigen::Matrix<double, states, states>;
  /// Matrix by which the time loop multiplies a state.
  template <int rows>
  using RowsOfState =
      std::conditional_t<N == Eigen::Dynamic, numerics::AlignedMatrix, Eigen::Matrix<double, rows, states>>;
  using Factor = RowsOfState<states>;
};

/// One armed guard of a mode, divided by the contact stiffness so that it is a length. It is negative inside
/// the mode.
template <int N>
struct LinearGuard {
  std::size_t contact = 0;
  contact::Mode next = contact::Mode::open;
  typename ExactTypes<N>::Row physical;  ///< value = physical . (u, u') - part of the clearance
  /// Fast pairs (a ringing casing) may be replaced by their envelope; the slow pairs then determine the step.
  /// If no pairs are separated, all count as fast.
  ModalTerms terms;
  double constant = 0;  ///< value = sum of the `terms` + constant + forced part
  /// Taylor coefficients of the sum of the terms, with time in units of 1 / fastest_rad_per_s of the mode:
  /// column j is the contribution of a unit of z_j.
  numerics::SeriesTable<ExactTypes<N>::states> taylor;
  std::vector<Eigen::Index> columns;  ///< indices of the non-zero columns
};

/// An annular stop without contact. The offset of the rotor, d = row . z + centre + forced part, is a vector
/// of two components. The guard reaches zero when the length of d equals the clearance. `rate` gives d' from
/// z. Multiplied by ExactMotion::sizes(), `speed_bound` and `curvature_bound` bound the lengths of the free
/// vibration's parts of d' and d'' over the mode's longest step.
template <int N>
struct AnnularGuard {
  std::size_t contact = 0;
  std::array<typename ExactTypes<N>::Row, 2> physical, row, rate;
  std::array<double, 2> centre{};
  typename ExactTypes<N>::Row speed_bound, curvature_bound;
};

/// A touching contact: its normal force, for the peak, and its sliding speed, which must stay where friction
/// is saturated. The bounds hold over the mode's longest step; they must be multiplied by
/// ExactMotion::sizes().
template <int N>
struct TouchWatch {
  std::size_t contact = 0;
  typename ExactTypes<N>::Row force;  ///< normal force = force . (state - rest) + constant, newtons
  double force_constant = 0;
  ModalTerms force_of_free;                        ///< the free vibration's part of the force
  bool pushes = false;                             ///< false: released, the normal force is zero
  double way = 1;                                  ///< -1: slip and friction are backward
  typename ExactTypes<N>::Row sliding;             ///< d' . tangent of (u, u'), scaled length per second
  ModalTerms sliding_of_free;                      ///< the free vibration's part of the sliding speed
  typename ExactTypes<N>::Row sliding_rate_bound;  ///< bound on the free vibration's part of d sliding / dt
  /// Empty in most modes. Where every touching contact is released, only friction (mu K p at contact k) acts
  /// between rotor and casings, and the penetrations p decrease. `sliding_rate_bound` then refers to the free
  /// vibration of the structure without any contact, and friction is added as an external force. Both members
  /// are per initial penetration of contact k: `friction_rate[k]` is its immediate contribution to d sliding
  /// / dt, and `friction_swing[k]` the contribution per second by the vibration that it has excited so far.
  std::vector<double> friction_rate, friction_swing;
};

/// Displacement of a casing as a linear function of the free vibration, so that no whole state is needed.
template <int N>
struct CasingView {
  Eigen::Matrix<double, 2, N> map;  ///< map as in run::ScaledCasing
  Eigen::Vector2d rest;             ///< displacement of the constant particular solution
  typename ExactTypes<N>::template RowsOfState<4> of_free;  ///< maps z to (x, y, x', y')
};

/// Matrices of a mode before rounding to double.
struct UnroundedMode {
  numerics::LongMatrix stiffness, damping;
  numerics::LongVector rest;
  numerics::LongMatrix basis, inverse;
};

/// Precomputed data of one joint contact mode, inside which the law is linear: (u, u') = particular solution
/// + basis z, with the free vibration z. With a modal form (`paired`), z consists of independent pairs (z_j,
/// z_{n+j}), and bounds use the length of each pair. Otherwise the basis is the identity, z moves by full
/// matrix exponentials, and bounds use the magnitude of each component.
template <int N>
struct LinearMode {
  using Types = ExactTypes<N>;
  std::size_t index = 0;                           ///< index in one MachineModes, in the order of making
  std::vector<contact::Mode> modes;                ///< mode of each contact
  Eigen::Matrix<double, N, N> stiffness, damping;  ///< matrices that include the contacts
  typename Types::Flow generator;                  ///< generator of (u, u')
  typename Types::Vector rest;                     ///< u of the constant particular solution
  bool paired = false;
  bool diagonal_basis = false;
  typename Types::Factor basis, inverse;
  typename Types::Pairs pairs;  ///< generators of the pairs
  /// Taylor coefficients of the pairs as in PairSeries.
  Eigen::Array<double, N, numerics::most_series_terms> unit_terms, generator_terms;
  double longest_step_s = 0;
  double longest_steps_per_s = 0;                   ///< 1 / longest_step_s
  std::vector<typename Types::Row> closing;         ///< row of each flat contact: p'' from (u, u') - rest
  double fastest_rad_per_s = 0;                     ///< largest |eigenvalue| of the generator
  std::vector<typename Types::Pairs> pair_steps;    ///< e^{A h} of table steps, for pairs
  mutable StepFlows<typename Types::Factor> steps;  ///< e^{A h} of table steps, full matrices
  std::vector<LinearGuard<N>> guards;
  std::vector<AnnularGuard<N>> annular_guards;
  std::vector<TouchWatch<N>> touches;
  std::vector<CasingView<N>> casings;
  bool pushes = false;      ///< true: some touch pushes
  UnroundedMode unrounded;  ///< only where N is a compile-time constant

  using State = typename Types::State;
  /// State (u, u') minus the particular solution, computed from z; and the inverse transformation.
  void put_from_free(const State& z, State& vibration) const { put_changed(basis, z, vibration); }
  void put_to_free(const State& vibration, State& z) const { put_changed(inverse, vibration, z); }
  State from_free(const State& z) const {
    State vibration;
    put_from_free(z, vibration);
    return vibration;
  }
  State to_free(const State& vibration) const {
    State z;
    put_to_free(vibration, z);
    return z;
  }

 private:
  void put_changed(const typename Types::Factor& matrix, const State& from, State& to) const {
    if (diagonal_basis) {
      to = matrix.diagonal().cwiseProduct(from);
    } else {
      numerics::put_product(matrix, from, to);
    }
  }
};

/// Data that all contact modes of a machine share.
struct CommonToModes {
  run::ScaledSystem<Eigen::Dynamic> system;          ///< the system with time in seconds
  std::vector<contact::SaturatedFriction> friction;  ///< friction of each contact
  std::optional<numerics::ModalForm> open_form;      ///< modal form of the system without contact
};

/// Linear mode of one joint contact mode; `modes` and `backward` (slip direction) are given per contact. Null
/// where the mode has no equilibrium, as in a structure without springs.
template <int N>
std::unique_ptr<LinearMode<N>> make_linear_mode(const CommonToModes& common,
                                                const std::vector<contact::Mode>& modes,
                                                const std::vector<bool>& backward);

}  // namespace rubsweep::integrate::exact::modes
