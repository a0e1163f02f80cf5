#include "rubsweep/structure/full_reference.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "rubsweep/error.hpp"
#include "rubsweep/numerics/dense/lu.hpp"
#include "rubsweep/structure/free_modes.hpp"
#include "rubsweep/structure/seen_modes.hpp"

namespace rubsweep::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using std::numbers::pi;

constexpr double grid_decades = 2.5;
constexpr double grows = 1e-4;  ///< share of its frequency at which a vibration surely grows

/// Points for a system of so many coordinates: a solution takes the third power of these.
int points_for(Index coordinates) {
  constexpr int most = 100, least = 25;
  constexpr double many = 150;
  return std::clamp(static_cast<int>(most * std::pow(many / static_cast<double>(coordinates), 3)), least,
                    most);
}

/// Rates of the free vibrations up to a frequency; no numbers where they cannot be told.
Eigen::VectorXcd rates_within(const SpeedMatrices& matrices, double rad_per_s) {
  try {
    return free_modes(matrices, {0, rad_per_s}).rate_per_s;
  } catch (const SolverError&) {
    return Eigen::VectorXcd::Constant(1, std::numeric_limits<double>::quiet_NaN());
  }
}

/// Distance of a growing rate from the nearest of `others`: the larger one of the shares by which frequency
/// and growth differ.
double distance(std::complex<double> rate, const Eigen::VectorXcd& others) {
  constexpr double slow = 0.01;  // of the frequency: slower growth counts by this
  double least = 1;
  for (const std::complex<double>& other : others) {
    const double size = std::abs(rate), growth = std::abs(rate.real() - other.real());
    least = std::min(least, std::max(std::abs(rate - other) / size, growth / (rate.real() + slow * size)));
  }
  return least;
}

bool any_grows(const Eigen::VectorXcd& rates) {
  return std::ranges::any_of(rates, [](const auto& rate) { return rate.real() > grows * std::abs(rate); });
}

}  // namespace

FullReference::FullReference(const BeamShaft& shaft, const model::RotorKit& kit,
                             std::vector<double> responses_m, std::vector<double> forces_m,
                             std::vector<double> loads_m)
    : shaft_(shaft),
      kit_(kit),
      responses_m_(std::move(responses_m)),
      forces_m_(std::move(forces_m)),
      loads_m_(std::move(loads_m)),
      lines_{{true, 0, {}}, {false, 0, {}}} {
  if (model::has_tables(kit)) {
    const model::Range speeds_hz = model::table_speeds_hz(kit);
    for (const double hz : {speeds_hz.low, speeds_hz.high})
      lines_.push_back({false, 2 * pi * hz, 2 * pi * hz});
  }
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(shaft.coordinates(), shaft.coordinates());
  full_ = rotor_of({one, one}, full_system(shaft, kit));
  points_ = points_for(full_.matrices.system.coordinates());
  around_ = std::max(1, points_ / 25);
  for (const Line& line : lines_) {
    auto& values = exact_.emplace_back();
    for (int k = 0; k < points_; ++k) values.push_back(receptance(full_, line, rad_per_s(k)));
  }
  if (!may_feed_vibrations(shaft, kit)) return;
  const double highest = 2 * pi * kit.modes_up_to_hz;
  std::vector<Line> speeds(lines_.begin() + 1, lines_.end());
  for (const double share : {0.1, 1.0}) speeds.push_back({false, share * highest, {}});
  for (const Line& at : speeds) {
    rates_.emplace_back(
        at, rates_within(matrices_at(full_.matrices, at.speed_rad_per_s, at.supports_rad_per_s), highest));
  }
}

FullReference::Rotor FullReference::rotor_of(const PlaneBases& bases, FullSystem matrices) const {
  const LateralSystem& system = matrices.system;
  const auto at_places = [&](const std::vector<double>& places_m) {
    std::vector<Index> coordinates;
    for (const double place : places_m) coordinates.push_back(shaft_.deflection(place));
    return coordinates;
  };
  const auto rows = [&](const std::vector<Index>& coordinates) {
    Eigen::MatrixXd seen(static_cast<Index>(2 * coordinates.size()), system.coordinates());
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      for (std::size_t plane = 0; plane < 2; ++plane) {
        seen.row(static_cast<Index>(2 * i + plane)) =
            system.scatter(plane, bases[plane].row(coordinates[i]).transpose()).transpose();
      }
    }
    return seen;
  };
  std::vector<double> forces_m = forces_m_;
  forces_m.insert(forces_m.end(), loads_m_.begin(), loads_m_.end());
  std::vector<Index> forces = at_places(forces_m);
  for (Index i = 0; i < shaft_.coordinates(); ++i) {
    if (shaft_.unbalance_kg(i) != 0.0) forces.push_back(i);
  }
  Eigen::MatrixXd responses = rows(at_places(responses_m_)), columns = rows(forces).transpose();
  return {std::move(matrices), std::move(responses), std::move(columns)};
}

FullReference::Rotor FullReference::reduced_rotor(const Reduction& reduction) const {
  FullSystem reduced{reduced_system(shaft_, kit_, reduction), {}, {}};
  if (model::has_rotating_damping(kit_)) {
    const RotatingDamping added = rotating_damping(shaft_, kit_, reduction, reduced.system);
    reduced.system.damping += added.damping;
    reduced.circulatory = added.circulatory;
  }
  reduced.tables =
      tabled_supports(shaft_, kit_, reduction.bases, reduced.system, reduced.system.coordinates());
  return rotor_of(reduction.bases, std::move(reduced));
}

