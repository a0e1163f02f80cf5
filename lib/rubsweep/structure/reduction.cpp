#include "rubsweep/structure/reduction.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/error.hpp"
#include "rubsweep/numerics/dense/cholesky.hpp"
#include "rubsweep/numerics/dense/lu.hpp"
#include "rubsweep/structure/reduce_to_modes.hpp"

namespace rubsweep::structure {
namespace {

constexpr double unseen = 1e-9;   ///< share of a station's static compliance
constexpr int grid_points = 100;  ///< frequencies at which receptances are compared
constexpr double grid_decades = 2.5;
constexpr const char* too_extreme =
    "rotor: its parts are too far apart in stiffness or mass for the motion at the stops to be computed, "
    "allowed: "
    "less extreme numbers";

/// One plane before the reduction: all modes that may be kept, and the deflection by a force at each stop.
struct Plane {
  Eigen::MatrixXd mass, stiffness;
  numerics::dense::CholeskyFactors factor;
  PlaneModes modes;
  std::vector<Eigen::Index> seen;  ///< of `modes`
};

Plane study_plane(const BeamShaft& shaft, std::size_t index, const std::vector<double>& places_m) {
  Plane plane;
  plane.stiffness = shaft.plane_stiffness(index);
  plane.mass = shaft.plane_mass(index);
  plane.modes = plane_modes(plane.mass, plane.stiffness, model::RotorKit::most_modes);
  plane.factor = numerics::dense::CholeskyFactors(plane.stiffness);
  std::vector<double> compliance;
  for (const double place : places_m) {
    const Eigen::Index w = shaft.deflection(place);
    compliance.push_back(
        plane.factor.solve(Eigen::VectorXd(Eigen::VectorXd::Unit(shaft.coordinates(), w)))(w));
  }
  for (const double value : compliance) {
    if (!(value > 0) || !std::isfinite(value)) throw ConfigError(too_extreme);
  }
  for (Eigen::Index j = 0; j < plane.modes.rad_per_s.size(); ++j) {
    for (std::size_t i = 0; i < places_m.size(); ++i) {
      const double share = plane.modes.shape(shaft.deflection(places_m[i]), j) / plane.modes.rad_per_s(j);
      if (share * share <= unseen * compliance[i]) continue;
      plane.seen.push_back(j);
      break;
    }
  }
  if (plane.seen.empty()) throw ConfigError(too_extreme);
  return plane;
}

/// Residual static deflections of forces at the stops, orthogonal to the modes, as modes among themselves.
PlaneModes attachments(const BeamShaft& shaft, const Plane& plane, const Eigen::MatrixXd& modes,
                       const std::vector<double>& stops_m) {
  Eigen::MatrixXd kept(shaft.coordinates(), 0);
  for (const double stop : stops_m) {
    Eigen::VectorXd shape = plane.factor.solve(
        Eigen::VectorXd(Eigen::VectorXd::Unit(shaft.coordinates(), shaft.deflection(stop))));
    const double whole = shape(shaft.deflection(stop));
    for (int pass = 0; pass < 2; ++pass) {  // twice is enough: rounding of the first is taken out
      shape -= modes * (modes.transpose() * (plane.mass * shape));
      shape -= kept * (kept.transpose() * (plane.stiffness * shape));
    }
    const double energy = shape.dot(plane.stiffness * shape);
    if (energy <= unseen * whole) continue;
    kept.conservativeResize(Eigen::NoChange, kept.cols() + 1);
    kept.rightCols<1>() = shape / std::sqrt(energy);
  }
  if (kept.cols() == 0) return {Eigen::VectorXd(0), kept};
  PlaneModes found = plane_modes(kept.transpose() * plane.mass * kept,
                                 kept.transpose() * plane.stiffness * kept, kept.cols());
  found.shape = kept * found.shape;
  return found;
}

/// Basis of one plane from its `count` lowest seen modes.
void fill_plane(const BeamShaft& shaft, const Plane& plane, std::size_t index, int count,
                const std::vector<double>& stops_m, Reduction& reduction) {
  const auto modes = std::min(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(plane.seen.size()));
  Eigen::MatrixXd shape(shaft.coordinates(), modes);
  Eigen::VectorXd rad_per_s(modes);
  reduction.mode_number[index].clear();
  for (Eigen::Index j = 0; j < modes; ++j) {
    const Eigen::Index mode = plane.seen[static_cast<std::size_t>(j)];
    shape.col(j) = plane.modes.shape.col(mode);
    rad_per_s(j) = plane.modes.rad_per_s(mode);
    reduction.mode_number[index].push_back(static_cast<int>(mode) + 1);
  }
  const PlaneModes added = attachments(shaft, plane, shape, stops_m);
  Eigen::MatrixXd& basis = reduction.bases[index];
  basis.resize(shape.rows(), modes + added.shape.cols());
  basis << shape, added.shape;
  Eigen::VectorXd& hz = reduction.frequency_hz[index];
  hz.resize(basis.cols());
  hz << rad_per_s, added.rad_per_s;
  hz /= 2 * std::numbers::pi;
  const auto nodes = static_cast<Eigen::Index>(shaft.node_position_m.size());
  for (Eigen::Index j = 0; j < basis.cols(); ++j) {
    // A coordinate is then a displacement in metres, and an integrator's tolerance means the same for all.
    Eigen::Index largest = 0;
    basis(Eigen::seqN(0, nodes, 2), j).cwiseAbs().maxCoeff(&largest);
    const double deflection = basis(2 * largest, j);
    if (deflection == 0 || !std::isfinite(deflection)) throw ConfigError(too_extreme);
    basis.col(j) /= deflection;
  }
  if (!basis.allFinite() || !hz.allFinite()) throw ConfigError(too_extreme);
}

class Reducer {
 public:
  Reducer(const BeamShaft& shaft, const model::RotorKit& kit, const std::vector<double>& stops_m,
          const std::vector<double>& sensors_m)
      : shaft_(shaft), kit_(kit), stops_(stops_m), places_(stops_m), forces_(stops_m) {
    for (const auto& support : kit.supports) {
      if (support.fault) forces_.push_back(support.position_m);
    }
    places_.insert(places_.end(), sensors_m.begin(), sensors_m.end());
    for (std::size_t index = 0; index < 2; ++index) planes_[index] = study_plane(shaft, index, places_);
    same_planes_ = planes_[0].stiffness == planes_[1].stiffness && planes_[0].mass == planes_[1].mass;
  }

