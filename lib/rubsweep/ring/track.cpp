#include "rubsweep/ring/track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rubsweep/core/numerics/assignment.hpp"

namespace rubsweep::ring {
namespace {

using Eigen::Index;

/// Pairs of eigenvalues: complex conjugates, and neighbouring real ones in the order of their size.
std::vector<std::pair<Index, Index>> natural_pairs(const Eigen::VectorXcd& values) {
  std::vector<std::pair<Index, Index>> pairs;
  std::vector<Index> real;
  for (Index i = 0; i < values.size(); ++i) {
    if (values(i).imag() == 0) real.push_back(i);
    if (values(i).imag() > 0) pairs.emplace_back(i, i + 1);  // Eigen lists conjugates one after the other
  }
  std::sort(real.begin(), real.end(),
            [&](Index a, Index b) { return std::abs(values(a)) < std::abs(values(b)); });
  for (std::size_t i = 0; i + 1 < real.size(); i += 2) pairs.emplace_back(real[i], real[i + 1]);
  return pairs;
}

/// Names of the N modes: two of the ring, then one for every load with a coordinate. A load mode is called
/// radial where the coordinate is mostly along the load (inclination above 45 degrees).
std::vector<std::string> mode_names(const System& system) {
  std::vector<std::string> names{"ring forward", "ring backward"};
  for (std::size_t j = 0; j < system.loads.size(); ++j) {
    if (system.loads[j].motion == Motion::radial) continue;
    const bool along = std::abs(system.loads[j].inclination_deg) > 45;
    names.push_back(fmt::format("load {} {}", j, along ? "radial" : "flexural"));
  }
  return names;
}

/// Mode of each eigenvalue at the first speed of a track, by the load coordinate that moves most. The order
/// of the two ring modes is still arbitrary (see name_ring_modes).
std::vector<int> first_modes(const Spectrum& spectrum) {
  const auto pairs = natural_pairs(spectrum.values);
  const Index modes = static_cast<Index>(pairs.size());
  // Share of each pair's motion in the coordinates of the loads. Pairs that no load gets belong to the ring.
  Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(modes, modes);
  for (Index p = 0; p < modes; ++p) {
    const auto shape = spectrum.vectors.col(pairs[static_cast<std::size_t>(p)].first).head(modes);
    for (Index k = 2; k < modes; ++k) cost(p, k) = -std::norm(shape(k)) / shape.squaredNorm();
  }
  const auto taken = numerics::cheapest_assignment(cost);
  std::vector<Index> ring;
  std::vector<int> mode(static_cast<std::size_t>(2 * modes));
  const auto give = [&](Index pair, int name) {
    const auto [first, second] = pairs[static_cast<std::size_t>(pair)];
    mode[static_cast<std::size_t>(first)] = mode[static_cast<std::size_t>(second)] = name;
  };
  for (Index p = 0; p < modes; ++p) {
    const Index k = taken[static_cast<std::size_t>(p)];
    if (k < 2) {
      ring.push_back(p);
    } else {
      give(p, static_cast<int>(k));
    }
  }
  give(ring[0], 0);
  give(ring[1], 1);
  return mode;
}

/// Name of an eigenvector by its shape, independent of its curve: the load, if it has more kinetic energy
/// than the ring; otherwise the direction in which the wave on the ring travels in the fixed frame; "ring"
/// for a real root.
std::string shape_name(const std::vector<std::string>& names, int nodal_diameters, double speed_rad_per_s,
                       std::complex<double> value, const Eigen::VectorXcd& vector) {
  const auto shape = vector.head(vector.size() / 2);
  Index load = 1;
  double most = 0;
  for (Index k = 2; k < shape.size(); ++k) {
    if (std::norm(shape(k)) > most) {
      most = std::norm(shape(k));
      load = k;
    }
  }
  if (most > shape.head<2>().squaredNorm()) return names[static_cast<std::size_t>(load)];
  if (value.imag() == 0) return "ring";
  // In the rotating frame the wave A cos n phi + B sin n phi travels towards +phi if B lags behind A.
  const bool with_frame = (shape(0) * std::conj(shape(1))).imag() * value.imag() > 0;
  const double relative = (with_frame ? 1 : -1) * std::abs(value.imag()) / nodal_diameters;
  return names[speed_rad_per_s + relative > 0 ? 0 : 1];
}

/// Assigns both eigenvalues of every conjugate pair to one mode, so that each mode has two eigenvalues. If
/// real roots of two modes have become a pair, the pair keeps one mode, and the two remaining roots get the
/// other mode.
void pair_up(const Eigen::VectorXcd& values, std::vector<int>& mode) {
  for (Index i = 0; i + 1 < values.size(); ++i) {
    if (!(values(i).imag() > 0)) continue;
    int& first = mode[static_cast<std::size_t>(i)];
    int& second = mode[static_cast<std::size_t>(i) + 1];
    if (first == second) continue;
    const int kept = first, given_away = second;
    second = kept;
    for (Index k = 0; k < values.size(); ++k) {
      int& other = mode[static_cast<std::size_t>(k)];
      if (k != i && k != i + 1 && other == kept) other = given_away;
    }
  }
}

using Eigen::MatrixXd;

constexpr int most_halvings = 8;

/// Cost of continuing eigenvalue i of `from` by eigenvalue k of `to`. It is the distance from the old value
/// or from its linear prediction, whichever is smaller, plus the length of the predicted step times the
/// change of shape.
MatrixXd continuation_costs(const TrackPoint& from, const TrackPoint& to, double size) {
  const double step = to.speed_rad_per_s - from.speed_rad_per_s;
  const Index count = from.spectrum.values.size();
  const MatrixXd assurance = (from.spectrum.vectors.adjoint() * to.spectrum.vectors).cwiseAbs2();
  MatrixXd cost(count, count);
  for (Index i = 0; i < count; ++i) {
    const std::complex<double> moved = from.spectrum.slopes(i) * step;
    const std::complex<double> predicted = from.spectrum.values(i) + moved;
    // Where two roots merge, the derivative is unbounded and useless for a prediction.
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

/// Whether an eigenvalue of another mode would have cost about as little.
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
    // At a crossing or a merger the doubt remains however small the step is, and the cheapest assignment is
    // as good as any other.
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

/// Frequency of a mode at a point; 0 where it has two real roots.
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
  const auto point = std::ranges::min_element(track.points, {}, [&](const TrackPoint& one) {
    return std::abs(one.speed_rad_per_s - speed_rad_per_s);
  });
  return describe_mode(track, *point, static_cast<std::size_t>(nearest_to(value, point->spectrum.values)));
}

}  // namespace rubsweep::ring
