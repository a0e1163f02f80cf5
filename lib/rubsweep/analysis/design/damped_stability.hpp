#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/analysis/linear/whirl_modes.hpp"
#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::design {

/// An impeller or a stage of blades, which drives the rotor forward by cross-coupled stiffness.
struct Stage {
  bool axial = false;        ///< blades (Alford), else an impeller (Wachel)
  double power_w = 0;        ///< > 0
  double density_ratio = 1;  ///< discharge by suction; of blades 1
  double diameter_m = 0;     ///< diameter of the impeller, or pitch diameter of the blades; > 0
  double width_m = 0;        ///< narrowest width of diffuser or impeller, or the height of the blades; > 0
};

/// Cross-coupled stiffness of a stage in N/m, as API 617 takes it for Level I: B power density ratio / (speed
/// diameter width), B = 3 of an impeller (Wachel) and 1.5 of blades (Alford), the speed in rad/s.
double cross_coupling_n_per_m(const Stage& stage, double speed_hz);

/// Logarithmic decrement of the first forward whirl at a speed; whirl damped by more than half of critical is
/// left out.
struct Decrement {
  double speed_hz = 0, frequency_hz = 0;
  double decrement = 0;  ///< 2 pi times damping ratio / sqrt(1 - ratio^2); negative: it grows
};

/// The least decrement at some speeds, ascending. `coupling_n_per_m` at the place number `place` of the rotor
/// drives it forward: kxy = coupling, kyx = -coupling. Empty where no whirl below `up_to_hz` is forward.
/// Supports by tables must reach the speeds.
std::optional<Decrement> first_forward(const linear::FreeRotor& rotor, std::span<const double> speeds_hz,
                                       double up_to_hz, Eigen::Index place = 0, double coupling_n_per_m = 0);

/// The decrement at one speed for each of these couplings, ascending: the first forward whirl without
/// coupling, followed as the coupling grows. Fewer where it is lost; empty where no whirl below `up_to_hz` is
/// forward.
std::vector<Decrement> over_coupling(const linear::FreeRotor& rotor, double speed_hz, double up_to_hz,
                                     Eigen::Index place, std::span<const double> couplings_n_per_m);

/// Coupling at which the first forward whirl neither decays nor grows; 0 where it grows without any, empty
/// where none up to 1e12 N/m makes it grow.
std::optional<double> threshold_n_per_m(const linear::FreeRotor& rotor, double speed_hz, double up_to_hz,
                                        Eigen::Index place);

}  // namespace rubsweep::design
