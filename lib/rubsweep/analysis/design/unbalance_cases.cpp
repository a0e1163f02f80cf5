#include "rubsweep/analysis/design/unbalance_cases.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/analysis/design/static_line.hpp"
#include "rubsweep/analysis/design/unbalance_response.hpp"
#include "rubsweep/core/model/balance.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/numerics/banded_system.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::design {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Places a vector of one plane among the coordinates of both planes.
Eigen::VectorXd in_plane(const Eigen::VectorXd& of_plane, Index plane) {
  Eigen::VectorXd both = Eigen::VectorXd::Zero(2 * of_plane.size());
  both(Eigen::seqN(plane, of_plane.size(), 2)) = of_plane;
  return both;
}

/// Mass of a layer of a segment between two shares of its length.
double layer_kg(const model::ShaftLayer& layer, double length_m, double begin, double end) {
  const auto area_m2 = [&](double at) {
    const model::Diameters d = model::diameters(layer, at);
    return std::numbers::pi / 4 * (d.outer_m * d.outer_m - d.inner_m * d.inner_m);
  };
  // Areas are quadratic along a taper, which Simpson's rule integrates exactly.
  return layer.density_kg_per_m3 * length_m * (end - begin) / 6 *
         (area_m2(begin) + 4 * area_m2((begin + end) / 2) + area_m2(end));
}

/// Mass of shaft, discs and point masses strictly between two places.
double mass_between_kg(const model::RotorKit& kit, double low_m, double high_m) {
  double mass_kg = 0, at_m = 0;
  for (const model::ShaftSegment& segment : kit.shaft) {
    const double begin = std::clamp((low_m - at_m) / segment.length_m, 0.0, 1.0),
                 end = std::clamp((high_m - at_m) / segment.length_m, 0.0, 1.0);
    if (end > begin) {
      mass_kg += layer_kg(segment, segment.length_m, begin, end);
      for (const model::ShaftLayer& layer : segment.layers)
        mass_kg += layer_kg(layer, segment.length_m, begin, end);
    }
    at_m += segment.length_m;
  }
  const auto add = [&](const auto& parts) {
    for (const auto& part : parts)
      if (part.position_m > low_m && part.position_m < high_m) mass_kg += part.mass_kg;
  };
  add(kit.discs);
  add(kit.point_masses);
  return mass_kg;
}

/// Motion of a place, as a share of the largest of the rotor, below which it is the rounding of a node.
constexpr double rounding = 1e-9;

double residual_kg_m(double mass_kg, double max_continuous_hz) {
  constexpr double g_mm_per_kg_m = 1e6;
  return unbalance_g_mm_rpm_per_kg / g_mm_per_kg_m * mass_kg / (model::rpm_per_hz * max_continuous_hz);
}

}  // namespace

WholeRotor::WholeRotor(const model::Machine& machine)
    : machine_(machine), rotor_(linear::free_rotor(machine)) {
  const structure::LateralSystem& system = rotor_.full.system;
  if (const model::RotorKit* kit = model::kit_of(machine_)) {
    add_shaft(*kit);
  } else {
    const double mass_kg = model::rotor_mass_kg(machine_);
    configured_kg_ = in_one_place(0, mass_kg);
    mass_kg_ = Eigen::VectorXd::Constant(1, mass_kg);
  }
  whole_mass_kg_ = mass_kg_.sum();
  const structure::SpeedMatrices some = structure::matrices_at(rotor_.full, 1);
  band_ = numerics::band_of({&some.mass, &some.damping, &some.stiffness});
  for (const structure::TabledSupport& table : rotor_.full.tables) {
    const Eigen::MatrixXd joined = table.map.transpose() * Eigen::Matrix2d::Ones() * table.map;
    band_ = std::max(band_, numerics::band_of({&joined}));
  }
  band_ = std::min(band_, system.coordinates() - 1);
}

void WholeRotor::add_shaft(const model::RotorKit& kit) {
  const std::vector<double> stations_m = stop_stations_m(machine_);
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(kit, stations_m);
  configured_kg_.resize(2 * shaft.unbalance_kg.size());
  configured_kg_(Eigen::seqN(0, shaft.unbalance_kg.size(), 2)) = shaft.unbalance_kg;
  configured_kg_(Eigen::seqN(1, shaft.unbalance_kg.size(), 2)) = -Complex(0, 1) * shaft.unbalance_kg;
  const auto places = static_cast<Index>(shaft.node_position_m.size());
  mass_kg_ = shaft.weight_kg(Eigen::seqN(0, places, 2));
  const structure::PlaneModes modes =
      structure::plane_modes(shaft.plane_mass(0), shaft.plane_stiffness(0), 2);
  first_ = modes.shape.col(0)(Eigen::seqN(0, places, 2));
  if (modes.shape.cols() > 1) second_ = modes.shape.col(1)(Eigen::seqN(0, places, 2));
  model::RotorKit without_loads = kit;
  without_loads.static_loads.clear();
  const StaticLine line = static_line(without_loads, stations_m);
  const double equal_n = standard_gravity_m_per_s2 * mass_kg_.sum() /
                         static_cast<double>(std::max<std::size_t>(line.loads.size(), 1));
  for (const BearingLoad& load : line.loads) {
    const Eigen::VectorXd gap = structure::support_gap(shaft, kit, load.support);
    bearings_.push_back({load.support, kit.supports[load.support].position_m,
                         line.holds ? -load.load_n[1] : equal_n, in_plane(gap, 0), in_plane(gap, 1)});
  }
  if (!bearings_.empty()) weigh_overhangs(kit);
}

