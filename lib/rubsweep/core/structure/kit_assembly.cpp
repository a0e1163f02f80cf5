#include "rubsweep/core/structure/kit_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/core/structure/coupling_loads.hpp"

namespace rubsweep::structure {
namespace {

/// smallest squared deflection at a stop / squared largest one, for a stop that is at no node
constexpr double node_of_mode = 1e-6;

/// Whether the damping constant of a contact depends on the rotor mass.
bool takes_mass(const model::ContactDamping& damping) {
  return std::visit(overloaded{[](const model::NominalRestitution&) { return true; },
                               [](const model::DeliveredRestitution&) { return true; },
                               [](const model::RestitutionByRotorMass&) { return true; },
                               [](const model::ExplicitDamping&) { return false; }},
                    damping);
}

class KitBuilder {
 public:
  KitBuilder(const model::Machine& machine, decltype(reduce)& by)
      : machine_(machine), kit_(std::get<model::RotorKit>(machine.rotor)) {
    for (const auto& stop : machine.stops) stops_.push_back(*stop.position_m);
    for (const auto& sensor : kit_.sensors) sensors_.push_back(sensor.position_m);
    kick_ = machine.kick && machine.kick->position_m ? *machine.kick->position_m : stops_.front();
    std::vector<double> stations = stops_;
    stations.push_back(kick_);
    shaft_ = assemble_beam_shaft(kit_, stations);
    result_.reduction = by(shaft_, kit_, stops_and_tables(), sensors_, kick_);
    lateral_ = reduced_system(shaft_, kit_, result_.reduction);
  }

  KitAssembly build() {
    allocate();
    add_lateral();
    if (model::has_rotating_damping(kit_)) add_rotating_damping();
    if (kit_.torsion) add_torsion();
    if (kit_.bow || model::has_misalignment(kit_)) add_bow();
    if (!kit_.static_loads.empty() || model::has_standing_misalignment(kit_)) add_static_loads();
    if (std::ranges::any_of(kit_.couplings, model::is_asymmetric)) add_twice_per_turn();
    add_faults();
    add_points();
    result_.assembly.tables =
        tabled_supports(shaft_, kit_, result_.reduction.bases, lateral_, system().coordinates());
    add_casings();
    return std::move(result_);
  }

 private:
  /// Attachment modes at supports with tables keep the static compliance exact at all speeds of the tables.
  std::vector<double> stops_and_tables() const {
    std::vector<double> places = stops_;
    for (const model::Support& support : kit_.supports)
      if (support.table && !support.at_housing) places.push_back(support.position_m);
    return places;
  }

  LinearSystem& system() { return result_.assembly.system; }
  Eigen::Index lateral() const { return lateral_.coordinates(); }

  void allocate() {
    Eigen::Index n = lateral() + (kit_.torsion ? 1 : 0);
    for (const auto& stop : machine_.stops) n += stop.casing ? 2 : 0;
    system().mass = system().damping = system().stiffness = Eigen::MatrixXd::Zero(n, n);
    result_.assembly.gyroscopic = Eigen::MatrixXd::Zero(n, n);
    system().unbalance_kg = Eigen::VectorXcd::Zero(n);
    system().weight_kg = Eigen::VectorXd::Zero(n);
  }

  void add_lateral() {
    const Eigen::Index n = lateral();
    system().mass.topLeftCorner(n, n) = lateral_.mass;
    system().damping.topLeftCorner(n, n) = lateral_.damping;
    system().stiffness.topLeftCorner(n, n) = lateral_.stiffness;
    result_.assembly.gyroscopic.topLeftCorner(n, n) = lateral_.gyroscopic;
    system().unbalance_kg.head(n) = turning(shaft_.unbalance_kg);
    system().weight_kg.head(n) = -lateral_.scatter(1, basis(1).transpose() * shaft_.weight_kg);
  }

  void add_rotating_damping() {
    const RotatingDamping added = rotating_damping(shaft_, kit_, result_.reduction, lateral_);
    result_.assembly.circulatory = Eigen::MatrixXd::Zero(system().coordinates(), system().coordinates());
    system().damping.topLeftCorner(lateral(), lateral()) += added.damping;
    result_.assembly.circulatory.topLeftCorner(lateral(), lateral()) = added.circulatory;
  }

