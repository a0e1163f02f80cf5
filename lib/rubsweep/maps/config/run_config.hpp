#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config {

/// One complete configuration of `rubsweep`: the study and where its files go.
struct RunConfig {
  sweep::Study study;
  std::filesystem::path output_directory;
  double warn_over_clearances = 10;  ///< cells with larger deflections are counted in a warning
  batch::Captions captions{};
  std::vector<std::string> questions{};  ///< questions about likely slips of units (see unit_slips.hpp)

  /// Visits the keys of `output` except the directory.
  static void visit_fields(auto& self, auto&& visit) {
    visit("warn_over_clearances", self.warn_over_clearances,
          model::newer_key(model::positive,
                           "motions beyond so many clearances of the first stop are counted and warned of"));
  }
};

/// Reads a configuration, merged with the bases that it names (see base.hpp), after the `key.path=value`
/// strings of `overrides` (see override.hpp) replaced values. Name, type, range and meaning of every key are
/// checked, and optional keys that are left out get their defaults.
///
/// Throws ConfigError with every problem found, one a line, in the order of the files (a base before the file
/// that names it), then of the overrides: `file:line:column: path.to.key: what is wrong, allowed: what is
/// allowed`. A problem of an override begins with `--set path.to.key=value` in place of `file:line:column`. A
/// file that is not YAML, or a base that cannot be read, is reported alone. Throws IoError where the file
/// cannot be read.
RunConfig read_run_config(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// Reads a configuration from a text. `name` stands for the file in messages, and bases are relative to it.
/// Throws ConfigError.
RunConfig read_run_config_text(std::string_view text, const std::string& name,
                               const std::vector<std::string>& overrides);

/// All keys of a configuration of `rubsweep`.
keys::Form run_form();

/// Reads only the machine of a configuration, from a text. Skips the checks for likely slips of units, which
/// would prepare the machine several times: meant for many variants of one configuration. Throws ConfigError.
model::Machine read_machine_text(std::string_view text, const std::string& name,
                                 const std::vector<std::string>& overrides);

}  // namespace rubsweep::config
