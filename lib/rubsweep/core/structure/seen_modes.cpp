#include "rubsweep/core/structure/seen_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double share_of_compliance = 1e-9;  ///< least share of a mode in the compliance at a place
constexpr double share_of_shape = 1e-6;       ///< least deflection of a mode at a place, over its largest
constexpr double coupled = 1e-8;  ///< share of the largest coupling by the same matrix; less is rounding
constexpr const char* nothing_seen =
    "rotor: its parts are too far apart in stiffness or mass for the motion at the stops to be computed, "
    "allowed: "
    "less extreme numbers";

/// Rounding error of a mode's shape: small for slow modes, large for modes of nearly equal frequency.
double rounding_of(const PlaneModes& modes, Index j) {
  constexpr double of_the_first = 1e-13;
  const Eigen::VectorXd& w = modes.rad_per_s;
  double apart = 1;
  if (j > 0) apart = std::min(apart, 1 - w(j - 1) / w(j));
  if (j + 1 < w.size()) apart = std::min(apart, w(j + 1) / w(j) - 1);
  return of_the_first * std::pow(w(j) / w(0), 2) / std::max(apart, of_the_first);
}

using Marks = std::array<std::vector<bool>, 2>;  ///< marks per plane and mode

StudiedPlane plane_of(const BeamShaft& shaft, std::size_t index) {
  StudiedPlane plane;
  plane.stiffness = shaft.plane_stiffness(index);
  plane.mass = shaft.plane_mass(index);
  plane.modes = plane_modes(plane.mass, plane.stiffness, model::RotorKit::most_modes);
  plane.factor = numerics::dense::CholeskyFactors(plane.stiffness);
  return plane;
}

/// For each mode, whether it moves one of the places.
std::vector<bool> seen_by_shape(const BeamShaft& shaft, const StudiedPlane& plane,
                                const std::vector<double>& places_m) {
  const auto nodes = static_cast<Index>(shaft.node_position_m.size());
  std::vector<bool> seen(static_cast<std::size_t>(plane.modes.rad_per_s.size()), false);
  for (const double place : places_m) {
    const Index w = shaft.deflection(place);
    const double compliance =
        plane.factor.solve(Eigen::VectorXd(Eigen::VectorXd::Unit(shaft.coordinates(), w)))(w);
    if (!(compliance > 0) || !std::isfinite(compliance)) throw ConfigError(nothing_seen);
    for (Index j = 0; j < plane.modes.rad_per_s.size(); ++j) {
      const double here = std::abs(plane.modes.shape(w, j)), share = here / plane.modes.rad_per_s(j);
      const double largest = plane.modes.shape.col(j)(Eigen::seqN(0, nodes, 2)).cwiseAbs().maxCoeff();
      if (share * share > share_of_compliance * compliance ||
          here > (share_of_shape + rounding_of(plane.modes, j)) * largest)
        seen[static_cast<std::size_t>(j)] = true;
    }
  }
  return seen;
}

/// A matrix from displacements of plane b to forces in plane a. Multiplied by this power of the frequency of
/// a mode, the forces of different matrices are comparable.
struct Coupling {
  std::size_t a, b;
  MatrixXd matrix;
  double power;
};

std::vector<Coupling> couplings_of(const BeamShaft& shaft, const model::RotorKit& kit) {
  constexpr double by_rate = 0.5, by_place = 1;
  std::vector<Coupling> all{{0, 1, shaft.gyroscopic, by_rate}};
  for (std::size_t a = 0; a < 2; ++a) {
    all.push_back({a, a, shaft.damping + shaft.support_damping[a][a], by_rate});
    all.push_back({a, 1 - a, shaft.support_damping[a][1 - a], by_rate});
    all.push_back({a, 1 - a, shaft.support_stiffness[a][1 - a], by_place});
  }
  for (std::size_t i = 0; i < kit.supports.size(); ++i) {
    if (!kit.supports[i].table) continue;
    const Eigen::VectorXd gap = support_gap(shaft, kit, i);
    for (std::size_t a = 0; a < 2; ++a) {
      for (std::size_t b = 0; b < 2; ++b) all.push_back({a, b, gap * gap.transpose(), by_place});
    }
  }
  return all;
}

