#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/response/settle.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::bench {

/// Label of a map for the motion of one cell.
struct Label {
  response::motion::MotionClass motion_class = response::motion::MotionClass::failed;
  std::optional<int> order;
  bool operator==(const Label&) const = default;
};

struct LabelledCell {
  std::size_t place = 0;  ///< index into the places asked for
  scene::Cell cell;
  Label label;
};

/// Tolerance of the steppers behind reference labels.
inline constexpr double label_tolerance = 1e-11;

/// The cells at `places` that can be run (neither initial contact nor unreachable) with the label that the
/// reference solver gives them (reference_options at label_tolerance).
std::vector<LabelledCell> reference_labels(const model::Machine& machine,
                                           std::span<const scene::Place> places,
                                           const integrate::run::SolverOptions& base,
                                           const response::motion::ResponseOptions& response);

struct LabelAgreement {
  int compared = 0;
  int agreed = 0;    ///< class and order equal
  bool cut = false;  ///< the time was up before every cell was compared
};

/// Runs the cells with `solver` until all are compared or `seconds` of processor time are up, in an order
/// that spreads any part of them over the whole.
LabelAgreement label_agreement(std::span<const LabelledCell> cells,
                               const integrate::run::SolverOptions& solver,
                               const response::motion::ResponseOptions& response, double seconds);

/// `wanted` indices spread evenly over 0 ... count - 1, the first and the last among them, all where there
/// are no more; the middle one where one is wanted.
std::vector<std::size_t> spread(std::size_t count, std::size_t wanted);

}  // namespace rubsweep::bench
