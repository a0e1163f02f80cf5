#pragma once

/// \file
/// A machine: rotor, stops and kick, as plain structs. All numbers are in SI units, named in each identifier;
/// +x is right, +y is up, angles are in degrees from +x. A number without a default is model::required until
/// it is given. model::validate throws ConfigError, which names the missing or wrong number; build_cell
/// (cell.hpp) calls it.
///
/// - model::Machine: `rotor`, `stops`, `kick`, `start`, `gravity_m_per_s2` and the rest of a
///   configuration's machine
/// - model::JeffcottRotor or model::RotorKit: one disc between two bearings, or shaft, discs and supports
/// - model::Stop: a flat (`OneSideGeometry`) or annular (`AnnularGeometry`) wall with stiffness, damping
///   and friction
///
/// ```cpp
/// using namespace rubsweep;
/// model::Stop stop;
/// stop.geometry = model::OneSideGeometry{.angle_deg = 90};  // above the rotor
/// stop.clearance_m = 1e-3;
/// stop.stiffness_n_per_m = 2e6;
/// stop.damping = model::NominalRestitution{.value = 0.7};
/// stop.contact_radius_m = 0.0375;
/// model::Machine machine;
/// machine.rotor =
///     model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0.02};
/// machine.stops = {stop};
/// model::validate(machine);
/// ```

#include "rubsweep/core/model/machine.hpp"
