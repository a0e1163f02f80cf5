#include "rubsweep/maps/config/output.hpp"

#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config {
namespace {

std::filesystem::path read_directory(yaml::Section& section) {
  const auto text = section.require("directory", "a path");
  return text ? read_text(*text).value_or("") : std::string();
}

}  // namespace

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
  section.field("warn_over_clearances", config.warn_over_clearances, model::positive);
  section.refuse_unknown_keys();
}

void print_run_output(yaml::Printer& printer, const RunConfig& config) {
  printer.open("output");
  printer.text("directory", config.output_directory.string());
  printer.number("warn_over_clearances", config.warn_over_clearances);
  printer.close();
}

}  // namespace rubsweep::config
