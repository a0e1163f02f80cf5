#include "shared/figure.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "rubsweep/batch/directory.hpp"
#include "rubsweep/batch/input_file.hpp"
#include "rubsweep/batch/whole_file.hpp"
#include "rubsweep/error.hpp"
#include "shared/child_process.hpp"
#include "shared/interrupt.hpp"
#include "shared/program.hpp"
#include "shared/writable.hpp"

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

/// Package that draws. RUBPLOT_FROM_BIN leads to it from the directory of an installed program,
/// RUBPLOT_SOURCE is where it was when that was built.
fs::path rubplot_package(const std::string& option) {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path installed = program.parent_path() / RUBPLOT_FROM_BIN, source = RUBPLOT_SOURCE;
  for (const fs::path& package : {installed, source})
    if (fs::exists(package / "__main__.py", none)) return fs::weakly_canonical(package, none);
  throw IoError(fmt::format("--{}: rubplot, which draws, is neither in {} nor in {}", option,
                            installed.lexically_normal().string(), source.string()));
}

}  // namespace

void add_figure(po::options_description& options, const char* meaning) {
  options.add_options()("figure", po::value<std::string>()->value_name("FILE"), meaning);
}

Figure::Figure(fs::path file, const std::string& option) : file_(std::move(file)) {
  const std::string kind = file_.extension();
  if (kind != ".png" && kind != ".svg" && kind != ".pdf")
    throw UsageError(fmt::format("--{}: allowed: a name that ends with .png, .svg or .pdf", option));
  for (const auto& [command, package] :
       {std::pair("gnuplot", "gnuplot-nox"), std::pair("python3", "python3")}) {
    if (!find_command(command)) {
      throw IoError(fmt::format("--{}: there is no program called {} to draw with (Debian: {})", option,
                                command, package));
    }
  }
  rubplot_ = rubplot_package(option);
  require_writable(file_, true);
}

void Figure::draw(const std::string& picture, const fs::path& input, const std::string& heading,
                  const std::vector<std::string>& options) const {
  const InterruptsWait until_the_directory_is_gone;
  const TemporaryDirectory work;
  const fs::path output = (work.path() / "picture") += file_.extension();
  // Pictures are the same whatever the user has set for Python.
  std::vector<std::string> command{
      "python3", "-E", "-s", "-B", rubplot_, picture, "--output", output, "--heading=" + heading};
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
