#pragma once

#include <string>
#include <string_view>

#include "rubsweep/maps/config/keys/form.hpp"

namespace rubsweep::apps {

/// JSON Schema (draft 7) of a configuration of this form, for an editor that completes, explains and checks.
/// The reader refuses everything that the schema refuses, and also what a schema cannot state: rules over
/// several numbers. A map that has a base may lack required keys, and its keys may be without a value. The
/// same holds for maps inside it, except those in lists.
std::string schema_of(const config::keys::Form& root, std::string_view title);

}  // namespace rubsweep::apps
