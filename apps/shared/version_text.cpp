#include "shared/version_text.hpp"

#include <fmt/format.h>

#include "commit.hpp"

namespace rubsweep::apps {

std::string version_text(std::string_view program) {
  return fmt::format("{} {}\ncommit {}\ncompiler {}\n", program, RUBSWEEP_VERSION, commit, RUBSWEEP_COMPILER);
}

}  // namespace rubsweep::apps
