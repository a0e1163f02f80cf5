#pragma once

#include "rubsweep/maps/batch/captions.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::study {

/// Reads `title`, `author` and `note` of a root: texts that change no number. Refuses characters that would
/// not be shown as written: control characters (in a note all but its line ends), and those that turn the
/// direction of writing.
void read_captions(yaml::Section& root, batch::Captions& captions);

/// The keys that read_captions reads.
std::vector<keys::Key> caption_keys();

/// Prints the captions that are not empty.
void print_captions(yaml::Printer& printer, const batch::Captions& captions);

}  // namespace rubsweep::config::study
