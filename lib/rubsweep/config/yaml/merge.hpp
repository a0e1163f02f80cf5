#pragma once

#include <string_view>

#include "rubsweep/config/yaml/diagnostics.hpp"
#include "rubsweep/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// The value that results when `over` is written over `base`, both found at `path`:
/// - Two maps are merged key by key. A key of `over` takes back what the base says by other means (see
///   alternatives.hpp), and without a value it takes back the base's own. Two maps that name different kinds
///   (key `kind`) share nothing: that of `over` stands alone.
/// - Anything else, lists included, replaces what the base has.
/// Remaining keys keep their places; the merged map itself has that of `over`. Repeated keys are a problem in
/// either.
Node merged(Node base, Node over, std::string_view path, Diagnostics& diagnostics);

}  // namespace rubsweep::config::yaml
