#pragma once

#include <string>
#include <string_view>

#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config {

/// Name-based UUID (version 5, SHA-1) of a text.
std::string digest_of(std::string_view text);

/// Digest of everything that decides the numbers of a map (see print_study): a name-based UUID (version 5,
/// SHA-1). Equal studies have equal digests however their files were written.
std::string study_digest(const sweep::Study& study);

}  // namespace rubsweep::config
