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

/// State of the rotor once per revolution, at the phase of smallest quiet gap.
struct SectionPoint {
  Eigen::Vector2d displacement_m{0, 0}, velocity_m_per_s{0, 0};
};

/// State of all coordinates at that phase, from which another cell can start. Velocities are per radian of
/// shaft rotation, so that a whirl remains a whirl at another speed.
struct HandedState {
  Eigen::VectorXd displacement_m, velocity_m_per_rad;
};

/// Settled motion of a run, long enough to be drawn.
struct SettledMotion {
  /// One point per turn of the period for a periodic motion, one point for a rotor at rest, and the points of
  /// two windows for any other motion.
  std::vector<SectionPoint> section;
  response::spectrum::FullSpectrum spectrum;  ///< spectrum over the same window as in a map
  HandedState end;                            ///< state at the end of the recorded motion
};

/// Start of the cells of a line.
enum class Pass {
  kick,  ///< each cell starts from its kick, as in a map
  up,    ///< each cell starts on the motion of the one before it, the first from its kick
  down,  ///< like up, but from the last cell to the first
};

constexpr std::string_view to_string(Pass pass) { return enumerator_word(pass); }

/// One cell of a line. Neighbours share the data that are the same for both.
struct LineCell {
  double value = 0;  ///< value of the parameter along the line
  std::shared_ptr<const sweep::Study> study;
  std::shared_ptr<const scene::PreparedMachine> machine;  ///< prepared study->machine
  scene::Place place;
};

/// Result of one cell in one pass.
struct LinePoint {
  Pass pass = Pass::kick;
  std::size_t cell = 0;
  sweep::Row row;
  std::optional<SettledMotion> motion;  ///< empty where the cell has no motion
};

/// Runs the cells of a line in every pass, and returns the number of points. A cell of an upward or downward
/// pass starts, without a kick, on the settled motion of the cell before it. It takes over the displacements,
/// and the velocities per radian of shaft rotation, at the phase of smallest quiet gap. After a cell without
/// motion the next cell starts from its kick. Cells of Pass::kick run in parallel, and so do whole passes.
/// The result does not depend on `threads` (0: all processors). `on_point` gets the points one at a time, in
/// any order. Once `stop` is true no new cell starts. Throws ConfigError where an upward or downward pass
/// meets cells with different numbers of coordinates.
std::size_t follow_line(std::span<const LineCell> cells, std::span<const Pass> passes, int threads,
                        const std::function<void(LinePoint&&)>& on_point, const std::atomic<bool>& stop);

}  // namespace rubsweep::line
