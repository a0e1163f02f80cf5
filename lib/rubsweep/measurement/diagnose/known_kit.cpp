#include "rubsweep/measurement/diagnose/known_kit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/balance.hpp"
#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"
#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::diagnose {
namespace {

/// Part of a kit that fixes a length or a force, so that the motion cannot be scaled; empty where no part
/// does.
std::optional<std::string_view> part_of_its_own_size(const model::RotorKit& kit) {
  if (kit.bow) return "rotor.bow";
  if (model::has_misalignment(kit) || model::has_standing_misalignment(kit)) return "rotor.couplings";
  if (!kit.static_loads.empty()) return "rotor.static_loads";
  if (kit.clearances_from_sag) return "rotor.clearances_from_sag";
  if (kit.torsion) return "rotor.torsion";
  if (std::ranges::any_of(kit.supports,
                          [](const model::Support& support) { return support.fault.has_value(); }))
    return "rotor.supports";
  return std::nullopt;
}

/// The kit with a round stop out of its reach.
model::Machine in_a_wide_stop(const model::RotorKit& kit, double position_m) {
  model::Stop stop;
  stop.geometry = model::AnnularGeometry{};
  stop.position_m = position_m;
  stop.clearance_m = 1e-3;
  stop.stiffness_n_per_m = 1e6;
  stop.damping = model::ExplicitDamping{0};
  stop.contact_radius_m = 0.01;
  model::Machine machine;
  machine.rotor = kit;
  machine.stops.push_back(stop);
  return machine;
}

std::vector<double> nodes_of(const model::RotorKit& kit) {
  std::vector<double> nodes_m;
  if (!kit.matrices) return nodes_m;
  for (const model::DegreeOfFreedom& freedom : kit.matrices->degrees_of_freedom)
    if (freedom.position_m) nodes_m.push_back(*freedom.position_m);
  return nodes_m;
}

/// Positions of the first and the last support on the shaft; both ends of the shaft where these do not
/// differ.
std::pair<double, double> span_of(const model::RotorKit& kit) {
  double from_m = std::numeric_limits<double>::infinity(), to_m = 0;
  for (const model::Support& support : kit.supports) {
    if (support.at_housing) continue;
    from_m = std::min(from_m, support.position_m);
    to_m = std::max(to_m, support.position_m);
  }
  if (from_m < to_m) return {from_m, to_m};
  return {0, shaft_length_m(kit)};
}

double lowest_frequency_hz(const scene::PreparedMachine& prepared) {
  return std::min(prepared.reduction->frequency_hz[0].minCoeff(),
                  prepared.reduction->frequency_hz[1].minCoeff());
}

/// Number of modes kept in each plane: all modes up to the highest compared order, and one more. The
/// attachment modes of the stops represent the compliance of the omitted modes.
int modes_kept(const structure::Reduction& reduction, double speed_hz) {
  const double compared_hz = most_order * speed_hz;
  Eigen::Index most = 1;
  for (std::size_t plane = 0; plane < 2; ++plane) {
    const auto kept = static_cast<Eigen::Index>(reduction.mode_number[plane].size());
    const Eigen::Index within = (reduction.frequency_hz[plane].head(kept).array() <= compared_hz).count();
    most = std::max(most, std::min(kept, within + 1));
  }
  return static_cast<int>(most);
}

template <class Matrix>
void add(const Matrix& matrix, batch::Sha256& sum) {
  sum.add({reinterpret_cast<const char*>(matrix.data()),
           static_cast<std::size_t>(matrix.size()) * sizeof(typename Matrix::Scalar)});
}

/// Adds everything that decides the motion of the kit to a digest, independent of the file it came from.
void add(const scene::PreparedMachine& prepared, batch::Sha256& sum) {
  const structure::LinearSystem& system = prepared.assembly.system;
  for (const Eigen::MatrixXd* matrix :
       {&system.mass, &system.damping, &system.stiffness, &prepared.assembly.gyroscopic})
    add(*matrix, sum);
  add(system.unbalance_kg, sum);
  for (const structure::Point& point : system.points) add(point.map, sum);
}

KnownKit places_of(const model::RotorKit& kit) {
  KnownKit known;
  known.probe_position_m = kit.sensors.front().position_m;
  known.nodes_m = nodes_of(kit);
  known.length_m = shaft_length_m(kit);
  std::tie(known.from_m, known.to_m) = span_of(kit);
  return known;
}

}  // namespace