  Reduction with_modes(int count, const std::vector<double>& stops_m) const {
    Reduction reduction;
    for (std::size_t index = 0; index < 2; ++index) {
      fill_plane(shaft_, planes_[same_planes_ ? 0 : index], index, count, stops_m, reduction);
    }
    return reduction;
  }

  Reduction run() const {
    // As good as the full model far beyond the frequencies compared; tests compare with the full model
    // itself.
    const std::vector<Eigen::MatrixXcd> exact = curves(with_modes(model::RotorKit::most_modes, places_));
    if (kit_.modes) return judged(with_modes(*kit_.modes, stops_), exact);
    const auto most = static_cast<int>(std::max(planes_[0].seen.size(), planes_[1].seen.size()));
    Reduction reduction;
    for (int count = 1; count <= most; ++count) {
      reduction = judged(with_modes(count, stops_), exact);
      if (reduction.receptance_error <= receptance_tolerance) break;
    }
    reduction.automatic = true;
    return reduction;
  }

 private:
  static double grid(int k, double highest) {
    return highest * std::pow(10.0, -grid_decades * (1 - static_cast<double>(k) / (grid_points - 1)));
  }

  /// Receptances over frequency, at rest and with the shaft turning as fast as the force.
  std::vector<Eigen::MatrixXcd> curves(const Reduction& reduction) const {
    const LateralSystem system = reduced_system(shaft_, kit_, reduction);
    std::vector<Eigen::MatrixXcd> values;
    for (const double turning : {0.0, 1.0}) {
      for (int k = 0; k < grid_points; ++k) {
        const double w = grid(k, 2 * std::numbers::pi * kit_.modes_up_to_hz);
        values.push_back(receptance(shaft_, reduction.bases, system, w, turning * w, places_, forces_));
      }
    }
    return values;
  }

  /// Largest difference, against the largest receptance within a few grid points: an antiresonance is no
  /// reason to keep on adding modes.
  Reduction judged(Reduction reduction, const std::vector<Eigen::MatrixXcd>& exact) const {
    constexpr int around = 4;
    const std::vector<Eigen::MatrixXcd> found = curves(reduction);
    for (int k = 0; k < static_cast<int>(exact.size()); ++k) {
      double size = 0;
      for (int j = k - around; j <= k + around; ++j) {
        const bool same_curve =
            j >= 0 && j < static_cast<int>(exact.size()) && j / grid_points == k / grid_points;
        if (same_curve) size = std::max(size, exact[static_cast<std::size_t>(j)].norm());
      }
      const auto at = static_cast<std::size_t>(k);
      reduction.receptance_error =
          std::max(reduction.receptance_error, (found[at] - exact[at]).norm() / size);
    }
    return reduction;
  }

