#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/analysis/design/critical_map.hpp"
#include "rubsweep/analysis/design/damped_stability.hpp"
#include "rubsweep/analysis/design/static_line.hpp"
#include "rubsweep/analysis/linear/whirl_modes.hpp"
#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::apps {

/// Remark on a picture of a rotor report: what it shows, or why it is missing.
struct ReportNote {
  std::string picture, note;
  std::optional<double> from_hz = {}, to_hz = {};  ///< range of speeds that it is about
};

/// Tables of a rotor report as texts, with their header and without their head. Lengths in metres.

/// Parts of a rotor kit: element (layer, shaft, disc, point_mass, bearing, seal, coupling, load, stop,
/// probe), name, position_m, end_m, diameters inner_m, outer_m, inner_end_m, outer_end_m, mass_kg,
/// polar_inertia_kg_m2, angle_deg.
std::string rotor_parts_csv(const model::Machine& machine, const std::vector<std::string>& stop_names = {});

/// Columns position_m, deflection_x_m, deflection_y_m, shear_x_n, shear_y_n, moment_x_nm, moment_y_nm; a
/// place where a force acts has two rows.
std::string static_line_csv(const design::StaticLine& line);

/// Columns bearing, position_m, load_x_n, load_y_n, unbalance_force_n.
std::string bearing_loads_csv(const model::RotorKit& kit, const design::StaticLine& line,
                              std::span<const double> unbalance_force_n);

/// Columns stiffness_n_per_m, mode, speed_hz.
std::string critical_map_csv(const std::vector<design::CriticalSpeedsAt>& map);

/// Stiffness of the bearings over these speeds: bearing, speed_hz, stiffness_x_n_per_m, stiffness_y_n_per_m.
std::string bearing_stiffness_csv(const model::RotorKit& kit, std::span<const double> speeds_hz);

/// Columns coupling_n_per_m, frequency_hz, decrement.
std::string stability_csv(std::span<const double> couplings_n_per_m,
                          const std::vector<design::Decrement>& decrements);

/// The rotor of a kit without matrices, with further places between the nodes of its elements, whose cubics
/// give the deflections there.
linear::FreeRotor with_places_between(linear::FreeRotor rotor);

/// Columns position_m, x_real, x_imag, y_real, y_imag of the response of all coordinates.
std::string deflected_shape_csv(const linear::FreeRotor& rotor, const Eigen::VectorXcd& response);

/// Columns picture, note, from_hz, to_hz.
std::string report_notes_csv(const std::vector<ReportNote>& notes);

/// Name of a support, or its number where it has none.
std::string support_label(const model::RotorKit& kit, std::size_t support);

}  // namespace rubsweep::apps
