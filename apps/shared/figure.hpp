#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shared/command_line.hpp"

namespace rubsweep::apps {

void add_figure(po::options_description& options, const char* meaning);

/// Picture that a program draws of its results, with rubplot: that of an installed copy in
/// share/rubsweep/rubplot, else that of the sources it was built from.
class Figure {
 public:
  /// `file`, the value of --OPTION, ends with .png, .svg or .pdf, else UsageError. Throws IoError, before any
  /// thing is computed, where gnuplot, Python or rubplot are missing, or FILE could not be written.
  Figure(std::filesystem::path file, const std::string& option);

  const std::filesystem::path& file() const { return file_; }

  /// Lets `rubplot PICTURE` draw `input` under a heading. The picture appears whole or not at all. Throws
  /// IoError.
  void draw(const std::string& picture, const std::filesystem::path& input, const std::string& heading,
            const std::vector<std::string>& options = {}) const;

 private:
  std::filesystem::path file_, rubplot_;
};

/// Draws the figure where one is asked for, and says where it is unless `quiet`; else as Figure::draw.
void draw_and_say(const std::optional<Figure>& figure, const std::string& picture,
                  const std::filesystem::path& input, const std::string& heading, bool quiet,
                  const std::vector<std::string>& options = {});

/// The figure that --figure, or another option of that kind, asks for, if it does.
std::optional<Figure> figure_of(const po::variables_map& given, const std::string& option = "figure");

}  // namespace rubsweep::apps
