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

/// One complete configuration of `rubsweep`: the study and where its files go.
struct RunConfig {
  sweep::Study study;
  std::filesystem::path output_directory;
  double warn_over_clearances = 10;  ///< cells whose rotor moves farther are counted and warned of
  batch::Captions captions{};
  std::vector<std::string> questions{};  ///< questions about likely slips of units (see unit_slips.hpp)

  /// Keys of `output` beside the directory.
  static void visit_fields(auto& self, auto&& visit) {
    visit("warn_over_clearances", self.warn_over_clearances,
          model::newer_key(model::positive,
                           "motions beyond so many clearances of the first stop are counted and warned of"));
  }
};

/// Reads a configuration, after the `key.path=value` strings of `overrides` (see override.hpp) replaced
/// values of it, and after it was written over the bases that it names (see base.hpp). Every key is checked
/// for name, type, range and meaning; what may be left out gets its default.
///
/// Throws ConfigError whose text holds every problem found, one a line, in the order of the files (bases
/// before those that name them), then of the overrides: `file:line:column: path.to.key: what is wrong,
/// allowed: what is allowed`, where
/// `--set path.to.key=value` stands in place of `file:line:column` for what an override wrote. A file that is
/// not YAML at all, or a base that cannot be had, is the only problem. Throws IoError when the file cannot be
/// read.
RunConfig read_run_config(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// The same for a text; `name` replaces the file in messages, and bases are relative to it. Throws
/// ConfigError.
RunConfig read_run_config_text(std::string_view text, const std::string& name,
                               const std::vector<std::string>& overrides);

/// All keys of such a configuration.
keys::Form run_form();

/// Keys of it that exclude each other.
const yaml::Alternatives& run_alternatives();

/// The machine alone of such a text, without what is refused or asked as a likely slip of units, which would
/// prepare the machine several times: for many machines of one configuration that was read. Throws
/// ConfigError.
model::Machine read_machine_text(std::string_view text, const std::string& name,
                                 const std::vector<std::string>& overrides);

/// The complete configuration as YAML, defaults included, that reads back as an equal one: axes as they were
/// written, by ends and count and in the units of the person. Configurations that are written alike give
/// equal bytes. What is optional and has no value of its own (kick, kick.angle_deg, contact_mass_kg) is left
/// out. Matrices of a rotor are written as texts, or as the names of files beside the configuration. Throws
/// ConfigError when the output directory is not UTF-8.
std::string print_config(const RunConfig& config,
                         machine::MatrixPrint matrices = machine::MatrixPrint::inside);

/// Everything that decides the numbers of a map, nothing else: without captions and `output`, and with every
/// axis as its values in SI units, so that equal studies give equal bytes however their files were written.
std::string print_study(const sweep::Study& study);

/// Names of all files of exported_matrices.
inline constexpr std::string_view exported_matrix_files[]{
    "mass.mtx",      "stiffness.mtx", "damping.mtx", "gyroscopic.mtx", "degrees_of_freedom.csv",
    "unbalance.csv", "rotor.yaml"};

/// The full finite-element model of the rotor as files by name: matrices, tables of the degrees of freedom
/// and the unbalance, and rotor.yaml, the same configuration with them in place of the rotor kit, its results
/// beside those of the given one. Throws ConfigError where matrices cannot say the rotor, and where an axis
/// of the sweep or the study varies a part of it.
std::map<std::string_view, std::string> exported_matrices(const RunConfig& config);

/// Name-based UUID (version 5, SHA-1) of a text.
std::string digest_of(std::string_view text);

/// Digest of everything that decides the numbers of a map (see print_study): a name-based UUID (version 5,
/// SHA-1). Equal studies have equal digests however their files were written.
std::string study_digest(const sweep::Study& study);

}  // namespace rubsweep::config
