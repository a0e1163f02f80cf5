#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::diagnose {

/// A rotor kit as far as it is known.
struct KnownKit {
  std::vector<model::RotorKit> likely;  ///< each as likely as the others; the lowest natural frequency first
  double natural_frequency_hz = 0;      ///< lowest bending frequency at rest, of the middle one
  double rotor_mass_kg = 0;
  double probe_position_m = 0;    ///< place of the first sensor
  double from_m = 0, to_m = 0;    ///< first and last support on the shaft: stops stand between them
  double length_m = 0;            ///< length of the shaft
  bool same_all_around = false;   ///< no direction across the shaft differs from another
  std::vector<double> nodes_m{};  ///< nodes of a kit of matrices, where its stops stand
  std::string digest{};           ///< digest of all that decided the kits, for tables of cases
};

/// Throws ConfigError, opened by `name`, where a kit has a length or a force that does not grow with the
/// unbalance (bow, couplings out of line, static loads, a faulty bearing, clearances from the sag), torsion,
/// or no sensor.
void refuse_unscalable(const model::RotorKit& kit, const std::string& name);

/// Kits from draws of what is not known. Each keeps the modes up to most_order times the speed and one more,
/// or what it says itself. Throws ConfigError, opened by `name`, as refuse_unscalable, and where a kit has no
/// damping or cannot be computed at this speed.
KnownKit known_kit(std::vector<model::RotorKit> drawn, double speed_hz, const std::string& name);

/// The kit with all natural frequencies times a factor, by stiffnesses, and all damping times another one.
/// Bearings that follow tables and matrices stay as they are.
model::RotorKit varied_kit(const model::RotorKit& kit, double frequency_factor, double damping_factor);

/// Kits whose frequencies and damping lie evenly within shares of those of `kit`.
std::vector<model::RotorKit> varied_kits(const model::RotorKit& kit, double frequency_share,
                                         double damping_share, std::size_t count, std::uint64_t seed);

/// The kit at a share in [0, 1] of the likely ones.
const model::RotorKit& likely_kit(const KnownKit& kit, double share);

/// Place of a stop that is drawn at a position: there, or at the nearest node of matrices.
double place_of_stop(const KnownKit& kit, double position_m);

}  // namespace rubsweep::diagnose
