#include "rubsweep/core/structure/full_reference.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/banded_system.hpp"
#include "rubsweep/core/structure/free_modes.hpp"
#include "rubsweep/core/structure/seen_modes.hpp"

namespace rubsweep::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using std::numbers::pi;

constexpr double grid_decades = 2.5;
constexpr double growing = 1e-4;  ///< share of its frequency above which growth is certain

/// Number of frequency points for a system of this size; the cost of each grows with the third power of the
/// size.
int points_for(Index coordinates) {
  constexpr int most = 100, least = 25;
  constexpr double many = 150;
  return std::clamp(static_cast<int>(most * std::pow(many / static_cast<double>(coordinates), 3)), least,
                    most);
}

/// Rates of the free vibrations up to a frequency; NaN where they cannot be computed.
Eigen::VectorXcd rates_within(const SpeedMatrices& matrices, double rad_per_s) {
  try {
    return free_modes(matrices, {0, rad_per_s}).rate_per_s;
  } catch (const SolverError&) {
    return Eigen::VectorXcd::Constant(1, std::numeric_limits<double>::quiet_NaN());
  }
}

/// Distance of a growing rate from the nearest of `others`: the larger of the relative differences in
/// frequency and in growth.
double distance(std::complex<double> rate, const Eigen::VectorXcd& others) {
  constexpr double slow = 0.01;  // share of the frequency: least reference for a growth
  double least = 1;
  for (const std::complex<double>& other : others) {
    const double size = std::abs(rate), growth = std::abs(rate.real() - other.real());
    least = std::min(least, std::max(std::abs(rate - other) / size, growth / (rate.real() + slow * size)));
  }
  return least;
}

/// Largest ratio of `differences` to `sizes`; the last ratio is weighted by `share_of_last`. A size of 0 is
/// skipped, as where there are no loads.
double largest_share(const Eigen::VectorXd& differences, const Eigen::VectorXd& sizes, double share_of_last) {
  double largest = 0;
  for (Index i = 0; i < sizes.size(); ++i) {
    const double counts = i + 1 < sizes.size() ? 1 : share_of_last;
    if (sizes(i) > 0) largest = std::max(largest, counts * differences(i) / sizes(i));
  }
  return largest;
}

bool any_grows(const Eigen::VectorXcd& rates, double share) {
  return std::ranges::any_of(rates, [=](const auto& rate) { return rate.real() > share * std::abs(rate); });
}

/// Whether one set of rates surely has a growing vibration and the other surely has none. A margin excludes
/// speeds near the onset of growth, where either set may be right.
bool contradict(const Eigen::VectorXcd& one, const Eigen::VectorXcd& other) {
  const auto only_first = [](const Eigen::VectorXcd& a, const Eigen::VectorXcd& b) {
    return any_grows(a, growing) && !any_grows(b, growing / 4);
  };
  return only_first(one, other) || only_first(other, one);
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
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    auto& values = exact_.emplace_back();
    for (int k = 0; k < points_; ++k) values.push_back(receptance(full_, line, rad_per_s(k)));
  }
  if (!may_feed_vibrations(shaft, kit)) return;
  const double highest = 2 * pi * kit.modes_up_to_hz;
  std::vector<Line> speeds{lines_[1]};
  for (const double share : {0.02, 0.05, 0.1, 0.2, 0.4, 1.0}) speeds.push_back({false, share * highest, {}});
  if (model::has_tables(kit)) {
    constexpr int parts = 6;
    const double low = lines_[2].speed_rad_per_s, high = lines_[3].speed_rad_per_s;
    for (int part = 0; part <= parts; ++part) {
      const double speed = low + (high - low) * part / parts;
      speeds.push_back({false, std::clamp(speed, low, high), std::clamp(speed, low, high)});
    }
  }
  for (const Line& at : speeds) {
    rates_.emplace_back(
        at, rates_within(matrices_at(full_.matrices, at.speed_rad_per_s, at.supports_rad_per_s), highest));
  }
}

