#include "ramp_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubline/line_tables.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {

using namespace ramp;

namespace {

using batch::csv_number;

std::string envelope_csv(const std::vector<EnvelopePoint>& envelope) {
  std::string text =
      "t_s,speed_hz,lowest_x_m,highest_x_m,lowest_y_m,highest_y_m,peak_displacement_m,peak_contact_force_n,"
      "hits,"
      "contact_fraction\n";
  for (const EnvelopePoint& at : envelope) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_number(at.t_s), csv_number(at.speed_hz),
                        csv_number(at.lowest_x_m), csv_number(at.highest_x_m), csv_number(at.lowest_y_m),
                        csv_number(at.highest_y_m), csv_number(at.peak_displacement_m),
                        csv_number(at.peak_contact_force_n), at.hits,
                        csv_number(std::min(1.0, at.touching_s / at.duration_s)));
  }
  return text;
}

std::string orbits_csv(const std::vector<RampOrbit>& orbits) {
  std::string text = "orbit,speed_hz,t_s,x_m,y_m\n";
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    for (const RampSample& sample : orbits[i].samples) {
      text += fmt::format("{},{},{},{},{}\n", i, csv_number(orbits[i].speed_hz), csv_number(sample.t_s),
                          csv_number(sample.displacement_m.x()), csv_number(sample.displacement_m.y()));
    }
  }
  return text;
}

std::string spectrogram_csv(const std::vector<OrderSpectrum>& spectra) {
  constexpr int last = largest_cascade_order * spectrum_turns;
  double largest_m = 0;
  for (const OrderSpectrum& at : spectra) {
    for (int k = -last; k <= last; ++k)
      if (k != 0) largest_m = std::max(largest_m, at.spectrum.amplitude(k));
  }
  const double floor_m = response::motion::significant_share_of_largest * largest_m;
  std::string text = "t_s,speed_hz,order,amplitude_m\n";
  for (const OrderSpectrum& at : spectra) {
    for (int k = -last; k <= last; ++k) {
      if (at.spectrum.amplitude(k) <= floor_m) continue;
      text += fmt::format("{},{},{},{}\n", csv_number(at.t_s), csv_number(at.speed_hz),
                          csv_number(at.spectrum.order(k)), csv_number(at.spectrum.amplitude(k)));
    }
  }
  return text;
}

std::string quasi_static_csv(std::span<const line::LinePoint> points) {
  std::string text = "speed_hz,class,order,peak_displacement_m\n";
  for (const line::LinePoint& point : points) {
    text +=
        fmt::format("{},{},{},{}\n", csv_number(point.row.speed_hz), to_string(point.row.motion_class),
                    point.row.order ? fmt::format("{}", *point.row.order) : "",
                    point.row.measures ? csv_number(point.row.measures->contact.peak_displacement_m) : "");
  }
  return text;
}

void add(std::span<const RubbingSpan> spans, const char* source, RampTables& tables) {
  for (const RubbingSpan& span : spans)
    tables.rub_csv += fmt::format("{},{},{}\n", source, csv_number(span.from_hz), csv_number(span.to_hz));
}

std::string spans_text(const char* label, const std::vector<RubbingSpan>& spans) {
  std::string text;
  for (const RubbingSpan& span : spans)
    text += (text.empty() ? "" : ", ") + model::speed_range_text(span.from_hz, span.to_hz, 5);
  return fmt::format("{:<9} {}\n", label, text.empty() ? "nowhere" : text);
}

}  // namespace

std::vector<RubbingSpan> rubbing_spans(std::span<const line::LinePoint> points) {
  std::vector<RubbingSpan> spans;
  bool rubbed = false;
  for (const line::LinePoint& point : points) {
    const bool rubs = row_of(point.row.motion_class).rubs && point.row.measures &&
                      point.row.measures->contact.contact_fraction > 0;
    if (rubs && !rubbed) spans.push_back({point.row.speed_hz, 0});
    if (rubs) spans.back().to_hz = point.row.speed_hz;
    rubbed = rubs;
  }
  return spans;
}

RampTables tables_of(const RampRecord& record, std::span<const line::LinePoint> quasi_static,
                     const model::ShownLengths& shown) {
  RampTables tables{.envelope_csv = envelope_csv(record.envelope()),
                    .orbits_csv = orbits_csv(record.orbits()),
                    .spectrogram_csv = spectrogram_csv(record.spectra()),
                    .quasi_static_csv = quasi_static_csv(quasi_static),
                    .rub_csv = "source,from_hz,to_hz\n",
                    .summary = {}};
  const std::vector<RubbingSpan> spans = record.rubbing_spans(), steady = rubbing_spans(quasi_static);
  add(spans, "ramp", tables);
  add(steady, "quasi_static", tables);
  double peak_m = 0, peak_hz = 0, force_n = 0;
  for (const EnvelopePoint& at : record.envelope()) {
    if (at.peak_displacement_m > peak_m) peak_hz = at.speed_hz;
    peak_m = std::max(peak_m, at.peak_displacement_m);
    force_n = std::max(force_n, at.peak_contact_force_n);
  }
  tables.summary = fmt::format("peak      {} at {}, largest contact force {:.4g} N\n",
                               model::length_text(peak_m, shown, model::LengthUnit::m),
                               model::speed_text(peak_hz, 5), force_n) +
                   spans_text("rubs", spans) + spans_text("steadily", steady);
  return tables;
}

}  // namespace rubsweep::apps
