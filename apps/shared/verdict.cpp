#include "shared/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "shared/exit_code.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {

int report_verdict(std::string_view program, const std::filesystem::path& directory,
                   const DirectoryVerdict& verdict, bool quiet) {
  const auto list = [&](const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) say(fmt::format("{}: {}\n", program, sentence));
  };
  list(verdict.faults);
  if (!quiet) list(verdict.remarks);
  if (!quiet && verdict.faults.empty())
    apps::print("{}: whole: {}\n", directory.string(), fmt::join(verdict.files, " "));
  return verdict.faults.empty() ? done : not_whole;
}

}  // namespace rubsweep::apps
