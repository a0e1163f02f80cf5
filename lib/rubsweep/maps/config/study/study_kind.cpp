#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "rubsweep/maps/basin/low_discrepancy.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/study/study.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::study {
namespace {

constexpr std::string_view threshold_kind = "threshold";
constexpr std::string_view basin_kind = "basin";
constexpr std::string_view map_kind = "map";
constexpr std::array kinds{threshold_kind, basin_kind, map_kind};
constexpr model::Range tolerances{.low = 1e-12, .high = 0.5};

constexpr yaml::IntegerRange sample_counts{1, 1'000'000};

sweep::ThresholdScan read_threshold(yaml::Section& section) {
  sweep::ThresholdScan scan{read_key_axis(section)};
  section.field("tolerance", scan.tolerance, tolerances);
  const std::vector<double>& values = scan.axis.values;
  const bool ascending = std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end();
  if (!values.empty() && (values.size() < 2 || !ascending)) {
    const auto* const way = section.find("values") ? "values" : section.find("step") ? "step" : "count";
    section.refuse_together(way, {"values", "from", "to", "count", "step"},
                            values.size() < 2 ? "one value is no scan" : "does not ascend",
                            "two values or more, each larger than the one before");
  }
  return scan;
}

sweep::DrawnKey read_drawn_key(const yaml::Value& value) {
  yaml::Section section(value, "{key: PATH, from, to}");
  sweep::DrawnKey drawn{{}, model::required, model::required};
  Scale scale = Scale::linear;
  if (const auto key = section.require("key", "a key of the configuration"))
    drawn.key = read_text(*key).value_or("");
  section.field("from", drawn.from, model::any_finite);
  section.field("to", drawn.to, model::any_finite);
  section.field("scale", scale, scales);
  drawn.logarithmic = scale == Scale::log;
  if (section.is_sound()) {
    if (drawn.from == drawn.to)
      section.refuse_together("to", {"from", "to"}, "is no other number than from", "another number");
    if (drawn.logarithmic && !(std::min(drawn.from, drawn.to) > 0)) {
      section.refuse_together("scale", {"from", "to", "scale"},
                              "a logarithmic scale has no place for 0 or less", "from and to > 0");
    }
  }
  return drawn;
}

sweep::BasinSampling read_basin(yaml::Section& section) {
  sweep::BasinSampling sampling;
  long samples = 0;
  if (section.require("samples", yaml::describe(sample_counts)))
    section.field("samples", samples, sample_counts);
  sampling.samples = static_cast<std::size_t>(samples);
  const auto over = section.require("over", "a list of {key: PATH, from, to}");
  if (!over) return sampling;
  std::set<std::string> taken;
  for (const yaml::Value& item : read_list(*over, basin::most_dimensions)) {
    sampling.over.push_back(read_drawn_key(item));
    const std::string& key = sampling.over.back().key;
    if (!taken.insert(key).second)
      refuse(item, fmt::format("'{}' is drawn twice", yaml::shown(key)), "every key once");
  }
  return sampling;
}

}  // namespace

void read_study_kind(const yaml::Value& value, sweep::Study& study) {
  yaml::Section section(value);
  const auto kind = section.require_kind("kind", kinds);
  if (!kind) return section.allow_unknown_keys();
  if (kinds[*kind] == threshold_kind) study.threshold = read_threshold(section);
  if (kinds[*kind] == basin_kind) study.basin = read_basin(section);
}

keys::Form study_form() {
  using namespace keys;
  const auto kind = [](std::string_view word, std::string meaning) {
    return must("kind", one_of({&word, 1}), std::move(meaning));
  };
  Form drawn =
      map_of({must("key", text(), "key that is drawn, as --set names it"),
              must("from", number({}), "one end of its interval"), must("to", number({}), "the other end"),
              may("scale", one_of(scales.texts), "evenly, or evenly in ratios", "linear")});
  return any_of(
      {map_of({kind(map_kind, "map")}),
       map_of(
           joined(
               {{kind(threshold_kind,
                      "after which numbers of a key rub goes on (threshold), where starts lead (basin), or "
                      "nothing more (map)"),
                 may("tolerance", number(tolerances),
                     "to which a beginning or an end of rub is bisected, relative to it",
                     written(sweep::ThresholdScan{}.tolerance, tolerances))},
                key_axis_keys(),
                spaced_keys({})}),
           key_axis_choices()),
       map_of({kind(basin_kind, "basin"),
               must("samples", form_of(sample_counts), "how many starts each cell is run from"),
               must("over", list_of(std::move(drawn), 1, basin::most_dimensions),
                    "box that they are drawn from, key by key")})});
}

void print_study_kind(yaml::Printer& printer, const sweep::Study& study, AxisPrint how) {
  if (study.threshold) {
    printer.open("study");
    printer.word("kind", threshold_kind);
    print_key_axis(printer, study.threshold->axis, how);
    printer.number("tolerance", study.threshold->tolerance);
    printer.close();
  }
  if (study.basin) {
    printer.open("study");
    printer.word("kind", basin_kind);
    printer.integer("samples", static_cast<long>(study.basin->samples));
    printer.open("over");
    for (const sweep::DrawnKey& drawn : study.basin->over) {
      printer.open_item();
      printer.text("key", drawn.key);
      printer.number("from", drawn.from);
      printer.number("to", drawn.to);
      if (drawn.logarithmic) printer.word("scale", "log");
      printer.close();
    }
    printer.close();
    printer.close();
  }
}

}  // namespace rubsweep::config::study
