#include "rubsweep/response/orbit_proof.hpp"

#include <algorithm>

#include "rubsweep/integrate/start.hpp"
#include "rubsweep/response/record.hpp"

namespace rubsweep::response {
namespace {

/// Tight enough for derivatives by differences.
constexpr double tolerance_of_a_proof = 1e-11;

}  // namespace

OrbitProof::OrbitProof(const scene::Scene& scene, const integrate::SolverOptions& solver,
                       const ResponseOptions& options, Workspace& workspace)
    : scene_(after_the_kick(scene)),
      solver_(solver),
      options_(options),
      workspace_(workspace),
      search_(2 * static_cast<std::size_t>(scene.structure.coordinates()), 2 * options.max_order) {
  solver_.relative_tolerance = std::min(solver.relative_tolerance, tolerance_of_a_proof);
}

std::optional<ProvenMotion> OrbitProof::look(const integrate::Turn& turn) {
  const auto orbit = find(turn);
  if (!orbit) return std::nullopt;
  const auto measures = measure(*orbit);
  if (!measures) return std::nullopt;
  return ProvenMotion{orbit->order == 1 ? MotionClass::synchronous : MotionClass::subharmonic, orbit->order,
                      *measures, orbit->floquet_modulus};
}

std::optional<StableOrbit> OrbitProof::find(const integrate::Turn& turn) {
  search_.add(turn.section, turn.touched);
  const auto order = search_.candidate();
  if (!order) return std::nullopt;
  if (!map_) map_.emplace(scene_, solver_, workspace_.plans);
  const TurnMap map = [this](std::span<double> section, Eigen::MatrixXd* disturbances) {
    return disturbances ? map_->carry(section, *disturbances) : (*map_)(section);
  };
  auto orbit = prove_orbit(map, turn.section, *order);
  if (!orbit) search_.refuse(*order);
  return orbit;
}

/// Over exactly one period; empty when the orbit touches nothing.
std::optional<Measures> OrbitProof::measure(const StableOrbit& orbit) {
  ResponseOptions window = options_;
  window.window_revolutions = orbit.order;
  Record record(scene_, window);
  record.begin(orbit.section);
  const integrate::Run run = integrate::start(scene_, solver_, workspace_.plans);
  run.restart(orbit.section);
  integrate::Turn turn;
  turn.samples_per_revolution = options_.samples_per_revolution;
  turn.peaks = true;
  bool touched = false;
  for (int k = 0; k < orbit.order; ++k) {
    if (run.advance(turn) != integrate::Outcome::ok) return std::nullopt;
    record.add(turn);
    touched = touched || turn.touched;
  }
  if (!touched) return std::nullopt;
  return measure_window(record.window(0), workspace_.spectrum);
}

}  // namespace rubsweep::response
