#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/structure/steel.hpp"
#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::structure {

/// The machine with its tables replaced by their values at a speed; in random kits they are linear in the
/// speed.
inline model::Machine with_lines_at(model::Machine machine, double hz) {
  for (model::Support& support : model::kit_of(machine)->supports) {
    if (!support.table) continue;
    const model::SupportTable& table = *support.table;
    const double share = (hz - table.speed_hz.front()) / (table.speed_hz.back() - table.speed_hz.front());
    std::array<double, model::support_coefficients.size()> values{};
    for (std::size_t c = 0; c < values.size(); ++c)
      values[c] = (1 - share) * table.columns[c].front() + share * table.columns[c].back();
    model::set_coefficients(support, values);
    support.table.reset();
  }
  return machine;
}

/// Random kits with all kinds of parts and loads.
class RandomKit {
 public:
  explicit RandomKit(unsigned seed) : random_(seed) {}

  model::Machine machine() {
    model::RotorKit kit;
    const int segments = 1 + below(3);
    double length = 0;
    for (int i = 0; i < segments; ++i) {
      kit.shaft.push_back(steel_segment(between(0.15, 0.4), between(0.012, 0.03)));
      length += kit.shaft.back().length_m;
    }
    for (int i = 1 + below(3); i > 0; --i) {
      const double mass = between(0.3, 3), polar = mass * between(5e-4, 2e-3);
      kit.discs.push_back({.position_m = place(length),
                           .mass_kg = mass,
                           .polar_inertia_kg_m2 = polar,
                           .diametral_inertia_kg_m2 = polar * between(0.5, 1),
                           .eccentricity_ratio = between(0, 1)});
    }
    kit.supports = {support(0), support(below(2) ? length : 0.9 * length)};
    if (below(3) == 0) kit.supports.push_back(seal(place(length)));
    if (below(2)) kit.sensors = {{.position_m = place(length)}};
    kit.damping_ratio = {between(0.002, 0.03)};
    if (below(4) == 0) kit.rotating_damping_ratio = {between(0, 0.01)};
    if (below(3) == 0) kit.static_loads = {{place(length), between(-100, 100), between(-100, 100)}};
    kit.modes_up_to_hz = between(200, 1200);
    kit.elements = 10;
    if (below(3) == 0) add_tables(kit);
    if (below(3) == 0)
      kit.supports[0].fault = {
          .impulse_ns = 1, .multiple = between(1, 5), .angle_deg = between(0, 90), .phase_deg = 0};
    model::Machine machine;
    machine.rotor = kit;
    model::Stop& stop = machine.stops.emplace_back();
    stop.position_m = place(length);
    stop.clearance_m = 3e-4, stop.stiffness_n_per_m = 1e6, stop.contact_radius_m = 0.02;
    stop.damping = model::ExplicitDamping{10};
    return machine;
  }

  /// A speed within the tables; without tables, one up to the kit's highest claimed frequency.
  double speed_hz(const model::RotorKit& kit) {
    if (!model::has_tables(kit)) return between(0, kit.modes_up_to_hz);
    const model::Range range = model::table_speeds_hz(kit);
    return between(range.low, range.high);
  }

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

 private:
  /// Half of all positions are nodes of symmetric mode shapes.
  double place(double length_m) {
    return length_m * (below(2) ? 0.25 * (1 + below(3)) : between(0.05, 0.95));
  }

  model::Support support(double place_m) {
    model::Support one = isotropic_support(place_m, std::pow(10, between(4.8, 7)));
    one.stiffness_y_n_per_m *= below(2) ? 1 : between(0.5, 2);
    one.damping_x_ns_per_m = std::pow(10, between(0, 3.3));
    one.damping_y_ns_per_m = below(2) ? one.damping_x_ns_per_m : std::pow(10, between(0, 3.3));
    if (below(3) == 0) one.angular_stiffness_nm_per_rad = between(10, 1e4);
    return one;
  }

  model::Support seal(double place_m) {
    model::Support one = isotropic_support(place_m, between(1e3, 1e5));
    one.stiffness_xy_n_per_m = between(-3e5, 3e5);
    one.stiffness_yx_n_per_m = -one.stiffness_xy_n_per_m * between(0.5, 1.5);
    one.damping_x_ns_per_m = one.damping_y_ns_per_m = between(0, 300);
    one.damping_xy_ns_per_m = between(-20, 20), one.damping_yx_ns_per_m = -one.damping_xy_ns_per_m;
    return one;
  }

  /// Adds tables of fluid films: with rising speed they become stiffer or softer, with more or less cross
  /// stiffness.
  void add_tables(model::RotorKit& kit) {
    const double low_hz = between(5, 20), high_hz = between(60, 300);
    for (model::Support& support : kit.supports) {
      const double kxx = support.stiffness_x_n_per_m, kyy = support.stiffness_y_n_per_m,
                   cxx = support.damping_x_ns_per_m, cyy = support.damping_y_ns_per_m;
      const double cross = between(0, 0.8) * std::min({kxx, kyy, 3e5}), faster = between(0.4, 2.5),
                   damped = between(0.4, 2.5), driven = between(-0.5, 2);
      const std::array<double, model::support_coefficients.size()> slow{kxx, cross, -cross, kyy, cxx,
                                                                        0,   0,     cyy,    0,   0},
          fast{kxx * faster,
               cross * driven,
               -cross * driven,
               kyy * faster,
               cxx * damped,
               0,
               0,
               cyy * damped,
               0,
               0};
      model::SupportTable table;
      constexpr int points = 6;
      for (int k = 0; k < points; ++k) {
        const double share = static_cast<double>(k) / (points - 1);
        table.speed_hz.push_back(low_hz + share * (high_hz - low_hz));
        for (std::size_t c = 0; c < slow.size(); ++c)
          table.columns[c].push_back((1 - share) * slow[c] + share * fast[c]);
      }
      support = model::with_table(support, table);
    }
  }

  std::mt19937 random_;
};

}  // namespace rubsweep::structure
