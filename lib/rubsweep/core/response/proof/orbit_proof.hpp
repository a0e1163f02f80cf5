#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/proof/periodic_orbit.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::proof {

/// Search for a stable orbit of up to twice max_order turns to which a transient converges. Proven
/// (`floquet`): the followed transient enters a ball about the orbit from which every motion converges to it.
/// If there is no such ball, observed (`floquet_observed`): its distance has fallen to a ten-thousandth in
/// the adapted norm, or to 1e-6 clearances.
class OrbitProof {
 public:
  /// All searches together take no more work than `budget`. `budget`, `options` and `workspace` must outlive
  /// the proof.
  OrbitProof(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
             const motion::ResponseOptions& options, motion::Workspace& workspace,
             integrate::run::WorkBudget& budget);

  /// Adds one turn. Returns a motion once it is proven; an orbit without contact is not reported.
  std::optional<motion::ProvenMotion> look(const integrate::run::TurnReport& turn);

 private:
  std::optional<motion::ProvenMotion> prove(std::span<const double> section, int order);
  std::optional<motion::Proof> converges(std::span<const double> section, const StableOrbit& orbit);
  bool enters_split_ball(std::span<const double> section, const StableOrbit& orbit);
  TurnMap at_tight_tolerance(double tangent_accuracy = integrate::run::TurnRequest{}.tangent_accuracy);
  TurnMap as_it_runs();
  std::optional<motion::Measures> measure(const std::vector<double>& section, int order);

  scene::Scene scene_;
  scene::Scene distinct_;  ///< equal stops merged, so that no two guards are identical
  integrate::run::SolverOptions run_solver_, solver_;
  const motion::ResponseOptions& options_;
  motion::Workspace& workspace_;
  integrate::run::WorkBudget& budget_;
  PeriodSearch search_;
  std::optional<SceneMap> map_, run_map_;
  /// integrate::run::remembers_impacts: a proof then cannot start from a section in contact
  bool remembers_;
};

/// The scene with equal stops merged: contacts of one point of the rotor with the same wall at the same
/// clearance, on rigid casings, with the same ratio of damping to stiffness and the same friction. Their
/// guards are the same function of the state, so that they change mode together, and the sum of their forces
/// is that of a single stop with the sum of stiffnesses and dampings. Motions differ only by rounding. Stops
/// with a casing each are two bodies and are not merged.
scene::Scene with_equal_stops_as_one(scene::Scene scene);

}  // namespace rubsweep::response::proof
