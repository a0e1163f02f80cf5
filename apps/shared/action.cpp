#include "shared/action.hpp"

#include <fmt/format.h>

#include "shared/exit_code.hpp"
#include "shared/help_text.hpp"
#include "shared/program.hpp"
#include "shared/version_text.hpp"

namespace rubsweep::apps {

bool answered(std::string_view program, Action action, const std::function<std::string()>& help) {
  if (action == Action::help) {
    print("{}", wrapped(help()));
  } else if (action == Action::version) {
    print("{}", version_text(program));
  } else {
    return false;
  }
  return true;
}

int act(const StudyArguments& arguments, const StudyActions& actions) {
  switch (arguments.action) {
    case Action::check:
      if (!arguments.quiet) print("{}: ok, {}\n", arguments.config.string(), actions.size());
      return done;
    case Action::explain: print("{}", actions.explanation()); return done;
    case Action::print_config: print("{}", actions.configuration()); return done;
    case Action::run:
    case Action::help:
    case Action::version: break;
  }
  return actions.run();
}

}  // namespace rubsweep::apps
