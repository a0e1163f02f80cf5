#include "rubsweep/core/structure/reduction.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/full_reference.hpp"
#include "rubsweep/core/structure/seen_modes.hpp"

namespace rubsweep::structure {
namespace {

constexpr double nothing_left = 1e-9;  ///< share of the energy of a deflection: less is rounding
constexpr const char* too_extreme =
    "rotor: its parts are too far apart in stiffness or mass for the motion at the stops to be computed, "
    "allowed: "
    "less extreme numbers";

/// Attachment modes: static deflections under forces at the stops, orthogonal to the modes and to each other.
PlaneModes attachments(const BeamShaft& shaft, const StudiedPlane& plane, const Eigen::MatrixXd& modes,
                       const std::vector<double>& stops_m) {
  Eigen::MatrixXd kept(shaft.coordinates(), 0);
  for (const double stop : stops_m) {
    Eigen::VectorXd shape = plane.factor.solve(
        Eigen::VectorXd(Eigen::VectorXd::Unit(shaft.coordinates(), shaft.deflection(stop))));
    const double whole = shape(shaft.deflection(stop));
    for (int pass = 0; pass < 2; ++pass) {  // twice is enough: pass 2 removes the rounding of pass 1
      shape -= modes * (modes.transpose() * (plane.mass * shape));
      shape -= kept * (kept.transpose() * (plane.stiffness * shape));
    }
    const double energy = shape.dot(plane.stiffness * shape);
    if (energy <= nothing_left * whole) continue;
    kept.conservativeResize(Eigen::NoChange, kept.cols() + 1);
    kept.rightCols<1>() = shape / std::sqrt(energy);
  }
  if (kept.cols() == 0) return {Eigen::VectorXd(0), kept};
  PlaneModes found = plane_modes(kept.transpose() * plane.mass * kept,
                                 kept.transpose() * plane.stiffness * kept, kept.cols());
  found.shape = kept * found.shape;
  return found;
}

/// Basis of one plane from its `count` lowest seen modes and all lower modes of `beside`.
void fill_plane(const BeamShaft& shaft, const StudiedPlane& plane, std::size_t index, int count,
                const std::vector<double>& stops_m, Reduction& reduction) {
  const auto seen = std::min(static_cast<std::size_t>(count), plane.seen.size());
  std::vector<Eigen::Index> kept(plane.seen.begin(), plane.seen.begin() + static_cast<std::ptrdiff_t>(seen));
  std::ranges::copy_if(plane.beside, std::back_inserter(kept),
                       [last = kept.back()](auto mode) { return mode < last; });
  std::ranges::sort(kept);
  const auto modes = static_cast<Eigen::Index>(kept.size());
  Eigen::MatrixXd shape(shaft.coordinates(), modes);
  Eigen::VectorXd rad_per_s(modes);
  reduction.mode_number[index].clear();
  for (Eigen::Index j = 0; j < modes; ++j) {
    const Eigen::Index mode = kept[static_cast<std::size_t>(j)];
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
    // A coordinate is then a displacement in metres, so that an integrator's tolerance fits all of them.
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
          const std::vector<double>& sensors_m, const std::vector<double>& kicks_m)
      : shaft_(shaft), kit_(kit), stops_(stops_m), places_(stops_m), kicks_(kicks_m) {
    if (kicks_.empty()) kicks_ = {stops_.front()};
    places_.insert(places_.end(), sensors_m.begin(), sensors_m.end());
    planes_ = study_planes(shaft, kit, places_);
    same_planes_ = planes_[0].stiffness == planes_[1].stiffness && planes_[0].mass == planes_[1].mass;
  }

  Reduction with_modes(int count) const { return with_modes(count, stops_); }

  Reduction with_modes(int count, const std::vector<double>& attached_m) const {
    Reduction reduction;
    reduction.modes = count;
    for (std::size_t index = 0; index < 2; ++index) {
      fill_plane(shaft_, planes_[same_planes_ ? 0 : index], index, count, attached_m, reduction);
    }
    return reduction;
  }

  Reduction run() const {
    const FullReference full = reference();
    if (kit_.modes) return as_asked(full);
    const auto most = static_cast<int>(std::max(planes_[0].seen.size(), planes_[1].seen.size()));
    // Heavy dampers hold a shaft like pins, which needs many modes, or one more attachment mode at each.
    for (const std::vector<double>& attached : {stops_, stops_and_supports()}) {
      for (int count = 1; count <= most; ++count) {
        Reduction reduction = with_modes(count, attached);
        reduction.receptance_error = full.receptance_error(reduction, receptance_tolerance);
        if (reduction.receptance_error > receptance_tolerance) continue;
        const FullReference::Growth growth = full.growth(reduction);
        reduction.growth_error = growth.error;
        reduction.automatic = true;
        if (!growth.mistaken && growth.error <= receptance_tolerance) return reduction;
      }
    }
    throw ConfigError("rotor.modes: auto does not answer as the full matrices do up to " +
                      std::to_string(kit_.modes_up_to_hz) + " Hz, with any number of modes up to " +
                      std::to_string(most) +
                      ", allowed: a smaller rotor.modes_up_to_hz, or a number as rotor.modes");
  }

 private:
  std::vector<double> stops_and_supports() const {
    std::vector<double> places = stops_;
    for (const auto& support : kit_.supports)
      if (!support.at_housing) places.push_back(support.position_m);
    return places;
  }

  FullReference reference() const {
    std::vector<double> forces = stops_, loads;
    for (const auto& support : kit_.supports) {
      if (support.fault) forces.push_back(support.position_m);
    }
    for (const auto& load : kit_.static_loads) loads.push_back(load.position_m);
    loads.insert(loads.end(), kicks_.begin(), kicks_.end());
    return {shaft_, kit_, places_, forces, loads};
  }

  Reduction as_asked(const FullReference& full) const {
    Reduction reduction = with_modes(*kit_.modes);
    reduction.receptance_error = full.receptance_error(reduction, std::numeric_limits<double>::infinity());
    const FullReference::Growth growth = full.growth(reduction);
    reduction.growth_error = growth.error;
    if (growth.mistaken)
      throw ConfigError(
          "rotor.modes: with so few modes a vibration that grows by the full matrices does not, or one grows "
          "that does not by these, allowed: more modes, or auto");
    return reduction;
  }

  const BeamShaft& shaft_;
  const model::RotorKit& kit_;
  std::vector<double> stops_, places_, kicks_;
  std::array<StudiedPlane, 2> planes_;
  bool same_planes_ = false;
};

}  // namespace

Reduction reduce(const BeamShaft& shaft, const model::RotorKit& kit, const std::vector<double>& stops_m,
                 const std::vector<double>& sensors_m, const std::vector<double>& kicks_m) {
  return Reducer(shaft, kit, stops_m, sensors_m, kicks_m).run();
}

Reduction reduce_to_modes(const BeamShaft& shaft, const model::RotorKit& kit,
                          const std::vector<double>& stops_m, const std::vector<double>& sensors_m,
                          const std::vector<double>& kicks_m) {
  const Reducer reducer(shaft, kit, stops_m, sensors_m, kicks_m);
  return kit.modes ? reducer.with_modes(*kit.modes) : reducer.run();
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
      // Equal planes get bitwise equal blocks, as in `project`.
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

double modal_mass_kg(const BeamShaft& shaft, const Reduction& reduction, std::size_t plane, Eigen::Index j,
                     double position_m) {
  const auto shape = reduction.bases[plane].col(j);
  const double here = shape(shaft.deflection(position_m));
  return shape.dot(shaft.plane_mass(plane) * shape) / (here * here);
}

}  // namespace rubsweep::structure
