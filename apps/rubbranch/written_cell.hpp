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

/// The cell of --cell with some parameters replaced. A parameter is speed_hz, whirl_ratio, eccentricity_m, or
/// the key of a number as in --set.
class WrittenCell {
 public:
  struct Written {
    std::string key;
    double value = 0;
  };

  WrittenCell(const RubbranchArguments& arguments, const config::RunConfig& config);

  /// The cell with these values; empty for an invalid speed or unbalance. Throws ConfigError where the
  /// configuration does not allow a number.
  std::optional<scene::Cell> with(const std::vector<Written>& all) const;

  /// Scene of the cell; empty also where there is no such configuration or the cell cannot run.
  std::optional<scene::Scene> scene_with(const std::vector<Written>& all) const;

  /// Value of `key` in the cell with `all` replaced. Throws ConfigError where the values are not allowed for
  /// a machine.
  double value_of(const std::string& key, const std::vector<Written>& all) const;

 private:
  RubbranchArguments arguments_;
  config::RunConfig config_;
  std::string text_;
  std::shared_ptr<const scene::PreparedMachine> prepared_;
};

/// Whether a parameter is the key of a number.
bool is_key(const std::string& parameter);
/// Whether a parameter is the unbalance.
bool is_unbalance(const std::string& parameter);

/// Throws ConfigError, with the name of `option`, where `parameter` is not a number of the machine.
void require_number(std::string_view option, const std::string& parameter, const config::RunConfig& config);

/// Ends of a range, where the command line gives them.
struct AskedRange {
  std::optional<double> low, high;
};

/// Range of a parameter. A missing end comes from the sweep, extended to `start` if necessary; for a key it
/// is half or twice `start`. Throws UsageError where `start` is 0 and an end is missing.
branch::orbits::ParameterRange range_of(const std::string& parameter, const AskedRange& asked, double start,
                                        const sweep::Grid& grid);

}  // namespace rubsweep::apps
