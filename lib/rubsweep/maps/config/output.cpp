#include "rubsweep/maps/config/output.hpp"

#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config {
namespace {

std::filesystem::path read_directory(yaml::Section& section) {
  const auto text = section.require("directory", "a path");
  return text ? read_text(*text).value_or("") : std::string();
}

keys::Key directory_key() {
  return keys::must("directory", keys::text(), "directory of the results; --output goes first");
}

}  // namespace

keys::Form output_form() { return keys::map_of({directory_key()}); }

keys::Form run_output_form() {
  return keys::map_of(keys::joined({{directory_key()}, keys::keys_of<RunConfig>()}));
}

std::filesystem::path read_output(const yaml::Value& value) {
  yaml::Section section(value);
  const std::filesystem::path directory = read_directory(section);
  section.refuse_unknown_keys();
  return directory;
}

void print_output(yaml::Printer& printer, const std::filesystem::path& directory) {
  printer.open("output");
  printer.text("directory", directory.string());
  printer.close();
}

void read_run_output(const yaml::Value& value, RunConfig& config) {
  yaml::Section section(value);
  config.output_directory = read_directory(section);
  read_fields(section, config);
  section.refuse_unknown_keys();
}

void print_run_output(yaml::Printer& printer, const RunConfig& config) {
  printer.open("output");
  printer.text("directory", config.output_directory.string());
  print_fields(printer, config);
  printer.close();
}

}  // namespace rubsweep::config
