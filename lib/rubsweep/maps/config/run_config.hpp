#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/yaml/alternatives.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config {

/// One complete configuration of `rubsweep`: the study and the directory of its files.
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

/// Reads a configuration, merges it with the bases that it names (see base.hpp), and replaces values by the
/// `key.path=value` strings of `overrides` (see override.hpp). Name, type, range and meaning of every key are
/// checked, and optional keys that are left out get their defaults.
///
/// Throws ConfigError with every problem found, one a line: `file:line:column: path.to.key: what is wrong,
/// allowed: what is allowed`. Problems are in the order of the files (a base before the file that names it),
/// then of the overrides. A problem of an override begins with `--set path.to.key=value` instead of
/// `file:line:column`. A file that is not YAML, or a base that cannot be read, is reported alone. Throws
/// IoError where the file cannot be read.
RunConfig read_run_config(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// Reads a configuration from a text. `name` stands for the file in messages, and bases are relative to it.
/// Throws ConfigError.
RunConfig read_run_config_text(std::string_view text, const std::string& name,
                               const std::vector<std::string>& overrides);

/// All keys of a configuration of `rubsweep`.
keys::Form run_form();

/// Keys of run_form() that exclude each other.
const yaml::Alternatives& run_alternatives();

/// Reads only the machine of a configuration, from a text. Meant for many variants of one configuration:
/// skips the checks for likely slips of units, which would prepare the machine several times. Throws
/// ConfigError.
model::Machine read_machine_text(std::string_view text, const std::string& name,
                                 const std::vector<std::string>& overrides);

/// Complete configuration as YAML, defaults included, that reads back as an equal configuration. Axes are
/// printed as they were written: by ends and count, and in the unit of the file. Configurations that were
/// written alike give equal bytes. Optional keys without a value (kick, kick.angle_deg, contact_mass_kg) are
/// left out. Matrices of a rotor are printed as texts, or as names of files in the directory of the
/// configuration. Throws ConfigError where the output directory is not UTF-8.
std::string print_config(const RunConfig& config,
                         machine::MatrixPrint matrices = machine::MatrixPrint::inside);

/// Study as YAML with everything that decides the numbers of a map, but without captions and `output`. Axes
/// are printed by their values in SI units, so that equal studies give equal bytes even if their files were
/// written differently.
std::string print_study(const sweep::Study& study);

/// Names of all files that exported_matrices may return.
inline constexpr std::string_view exported_matrix_files[]{
    "mass.mtx",      "stiffness.mtx", "damping.mtx", "gyroscopic.mtx", "degrees_of_freedom.csv",
    "unbalance.csv", "rotor.yaml"};

/// Full finite-element model of the rotor as files by name: the matrices, tables of the degrees of freedom
/// and the unbalance, and rotor.yaml. The file rotor.yaml is the same configuration with these files instead
/// of the rotor kit; its results are written beside those of the given configuration. Throws ConfigError
/// where matrices cannot represent the rotor, and where an axis of the sweep or the study varies a part of
/// it.
std::map<std::string_view, std::string> exported_matrices(const RunConfig& config);

/// Name-based UUID (version 5, SHA-1) of a text.
std::string digest_of(std::string_view text);

/// Digest of everything that decides the numbers of a map (see print_study): a name-based UUID (version 5,
/// SHA-1). Equal studies have equal digests even if their files were written differently.
std::string study_digest(const sweep::Study& study);

}  // namespace rubsweep::config
