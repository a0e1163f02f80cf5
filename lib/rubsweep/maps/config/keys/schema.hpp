#pragma once

#include <string>
#include <string_view>

#include "rubsweep/maps/config/keys/form.hpp"

namespace rubsweep::config::keys {

/// JSON Schema (draft 7) of a configuration of this form, for an editor that completes, explains and checks.
/// The reader refuses everything that the schema refuses, and more: a schema cannot state rules over several
/// numbers. A map that has a base need not be complete. Neither need maps inside it, except those in lists,
/// and a key in them may be without a value.
std::string schema_of(const Form& root, std::string_view title);

}  // namespace rubsweep::config::keys
