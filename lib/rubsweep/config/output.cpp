#include "rubsweep/config/output.hpp"

#include "rubsweep/config/section.hpp"

namespace rubsweep::config {

std::filesystem::path read_output(const Value& value) {
  Section section(value);
  std::string directory;
  if (const auto text = section.require("directory", "a path")) directory = read_text(*text).value_or("");
  section.refuse_unknown_keys();
  return directory;
}

void print_output(Printer& printer, const std::filesystem::path& directory) {
  printer.open("output");
  printer.text("directory", directory.string());
  printer.close();
}

}  // namespace rubsweep::config