void refuse_unscalable(const model::RotorKit& kit, const std::string& name) {
  if (const auto part = part_of_its_own_size(kit))
    throw ConfigError(name + ": " + std::string(*part) +
                      ": gives the motion a size of its own, allowed: no such part, as motions are scaled to "
                      "the recording");
  if (kit.sensors.empty())
    throw ConfigError(name + ": rotor.sensors: is missing, allowed: the place of the probes along the shaft");
}

KnownKit known_kit(std::vector<model::RotorKit> drawn, double speed_hz, const std::string& name) {
  const model::RotorKit& first = drawn.front();
  refuse_unscalable(first, name);
  KnownKit known = places_of(first);
  // A place away from midspan, where every second mode of a symmetric shaft has a node.
  const double inside_m = place_of_stop(known, std::lerp(known.from_m, known.to_m, 0.3));
  const int modes = modes_kept(*scene::prepare_machine(in_a_wide_stop(first, inside_m)).reduction, speed_hz);
  std::vector<std::pair<double, std::size_t>> order;
  batch::Sha256 sum;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    drawn[k].modes = modes;
    const scene::PreparedMachine prepared =
        scene::prepared_at(scene::prepare_with_modes(in_a_wide_stop(drawn[k], inside_m), modes), speed_hz);
    add(prepared, sum);
    order.emplace_back(lowest_frequency_hz(prepared), k);
    if (k > 0) continue;
    known.rotor_mass_kg = model::rotor_mass_kg(prepared.machine);
    known.same_all_around = response::rotating::rotationally_symmetric(
        scene::build_cell(prepared, speed_hz, scene::Eccentricity{1e-6}).scene);
    if (prepared.assembly.system.damping.isZero(0))
      throw ConfigError(name + ": rotor: has no damping, allowed: some, as no motion would settle");
  }
  known.digest = sum.digits();
  std::ranges::sort(order);
  known.natural_frequency_hz = order[order.size() / 2].first;
  for (const auto& [frequency_hz, k] : order) known.likely.push_back(std::move(drawn[k]));
  return known;
}

model::RotorKit varied_kit(const model::RotorKit& kit, double frequency_factor, double damping_factor) {
  model::RotorKit varied = kit;
  const double stiffness = frequency_factor * frequency_factor, damping = frequency_factor * damping_factor;
  for (model::ShaftSegment& segment : varied.shaft) {
    const auto vary = [&](model::ShaftLayer& layer) {
      layer.youngs_modulus_pa *= stiffness;
      layer.shear_modulus_pa *= stiffness;
    };
    vary(segment);
    for (model::ShaftLayer& layer : segment.layers) vary(layer);
  }
  for (model::Support& support : varied.supports) {
    if (support.table) continue;
    for (double* k :
         {&support.stiffness_x_n_per_m, &support.stiffness_y_n_per_m, &support.stiffness_xy_n_per_m,
          &support.stiffness_yx_n_per_m, &support.angular_stiffness_nm_per_rad})
      *k *= stiffness;
    for (double* c : {&support.damping_x_ns_per_m, &support.damping_y_ns_per_m, &support.damping_xy_ns_per_m,
                      &support.damping_yx_ns_per_m})
      *c *= damping;
  }
  for (double& ratio : varied.damping_ratio) ratio = std::min(ratio * damping_factor, 1.0);
  return varied;
}

std::vector<model::RotorKit> varied_kits(const model::RotorKit& kit, double frequency_share,
                                         double damping_share, std::size_t count, std::uint64_t seed) {
  std::vector<model::RotorKit> kits;
  for (std::size_t k = 0; k < count; ++k) {
    RandomStream random(seed, k, DrawPurpose::of_kit);
    const auto factor = [&](double share) { return 1 + share * (2 * random.uniform() - 1); };
    const double frequency = factor(frequency_share);
    kits.push_back(varied_kit(kit, frequency, factor(damping_share)));
  }
  return kits;
}

const model::RotorKit& likely_kit(const KnownKit& kit, double share) {
  const auto count = static_cast<double>(kit.likely.size());
  return kit.likely[static_cast<std::size_t>(std::clamp(share * count, 0.0, count - 1))];
}

double place_of_stop(const KnownKit& kit, double position_m) {
  if (kit.nodes_m.empty()) return position_m;
  return *std::ranges::min_element(kit.nodes_m, {},
                                   [&](double node_m) { return std::abs(node_m - position_m); });
}

}  // namespace rubsweep::diagnose
