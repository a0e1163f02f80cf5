#pragma once

#include <complex>
#include <optional>
#include <span>

#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/poincare_section.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::motion {

/// A line is significant above the larger of these two. 0X never counts as the largest line: a static
/// deflection must not hide a motion.
inline constexpr double significant_share_of_largest = 1e-3;
inline constexpr double significant_share_of_clearance = 1e-6;

/// Energy off the multiples of 1/n stays below this share of the energy without 0X.
inline constexpr double off_order_energy_limit = 1e-4;

/// View of one window: `turns` successive turns of one run. Nothing is copied.
struct Window {
  int turns = 0;
  int samples_per_revolution = 0;
  double clearance_m = 0;  ///< clearance of the kicked stop, > 0: scale of what matters
  /// turns x samples_per_revolution samples, the end point left out.
  std::span<const std::complex<double>> displacement_m;
  int states = 0;
  std::span<const double> section;  ///< (turns + 1) x states, scaled rows as `period_of_section` takes them
  std::span<const ContactFacts> contact;  ///< facts of each turn
};

/// Verdict of one window by itself.
struct WindowVerdict {
  MotionClass motion_class = MotionClass::unsettled;  ///< class of no contact, of a period, or unsettled
  std::optional<int> order;                           ///< confirmed by section and spectrum
  std::optional<SectionPeriod> period;                ///< period by the section alone; empty without contact
  bool spectrum_agrees = true;                        ///< false: `period` exists and the spectrum denies it
  std::optional<double> off_order_energy_fraction;    ///< energy off the multiples of 1/n / energy without 0X
  Measures measures;
};

/// Classifies one window. Without any contact: `non_contact`. Else the section names the period n, and the
/// spectrum over the last window_turns(turns, n) turns must confirm it: no significant line and less than
/// off_order_energy_limit of the energy off the multiples of 1/n (energy below one line at the floor of
/// significance, 1e-6 clearance, is rounding and counts as none). Everything else is `unsettled`, and its
/// spectrum is over all turns: chaos and quasi-periodic motion take more evidence than one window holds.
/// SolverError when sizes do not match, there are fewer than 4 samples per turn or no clearance.
WindowVerdict classify_window(const Window& window, const ResponseOptions& options,
                              spectrum::SpectrumWorkspace& workspace);

/// Class of a motion with contact whose section returns after `order` turns: synchronous or subharmonic, and
/// `resting_contact` where no line but 0X is significant, so that nothing moves.
MotionClass class_of_period(int order, const Measures& measures);

/// Measures of a window, its spectrum over all of its turns.
Measures measure_window(const Window& window, spectrum::SpectrumWorkspace& workspace);

/// The verdict of two successive windows: they must agree in class and order, else the motion is `unsettled`.
/// The measures are those of the last window. Status is `spectrum_disagrees` when it did so in either.
Motion settle_verdict(const WindowVerdict& previous, const WindowVerdict& last);

}  // namespace rubsweep::response::motion
