#pragma once

#include <string>

namespace rubsweep::batch {

/// Remarks of a person on a configuration, beside its numbers: shown, and part of no digest. UTF-8 without
/// control characters, but line ends in the note.
struct Captions {
  std::string title{}, author{}, note{};

  bool operator==(const Captions&) const = default;
};

/// Comment lines for the head of a table, each with its end: `# title T`, `# author A`, and one `# note N`
/// for every line of the note. Empty where nothing is said.
std::string caption_lines(const Captions& captions);

}  // namespace rubsweep::batch
