#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shared/command_line.hpp"

namespace rubsweep::apps {

void add_figure(po::options_description& options, const char* meaning);

/// A figure of a program's results, drawn by rubplot: by the installed copy in share/rubsweep/rubplot, or
/// else by the copy in the source tree.
class Figure {
 public:
  /// A picture, or a page of HTML with several ones.
  enum class Kind { picture, page };

  /// A picture's `file`, the value of --OPTION, must end with .png, .svg or .pdf, else UsageError. Throws
  /// IoError, before anything is computed, where gnuplot, Python or rubplot are missing, or the file cannot
  /// be written.
  Figure(std::filesystem::path file, const std::string& option, Kind kind = Kind::picture);

  const std::filesystem::path& file() const { return file_; }

  /// Draws `input` by `rubplot PICTURE` with a heading. The figure appears whole or not at all. Throws
  /// IoError.
  void draw(const std::string& picture, const std::filesystem::path& input, const std::string& heading,
            const std::vector<std::string>& options = {}) const;

 private:
  std::filesystem::path file_, rubplot_;
};

/// Draws the figure, if there is one, and reports its path unless `quiet`; otherwise like Figure::draw.
void draw_and_say(const std::optional<Figure>& figure, const std::string& picture,
                  const std::filesystem::path& input, const std::string& heading, bool quiet,
                  const std::vector<std::string>& options = {});

/// The figure that --figure, or a similar option, asks for; empty where it is not given.
std::optional<Figure> figure_of(const po::variables_map& given, const std::string& option = "figure");

}  // namespace rubsweep::apps
