#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/response/settle.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::bench {

/// Class and order of a cell's motion, as a map shows them.
struct Label {
  response::motion::MotionClass motion_class = response::motion::MotionClass::failed;
  std::optional<int> order;
  bool operator==(const Label&) const = default;
};

struct LabelledCell {
  std::size_t place = 0;  ///< index into the given places
  scene::Cell cell;
  Label label;
};

/// Tolerance of the steppers that compute reference labels.
inline constexpr double label_tolerance = 1e-11;

/// Labels of the reference solver (reference_options at label_tolerance) for the cells at `places` that can
/// run, that is, without initial contact and with a reachable unbalance.
std::vector<LabelledCell> reference_labels(const model::Machine& machine,
                                           std::span<const scene::Place> places,
                                           const integrate::run::SolverOptions& base,
                                           const response::motion::ResponseOptions& response);

struct LabelAgreement {
  int compared = 0;
  int agreed = 0;    ///< cells with the same class and order
  bool cut = false;  ///< the time ended before every cell was compared
};

/// Runs the cells with `solver` until all are compared or `seconds` of processor time have passed. The order
/// spreads any first part of the cells over the whole map.
LabelAgreement label_agreement(std::span<const LabelledCell> cells,
                               const integrate::run::SolverOptions& solver,
                               const response::motion::ResponseOptions& response, double seconds);

/// `wanted` indices spread evenly over 0 ... count - 1, including the first and the last; all indices if
/// there are not more; the middle one if a single one is wanted.
std::vector<std::size_t> spread(std::size_t count, std::size_t wanted);

}  // namespace rubsweep::bench