/// Pairs of modes (rows: plane a, columns: plane b) that a matrix couples.
Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> coupled_modes(const Coupling& coupling,
                                                                 const std::array<StudiedPlane, 2>& planes) {
  const auto scaled = [&](std::size_t plane) {
    const PlaneModes& modes = planes[plane].modes;
    return MatrixXd(modes.shape * modes.rad_per_s.array().pow(-coupling.power).matrix().asDiagonal());
  };
  const MatrixXd between = scaled(coupling.a).transpose() * coupling.matrix * scaled(coupling.b);
  const double largest = between.cwiseAbs().maxCoeff();
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> above(between.rows(), between.cols());
  for (Index i = 0; i < between.rows(); ++i) {
    for (Index j = 0; j < between.cols(); ++j) {
      const double rounding =
          rounding_of(planes[coupling.a].modes, i) + rounding_of(planes[coupling.b].modes, j);
      above(i, j) = std::abs(between(i, j)) > (coupled + rounding) * largest;
    }
  }
  return above;
}

/// Marks all modes that are coupled with a marked mode, directly or through others.
void mark_coupled(const BeamShaft& shaft, const model::RotorKit& kit,
                  const std::array<StudiedPlane, 2>& planes, Marks& marks) {
  std::vector<std::pair<const Coupling*, Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>>> edges;
  const std::vector<Coupling> couplings = couplings_of(shaft, kit);
  for (const Coupling& coupling : couplings) {
    if (!coupling.matrix.isZero(0)) edges.emplace_back(&coupling, coupled_modes(coupling, planes));
  }
  for (bool more = true; more;) {
    more = false;
    for (const auto& [coupling, between] : edges) {
      std::vector<bool>&rows = marks[coupling->a], &columns = marks[coupling->b];
      for (Index i = 0; i < between.rows(); ++i) {
        for (Index j = 0; j < between.cols(); ++j) {
          const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
          if (!between(i, j) || rows[row] == columns[column]) continue;
          rows[row] = columns[column] = more = true;
        }
      }
    }
  }
}

bool damps(const MatrixXd& xx, const MatrixXd& xy, const MatrixXd& yx, const MatrixXd& yy) {
  const Index n = xx.rows();
  MatrixXd both(2 * n, 2 * n);
  both << xx, xy, yx, yy;
  both = (both + both.transpose()).eval() / 2;
  constexpr double rounding = 1e-12;
  both.diagonal().array() += rounding * both.cwiseAbs().maxCoeff() + std::numeric_limits<double>::min();
  return numerics::dense::CholeskyFactors(both).positive_definite();
}

bool may_feed(const model::SupportTable& table) {
  for (std::size_t k = 0; k < table.speed_hz.size(); ++k) {
    const auto at = [&](std::size_t column) { return MatrixXd::Constant(1, 1, table.columns[column][k]); };
    if (table.columns[1][k] != table.columns[2][k] || !damps(at(4), at(5), at(6), at(7))) return true;
  }
  return false;
}

}  // namespace

bool may_feed_vibrations(const BeamShaft& shaft, const model::RotorKit& kit) {
  const MatrixXd &xy = shaft.support_stiffness[0][1], &yx = shaft.support_stiffness[1][0];
  constexpr double rounding = 1e-12;
  if (model::has_rotating_damping(kit)) return true;
  if (!((xy - yx.transpose()).cwiseAbs().maxCoeff() <= rounding * xy.cwiseAbs().maxCoeff())) return true;
  const auto& by = shaft.support_damping;
  if (!damps(shaft.damping + by[0][0], by[0][1], by[1][0], shaft.damping + by[1][1])) return true;
  return std::ranges::any_of(
      kit.supports, [](const model::Support& support) { return support.table && may_feed(*support.table); });
}

std::array<StudiedPlane, 2> study_planes(const BeamShaft& shaft, const model::RotorKit& kit,
                                         const std::vector<double>& places_m) {
  std::array<StudiedPlane, 2> planes{plane_of(shaft, 0), plane_of(shaft, 1)};
  Marks marks;
  for (std::size_t a = 0; a < 2; ++a) marks[a] = seen_by_shape(shaft, planes[a], places_m);
  mark_coupled(shaft, kit, planes, marks);
  const bool may_grow = may_feed_vibrations(shaft, kit);
  const bool same = planes[0].stiffness == planes[1].stiffness && planes[0].mass == planes[1].mass;
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t j = 0; j < marks[a].size(); ++j) {
      const auto mode = static_cast<Index>(j);
      // Planes that are alike keep the same modes.
      if (marks[a][j] || (same && marks[1 - a][j])) {
        planes[a].seen.push_back(mode);
      } else if (may_grow) {
        planes[a].beside.push_back(mode);
      }
    }
    if (planes[a].seen.empty()) throw ConfigError(nothing_seen);
  }
  return planes;
}

}  // namespace rubsweep::structure
