#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::response::motion {

/// Classes of motion.
enum class MotionClass {
  non_contact,
  synchronous,
  resting_contact,
  subharmonic,
  quasi_periodic,
  chaotic,
  unsettled,
  initial_contact,
  failed,
};

/// All that is said about one class. Maps, summaries, comparisons and help texts read it here; colours are
/// those of MotionKind.
struct MotionClassRow {
  std::string_view word;         ///< its name in map.csv
  std::string_view description;  ///< for help texts
  bool rubs = false;             ///< the rotor keeps touching a stop
  bool repeats = false;  ///< its measures do not depend on when one looks, so that maps may be compared
};

/// The table. It is a switch so that a class without a row does not compile.
constexpr MotionClassRow row_of(MotionClass motion_class) {
  switch (motion_class) {
    case MotionClass::non_contact:
      return {.word = "non_contact",
              .description = "no contact after the kick's transient",
              .rubs = false,
              .repeats = true};
    case MotionClass::synchronous:
      return {.word = "synchronous",
              .description = "the section returns after one turn",
              .rubs = true,
              .repeats = true};
    case MotionClass::resting_contact:
      return {.word = "resting_contact",
              .description = "pressed on a stop and at rest there: no line but 0X",
              .rubs = true,
              .repeats = true};
    case MotionClass::subharmonic:
      return {.word = "subharmonic",
              .description = "the section returns after n >= 2 turns and no fewer",
              .rubs = true,
              .repeats = true};
    case MotionClass::quasi_periodic:
      return {.word = "quasi_periodic",
              .description = "discrete lines without a common period; in symmetric scenes a comb",
              .rubs = true,
              .repeats = false};
    case MotionClass::chaotic:
      return {.word = "chaotic",
              .description = "largest Lyapunov exponent positive beyond its error bar",
              .rubs = true,
              .repeats = false};
    case MotionClass::unsettled:
      return {.word = "unsettled",
              .description = "not decided when the run ended",
              .rubs = true,
              .repeats = false};
    case MotionClass::initial_contact:
      return {.word = "initial_contact",
              .description =
                  "static forces press the rotor on the wall, so that no unbalance gives the whirl "
                  "ratio asked for",
              .rubs = false,
              .repeats = false};
    case MotionClass::failed:
      return {
          .word = "failed", .description = "the integration did not finish", .rubs = false, .repeats = false};
  }
  return {};
}

/// The word in map.csv; empty for a number that is no class.
constexpr std::string_view to_string(MotionClass motion_class) { return row_of(motion_class).word; }

/// Every class, in the order of the enumeration.
inline constexpr auto motion_classes =
    enumerators_of<MotionClass, [](MotionClass motion_class) { return row_of(motion_class).word; }>;

/// The class of a word in map.csv; empty for any other word.
constexpr std::optional<MotionClass> motion_class_of(std::string_view word) {
  const auto found = std::ranges::find(motion_classes, word,
                                       [](MotionClass motion_class) { return to_string(motion_class); });
  return found == motion_classes.end() ? std::nullopt : std::optional(*found);
}

}  // namespace rubsweep::response::motion
