#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/maps/config/keys/form.hpp"
#include "shared/command_line.hpp"

namespace rubsweep::apps {

/// Adds --keys and --schema, for programs that first read a kind of configuration.
void add_key_questions(po::options_description& options);

/// Answer to --keys (all keys, or those below the path that stands in place of the configuration file) or to
/// --schema; empty where neither is given. `configuration` makes the keys, which are not needed otherwise.
/// Throws UsageError.
std::optional<std::string> key_answer(const po::variables_map& given, config::keys::Form (*configuration)(),
                                      std::string_view title);

}  // namespace rubsweep::apps
