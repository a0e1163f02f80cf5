#include "rubsweep/maps/config/read_run_config.hpp"

#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/output.hpp"
#include "rubsweep/maps/config/plan_questions.hpp"
#include "rubsweep/maps/config/study/captions.hpp"
#include "rubsweep/maps/config/study/study.hpp"
#include "rubsweep/maps/config/unit_slips.hpp"
#include "rubsweep/maps/config/varied_study.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/file_bytes.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config {
namespace {

constexpr std::string_view root_form = "a map with rotor, stops, sweep, output";

RunConfig read_sections(const yaml::Value& root) {
  yaml::Section section(root, root_form);
  section.find(yaml::base_key);  // resolved before; still a name that a misspelt key may mean
  RunConfig config;
  config.study = study::read_study(section);
  if (const auto value = section.require("output", "a map")) read_run_output(*value, config);
  study::read_captions(section, config.captions);
  section.refuse_unknown_keys();
  return config;
}

}  // namespace

keys::Form run_form() {
  return keys::map_of(keys::joined({study::caption_keys(),
                                    {base_of_map()},
                                    study::study_keys(),
                                    {keys::must("output", run_output_form(), "where results go")}}),
                      {study::kick_or_start()});
}

model::Machine read_machine_text(std::string_view text, const std::string& name,
                                 const std::vector<std::string>& overrides) {
  yaml::Diagnostics diagnostics(name, overrides);
  const yaml::Node root = parse_config(text, name, root_form, overrides, diagnostics);
  model::Machine machine = read_sections({root, "", diagnostics}).study.machine;
  diagnostics.throw_if_any();
  return machine;
}

RunConfig read_run_config(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return read_run_config_text(yaml::read_config_bytes(file), file.string(), overrides);
}

RunConfig read_run_config_text(std::string_view text, const std::string& name,
                               const std::vector<std::string>& overrides) {
  yaml::Diagnostics diagnostics(name, overrides);
  const yaml::Node root = parse_config(text, name, root_form, overrides, diagnostics);
  refuse_foreign(root, {"ring", "loads"}, {"rotor", "stops"}, "ringstab", diagnostics);
  RunConfig config = read_sections({root, "", diagnostics});
  if (diagnostics.count() == 0) refuse_unit_slips({root, "", diagnostics}, &config.study.machine);
  if (diagnostics.count() == 0) vary_keys({root, "", diagnostics}, config.study);
  diagnostics.throw_if_any();
  config.questions = unit_questions({root, "", diagnostics}, &config.study.machine);
  // A number in another unit makes all the rest odd.
  if (config.questions.empty()) config.questions = plan_questions({root, "", diagnostics}, config.study);
  return config;
}

}  // namespace rubsweep::config