  /// Reduced form of a load that turns with the shaft, given in the x plane of the full model.
  Eigen::VectorXcd turning(const Eigen::VectorXcd& load) const {
    const std::complex<double> i(0, 1);
    Eigen::VectorXcd force = Eigen::VectorXcd::Zero(lateral());
    for (std::size_t plane = 0; plane < 2; ++plane) {
      const Eigen::VectorXd real = basis(plane).transpose() * load.real();
      const Eigen::VectorXd imaginary = basis(plane).transpose() * load.imag();
      const Eigen::VectorXcd both = lateral_.scatter(plane, real).cast<std::complex<double>>() +
                                    i * lateral_.scatter(plane, imaginary).cast<std::complex<double>>();
      force += plane == 0 ? both : Eigen::VectorXcd(-i * both);
    }
    return force;
  }

  const Eigen::MatrixXd& basis(std::size_t plane) const { return result_.reduction.bases[plane]; }

  void add_torsion() {
    const Eigen::Index angle = lateral();
    system().mass(angle, angle) = shaft_.polar_inertia_kg_m2;
    system().stiffness(angle, angle) = kit_.torsion->drive_stiffness_nm_per_rad;
    system().damping(angle, angle) = kit_.torsion->drive_damping_nms_per_rad;
    result_.assembly.twist = angle;
    for (const model::Disc& disc : kit_.discs)
      result_.assembly.unbalance_inertia_kg +=
          disc.mass_kg * disc.eccentricity_ratio * disc.eccentricity_ratio;
  }

  /// Shape of one of the shaft's modes, scaled to this amplitude at its largest deflection.
  Eigen::VectorXd line_of(const model::BowMode& mode) const {
    const PlaneModes modes = plane_modes(shaft_.plane_mass(0), shaft_.plane_stiffness(0), mode.mode);
    if (modes.rad_per_s.size() < mode.mode) {
      throw ConfigError("rotor.bow.mode: the shaft has fewer modes that can be computed, allowed: 1 to " +
                        std::to_string(modes.rad_per_s.size()));
    }
    const auto nodes = static_cast<Eigen::Index>(shaft_.node_position_m.size());
    Eigen::VectorXd line = modes.shape.rightCols<1>();
    Eigen::Index largest = 0;
    line(Eigen::seqN(0, nodes, 2)).cwiseAbs().maxCoeff(&largest);
    line *= mode.amplitude_m / line(2 * largest);
    return line;
  }

  /// Load of a bow: the force that would bend a straight shaft into the bowed line.
  Eigen::VectorXcd bow_load() const {
    const Eigen::VectorXd line = std::visit(
        overloaded{[&](const model::BowMode& mode) { return line_of(mode); },
                   [&](const model::BowPoints& points) { return least_bent_line(shaft_, points); }},
        kit_.bow->shape);
    return (shaft_.elastic * line).cast<std::complex<double>>() *
           std::polar(1.0, kit_.bow->phase_deg * std::numbers::pi / 180);
  }

  void add_bow() {
    Eigen::VectorXcd load = misalignment_load(shaft_, kit_);
    if (kit_.bow) load += bow_load();
    result_.assembly.bow_n = Eigen::VectorXcd::Zero(system().coordinates());
    result_.assembly.bow_n.head(lateral()) = turning(load);
  }

  void add_static_loads() {
    result_.assembly.static_n = Eigen::VectorXd::Zero(system().coordinates());
    for (const model::StaticLoad& load : kit_.static_loads) {
      const Eigen::Index w = shaft_.deflection(load.position_m);
      result_.assembly.static_n.head(lateral()) +=
          lateral_.scatter(0, load.force_x_n * basis(0).row(w).transpose()) +
          lateral_.scatter(1, load.force_y_n * basis(1).row(w).transpose());
    }
    if (!model::has_standing_misalignment(kit_)) return;
    const Eigen::VectorXcd load = standing_misalignment_load(shaft_, kit_);
    result_.assembly.static_n.head(lateral()) += lateral_.scatter(0, basis(0).transpose() * load.real()) +
                                                 lateral_.scatter(1, basis(1).transpose() * load.imag());
  }

  /// Uses the full model: the static position at the couplings must not depend on the kept modes.
  void add_twice_per_turn() {
    const std::complex<double> i(0, 1);
    Eigen::VectorXcd load = standing_misalignment_load(shaft_, kit_) -
                            i * machine_.gravity_m_per_s2 * shaft_.weight_kg.cast<std::complex<double>>();
    for (const model::StaticLoad& given : kit_.static_loads)
      load(shaft_.deflection(given.position_m)) += std::complex<double>(given.force_x_n, given.force_y_n);
    result_.assembly.second_n = Eigen::VectorXcd::Zero(system().coordinates());
    result_.assembly.second_n.head(lateral()) =
        turning(twice_per_turn_load(shaft_, kit_, position_at_rest(shaft_, load)));
  }

