#pragma once

#include <functional>
#include <span>

#include "rubsweep/integrate/options.hpp"
#include "rubsweep/integrate/turn.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::response {

/// One iteration of a map, in place. False: it could not be made, and the state means nothing any more.
using SectionMap = std::function<bool(std::span<double> state)>;

/// One revolution of a scene as a map of its scaled section (as Turn::section): from phase 0 to phase 0, the
/// pulse left out. Every call starts a run of its own, so that the map has no memory: equal sections give
/// equal sections to the last bit, near ones go through nearly the same steps. Starting a run costs two
/// percent of a turn.
class SceneMap {
 public:
  SceneMap(const scene::Scene& scene, const integrate::SolverOptions& solver);

  /// `section`: 2n numbers. False when the solver fails.
  bool operator()(std::span<double> section);

  /// Some contact was touching at some time in the revolution made last.
  bool touched() const { return turn_.touched; }

 private:
  scene::Scene scene_;
  integrate::SolverOptions solver_;
  integrate::Turn turn_;
};

}  // namespace rubsweep::response
