#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::line {

/// The rotor once per revolution, at the phase of smallest quiet gap.
struct SectionPoint {
  Eigen::Vector2d displacement_m{0, 0}, velocity_m_per_s{0, 0};
};

/// State of all coordinates at that phase, in a form that another cell can start from: velocities per radian
/// of shaft rotation, so that a whirl stays a whirl at another speed.
struct HandedState {
  Eigen::VectorXd displacement_m, velocity_m_per_rad;
};

/// Settled motion of a run, long enough to be drawn.
struct SettledMotion {
  /// One point per turn of the period of a periodic motion; one of a rotor at rest; else two windows.
  std::vector<SectionPoint> section;
  response::spectrum::FullSpectrum spectrum;  ///< spectrum over the window that a map takes
  HandedState end;                            ///< after all of it
};

/// How the cells of a line start.
enum class Pass {
  kick,  ///< each from its kick, as in a map
  up,    ///< each from what the one before it does, the first from its kick
  down,  ///< the same from the last cell to the first
};

constexpr std::string_view to_string(Pass pass) { return enumerator_word(pass); }

/// One cell: neighbours share what they have in common.
struct LineCell {
  double value = 0;  ///< value of whatever changes along the line
  std::shared_ptr<const sweep::Study> study;
  std::shared_ptr<const scene::PreparedMachine> machine;  ///< prepared form of study->machine
  scene::Place place;
};

/// One cell in one pass.
struct LinePoint {
  Pass pass = Pass::kick;
  std::size_t cell = 0;
  sweep::Row row;
  std::optional<SettledMotion> motion;  ///< empty where there is none
};

/// Runs the cells of a line in every pass, and returns how many points that made. A cell of an upward or
/// downward pass starts on what the one before it does after it has settled: the same displacements and the
/// same velocities per radian of shaft rotation, at the phase of smallest quiet gap, without a kick. Behind a
/// cell without motion the next one starts from its kick. Cells of Pass::kick run in parallel, and so do
/// whole passes; what comes out does not depend on `threads` (0: all processors). `on_point` gets the points
/// one at a time, in any order; no new cell starts once `stop` is true. Throws ConfigError where an upward or
/// downward pass meets cells with different numbers of coordinates.
std::size_t follow_line(std::span<const LineCell> cells, std::span<const Pass> passes, int threads,
                        const std::function<void(LinePoint&&)>& on_point, const std::atomic<bool>& stop);

}  // namespace rubsweep::line
