#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rubsweep::model {

/// A mil is a thousandth of an inch.
enum class LengthUnit { m, mm, um, mil };

/// The unit that a command line calls "mm", "um" or "mil"; empty for any other word.
std::optional<LengthUnit> length_unit_of(std::string_view word);

/// Name of a unit, including "m".
std::string_view word_of(LengthUnit unit);

/// How lengths are shown to the user.
struct ShownLengths {
  std::optional<LengthUnit> unit = {};  ///< unit that the user chose; empty: the usual unit of the text
  bool peak_to_peak = false;            ///< true: amplitudes are doubled, as is usual for vibrations
};

/// A length (m) in the unit that the user chose, or else in `usual`, such as "0.85 mil"; `digits`:
/// significant digits.
std::string length_text(double length_m, const ShownLengths& shown, LengthUnit usual, int digits = 4);

/// Amplitude (m) of a vibration in the same unit, such as "1.7 mil peak to peak" if the user chose peak to
/// peak.
std::string amplitude_text(double amplitude_m, const ShownLengths& shown, LengthUnit usual, int digits = 4);

}  // namespace rubsweep::model
