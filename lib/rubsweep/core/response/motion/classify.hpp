#pragma once

#include <complex>
#include <optional>
#include <span>

#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/poincare_section.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::motion {

/// A line is significant when it exceeds both of these limits. 0X never counts as the largest line, so that a
/// static deflection does not hide a motion.
inline constexpr double significant_share_of_largest = 1e-3;
inline constexpr double significant_share_of_clearance = 1e-6;

/// Largest share of energy off the multiples of 1/n, relative to the energy without 0X.
inline constexpr double off_order_energy_limit = 1e-4;

/// View of one window: `turns` successive turns of one run, without copying.
struct Window {
  int turns = 0;
  int samples_per_revolution = 0;
  double clearance_m = 0;  ///< clearance of the kicked stop, > 0: scale for small quantities
  /// turns x samples_per_revolution samples, without the end point.
  std::span<const std::complex<double>> displacement_m;
  int states = 0;
  std::span<const double> section;  ///< (turns + 1) x states, scaled rows as `period_of_section` takes them
  std::span<const ContactFacts> contact;  ///< facts of each turn
};

/// Verdict on a single window.
struct WindowVerdict {
  MotionClass motion_class = MotionClass::unsettled;  ///< non_contact, a periodic class, or unsettled
  std::optional<int> order;                           ///< order n confirmed by section and spectrum
  std::optional<SectionPeriod> period;                ///< period from the section only; empty without contact
  bool spectrum_agrees = true;                        ///< false: `period` exists, the spectrum contradicts it
  std::optional<double> off_order_energy_fraction;    ///< energy off multiples of 1/n over energy without 0X
  Measures measures;
};

/// Classifies one window. Without any contact: `non_contact`. Otherwise the section gives the period n, and
/// the spectrum over the last window_turns(turns, n) turns must confirm it: off the multiples of 1/n, no
/// significant line and less than off_order_energy_limit of the energy. (An energy below that of one line at
/// the limit of significance, 1e-6 clearance, is rounding and counts as none.) Every other motion is
/// `unsettled`, with a spectrum over all turns, because chaos and quasi-periodic motion need more evidence
/// than one window. SolverError when sizes do not match, with fewer than 4 samples per turn, or without
/// clearance.
WindowVerdict classify_window(const Window& window, const ResponseOptions& options,
                              spectrum::SpectrumWorkspace& workspace);

/// Class of a motion with contact whose section returns after `order` turns: synchronous or subharmonic, or
/// `resting_contact` where no line except 0X is significant, so that nothing moves.
MotionClass class_of_period(int order, const Measures& measures);

/// Measures of a window; the spectrum is over all its turns.
Measures measure_window(const Window& window, spectrum::SpectrumWorkspace& workspace);

/// Verdict of two successive windows. If they do not agree in class and order, the motion is `unsettled`. The
/// measures are those of the last window. Status is `spectrum_disagrees` when either spectrum disagreed.
Motion settle_verdict(const WindowVerdict& previous, const WindowVerdict& last);

}  // namespace rubsweep::response::motion