  /// Adds the impulse on the shaft and the opposite one on the pedestal, if there is one.
  void add_faults() {
    for (std::size_t i = 0; i < kit_.supports.size(); ++i) {
      if (!kit_.supports[i].fault) continue;
      const model::BearingFault& fault = *kit_.supports[i].fault;
      if (fault.impulse_ns == 0) continue;
      const Eigen::VectorXd gap = support_gap(shaft_, kit_, i);
      const double angle = fault.angle_deg * std::numbers::pi / 180;
      Eigen::VectorXd impulse_ns = Eigen::VectorXd::Zero(system().coordinates());
      impulse_ns.head(lateral()) =
          fault.impulse_ns * (std::cos(angle) * lateral_.scatter(0, basis(0).transpose() * gap) +
                              std::sin(angle) * lateral_.scatter(1, basis(1).transpose() * gap));
      result_.assembly.impulses.push_back({impulse_ns, fault.multiple, fault.phase_deg / 360});
    }
  }

  int add_point(double position_m) {
    Point point{Eigen::Matrix<double, 2, Eigen::Dynamic>::Zero(2, system().coordinates())};
    const Eigen::Index w = shaft_.deflection(position_m);
    for (std::size_t plane = 0; plane < 2; ++plane) {
      point.map.row(static_cast<Eigen::Index>(plane)).head(lateral()) =
          lateral_.scatter(plane, basis(plane).row(w).transpose()).transpose();
    }
    system().points.push_back(std::move(point));
    return static_cast<int>(system().points.size()) - 1;
  }

  void add_points() {
    Assembly& assembly = result_.assembly;
    for (std::size_t i = 0; i < stops_.size(); ++i) {
      assembly.rotor_points.push_back(add_point(stops_[i]));
      assembly.contact_mass_kg.push_back(contact_mass_kg(i));
    }
    for (const double position : sensors_) assembly.sensor_points.push_back(add_point(position));
    assembly.observed_point = add_point(sensors_.empty() ? stops_.front() : sensors_.front());
    assembly.kick_point = add_point(kick_);
  }

  /// Modal mass along the normal of a flat stop; mean of both planes in an annular stop.
  double contact_mass_kg(std::size_t i) const {
    const model::Stop& stop = machine_.stops[i];
    const double share_x =
        std::visit(overloaded{[](const model::OneSideGeometry& flat) {
                                return std::pow(std::cos(flat.angle_deg * std::numbers::pi / 180), 2);
                              },
                              [](const model::AnnularGeometry&) { return 0.5; }},
                   stop.geometry);
    const double inverse = share_x / modal_mass_kg(shaft_, result_.reduction, 0, 0, stops_[i]) +
                           (1 - share_x) / modal_mass_kg(shaft_, result_.reduction, 1, 0, stops_[i]);
    const double largest = 1 / basis(0).col(0).dot(shaft_.plane_mass(0) * basis(0).col(0));
    const bool needed = !stop.contact_mass_kg && takes_mass(stop.damping);
    if (needed && inverse <= node_of_mode * largest) {
      throw ConfigError(
          "stops." + std::to_string(i) +
          ".contact_mass_kg: missing; the stop sits at a node of the first mode, whose mass would be the "
          "default, allowed: a number > 0");
    }
    return 1 / inverse;
  }

  void add_casings() {
    Eigen::Index next = lateral() + (kit_.torsion ? 1 : 0);
    for (const auto& stop : machine_.stops) {
      if (!stop.casing) {
        result_.assembly.casing_points.emplace_back();
        continue;
      }
      result_.assembly.casing_points.emplace_back(static_cast<int>(system().points.size()));
      add_body(system(), next, stop.casing->mass_kg, stop.casing->stiffness_n_per_m,
               stop.casing->damping_ratio);
      next += 2;
    }
  }

  const model::Machine& machine_;
  const model::RotorKit& kit_;
  std::vector<double> stops_, sensors_;
  double kick_ = 0;
  BeamShaft shaft_;
  LateralSystem lateral_;
  KitAssembly result_;
};

}  // namespace

KitAssembly assemble_rotor_kit(const model::Machine& machine) { return KitBuilder(machine, reduce).build(); }

KitAssembly assemble_kit_for_speed(const model::Machine& machine) {
  return KitBuilder(machine, reduce_to_modes).build();
}

}  // namespace rubsweep::structure
