#include "rubsweep/maps/config/print_config.hpp"

#include <fmt/format.h>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/matrix_shaft.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/study/study.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"

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

std::string print_config(const RunConfig& config, machine::MatrixPrint matrices) {
  yaml::Printer printer;
  print_captions(printer, config.captions);
  study::print_study(printer, config.study, study::AxisPrint::as_written, matrices);
  print_run_output(printer, config);
  return printer.yaml();
}

std::string print_study(const sweep::Study& study) {
  yaml::Printer printer;
  study::print_study(printer, study, study::AxisPrint::by_value);
  return printer.yaml();
}

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

std::string digest_of(std::string_view text) {
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  return boost::uuids::to_string(generator(std::string(text)));
}

std::string study_digest(const sweep::Study& study) { return digest_of(print_study(study)); }

}  // namespace rubsweep::config
