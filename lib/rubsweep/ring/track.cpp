#include "rubsweep/ring/track.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/numerics/assignment.hpp"
#include "rubsweep/ring/mode_names.hpp"

namespace rubsweep::ring {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int most_halvings = 8;

/// Cost of taking eigenvalue k of `to` as the continuation of eigenvalue i of `from`: distance from the
/// prediction by its derivative, plus the size of its step times the change of shape.
MatrixXd continuation_costs(const TrackPoint& from, const TrackPoint& to, double size) {
  const double step = to.speed_rad_per_s - from.speed_rad_per_s;
  const Index count = from.spectrum.values.size();
  const MatrixXd assurance = (from.spectrum.vectors.adjoint() * to.spectrum.vectors).cwiseAbs2();
  MatrixXd cost(count, count);
  for (Index i = 0; i < count; ++i) {
    const std::complex<double> moved = from.spectrum.slopes(i) * step;
    const std::complex<double> predicted = from.spectrum.values(i) + moved;
    // A derivative without bound (two roots merge) predicts nothing.
    const double reach = std::min(std::abs(moved), 0.1 * size) + 1e-9 * size;
    for (Index k = 0; k < count; ++k) {
      const std::complex<double>& value = to.spectrum.values(k);
      const double distance =
          std::min(std::abs(value - predicted), std::abs(value - from.spectrum.values(i)));
      cost(i, k) = distance + reach * (1 - std::min(assurance(i, k), 1.0));
    }
  }
  return cost;
}

/// Another eigenvalue of another mode would have done about as well.
bool is_doubtful(const MatrixXd& cost, const std::vector<Index>& taken, const TrackPoint& from,
                 const TrackPoint& to, double size) {
  const auto mode_at = [&](Index i) { return from.mode[static_cast<std::size_t>(i)]; };
  for (Index i = 0; i < cost.rows(); ++i) {
    const Index own = taken[static_cast<std::size_t>(i)];
    for (Index other = 0; other < cost.rows(); ++other) {
      const Index rival = taken[static_cast<std::size_t>(other)];
      if (other == i || mode_at(other) == mode_at(i)) continue;
      if (std::abs(to.spectrum.values(rival) - to.spectrum.values(own)) < 1e-6 * size) continue;
      if (cost(i, own) > 1e-7 * size && cost(i, rival) < 3 * cost(i, own)) return true;
    }
  }
  return false;
}

class Tracker {
 public:
  Tracker(const NormalForm& form, Track& track, std::size_t most_points)
      : form_(form), track_(track), most_points_(most_points) {}

  void advance(double speed, bool asked, int halvings) {
    const TrackPoint& from = track_.points.back();
    TrackPoint to{speed, asked, spectrum(form_, speed), {}};
    const double size = std::max(size_of(from.spectrum.values), size_of(to.spectrum.values));
    const MatrixXd cost = continuation_costs(from, to, size);
    const auto taken = numerics::cheapest_assignment(cost);
    // At a crossing or a merger the doubt never ends; the cheapest assignment is as good as any there.
    const bool may_halve = halvings < most_halvings && track_.points.size() < most_points_;
    if (may_halve && is_doubtful(cost, taken, from, to, size)) {
      const double middle = from.speed_rad_per_s + 0.5 * (speed - from.speed_rad_per_s);
      advance(middle, false, halvings + 1);
      advance(speed, asked, halvings + 1);
      return;
    }
    to.mode.resize(taken.size());
    for (std::size_t i = 0; i < taken.size(); ++i) to.mode[static_cast<std::size_t>(taken[i])] = from.mode[i];
    pair_up(to.spectrum.values, to.mode);
    track_.points.push_back(std::move(to));
  }

 private:
  const NormalForm& form_;
  Track& track_;
  std::size_t most_points_;
};

/// Frequency of a mode at a point, 0 where it has two real roots.
double frequency_of(const TrackPoint& point, int mode) {
  double frequency = 0;
  for (std::size_t i = 0; i < point.mode.size(); ++i) {
    if (point.mode[i] == mode) frequency = std::abs(point.spectrum.values(static_cast<Index>(i)).imag());
  }
  return frequency;
}

void name_ring_modes(Track& track) {
  for (const TrackPoint& point : track.points) {
    const double first = frequency_of(point, 0), second = frequency_of(point, 1);
    if (std::abs(first - second) < 0.01 * (first + second)) continue;
    if (first < second) return;
    for (TrackPoint& renamed : track.points) {
      for (int& mode : renamed.mode) mode = mode < 2 ? 1 - mode : mode;
    }
    return;
  }
}

}  // namespace

Track track_modes(const System& system, const NormalForm& form, std::span<const double> speeds_rad_per_s) {
  Track track{system.ring.nodal_diameters, mode_names(system), {}};
  if (speeds_rad_per_s.empty()) return track;
  Tracker tracker(form, track, 16 * speeds_rad_per_s.size() + 1000);
  const Spectrum first = spectrum(form, speeds_rad_per_s.front());
  track.points.push_back({speeds_rad_per_s.front(), true, first, first_modes(first)});
  for (const double speed : speeds_rad_per_s.subspan(1)) tracker.advance(speed, true, 0);
  name_ring_modes(track);
  return track;
}

std::string describe_mode(const Track& track, const TrackPoint& point, std::size_t index) {
  const std::string& name = track.names[static_cast<std::size_t>(point.mode[index])];
  const auto i = static_cast<Index>(index);
  const std::string shape = shape_name(track.names, track.nodal_diameters, point.speed_rad_per_s,
                                       point.spectrum.values(i), point.spectrum.vectors.col(i));
  const bool alike = name.starts_with("load ") == shape.starts_with("load ");
  if (shape == name || (alike && (shape == "ring" || shape.starts_with("load ")))) return name;
  return name + " (moves as " + shape + ")";
}

std::string describe_mode_near(const Track& track, double speed_rad_per_s, std::complex<double> value) {
  const auto point = std::min_element(
      track.points.begin(), track.points.end(), [&](const TrackPoint& a, const TrackPoint& b) {
        return std::abs(a.speed_rad_per_s - speed_rad_per_s) < std::abs(b.speed_rad_per_s - speed_rad_per_s);
      });
  const auto& values = point->spectrum.values;
  const auto nearest = std::min_element(values.begin(), values.end(), [&](const auto& a, const auto& b) {
    return std::abs(a - value) < std::abs(b - value);
  });
  return describe_mode(track, *point, static_cast<std::size_t>(nearest - values.begin()));
}

}  // namespace rubsweep::ring
