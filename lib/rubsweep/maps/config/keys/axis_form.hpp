#pragma once

#include "rubsweep/maps/config/keys/form.hpp"

namespace rubsweep::config::keys {

/// Values of an axis, each in this range: a number, a list, or from one to another.
Form axis(const model::Range& range);

/// The keys of values from one to another, or listed, and how they exclude each other.
std::vector<Key> spaced_keys(const model::Range& range);
Choice spaced_ways();

/// Which keys of the configuration an axis goes over.
std::vector<Key> key_axis_keys();
Choice key_axis_ways();

}  // namespace rubsweep::config::keys
