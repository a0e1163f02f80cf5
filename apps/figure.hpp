#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "command_line.hpp"

namespace rubsweep::apps {

void add_figure(po::options_description& options, const char* meaning);

/// Picture that a program draws of its results, with the scripts that come with it: those of an installed
/// copy in share/rubsweep/scripts, else those of the sources it was built from.
class Figure {
 public:
  /// `file`, the value of --OPTION, ends with .png or .svg, else UsageError. Throws IoError, before anything
  /// is computed, where gnuplot, Python or the scripts are missing, or FILE could not be written.
  Figure(std::filesystem::path file, const std::string& option);

  const std::filesystem::path& file() const { return file_; }

  /// Lets analysis/SCRIPT draw `input` under a heading; it is called as SCRIPT INPUT OUTPUT_BASENAME
  /// HEADING MORE... The picture appears whole or not at all. Throws IoError.
  void draw(const std::string& script, const std::filesystem::path& input, const std::string& heading,
            const std::vector<std::string>& more = {}) const;

 private:
  std::filesystem::path file_, scripts_;
};

/// The figure that --figure, or another option of that kind, asks for, if it does.
std::optional<Figure> figure_of(const po::variables_map& given, const std::string& option = "figure");

}  // namespace rubsweep::apps
