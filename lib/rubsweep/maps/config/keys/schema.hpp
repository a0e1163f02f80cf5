#pragma once

#include <string>
#include <string_view>

#include "rubsweep/maps/config/keys/form.hpp"

namespace rubsweep::config::keys {

/// A configuration of this form as a JSON Schema (draft 7): for an editor that completes, explains and
/// checks. What it refuses, the reader refuses, too; rules over several numbers it cannot say. Of a map with
/// a base, of a map below such a one outside lists, nothing need be given, and a key without a value is
/// allowed.
std::string schema_of(const Form& root, std::string_view title);

}  // namespace rubsweep::config::keys
