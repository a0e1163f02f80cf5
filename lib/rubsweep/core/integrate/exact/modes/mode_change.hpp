#pragma once

#include "rubsweep/core/integrate/exact/modes/harmonic_response.hpp"
#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"

namespace rubsweep::integrate::exact::modes {

/// Transformation of the free vibration from one contact mode to another at an unchanged state: z' = by z +
/// constant, plus contributions of harmonic forces. A contact is as stiff as thousands of shafts, so that the
/// rounding of a displacement of one clearance is a considerable force. But the contact depends almost only
/// on one pair of z, that of its own fast vibration, which is small. The transformation therefore avoids
/// displacements: the difference of the two modes is computed in long double, and only the result is rounded.
template <int N>
struct ModeChange {
  typename ExactTypes<N>::Factor by;
  typename ExactTypes<N>::State constant;
};

/// Computes the change between modes that have kept their unrounded matrices (LinearMode::unrounded).
template <int N>
ModeChange<N> make_mode_change(const LinearMode<N>& from, const LinearMode<N>& to);

/// Contribution of a harmonic force to z': Re(phasor) real + Im(phasor) imaginary.
template <int N>
struct HarmonicChange {
  typename ExactTypes<N>::State real, imaginary;
};

/// Computes the change from the responses of both modes to the force.
template <int N>
HarmonicChange<N> make_harmonic_change(const LinearMode<N>& to, const HarmonicResponse<N>& in_from,
                                       const HarmonicResponse<N>& in_to);

extern template ModeChange<2> make_mode_change<2>(const LinearMode<2>&, const LinearMode<2>&);
extern template ModeChange<4> make_mode_change<4>(const LinearMode<4>&, const LinearMode<4>&);
extern template ModeChange<6> make_mode_change<6>(const LinearMode<6>&, const LinearMode<6>&);
extern template ModeChange<Eigen::Dynamic> make_mode_change<Eigen::Dynamic>(
    const LinearMode<Eigen::Dynamic>&, const LinearMode<Eigen::Dynamic>&);
extern template HarmonicChange<2> make_harmonic_change<2>(const LinearMode<2>&, const HarmonicResponse<2>&,
                                                          const HarmonicResponse<2>&);
extern template HarmonicChange<4> make_harmonic_change<4>(const LinearMode<4>&, const HarmonicResponse<4>&,
                                                          const HarmonicResponse<4>&);
extern template HarmonicChange<6> make_harmonic_change<6>(const LinearMode<6>&, const HarmonicResponse<6>&,
                                                          const HarmonicResponse<6>&);
extern template HarmonicChange<Eigen::Dynamic> make_harmonic_change<Eigen::Dynamic>(
    const LinearMode<Eigen::Dynamic>&, const HarmonicResponse<Eigen::Dynamic>&,
    const HarmonicResponse<Eigen::Dynamic>&);

}  // namespace rubsweep::integrate::exact::modes
