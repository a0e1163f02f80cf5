#include "motion_summary.hpp"

#include <fmt/format.h>

#include <cmath>

#include "rubsweep/core/model/speed_text.hpp"

namespace rubsweep::apps {
namespace {

std::string number_or_none(double value) { return std::isnan(value) ? "none" : fmt::format("{:.6g}", value); }

std::string length_or_none(double length_m, const model::ShownLengths& shown) {
  return std::isnan(length_m) ? "none" : model::length_text(length_m, shown, model::LengthUnit::m, 6);
}

std::string motion_text(const sweep::Row& row) {
  std::string text(to_string(row.motion_class));
  if (row.order && *row.order > 1) text += fmt::format(" 1/{}", *row.order);
  if (row.measures && row.measures->orbit) text += fmt::format(", {} orbit", to_string(*row.measures->orbit));
  if (row.measures && row.measures->whirl) text += fmt::format(", {} whirl", to_string(*row.measures->whirl));
  if (row.proof == response::motion::Proof::rest)
    text += fmt::format(", rest proven after {} revolutions", row.revolutions);
  if (row.proof == response::motion::Proof::observed)
    text += fmt::format(", observed after {} revolutions", row.revolutions);
  if (row.survival) {
    text += fmt::format(", lasts {:.3g} revolutions or more in the mean (95 %, {} of its companions escaped)",
                        row.survival->least_mean_life(), row.survival->escapes);
  }
  if (row.status != "ok") text += ", status " + row.status;
  return text;
}

}  // namespace

std::string motion_summary(const sweep::Row& row, const model::ShownLengths& shown) {
  return fmt::format("cell      {}, whirl ratio {}, eccentricity {}\nmotion    {}\n",
                     model::speed_text(row.speed_hz), number_or_none(row.whirl_ratio),
                     length_or_none(row.eccentricity_m, shown), motion_text(row));
}

}  // namespace rubsweep::apps
