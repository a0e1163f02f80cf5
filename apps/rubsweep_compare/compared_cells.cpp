#include "compared_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "rubsweep/maps/batch/table_file.hpp"

namespace rubsweep::apps {
namespace {

std::string_view word_of(CellVerdict verdict) {
  using enum CellVerdict;
  switch (verdict) {
    case equal: return "equal";
    case sensitive: return "sensitive";
    case numbers_differ: return "numbers_differ";
    case classes_differ: return "classes_differ";
    case only_in_one: return "only_in_one";
  }
  return "";
}

/// File name without line breaks, for the comments at the begin of a table.
std::string line_of(const std::filesystem::path& path) {
  std::string text = path.string();
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
  return text;
}

}  // namespace

void write_compared_cells(const std::filesystem::path& file, const MapComparison& comparison,
                          const std::filesystem::path& a, const std::filesystem::path& b, double tolerance) {
  std::string text = fmt::format("# a {}\n# b {}\n# tolerance {:g}\nspeed_hz,{}", line_of(a), line_of(b),
                                 tolerance, comparison.axis);
  for (const std::string& key : comparison.keys) text += "," + key;
  text += ",verdict,label_a,label_b\n";
  for (const ComparedCell& cell : comparison.cells) {
    text += fmt::format("{},{}", cell.speed_hz, cell.unbalance);
    for (const double key : cell.keys) text += fmt::format(",{}", key);
    text += fmt::format(",{},{},{}\n", word_of(cell.verdict), cell.label_a, cell.label_b);
  }
  batch::TableFile table(file,
                         {fmt::format("rubsweep-compare {}", RUBSWEEP_VERSION), comparison.digest_a, {}});
  table.write(text);
  table.commit();
}

}  // namespace rubsweep::apps
