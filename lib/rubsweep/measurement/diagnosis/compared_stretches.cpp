#include "rubsweep/measurement/diagnosis/compared_stretches.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/diagnose/features/line_features.hpp"
#include "rubsweep/measurement/diagnose/inference/simulated_case.hpp"
#include "rubsweep/measurement/scope/waterfall.hpp"

namespace rubsweep::diagnosis {
namespace {

using recording::Recording;

/// Lines by which the order of a fixed frequency near 1X moves in a stretch, from the speeds of its halves.
double moved_lines(const Recording& recording, const Stretch& stretch) {
  const int half = stretch.turns / 2;
  const double ratio = recording.mean_speed_hz(stretch.first_turn + half, half) /
                       recording.mean_speed_hz(stretch.first_turn, half);
  return std::abs(std::log(ratio)) / half * stretch.turns * stretch.turns;
}

/// Whether both halves of a stretch have similar sizes.
bool keeps_its_size(const Recording& recording, const Stretch& stretch) {
  constexpr double most = 1.2;
  const int half = stretch.turns / 2;
  const double first_m = diagnose::size_of(recording.samples(stretch.first_turn, half)),
               second_m = diagnose::size_of(recording.samples(stretch.first_turn + half, half));
  return std::max(first_m, second_m) <= most * std::min(first_m, second_m);
}

/// Stretches of so many turns, each half a stretch later than the last, in which the speed hardly changes.
std::vector<Stretch> steady_stretches(const Recording& recording, int turns) {
  constexpr double most_moved_lines = 0.6;
  std::vector<Stretch> stretches;
  for (int first = 0; first + turns <= recording.turns(); first += turns / 2) {
    const Stretch stretch{first, turns, recording.mean_speed_hz(first, turns), true};
    if (moved_lines(recording, stretch) <= most_moved_lines) stretches.push_back(stretch);
  }
  return stretches;
}

/// Share of the energy off +-1X in both halves, as in a motion that lasts. It counts less in motions that are
/// much smaller than `usual_m`: there it may be noise.
double lasting_off_1x(const Recording& recording, const Stretch& stretch, double usual_m) {
  constexpr int line_bins = 2;
  double least = 1;
  for (const int k : {0, 1}) {
    const int half = stretch.turns / 2;
    const auto lines = lines_of(recording, {stretch.first_turn + k * half, half, stretch.speed_hz, true});
    const diagnose::features::HannEnergy energy(lines, recording.plane);
    const double squared = std::pow(size_of(lines), 2),
                 share = 1 - energy.near(1, line_bins) - energy.near(-1, line_bins);
    least = std::min(least, share * squared / (squared + usual_m * usual_m));
  }
  return least;
}

/// The motion without the linear growth of its mean and of its lines at +-1X, by least squares: in a run-up
/// these change with the speed.
Eigen::VectorXcd without_growth(std::span<const std::complex<double>> samples, int turns) {
  const Eigen::Map<const Eigen::VectorXcd> all(samples.data(), static_cast<Eigen::Index>(samples.size()));
  const double last = 1 - 2 / static_cast<double>(all.size());
  const Eigen::ArrayXd time = Eigen::ArrayXd::LinSpaced(all.size(), -1, last);
  Eigen::MatrixXcd lines(all.size(), 6);
  for (const int order : {-1, 0, 1})
    lines.col(order + 1) = (std::complex<double>(0, order * std::numbers::pi * turns) * time).exp();
  lines.rightCols<3>() = time.matrix().asDiagonal() * lines.leftCols<3>();
  const Eigen::VectorXcd amplitude = lines.householderQr().solve(all);
  return all - lines.rightCols<3>() * amplitude.tail<3>();
}

}  // namespace

std::vector<Stretch> compared_stretches(const Recording& recording, const std::string& name) {
  constexpr std::size_t most_stretches = 3;
  constexpr double most_covered = 0.8, least_apart = 0.05;
  const int all = recording.turns();
  if (all < fewest_turns)
    throw ConfigError(fmt::format("{}: has {} whole turns, allowed: {} or more", name, all, fewest_turns));
  const int last = std::min(all, most_turns);
  if (!scope::speed_changes(recording)) return {{all - last, last, recording.mean_speed_hz()}};
  std::vector<Stretch> stretches;
  for (int turns = last; turns >= fewest_turns; --turns) {
    stretches = steady_stretches(recording, turns);
    if (static_cast<double>(stretches.size()) * turns / 2 >= most_covered * (all - turns)) break;
  }
  if (stretches.empty())
    throw ConfigError(fmt::format(
        "{}: the speed changes by 5 % or more in {} turns, allowed: a slower run-up, or from_s and to_s",
        name, fewest_turns));
  const auto steady = [&](const Stretch& stretch) { return keeps_its_size(recording, stretch); };
  if (std::ranges::any_of(stretches, steady))
    std::erase_if(stretches, [&](const Stretch& stretch) { return !steady(stretch); });
  const double usual_m = diagnose::size_of(recording.samples(0, all));
  std::vector<Stretch> taken{*std::ranges::max_element(
      stretches, {}, [&](const Stretch& stretch) { return lasting_off_1x(recording, stretch, usual_m); })};
  const auto apart = [&](const Stretch& stretch) {
    const auto from = [&](const Stretch& other) {
      return std::abs(std::log(stretch.speed_hz / other.speed_hz));
    };
    return from(std::ranges::min(taken, {}, from));
  };
  while (taken.size() < most_stretches) {
    const Stretch& farthest = *std::ranges::max_element(stretches, {}, apart);
    if (apart(farthest) < least_apart) break;
    taken.push_back(farthest);
  }
  return taken;
}

diagnose::MotionLines lines_of(const Recording& recording, const Stretch& stretch) {
  response::spectrum::SpectrumWorkspace workspace;
  const double order =
      diagnose::inference::seen_order({.readings_per_turn = recording.sampling_rate_hz / stretch.speed_hz});
  const std::span<const std::complex<double>> samples = recording.samples(stretch.first_turn, stretch.turns);
  if (!stretch.of_run_up) return diagnose::lines_of(samples, stretch.turns, order, workspace);
  const Eigen::VectorXcd steady = without_growth(samples, stretch.turns);
  return diagnose::lines_of(std::span(steady.data(), samples.size()), stretch.turns, order, workspace);
}

}  // namespace rubsweep::diagnosis
