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

/// Coordinates of the largest scene that an exact run takes: a kit of 40 modes in each plane and one of
/// torsion, with six stops that have an attachment mode in each plane and a casing each.
inline constexpr int most_exact_coordinates = 2 * (40 + 6) + 1 + 2 * 6;

/// Sizes of an exact run over N coordinates; its state is (u, u'), 2N numbers, lengths in units of the
/// scene's length scale, time in seconds. Where N is known only at run time it is bounded: what the time loop
/// makes on its way needs no allocation.
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
  /// Matrix that the time loop multiplies a state by.
  template <int rows>
  using RowsOfState =
      std::conditional_t<N == Eigen::Dynamic, numerics::AlignedMatrix, Eigen::Matrix<double, rows, states>>;
  using Factor = RowsOfState<states>;
};

/// One armed guard of a mode, divided by the contact stiffness so that it is a length. Negative inside the
/// mode.
template <int N>
struct LinearGuard {
  std::size_t contact = 0;
  contact::Mode next = contact::Mode::open;
  typename ExactTypes<N>::Row physical;  ///< value = physical . (u, u') - clearance's part
  /// Fast pairs (a ringing casing) may be bounded by their envelope, which lets the step go by the slow ones.
  /// Where none is split off, all count as fast.
  ModalTerms terms;
  double constant = 0;  ///< value = sum of the `terms` + constant + forced part
  /// Taylor coefficients in time of the sum of the terms, time in units of 1 / fastest_rad_per_s of the mode:
  /// column j is what a unit of z_j adds to them.
  numerics::SeriesTable<ExactTypes<N>::states> taylor;
  std::vector<Eigen::Index> columns;  ///< the nonzero ones
};

/// An annular stop that is not touched: the guard is reached when the offset d = row . z + centre + forced
/// part of the rotor against the stop, a vector of two components, becomes as long as the clearance. `rate`
/// gives d' from z. Multiplied by ExactMotion::sizes(), `speed_bound` and `curvature_bound` bound the lengths
/// of the free vibration's parts of d' and d'' over the mode's longest step.
template <int N>
struct AnnularGuard {
  std::size_t contact = 0;
  std::array<typename ExactTypes<N>::Row, 2> physical, row, rate;
  std::array<double, 2> centre{};
  typename ExactTypes<N>::Row speed_bound, curvature_bound;
};

/// A touching contact: its normal force, for the peak, and its sliding speed, which must stay where friction
/// is saturated. "Bound" is over the mode's longest step and is to be multiplied by ExactMotion::sizes().
template <int N>
struct TouchWatch {
  std::size_t contact = 0;
  typename ExactTypes<N>::Row force;  ///< normal force = force . (state - rest) + constant, newtons
  double force_constant = 0;
  ModalTerms force_of_free;                        ///< the free vibration's part of it
  bool pushes = false;                             ///< false: released, the normal force is zero
  double way = 1;                                  ///< -1: the slip, and friction with it, goes backward
  typename ExactTypes<N>::Row sliding;             ///< d' . tangent of (u, u'), scaled length per second
  ModalTerms sliding_of_free;                      ///< the free vibration's part of it
  typename ExactTypes<N>::Row sliding_rate_bound;  ///< bound on the free vibration's part of d sliding / dt
  /// Empty in most modes. Where every touching contact is released there is nothing but friction, mu K p at
  /// contact k, between rotor and casings, and the penetrations p only fall. `sliding_rate_bound` is then on
  /// the free vibration of the structure without any contact, and friction is added as a force from outside:
  /// per penetration of contact k at the start, `friction_rate[k]` is what it adds to d sliding / dt at once
  /// and `friction_swing[k]` what it adds per second through the vibration that it has excited by then.
  std::vector<double> friction_rate, friction_swing;
};

