#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubbranch_arguments.hpp"
#include "rubsweep/analysis/branch/orbits/scene_plane.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::apps {

/// The cell of --cell with values of parameters written over it. A parameter is speed_hz, whirl_ratio,
/// eccentricity_m, or the key of a number as --set names it.
class WrittenCell {
 public:
  struct Written {
    std::string key;
    double value = 0;
  };

  WrittenCell(const RubbranchArguments& arguments, const config::RunConfig& config);

  /// Empty where a speed or an unbalance is none. Throws ConfigError where the configuration may not have the
  /// number.
  std::optional<scene::Cell> with(const std::vector<Written>& all) const;

  /// Empty as well where there is no such configuration, or where the cell cannot run.
  std::optional<scene::Scene> scene_with(const std::vector<Written>& all) const;

  /// The value of `key` where `all` is written over the cell. Throws ConfigError where that is no machine.
  double value_of(const std::string& key, const std::vector<Written>& all) const;

 private:
  RubbranchArguments arguments_;
  config::RunConfig config_;
  std::string text_;
  std::shared_ptr<const scene::PreparedMachine> prepared_;
};

/// Whether it is the key of a number.
bool is_key(const std::string& parameter);
/// Whether the parameter is an unbalance.
bool is_unbalance(const std::string& parameter);

/// Throws ConfigError, which names `option`, where `parameter` is a key of no number of the machine.
void require_number(std::string_view option, const std::string& parameter, const config::RunConfig& config);

/// Ends of a range on the command line, where given.
struct AskedRange {
  std::optional<double> low, high;
};

/// Range that was asked for; an end that was not given is that of the sweep or `start` if that lies beyond,
/// of a key half of `start` or twice that. Throws UsageError where `start` is 0 and says no range.
branch::orbits::ParameterRange range_of(const std::string& parameter, const AskedRange& asked, double start,
                                        const sweep::Grid& grid);

}  // namespace rubsweep::apps
