#pragma once

#include "rubsweep/maps/config/keys/form.hpp"

namespace rubsweep::config::keys {

/// A whole configuration of ringstab.
Form ring_form();

}  // namespace rubsweep::config::keys
