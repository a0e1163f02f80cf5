#pragma once

#include "rubsweep/maps/config/keys/form.hpp"

namespace rubsweep::config::keys {

/// A whole rub configuration, which rubsweep and its sisters read.
Form run_form();

/// `title`, `author` and `note`, of configurations of ringstab as well.
std::vector<Key> caption_keys();

/// `base` of any map.
Key base_of_map();

}  // namespace rubsweep::config::keys
