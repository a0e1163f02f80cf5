#include "rubsweep/maps/batch/captions.hpp"

#include <sstream>

namespace rubsweep::batch {

std::string caption_lines(const Captions& captions) {
  std::string lines;
  const auto add = [&](const char* name, const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      lines.append("# ").append(name);
      if (!line.empty()) lines.append(" ").append(line);
      lines.append("\n");
    }
  };
  add("title", captions.title);
  add("author", captions.author);
  add("note", captions.note);
  return lines;
}

}  // namespace rubsweep::batch
