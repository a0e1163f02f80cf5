#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/ring/assembly.hpp"
#include "rubsweep/ring/changes.hpp"
#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// Speed known in closed form, and beside it the numerical speed from the eigenvalues.
struct CriticalSpeed {
  std::string name;
  double closed_form_rad_per_s = 0;
  /// Empty outside of the range of speeds, or where no change of stability was found.
  std::optional<double> numeric_rad_per_s;
};

/// All closed forms below that hold for this system. Each has the nearest numerical speed of the same kind
/// within a share of 1e-6. For divergence this is a speed at which K is singular, otherwise one of `changes`,
/// which belong to the system with its friction.
std::vector<CriticalSpeed> critical_speeds(const System& system, const std::vector<Change>& changes);

/// All speeds (rad/s, ascending, with multiplicity) at which K0 - Omega^2 K2 is singular, so that a root
/// lambda passes through zero. They are roots of a generalised eigenvalue problem and need no scan.
std::vector<double> divergence_speeds(const NormalForm& form);

/// All functions below give speeds in rad/s, ascending. Quantities of the ring: see system.hpp.

/// Divergence speeds of L identical radial loads without inclination:
///
///     Omega^2 = (a Omega_c^2 + l k_r) / (a + l m_r),
///     l the roots of l^2 - L l + (1 + (mu eta / n)^2) l1 l2 = 0,
///
/// with l1 and l2 the eigenvalues of the sum of e e^T over the loads, e = (-sin n phi, cos n phi). For one
/// load these are Omega_c and Omega_c2. Empty where l is complex, since there is no divergence then (the
/// paper's condition (3) is l1 = l2).
std::vector<double> radial_divergence_speeds(const System& system);

/// Omega_cs1 and Omega_cs2 of one radial load:
///
///     |sqrt((n^2 + 1) w_r^2 - n^2 Omega_c^2) -+ n^2 Omega_c| / (n^2 + 1).
///
/// With friction a light load is stable exactly between them, except between Omega_c and Omega_c2. Empty when
/// w_r^2 < Omega_c^2 n^2 / (n^2 + 1). (Before the root, where Omega_c belongs, the paper prints Omega_c^2.)
std::optional<std::pair<double, double>> radial_stability_window(const Ring& ring, const Load& load);

/// Speed sqrt(k_t / m_s), m_s = m_t - J_b, above which a tangential load diverges.
double tangential_divergence_speed(const Load& load);

/// Speed above which a tangential load no longer oscillates, as the roots of m_t s^2 + 2 mu g Omega s + k_t -
/// m_s Omega^2 are real.
double aperiodic_speed(const Load& load, double friction_coefficient);

/// Speed at which the load follows a mode of the ring, of frequency n (Omega_c -+ Omega), without any contact
/// force, so that friction neither drives nor damps it. With s = i n (Omega_c -+ Omega),
///
///     (m_r (s^2 - Omega^2) + k_r) (m_t s^2 - m_s Omega^2 + k_t) + 4 g^2 Omega^2 s^2 = 0.
///
struct NeutralSpeed {
  double speed_rad_per_s;
  double frequency_rad_per_s;  ///< frequency in the rotating frame
  bool forward;                ///< true: forward mode, lower sign
};
std::vector<NeutralSpeed> neutral_speeds(const Ring& ring, const Load& load);

/// Divergence speeds of one load of inclination alpha that has both motions: Omega_c, and the roots of
///
///     a (Omega_c^2 - Omega^2) [k_u s (s - mu c) + k_v c (c + mu s)] + k_u k_v = 0
///
/// with s = sin alpha, c = cos alpha, k_u = k_r - m_r Omega^2 and k_v = k_t - m_s Omega^2.
std::vector<double> inclined_divergence_speeds(const Ring& ring, const Load& load,
                                               double friction_coefficient);

}  // namespace rubsweep::ring
