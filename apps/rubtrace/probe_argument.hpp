#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/analysis/trace/probe.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::apps {

/// A simulated probe of a trace, as --probe gives it.
struct ProbeArgument {
  std::string text{};    ///< the option's value, for messages
  bool on_shaft = true;  ///< whether the shaft moves the probe: at `stop`, else where it is observed
  std::optional<std::size_t>
      stop{};            ///< stop whose casing moves the probe, or from which the shaft is measured
  int derivative = 0;    ///< 0: displacement, 1: velocity, 2: acceleration
  double angle_deg = 0;  ///< direction, from +x towards +y
  double noise = 0;      ///< standard deviation of a reading in m, m/s or m/s2
};

/// Reads PLACE:QUANTITY:ANGLE_DEG[:NOISE], with PLACE shaft, stopN or shaft-stopN. Throws UsageError.
ProbeArgument probe_of(const std::string& text);

/// Probes of a run; at a stop they have its name. Throws ConfigError where a machine has no such stop or its
/// casing is rigid.
trace::Probes probes_of(const std::vector<ProbeArgument>& arguments, const scene::PreparedMachine& prepared,
                        double sample_s, const std::vector<std::string>& stop_names = {});

/// A number for each probe that is the same for displacements at one place, and otherwise NaN.
std::vector<double> places_of(const std::vector<ProbeArgument>& arguments);

}  // namespace rubsweep::apps
