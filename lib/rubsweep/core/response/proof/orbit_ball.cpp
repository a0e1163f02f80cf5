#include "rubsweep/core/response/proof/orbit_ball.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/core/integrate/exact/tube/exact_tube.hpp"

namespace rubsweep::response::proof {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using integrate::exact::tube::Parts;

constexpr double largest_radius = 0.1;
constexpr int most_halvings = 26;  ///< halvings of 0.1, down to 1.5e-9
constexpr int unknown_halvings = most_halvings + 1;
/// Shares of the contraction margin of the linear map. The first is for a turn's nonlinear deviation; the
/// second, relative to the radius, for the distance between the given sections and the orbit. The remaining 5
/// % cover the effect of that distance.
constexpr double deviation_share = 0.9, defect_share = 1e-3;

VectorXd vector_of(const std::vector<double>& x) {
  return Eigen::Map<const VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// Tubes of an orbit's turns, in norms of one part or two.
class OrbitTubes {
 public:
  /// `defect`: distance between the orbit's last section and its first.
  OrbitTubes(std::vector<integrate::exact::tube::TurnTube> tubes, const Parts& defect)
      : tubes_(std::move(tubes)), defect_(defect) {}

  /// Largest of the radii 0.1 `shape`, 0.05 `shape`, ... at which the ball contracts. A tube that holds for
  /// some radii also holds for smaller ones, but the orbit's own defect needs a ball that is large enough.
  /// `known`: number of halvings of 0.1 that are known to suffice, updated on return; if it exceeds
  /// `most_halvings`, none is known.
  std::optional<Parts> largest(const Parts& shape, int& known) const {
    const auto halved = [&](int times) {
      const double size = std::ldexp(largest_radius, -times);
      return Parts{size * shape.fast, size * shape.slow};
    };
    if (known > most_halvings) {
      if (!draws_together(halved(most_halvings))) return std::nullopt;
      known = most_halvings;
    }
    // Searches from the known number in doubling steps; ends at once where no larger ball contracts.
    int too_large = known - 1;
    for (int step = 1; too_large >= 0 && draws_together(halved(too_large)); step *= 2) {
      known = too_large;
      too_large = std::max(-1, too_large - step);
    }
    while (known - too_large > 1) {
      const int middle = (known + too_large) / 2;
      (draws_together(halved(middle)) ? known : too_large) = middle;
    }
    const Parts radii = halved(known), room = room_in(radii);
    const bool closes =
        defect_.fast <= defect_share * 0.1 * room.fast && defect_.slow <= defect_share * 0.1 * room.slow;
    return closes ? std::optional(radii) : std::nullopt;
  }

  /// Radii up to twice those of `largest` at which the ball also contracts; a motion enters them sooner.
  Parts between_halvings(const Parts& radii) const {
    double times = 1, too_many = 2;
    for (int i = 0; i < 3; ++i) {
      const double middle = std::sqrt(times * too_many);
      (draws_together({middle * radii.fast, middle * radii.slow}) ? times : too_many) = middle;
    }
    return {times * radii.fast, times * radii.slow};
  }

 private:
  /// Amount by which the linear map brings each part below its radius, in the norms of the tubes.
  Parts room_in(const Parts& radii) const {
    Parts room = radii;
    for (const integrate::exact::tube::TurnTube& tube : tubes_) {
      const auto left = [&radii](double radius, const Parts& by) {
        return radius - by.fast * radii.fast - by.slow * radii.slow;
      };
      room.fast = std::min(room.fast, left(radii.fast, tube.to_fast));
      room.slow = std::min(room.slow, left(radii.slow, tube.to_slow));
    }
    return room;
  }

  bool draws_together(const Parts& radii) const {
    const Parts room = room_in(radii);
    if (!(room.fast > 0) || (radii.slow > 0 && !(room.slow > 0))) return false;
    return std::ranges::all_of(tubes_, [&](const integrate::exact::tube::TurnTube& tube) {
      const Parts deviation = tube.deviation(radii);
      return deviation.fast <= deviation_share * room.fast && deviation.slow <= deviation_share * room.slow;
    });
  }

  std::vector<integrate::exact::tube::TurnTube> tubes_;
  Parts defect_;
};

}  // namespace

std::optional<double> ball_radius(const scene::Scene& scene, integrate::exact::modes::ModeCache& modes,
                                  const std::vector<double>& section, const AdaptedNorms& norms) {
  std::vector<MatrixXd> unit;
  for (const MatrixXd& norm : norms.norm)
    unit.push_back(norm.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(norm.rows(), norm.cols())));
  std::vector<double> end = section;
  auto turns = integrate::exact::tube::turn_tubes(scene, modes, end, unit, norms.norm);
  if (!turns) return std::nullopt;
  const double defect = (norms.norm.front() * (vector_of(end) - vector_of(section))).norm();
  int halvings = unknown_halvings;
  const auto radii = OrbitTubes(std::move(*turns), {defect, 0}).largest({1, 0}, halvings);
  return radii ? std::optional(radii->fast) : std::nullopt;
}

double turns_to_enter(const SplitNorms& norms, const Parts& distance, const Parts& radii) {
  const auto turns = [](double from, double to, double contraction) {
    return std::log(std::max(1.0, from / to)) / -std::log(contraction);
  };
  return std::max(turns(distance.fast, radii.fast, norms.contraction.fast),
                  turns(distance.slow, radii.slow, norms.contraction.slow));
}

std::optional<Parts> split_ball_radii(const scene::Scene& scene, integrate::exact::modes::ModeCache& modes,
                                      const std::vector<double>& section, const SplitNorms& norms,
                                      const Parts& distance) {
  std::vector<double> end = section;
  auto turns = integrate::exact::tube::turn_tubes(scene, modes, end, norms.unit, norms.norm, norms.slow());
  if (!turns) return std::nullopt;
  const OrbitTubes tubes(std::move(*turns), parts_of(norms, 0, vector_of(end) - vector_of(section)));
  std::optional<Parts> best;
  // The slow radius falls from one ratio to the next, so that the same number of halvings remains sufficient.
  int halvings = unknown_halvings;
  for (const double ratio : {1e8, 1e7, 1e6, 1e5, 1e4, 1e3, 1e2, 1e1, 1.0}) {
    const auto radii = tubes.largest({1, ratio}, halvings);
    if (radii && (!best || turns_to_enter(norms, distance, *radii) < turns_to_enter(norms, distance, *best)))
      best = radii;
    if (best && turns_to_enter(norms, distance, *best) == 0) return best;
  }
  return best ? std::optional(tubes.between_halvings(*best)) : std::nullopt;
}

}  // namespace rubsweep::response::proof