double FullReference::rad_per_s(double step) const {
  return 2 * pi * kit_.modes_up_to_hz * std::pow(10.0, -grid_decades * (1 - step / (points_ - 1)));
}

MatrixXcd FullReference::receptance(const Rotor& rotor, const Line& line, double w, double loss) const {
  const SpeedMatrices at =
      matrices_at(rotor.matrices, line.with_the_force ? w : line.speed_rad_per_s, line.supports_rad_per_s);
  MatrixXcd dynamic(at.mass.rows(), at.mass.cols());
  dynamic.real() = at.stiffness - w * w * at.mass;
  dynamic.imag() = w * at.damping + loss * at.stiffness;
  return rotor.responses.cast<std::complex<double>>() *
         numerics::dense::solve(dynamic, MatrixXcd(rotor.forces.cast<std::complex<double>>()));
}

Eigen::Vector2d FullReference::sizes(const MatrixXcd& value) const {
  const auto forces = static_cast<Index>(2 * forces_m_.size());
  return {value.leftCols(forces).norm(), value.rightCols(value.cols() - forces).norm()};
}

double FullReference::difference(const MatrixXcd& found, const MatrixXcd& exact,
                                 const Eigen::Vector2d& size) const {
  const Eigen::Vector2d off = sizes(found - exact);
  // Loads may be none.
  return std::max(off(0) / size(0), size(1) > 0 ? share_beside * off(1) / size(1) : 0);
}

double FullReference::line_error(const Rotor& reduced, std::size_t line, double enough) const {
  double worst = 0;
  for (int k = points_ - 1; k >= 0 && worst <= enough; --k) {
    // An antiresonance is no reason to keep on adding modes.
    Eigen::Vector2d size(0, 0);
    for (int j = std::max(0, k - around_); j <= std::min(points_ - 1, k + around_); ++j)
      size = size.cwiseMax(sizes(exact_[line][static_cast<std::size_t>(j)]));
    const MatrixXcd found = receptance(reduced, lines_[line], rad_per_s(k));
    worst = std::max(worst, difference(found, exact_[line][static_cast<std::size_t>(k)], size));
  }
  return worst;
}

double FullReference::peak_error(const Rotor& reduced, std::size_t line, double enough) const {
  constexpr int finer = 8, cuts = 25;
  constexpr double loss = 0.004;  // without damping a peak has no height that could be compared
  const double step = 1.0 / finer;
  const auto height = [&](double at) {
    return receptance(reduced, lines_[line], rad_per_s(at), loss).norm();
  };
  double worst = 0, before = 0, here = height(0);
  for (int k = 0; k < finer * (points_ - 1) && worst <= enough; ++k) {
    const double after = height((k + 1) * step);
    const bool peak = k > 0 && here > before && here >= after;
    before = std::exchange(here, after);
    if (!peak) continue;
    double low = (k - 1) * step, high = (k + 1) * step;
    for (int cut = 0; cut < cuts; ++cut) {
      const double third = (high - low) / 3;
      if (height(low + third) < height(high - third)) {
        low += third;
      } else {
        high -= third;
      }
    }
    const double w = rad_per_s((low + high) / 2);
    const MatrixXcd exact = receptance(full_, lines_[line], w, loss),
                    found = receptance(reduced, lines_[line], w, loss);
    Eigen::Vector2d size = sizes(exact).cwiseMax(sizes(found));
    const Eigen::Vector2d off = sizes(found - exact);
    worst = std::max(worst, share_beside * std::max(off(0) / size(0), size(1) > 0 ? off(1) / size(1) : 0));
  }
  return worst;
}

double FullReference::receptance_error(const Reduction& reduction, double enough) const {
  const Rotor reduced = reduced_rotor(reduction);
  double worst = 0;
  for (std::size_t line = 0; line < lines_.size() && worst <= enough; ++line)
    worst = std::max(worst, line_error(reduced, line, enough));
  for (std::size_t line = 0; line < lines_.size() && worst <= enough; ++line)
    worst = std::max(worst, peak_error(reduced, line, enough));
  return worst;
}

FullReference::Growth FullReference::growth(const Reduction& reduction) const {
  Growth growth;
  if (rates_.empty()) return growth;
  const Rotor reduced = reduced_rotor(reduction);
  for (const auto& [at, exact] : rates_) {
    // Rates of either a little beyond may be those of the other within.
    constexpr double beyond = 1.1;
    const double highest = 2 * pi * kit_.modes_up_to_hz;
    const Eigen::VectorXcd found = rates_within(
        matrices_at(reduced.matrices, at.speed_rad_per_s, at.supports_rad_per_s), beyond * highest);
    growth.mistaken = growth.mistaken || any_grows(found) != any_grows(exact);
    for (const std::complex<double>& rate : exact) {
      if (rate.real() > grows * std::abs(rate)) growth.error = std::max(growth.error, distance(rate, found));
    }
    for (const std::complex<double>& rate : found) {
      if (rate.real() > grows * std::abs(rate) && std::abs(rate) <= highest / beyond)
        growth.error = std::max(growth.error, distance(rate, exact));
    }
  }
  return growth;
}

}  // namespace rubsweep::structure