  const BeamShaft& shaft_;
  const model::RotorKit& kit_;
  std::vector<double> stops_, places_, forces_;
  std::array<Plane, 2> planes_;
  bool same_planes_ = false;
};

}  // namespace

Reduction reduce(const BeamShaft& shaft, const model::RotorKit& kit, const std::vector<double>& stops_m,
                 const std::vector<double>& sensors_m) {
  return Reducer(shaft, kit, stops_m, sensors_m).run();
}

Reduction reduce_to_modes(const BeamShaft& shaft, const model::RotorKit& kit,
                          const std::vector<double>& stops_m, const std::vector<double>& sensors_m) {
  const Reducer reducer(shaft, kit, stops_m, sensors_m);
  return kit.modes ? reducer.with_modes(*kit.modes, stops_m) : reducer.run();
}

LateralSystem reduced_system(const BeamShaft& shaft, const model::RotorKit& kit, const Reduction& reduction) {
  LateralSystem system = project(shaft, reduction.bases);
  for (std::size_t plane = 0; plane < 2; ++plane) {
    const auto& numbers = reduction.mode_number[plane];
    for (Eigen::Index j = 0; j < reduction.bases[plane].cols(); ++j) {
      const auto column = static_cast<std::size_t>(j);
      const std::size_t mode =
          column < numbers.size() ? static_cast<std::size_t>(numbers[column]) : kit.damping_ratio.size();
      const double ratio = kit.damping_ratio[std::min(mode, kit.damping_ratio.size()) - 1];
      const Eigen::Index i = system.index(plane, j);
      const double w = 2 * std::numbers::pi * reduction.frequency_hz[plane](j);
      system.damping(i, i) += 2 * ratio * w * system.mass(i, i);
    }
  }
  return system;
}

std::vector<TabledSupport> tabled_supports(const BeamShaft& shaft, const model::RotorKit& kit,
                                           const PlaneBases& bases, const LateralSystem& system,
                                           Eigen::Index coordinates) {
  std::vector<TabledSupport> supports;
  for (std::size_t i = 0; i < kit.supports.size(); ++i) {
    if (!kit.supports[i].table) continue;
    const Eigen::VectorXd gap = support_gap(shaft, kit, i);
    TabledSupport& tabled = supports.emplace_back(tabled_support(kit.supports[i]));
    tabled.map.setZero(2, coordinates);
    for (std::size_t plane = 0; plane < 2; ++plane)
      tabled.map.row(static_cast<Eigen::Index>(plane)).head(system.coordinates()) =
          system.scatter(plane, bases[plane].transpose() * gap).transpose();
  }
  return supports;
}

RotatingDamping rotating_damping(const BeamShaft& shaft, const model::RotorKit& kit,
                                 const Reduction& reduction, const LateralSystem& system) {
  const auto& ratios = kit.rotating_damping_ratio;
  const auto& numbers = reduction.mode_number[0];
  const PlaneBases& bases = reduction.bases;
  Eigen::MatrixXd line = Eigen::MatrixXd::Zero(shaft.coordinates(), shaft.coordinates());
  for (Eigen::Index j = 0; j < bases[0].cols(); ++j) {
    const auto column = static_cast<std::size_t>(j);
    const std::size_t mode =
        column < numbers.size() ? static_cast<std::size_t>(numbers[column]) : ratios.size();
    const Eigen::VectorXd momentum = shaft.plane_mass(0) * bases[0].col(j);
    const double mass = bases[0].col(j).dot(momentum);
    const double rate = 2 * std::numbers::pi * reduction.frequency_hz[0](j);
    line += 2 * ratios[std::min(mode, ratios.size()) - 1] * rate / mass * momentum * momentum.transpose();
  }
  RotatingDamping added;
  added.damping = added.circulatory = Eigen::MatrixXd::Zero(system.coordinates(), system.coordinates());
  const bool same = bases[0].cols() == bases[1].cols() && bases[0] == bases[1];
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 2; ++b) {
      // Equal planes get the same bits, as in `project`.
      Eigen::MatrixXd block = bases[same ? 0 : a].transpose() * line * bases[same ? 0 : b];
      if (same) block = (block + block.transpose().eval()) / 2;
      Eigen::MatrixXd& matrix = a == b ? added.damping : added.circulatory;
      for (Eigen::Index i = 0; i < block.rows(); ++i) {
        for (Eigen::Index k = 0; k < block.cols(); ++k)
          matrix(system.index(a, i), system.index(b, k)) = a == 1 && b == 0 ? -block(i, k) : block(i, k);
      }
    }
  }
  return added;
}

Eigen::MatrixXcd receptance(const BeamShaft& shaft, const PlaneBases& bases, const LateralSystem& system,
                            double rad_per_s, double speed_rad_per_s, const std::vector<double>& responses_m,
                            const std::vector<double>& forces_m) {
  const auto rows = [&](const std::vector<double>& places) {
    Eigen::MatrixXd seen(static_cast<Eigen::Index>(2 * places.size()), system.coordinates());
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t plane = 0; plane < 2; ++plane) {
        seen.row(static_cast<Eigen::Index>(2 * i + plane)) =
            system.scatter(plane, bases[plane].row(shaft.deflection(places[i])).transpose()).transpose();
      }
    }
    return seen;
  };
  const std::complex<double> i(0, 1);
  Eigen::MatrixXcd dynamic =
      (system.stiffness - rad_per_s * rad_per_s * system.mass).cast<std::complex<double>>();
  dynamic += i * rad_per_s * (system.damping + speed_rad_per_s * system.gyroscopic);
  const Eigen::MatrixXcd forces = rows(forces_m).transpose().cast<std::complex<double>>();
  return rows(responses_m).cast<std::complex<double>>() * numerics::dense::solve(dynamic, forces);
}

double modal_mass_kg(const BeamShaft& shaft, const Reduction& reduction, std::size_t plane, Eigen::Index j,
                     double position_m) {
  const auto shape = reduction.bases[plane].col(j);
  const double here = shape(shaft.deflection(position_m));
  return shape.dot(shaft.plane_mass(plane) * shape) / (here * here);
}

}  // namespace rubsweep::structure
