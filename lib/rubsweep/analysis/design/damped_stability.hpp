#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/analysis/linear/whirl_modes.hpp"
#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::design {

/// An impeller or a stage of blades, which drives the rotor forward by cross-coupled stiffness.
struct Stage {
  bool axial = false;        ///< true: blades (Alford); false: an impeller (Wachel)
  double power_w = 0;        ///< > 0
  double density_ratio = 1;  ///< discharge density / suction density; 1 for blades
  double diameter_m = 0;     ///< diameter of the impeller, or pitch diameter of the blades; > 0
  double width_m = 0;        ///< narrowest width of diffuser or impeller, or the height of the blades; > 0
};

/// Cross-coupled stiffness of a stage in N/m for Level I of API 617: B power density ratio / (speed diameter
/// width), with the speed in rad/s. B is 3 for an impeller (Wachel) and 1.5 for blades (Alford).
double cross_coupling_n_per_m(const Stage& stage, double speed_hz);

/// Critical speed ratio above which a rotor is in region B of Level I of API 617, where a threshold below ten
/// times the coupling asks for Level II. `gas_density_kg_per_m3`: mean of suction and discharge. The line is
/// the one that ROSS draws (api_report.py); the standard itself was not at hand.
double region_limit(double gas_density_kg_per_m3);

/// Logarithmic decrement of the first forward whirl at a speed. Whirl above half of critical damping is
/// omitted.
struct Decrement {
  double speed_hz = 0, frequency_hz = 0;
  double decrement = 0;  ///< 2 pi times damping ratio / sqrt(1 - ratio^2); negative: the whirl grows
};

/// The smallest decrement at some speeds, which ascend. `coupling_n_per_m` acts at the place with number
/// `place` along the rotor and drives it forward: kxy = coupling, kyx = -coupling. Empty where no whirl below
/// `up_to_hz` is forward. Tables of supports must reach the speeds.
std::optional<Decrement> first_forward(const linear::FreeRotor& rotor, std::span<const double> speeds_hz,
                                       double up_to_hz, Eigen::Index place = 0, double coupling_n_per_m = 0);

/// Decrements of the first forward whirl at one speed, one for each of these couplings, which ascend. The
/// whirl without coupling is followed as the coupling grows. There are fewer where it is lost, and none where
/// no whirl below `up_to_hz` is forward.
std::vector<Decrement> over_coupling(const linear::FreeRotor& rotor, double speed_hz, double up_to_hz,
                                     Eigen::Index place, std::span<const double> couplings_n_per_m);

/// Coupling at which the first forward whirl neither decays nor grows. It is 0 where the whirl grows without
/// any coupling, and empty where no coupling up to 1e12 N/m makes it grow.
std::optional<double> threshold_n_per_m(const linear::FreeRotor& rotor, double speed_hz, double up_to_hz,
                                        Eigen::Index place);

}  // namespace rubsweep::design
