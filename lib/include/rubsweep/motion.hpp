#pragma once

/// \file
/// A settled motion: its class (non_contact, synchronous, subharmonic with its order, quasi_periodic,
/// chaotic, ...) and its measures over whole turns of the shaft. Measures are peaks in metres and newtons,
/// hits, share of time in contact, forward and backward 1X amplitudes in metres, the largest line of the full
/// spectrum with its order (negative: backward), and shape and direction of the orbit. Measures that do not
/// apply are empty. to_string gives the words of map.csv; kind_of gives the kind by which maps are coloured,
/// with its label.
///
/// ```cpp
/// using namespace rubsweep;
/// response::motion::Motion motion;  // as response::settle returns it
/// motion.motion_class = response::motion::MotionClass::subharmonic;
/// motion.order = 2;
/// const auto& kind =
///     kind_of(motion.motion_class, motion.order, motion.measures.orbit, motion.measures.whirl, false);
/// std::printf("%s: %s\n", std::string(to_string(motion.motion_class)).c_str(),
///             std::string(kind.label).c_str());
/// ```

#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