FullReference::Rotor FullReference::rotor_of(const PlaneBases& bases, FullSystem matrices) const {
  const LateralSystem& system = matrices.system;
  const auto at_places = [&](const std::vector<double>& places_m) {
    std::vector<Index> coordinates;
    coordinates.reserve(places_m.size());
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
  Rotor rotor{std::move(matrices), std::move(responses), std::move(columns), {}};
  rotor.band = numerics::band_of({&rotor.matrices.system.gyroscopic, &rotor.matrices.circulatory});
  for (const Line& line : lines_) {
    const SpeedMatrices& at = rotor.at_lines.emplace_back(
        matrices_at(rotor.matrices, line.speed_rad_per_s, line.supports_rad_per_s));
    rotor.band = std::max(rotor.band, numerics::band_of({&at.mass, &at.damping, &at.stiffness}));
  }
  return rotor;
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

MatrixXcd FullReference::receptance(const Rotor& rotor, std::size_t line, double w, double loss) const {
  const SpeedMatrices& at = rotor.at_lines[line];
  const bool with_the_force = lines_[line].with_the_force;
  const Eigen::MatrixXd& circulatory = rotor.matrices.circulatory;
  const auto transposed_dynamic = [&](Index column, Index row) {
    std::complex<double> value(at.stiffness(row, column) - w * w * at.mass(row, column),
                               w * at.damping(row, column) + loss * at.stiffness(row, column));
    if (!with_the_force) return value;
    value += std::complex<double>(0, w * w * rotor.matrices.system.gyroscopic(row, column));
    if (circulatory.size() > 0) value += std::complex<double>(w, loss * w) * circulatory(row, column);
    return value;
  };
  // The equations are solved from the left, because there are few responses, whereas forces act wherever the
  // shaft has unbalance.
  const MatrixXcd left = numerics::solve_banded(
      transposed_dynamic, rotor.responses.transpose().cast<std::complex<double>>(), rotor.band);
  MatrixXcd value(rotor.responses.rows(), rotor.forces.cols());
  value.real() = left.real().transpose() * rotor.forces;
  value.imag() = left.imag().transpose() * rotor.forces;
  return value;
}

Eigen::VectorXd FullReference::sizes(const MatrixXcd& value) const {
  const auto places = static_cast<Index>(forces_m_.size());
  Eigen::VectorXd sizes(places + 1);
  // One norm over all positions would hide a force with a weak response behind one with a strong response.
  for (Index i = 0; i < places; ++i) sizes(i) = value.middleCols<2>(2 * i).norm();
  sizes(places) = value.rightCols(value.cols() - 2 * places).norm();
  return sizes;
}

double FullReference::line_error(const Rotor& reduced, std::size_t line, double enough) const {
  double worst = 0;
  for (int k = points_ - 1; k >= 0 && worst <= enough; --k) {
    // Each reference is taken over neighbouring frequencies: an antiresonance is no reason to add more modes.
    Eigen::VectorXd size = Eigen::VectorXd::Zero(static_cast<Index>(forces_m_.size()) + 1);
    for (int j = std::max(0, k - around_); j <= std::min(points_ - 1, k + around_); ++j)
      size = size.cwiseMax(sizes(exact_[line][static_cast<std::size_t>(j)]));
    const MatrixXcd off = receptance(reduced, line, rad_per_s(k)) - exact_[line][static_cast<std::size_t>(k)];
    worst = std::max(worst, largest_share(sizes(off), size, share_beside));
  }
  return worst;
}

double FullReference::peak_error(const Rotor& reduced, std::size_t line, double enough) const {
  constexpr int finer = 8, bits = 20;
  constexpr std::uintmax_t most_iterations = 30;
  // Loss factor added to the damping of the rotor, so that peaks are finite without damping, too.
  constexpr double loss = 0.004;
  const double step = 1.0 / finer;
  const auto height = [&](double at) { return receptance(reduced, line, rad_per_s(at), loss).norm(); };
  double worst = 0, before = 0, here = height(0);
  for (int k = 0; k < finer * (points_ - 1) && worst <= enough; ++k) {
    const double after = height((k + 1) * step);
    const bool peak = k > 0 && here > before && here >= after;
    before = std::exchange(here, after);
    if (!peak) continue;
    std::uintmax_t iterations = most_iterations;
    const double top = boost::math::tools::brent_find_minima([&](double at) { return -height(at); },
                                                             (k - 1) * step, (k + 1) * step, bits, iterations)
                           .first;
    const double w = rad_per_s(top);
    const MatrixXcd exact = receptance(full_, line, w, loss), found = receptance(reduced, line, w, loss);
    const Eigen::VectorXd size = sizes(exact).cwiseMax(sizes(found));
    worst = std::max(worst, share_beside * largest_share(sizes(found - exact), size, 1));
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
    // A rate just beyond the limit in one model may lie within it in the other.
    constexpr double beyond = 1.1;
    const double highest = 2 * pi * kit_.modes_up_to_hz;
    const Eigen::VectorXcd found = rates_within(
        matrices_at(reduced.matrices, at.speed_rad_per_s, at.supports_rad_per_s), beyond * highest);
    growth.mistaken = growth.mistaken || contradict(found, exact);
    for (const std::complex<double>& rate : exact) {
      if (rate.real() > growing * std::abs(rate))
        growth.error = std::max(growth.error, distance(rate, found));
    }
    for (const std::complex<double>& rate : found) {
      if (rate.real() > growing * std::abs(rate) && std::abs(rate) <= highest / beyond)
        growth.error = std::max(growth.error, distance(rate, exact));
    }
  }
  return growth;
}

bool growth_is_mistaken(const BeamShaft& shaft, const model::RotorKit& kit, const Assembly& reduced,
                        double speed_rad_per_s) {
  if (!may_feed_vibrations(shaft, kit)) return false;
  const double highest = 2 * pi * kit.modes_up_to_hz;
  const LinearSystem small = system_at(reduced, speed_rad_per_s);
  const Eigen::VectorXcd found = rates_within({small.mass, small.damping, small.stiffness}, 10 * highest);
  double furthest = highest;
  for (const std::complex<double>& rate : found)
    if (rate.real() > growing * std::abs(rate)) furthest = std::max(furthest, 1.5 * std::abs(rate));
  const FullSystem full = full_system(shaft, kit);
  const Eigen::VectorXcd exact = rates_within(matrices_at(full, speed_rad_per_s, speed_rad_per_s), furthest);
  return exact.allFinite() && found.allFinite() && contradict(found, exact);
}

}  // namespace rubsweep::structure