void WholeRotor::weigh_overhangs(const model::RotorKit& kit) {
  const double first_m = bearings_.front().position_m, last_m = bearings_.back().position_m;
  if (!kit.matrices) {
    left_kg_ = mass_between_kg(kit, -1, first_m);
    right_kg_ = mass_between_kg(kit, last_m, 2 * model::shaft_length_m(kit));
    return;
  }
  // Matrices say how much each node weighs, and not where between nodes that is.
  for (Index k = 0; k < mass_kg_.size(); ++k) {
    const double at_m = rotor_.position_m[static_cast<std::size_t>(k)];
    if (at_m < first_m) left_kg_ += mass_kg_(k);
    if (at_m > last_m) right_kg_ += mass_kg_(k);
  }
}

Index WholeRotor::place(std::optional<double> position_m) const {
  if (!position_m) return 0;
  const auto next = std::ranges::min_element(rotor_.position_m, {},
                                             [&](double at_m) { return std::abs(at_m - *position_m); });
  return next - rotor_.position_m.begin();
}

Index WholeRotor::midspan() const {
  if (bearings_.empty()) return place((rotor_.position_m.front() + rotor_.position_m.back()) / 2);
  return place((bearings_.front().position_m + bearings_.back().position_m) / 2);
}

Eigen::VectorXcd WholeRotor::in_one_place(Index place, double kg_m) const {
  return kg_m * (rotor_.x.row(place).transpose().cast<Complex>() -
                 Complex(0, 1) * rotor_.y.row(place).transpose().cast<Complex>());
}

std::vector<UnbalanceCase> WholeRotor::cases(double eccentricity_m, double max_continuous_hz) const {
  std::vector<UnbalanceCase> cases{{"configured", eccentricity_m * configured_kg_}};
  if (first_.size() == 0) return cases;
  Index at = 0, other = 0;
  first_.cwiseAbs().maxCoeff(&at);
  cases.push_back({"mode 1", in_one_place(at, residual_kg_m(whole_mass_kg_, max_continuous_hz))});
  if (second_.size() > 0 && second_.maxCoeff(&at) > 0 && second_.minCoeff(&other) < 0) {
    const auto share_kg = [&](Index place) {
      if (bearings_.empty()) return whole_mass_kg_ / 2;
      const double here_m = rotor_.position_m[static_cast<std::size_t>(place)];
      const auto next = std::ranges::min_element(
          bearings_, {}, [&](const Bearing& one) { return std::abs(one.position_m - here_m); });
      return std::abs(next->static_load_n) / standard_gravity_m_per_s2;
    };
    cases.push_back({"mode 2", in_one_place(at, residual_kg_m(share_kg(at), max_continuous_hz)) -
                                   in_one_place(other, residual_kg_m(share_kg(other), max_continuous_hz))});
  }
  if (bearings_.empty()) return cases;
  if (left_kg_ > 0)
    cases.push_back({"left end", in_one_place(0, residual_kg_m(left_kg_, max_continuous_hz))});
  if (right_kg_ > 0)
    cases.push_back(
        {"right end", in_one_place(mass_kg_.size() - 1, residual_kg_m(right_kg_, max_continuous_hz))});
  return cases;
}

Eigen::MatrixXcd WholeRotor::response(const Eigen::MatrixXcd& unbalance_kg_m, double speed_hz) const {
  const double w = 2 * std::numbers::pi * speed_hz;
  const structure::SpeedMatrices at = structure::matrices_at(rotor_.full, w, w);
  const auto dynamic = [&](Index row, Index column) {
    return std::complex<double>(at.stiffness(row, column) - w * w * at.mass(row, column),
                                w * at.damping(row, column));
  };
  return numerics::solve_banded(dynamic, w * w * unbalance_kg_m, band_);
}

double WholeRotor::bearing_force_n(const Bearing& bearing, const Eigen::VectorXcd& response,
                                   double speed_hz) const {
  const double w = 2 * std::numbers::pi * speed_hz;
  const model::RotorKit& kit = *model::kit_of(machine_);
  const model::Support at = structure::support_at(kit.supports[bearing.support], speed_hz,
                                                  model::support_path(kit, bearing.support) + ".");
  const Complex i(0, 1), x = (bearing.x.transpose() * response).value(),
                         y = (bearing.y.transpose() * response).value();
  const Eigen::Vector2cd force{
      (at.stiffness_x_n_per_m + i * w * at.damping_x_ns_per_m - w * w * at.mass_x_kg) * x +
          (at.stiffness_xy_n_per_m + i * w * at.damping_xy_ns_per_m) * y,
      (at.stiffness_yx_n_per_m + i * w * at.damping_yx_ns_per_m) * x +
          (at.stiffness_y_n_per_m + i * w * at.damping_y_ns_per_m - w * w * at.mass_y_kg) * y};
  return major_axis(force) / 2;
}

const Eigen::MatrixXcd& Responses::at(double speed_hz) {
  const auto found = known_.find(speed_hz);
  if (found != known_.end()) return found->second;
  return known_.emplace(speed_hz, rotor_.response(unbalance_kg_m_, speed_hz)).first->second;
}

double Responses::major_axis(double speed_hz, Index place, Index column) {
  const linear::FreeRotor& free = rotor_.rotor();
  const auto q = at(speed_hz).col(column);
  const double axis_m =
      design::major_axis({(free.x.row(place) * q).value(), (free.y.row(place) * q).value()});
  const double largest_m = std::max((free.x * q).cwiseAbs().maxCoeff(), (free.y * q).cwiseAbs().maxCoeff());
  return axis_m < rounding * largest_m ? 0 : axis_m;
}

}  // namespace rubsweep::design
