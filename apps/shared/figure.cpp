#include "shared/figure.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "shared/child_process.hpp"
#include "shared/interrupt.hpp"
#include "shared/program.hpp"
#include "shared/writable.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// A temporary directory that is removed by the destructor.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (fs::temp_directory_path() / "rubsweep-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw IoError(fmt::format("a temporary directory: {}", std::strerror(errno)));
    path_ = name;
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Package or program that draws. RUBPLOT_FROM_BIN is its path relative to the directory of an installed
/// program, RUBPLOT_SOURCE its path for programs in the build directory. If neither exists, a rubplot command
/// in the user's PATH is used.
fs::path find_rubplot(const std::string& option) {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path here = program.parent_path(), installed = here / RUBPLOT_FROM_BIN;
  const bool built_here = here == fs::path(RUBPLOT_BUILT_IN);
  for (const fs::path& package : {installed, built_here ? fs::path(RUBPLOT_SOURCE) : installed})
    if (fs::exists(package / "__main__.py", none)) return fs::weakly_canonical(package, none);
  if (const auto command = find_command("rubplot")) return *command;
  throw IoError(fmt::format("--{}: rubplot, which draws, is neither in {} nor a command", option,
                            installed.lexically_normal().string()));
}

}  // namespace

void add_figure(po::options_description& options, const char* meaning) {
  options.add_options()("figure", po::value<std::string>()->value_name("FILE"), meaning);
}

Figure::Figure(fs::path file, const std::string& option, Kind kind) : file_(std::move(file)) {
  const std::string ending = file_.extension();
  if (kind == Kind::picture && ending != ".png" && ending != ".svg" && ending != ".pdf")
    throw UsageError(fmt::format("--{}: allowed: a name that ends with .png, .svg or .pdf", option));
  for (const auto& [command, package] :
       {std::pair("gnuplot", "gnuplot-nox"), std::pair("python3", "python3")}) {
    if (!find_command(command)) {
      throw IoError(fmt::format("--{}: there is no program called {} to draw with (Debian: {})", option,
                                command, package));
    }
  }
  rubplot_ = find_rubplot(option);
  require_writable(file_, true);
}

void Figure::draw(const std::string& picture, const fs::path& input, const std::string& heading,
                  const std::vector<std::string>& options) const {
  const InterruptsWait until_the_directory_is_gone;
  const TemporaryDirectory work;
  const fs::path output = (work.path() / "picture") += file_.extension();
  // Pictures must not depend on the user's Python settings.
  std::vector<std::string> command;
  if (fs::is_directory(rubplot_)) command = {"python3", "-E", "-s", "-B"};
  command.insert(command.end(), {rubplot_, picture, "--output", output, "--heading=" + heading});
  command.insert(command.end(), options.begin(), options.end());
  command.insert(command.end(), {"--", input});
  if (!run_child(std::move(command))) throw IoError(fmt::format("{}: could not be drawn", file_.string()));
  if (file_.has_parent_path()) batch::make_directory(file_.parent_path());
  batch::write_whole_file(file_, batch::read_input(output));
}

void draw_and_say(const std::optional<Figure>& figure, const std::string& picture, const fs::path& input,
                  const std::string& heading, bool quiet, const std::vector<std::string>& options) {
  if (!figure) return;
  figure->draw(picture, input, heading, options);
  if (!quiet) print("figure    {}\n", figure->file().string());
}

std::optional<Figure> figure_of(const po::variables_map& given, const std::string& option) {
  if (given.count(option) == 0) return std::nullopt;
  return Figure(given[option].as<std::string>(), option);
}

}  // namespace rubsweep::apps
