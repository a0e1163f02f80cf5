#include "figure.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "child_process.hpp"
#include "interrupt.hpp"
#include "program.hpp"
#include "rubsweep/batch/input_file.hpp"
#include "rubsweep/batch/whole_file.hpp"
#include "rubsweep/error.hpp"
#include "writable.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// A directory that goes when its owner does.
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

/// RUBSWEEP_SCRIPTS_FROM_BIN leads from the directory of an installed program to its scripts,
/// RUBSWEEP_SCRIPTS_SOURCE is where they were when it was built.
fs::path scripts_directory(const std::string& option) {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path installed = program.parent_path() / RUBSWEEP_SCRIPTS_FROM_BIN,
                 source = RUBSWEEP_SCRIPTS_SOURCE;
  for (const fs::path& directory : {installed, source})
    if (fs::is_directory(directory / "analysis", none)) return fs::weakly_canonical(directory, none);
  throw IoError(fmt::format("--{}: the scripts that draw are neither in {} nor in {}", option,
                            installed.lexically_normal().string(), source.string()));
}

}  // namespace

void add_figure(po::options_description& options, const char* meaning) {
  options.add_options()("figure", po::value<std::string>()->value_name("FILE"), meaning);
}

Figure::Figure(fs::path file, const std::string& option) : file_(std::move(file)) {
  const std::string kind = file_.extension();
  if (kind != ".png" && kind != ".svg")
    throw UsageError(fmt::format("--{}: allowed: a name that ends with .png or .svg", option));
  for (const auto& [command, package] :
       {std::pair("gnuplot", "gnuplot-nox"), std::pair("python3", "python3")}) {
    if (!find_command(command)) {
      throw IoError(fmt::format("--{}: there is no program called {} to draw with (Debian: {})", option,
                                command, package));
    }
  }
  scripts_ = scripts_directory(option);
  require_writable(file_, true);
}

void Figure::draw(const std::string& script, const fs::path& input, const std::string& heading,
                  const std::vector<std::string>& more) const {
  const InterruptsWait until_the_directory_is_gone;
  const TemporaryDirectory work;
  const fs::path output = work.path() / "picture";
  ::setenv("LC_ALL", "C.UTF-8", 1);
  // Pictures are the same whatever the user has set for Python and gnuplot.
  std::vector<std::string> command{
      "python3", "-E", "-s", "-B", scripts_ / "analysis" / script, input.string(), output.string(), heading};
  command.insert(command.end(), more.begin(), more.end());
  if (!run_child(std::move(command))) throw IoError(fmt::format("{}: could not be drawn", file_.string()));
  if (file_.has_parent_path()) make_directory(file_.parent_path());
  batch::write_whole_file(file_, batch::read_input(fs::path(output) += file_.extension()));
}

std::optional<Figure> figure_of(const po::variables_map& given, const std::string& option) {
  if (given.count(option) == 0) return std::nullopt;
  return Figure(given[option].as<std::string>(), option);
}

}  // namespace rubsweep::apps
