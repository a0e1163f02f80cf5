#include "rubsweep/maps/config/exported_matrices.hpp"

#include <fmt/format.h>

#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/matrix_shaft.hpp"
#include "rubsweep/maps/batch/result_files.hpp"
#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/print_config.hpp"

namespace rubsweep::config {
namespace {

std::vector<std::string> varied_keys(const sweep::Study& study) {
  std::vector<std::string> keys = sweep::key_names(study.grid);
  if (study.threshold)
    keys.insert(keys.end(), study.threshold->axis.keys.begin(), study.threshold->axis.keys.end());
  if (study.basin) {
    for (const sweep::DrawnKey& drawn : study.basin->over) keys.push_back(drawn.key);
  }
  return keys;
}

}  // namespace

std::map<std::string_view, std::string> exported_matrices(const RunConfig& config) {
  RunConfig exported = config;
  exported.study.machine = structure::machine_by_matrices(config.study.machine);
  for (const std::string& key : varied_keys(config.study)) {
    if (key.starts_with("rotor."))
      throw ConfigError(fmt::format(
          "{}: is varied, and matrices are of one rotor, allowed: keys of other parts of the machine", key));
  }
  exported.output_directory = batch::directory_beside(config.output_directory, "_matrices");
  auto files = machine::matrix_files(*model::kit_of(exported.study.machine)->matrices);
  files["rotor.yaml"] = print_config(exported, machine::MatrixPrint::as_files);
  return files;
}

}  // namespace rubsweep::config
