#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/adaptive/event_search.hpp"

namespace rubsweep::integrate::adaptive {

/// Size of the next step of an adaptive run, in radians of rotation. Contact and flight need different ones:
/// a mode begins with the latest size used in it.
template <class Law>
class StepSizes {
 public:
  /// `law` must outlive this.
  StepSizes(const Law& law, double tolerance)
      : law_(law), tolerance_(tolerance), remembered_(std::size_t{1} << (2 * numbered()), 0.0) {}

  double next = first;
  void restart() { next = first; }
  /// Restarts without memory of any mode.
  void forget() {
    restart();
    std::ranges::fill(remembered_, 0.0);
    retaken_ = false;
  }

  std::size_t joint_mode() const {
    std::size_t joint = 0;
    for (std::size_t i = 0; i < numbered(); ++i)
      joint = joint * contact::mode_count + static_cast<std::size_t>(law_.modes()[i]);
    return joint;
  }
  /// The joint mode has changed.
  void change(std::size_t before) {
    remembered_[before] = next;
    if (const double remembered = remembered_[joint_mode()]; remembered > 0) next = remembered;
  }

  /// Contact `i` has begun with this closing speed. A law that is not linear has no power series there, so
  /// that the error estimate of a step may be far below its error: over the first step the contact's whole
  /// push changes the speed by no more than the tolerance.
  void begin_contact(std::size_t i, double closing_speed) {
    const auto& c = law_.system().contacts[i];
    if (!c.law) return;
    next = std::min(next, 1.0);
    while (next > shortest_first &&
           c.mobility() * c.law->force_n(closing_speed * next * c.length_m) * next > tolerance_)
      next /= 4;
  }

  /// Whether a step from `start_phase` is taken again, up to its first crossing, because a curved law is not
  /// smooth there: a step across that instant would be no better than its dense output.
  bool retakes(const std::optional<Crossing>& crossing, double start_phase) {
    const bool opens = crossing && crossing->event == Crossing::Event::mode &&
                       crossing->next == contact::Mode::open && law_.system().contacts[crossing->contact].law;
    const bool ends = opens || (crossing && crossing->event == Crossing::Event::knot);
    retaken_ = ends && !retaken_ && crossing->phase - start_phase > shortest_retaken;
    if (retaken_) next = crossing->phase - start_phase;
    return retaken_;
  }

 private:
  static constexpr double first = 1e-3, shortest_first = 1e-9, shortest_retaken = 1e-9;
  static constexpr std::size_t most_numbered = 4;

  /// Number of contacts whose modes have a size.
  std::size_t numbered() const { return std::min(law_.modes().size(), most_numbered); }

  const Law& law_;
  double tolerance_;
  std::vector<double> remembered_;  ///< for each joint mode; 0: none yet
  bool retaken_ = false;            ///< true: the step is taken again
};

}  // namespace rubsweep::integrate::adaptive