/// Displacement of a casing as a linear function of the free vibration, so that no whole state is needed.
template <int N>
struct CasingView {
  Eigen::Matrix<double, 2, N> map;  ///< map as of run::ScaledCasing
  Eigen::Vector2d rest;             ///< displacement of the constant particular solution
  typename ExactTypes<N>::template RowsOfState<4> of_free;  ///< (x, y, x', y') of z
};

/// Matrices of a mode before they are rounded.
struct UnroundedMode {
  numerics::LongMatrix stiffness, damping;
  numerics::LongVector rest;
  numerics::LongMatrix basis, inverse;
};

/// Precomputed data of one joint contact mode, inside which the law is linear: (u, u') = particular
/// solution + basis z with the free vibration z. Where the mode has a modal form (`paired`), z consists of
/// pairs (z_j, z_{n+j}) that do not influence each other, and bounds go by the length of each pair. Else
/// the basis is the identity, z moves by full matrix exponentials, and bounds go by the size of each
/// component.
template <int N>
struct LinearMode {
  using Types = ExactTypes<N>;
  std::size_t index = 0;             ///< the modes of one MachineModes are numbered as they are made
  std::vector<contact::Mode> modes;  ///< mode of each contact
  Eigen::Matrix<double, N, N> stiffness, damping;  ///< contacts included
  typename Types::Flow generator;                  ///< generator of (u, u')
  typename Types::Vector rest;                     ///< u of the constant particular solution
  bool paired = false;
  bool diagonal_basis = false;
  typename Types::Factor basis, inverse;
  typename Types::Pairs pairs;  ///< generators
  /// As of PairSeries.
  Eigen::Array<double, N, numerics::most_series_terms> unit_terms, generator_terms;
  double longest_step_s = 0;
  double longest_steps_per_s = 0;                   ///< 1 / longest_step_s
  std::vector<typename Types::Row> closing;         ///< row of each flat contact: p'' of (u, u') - rest
  double fastest_rad_per_s = 0;                     ///< largest |eigenvalue|
  std::vector<typename Types::Pairs> pair_steps;    ///< e^{A h}, of pairs or
  mutable StepFlows<typename Types::Factor> steps;  ///< flows of whole steps
  std::vector<LinearGuard<N>> guards;
  std::vector<AnnularGuard<N>> annular_guards;
  std::vector<TouchWatch<N>> touches;
  std::vector<CasingView<N>> casings;
  bool pushes = false;      ///< true: one of the touches pushes
  UnroundedMode unrounded;  ///< only where the compiler knows N

  using State = typename Types::State;
  /// The state (u, u') but for its particular solution, from z; and the way back.
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
  run::ScaledSystem<Eigen::Dynamic> system;          ///< system with time in seconds
  std::vector<contact::SaturatedFriction> friction;  ///< friction of each contact
  std::optional<numerics::ModalForm> open_form;      ///< form of the system without contact
};

/// Linear mode of one joint contact mode: `modes` and whether the slip goes `backward`, per contact. Null
/// where the mode has no equilibrium, as in a structure without springs.
template <int N>
std::unique_ptr<LinearMode<N>> make_linear_mode(const CommonToModes& common,
                                                const std::vector<contact::Mode>& modes,
                                                const std::vector<bool>& backward);

extern template std::unique_ptr<LinearMode<2>> make_linear_mode<2>(const CommonToModes&,
                                                                   const std::vector<contact::Mode>&,
                                                                   const std::vector<bool>&);
extern template std::unique_ptr<LinearMode<4>> make_linear_mode<4>(const CommonToModes&,
                                                                   const std::vector<contact::Mode>&,
                                                                   const std::vector<bool>&);
extern template std::unique_ptr<LinearMode<6>> make_linear_mode<6>(const CommonToModes&,
                                                                   const std::vector<contact::Mode>&,
                                                                   const std::vector<bool>&);
extern template std::unique_ptr<LinearMode<Eigen::Dynamic>> make_linear_mode<Eigen::Dynamic>(
    const CommonToModes&, const std::vector<contact::Mode>&, const std::vector<bool>&);

}  // namespace rubsweep::integrate::exact::modes
