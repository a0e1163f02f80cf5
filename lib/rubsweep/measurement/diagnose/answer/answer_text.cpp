#include "rubsweep/measurement/diagnose/answer/answer_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "rubsweep/core/error.hpp"

namespace rubsweep::diagnose::answer {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

/// Rounded percentage, such as "93 %"; "under 1 %" for very small probabilities.
std::string percent(double probability) {
  if (probability < 0.005) return "under 1 %";
  if (probability > 0.995) return "over 99 %";
  return fmt::format("{:.0f} %", 100 * probability);
}

std::string sureness(double probability) {
  if (probability >= 0.9) return "sure";
  if (probability >= 0.7) return "likely";
  if (probability >= 0.5) return "more likely than all others together";
  return "not decided";
}

std::string probability_line(const std::string& name, double probability,
                             const std::optional<double>& standard_error) {
  std::string text = fmt::format("  {:<22} {}", name, percent(probability));
  if (standard_error) text += fmt::format(" +- {:.0f} %", std::ceil(100 * *standard_error));
  return text + '\n';
}

std::string first_line(const Answer& answer) {
  if (answer.clipped) return "none of these can be told: a probe is clipped, and shows what no rotor does\n";
  const CandidateAnswer& first = answer.candidates.front();
  if (answer.none > first.probability)
    return fmt::format(
        "none of these, {} ({}): no simulated motion {} the recording\n", percent(answer.none),
        sureness(answer.none),
        answer.size_fits ? "resembles" : "of these clearances and this unbalance is as large as");
  return fmt::format("{}, {} ({}): {}\n", first.name, percent(first.probability), sureness(first.probability),
                     words_for(first.cause));
}

/// Whether the interval of an angle contains no information: the 95 % interval of a uniform distribution is
/// 342 degrees wide.
bool is_any_direction(const NumberInterval& angle_deg) {
  constexpr double nearly_all_deg = 320;
  const double arc_deg = angle_deg.high_95 - angle_deg.low_95;
  return arc_deg - 360 * std::floor(arc_deg / 360) > nearly_all_deg;
}

std::string number_text(const NumberInterval& number, const model::ShownLengths& shown) {
  const std::string_view name = number.name;
  const auto values = [&](auto text) {
    return fmt::format("{}, 95 % from {} to {}", text(number.median), text(number.low_95),
                       text(number.high_95));
  };
  const std::string what(name.substr(0, name.rfind('_')));
  if (name == "position_m")
    return fmt::format("  {:<22} {}\n", what, values([](double x) { return fmt::format("{:.3g} m", x); }));
  if (name.ends_with("_m") && !name.ends_with("per_m"))
    return fmt::format("  {:<22} {}\n", what, values([&](double x) {
                         return model::length_text(x, shown, model::LengthUnit::um, 3);
                       }));
  if (name.ends_with("_deg") && is_any_direction(number))
    return fmt::format("  {:<22} any direction\n", what);
  if (name.ends_with("_deg"))
    return fmt::format("  {:<22} {}\n", what, values([](double x) { return fmt::format("{:.0f} deg", x); }));
  return fmt::format("  {:<22} {}\n", name, values([](double x) { return fmt::format("{:.3g}", x); }));
}

std::string trust_line(const Answer& answer) {
  std::string text =
      fmt::format("  {} simulated motions; +-: standard errors for want of motions\n", answer.cases);
  if (answer.interrupted) text += "  interrupted: an answer by the motions simulated so far\n";
  const long as_far = std::lround(100 * answer.p_value);
  return text + fmt::format("  of 100 simulated recordings {} {} as far from all others as this one{}\n",
                            as_far, as_far == 1 ? "lies" : "lie",
                            inference::evidence_power_of(answer.p_value) < 1 && answer.none < 0.5
                                ? ": the answer is less sure for it"
                                : "");
}

/// Signs of other causes; a rub that is more likely than all others together has no need of them.
std::string signs_text(const Answer& answer) {
  const CandidateAnswer& first = answer.candidates.front();
  const bool rubs = first.cause != Cause::no_rub && first.probability >= 0.5;
  if (answer.signs.empty() || rubs) return {};
  std::string text = "\nother causes with such lines, and the share of the energy off 1X in them\n";
  for (const ForeignSign& sign : answer.signs)
    text += fmt::format("  {:<22} {} at {:.3g}X: {}\n", to_string(sign.cause), percent(sign.share),
                        sign.order, words_for(sign.cause));
  return text;
}

}  // namespace

std::string probabilities_csv(const Answer& answer) {
  std::string text = "candidate,probability\n";
  for (const CandidateAnswer& candidate : answer.candidates)
    text += fmt::format("{},{:.6g}\n", candidate.name, candidate.probability);
  return text + fmt::format("none_of_these,{:.6g}\n", answer.none);
}

std::string orbits_csv(const Answer& answer, const MotionLines& recorded, bool plane) {
  constexpr int points_of_a_turn = 64, most_turns = 12;
  if (answer.best.empty()) return {};
  std::string text = plane ? "turns,x_m,y_m,simulated_x_m,simulated_y_m\n" : "turns,x_m,simulated_x_m\n";
  response::spectrum::SpectrumWorkspace workspace;
  const Eigen::VectorXcd seen = waveform_of(recorded, points_of_a_turn, workspace);
  const Eigen::VectorXcd simulated =
      waveform_of(answer.best.front().overlay.simulated, points_of_a_turn, workspace);
  const auto count = Eigen::Index{points_of_a_turn} * std::min(recorded.turns, most_turns);
  for (Eigen::Index k = seen.size() - count; k < seen.size(); ++k) {
    const double turns = static_cast<double>(k) / points_of_a_turn;
    text += plane ? fmt::format("{:.6f},{:.7g},{:.7g},{:.7g},{:.7g}\n", turns, seen(k).real(), seen(k).imag(),
                                simulated(k).real(), simulated(k).imag())
                  : fmt::format("{:.6f},{:.7g},{:.7g}\n", turns, seen(k).real(), simulated(k).real());
  }
  return text;
}

std::string compared_lines_csv(const Answer& answer, const MotionLines& recorded) {
  if (answer.best.empty()) return {};
  constexpr double visible = 1e-3;
  std::string text = "order,recorded_m,simulated_m\n";
  const MotionLines& simulated = answer.best.front().overlay.simulated;
  double largest = 0;
  for (int k = -recorded.last(); k <= recorded.last(); ++k)
    if (k != 0) largest = std::max(largest, std::abs(recorded.at(k)));
  for (int k = -recorded.last(); k <= recorded.last(); ++k) {
    const double a = std::abs(recorded.at(k)), b = std::abs(simulated.at(k));
    if (k != 0 && std::max(a, b) > visible * largest)
      text += fmt::format("{:.6g},{:.7g},{:.7g}\n", static_cast<double>(k) / recorded.turns, a, b);
  }
  return text;
}

std::string answer_json(const Answer& answer) {
  Json root;
  const RecordingFacts& recording = answer.recording;
  root["recording"] = {{"name", recording.name},     {"speed_hz", recording.speed_hz},
                       {"turns", recording.turns},   {"probes", recording.probes},
                       {"size_m", recording.size_m}, {"findings", recording.findings}};
  root["candidates"] = Json::array();
  for (const CandidateAnswer& candidate : answer.candidates) {
    Json numbers = Json::object();
    for (const NumberInterval& number : candidate.numbers)
      numbers[number.name] = {
          {"median", number.median}, {"low_95", number.low_95}, {"high_95", number.high_95}};
    root["candidates"].push_back({{"name", candidate.name},
                                  {"cause", to_string(candidate.cause)},
                                  {"probability", candidate.probability},
                                  {"standard_error", number_or_null(candidate.standard_error)},
                                  {"numbers", numbers}});
  }
  root["none_of_these"] = {{"probability", answer.none},
                           {"standard_error", number_or_null(answer.none_standard_error)},
                           {"p_value", answer.p_value},
                           {"clipped", answer.clipped}};
  root["simulations"] = {{"motions", answer.cases}, {"interrupted", answer.interrupted}};
  root["deciding_features"] = Json::array();
  for (const DecidingFeature& feature : answer.deciding)
    root["deciding_features"].push_back({{"name", feature.name},
                                         {"recorded", feature.recorded},
                                         {"first", feature.first},
                                         {"first_spread", feature.first_spread},
                                         {"second", feature.second},
                                         {"second_spread", feature.second_spread}});
  root["best_motions"] = Json::array();
  for (const BestMotion& motion : answer.best)
    root["best_motions"].push_back(
        {{"candidate", motion.candidate}, {"unexplained", motion.overlay.unexplained}});
  root["other_causes"] = Json::array();
  for (const ForeignSign& sign : answer.signs)
    root["other_causes"].push_back(
        {{"cause", to_string(sign.cause)}, {"share_off_1x", sign.share}, {"order", sign.order}});
  root["next_measurements"] = Json::array();
  for (const inference::NextMeasurement& next : answer.next)
    root["next_measurements"].push_back({{"name", next.name}, {"information_bits", next.information_bits}});
  return root.dump(2) + '\n';
}

std::string_view words_for(Cause cause) {
  switch (cause) {
    case Cause::no_rub: return "the rotor touches nothing";
    case Cause::one_side: return "it rubs on one flat stop";
    case Cause::two_sides: return "it rubs on two flat stops that face each other";
    case Cause::annular: return "it rubs on a round stop about the rest position";
    case Cause::annular_offset: return "it rubs on a round stop whose centre is off the rest position";
  }
  throw SolverError("cause: no such enumerator");
}

std::string answer_text(const Answer& answer, const model::ShownLengths& shown) {
  std::string text = first_line(answer);
  const RecordingFacts& recording = answer.recording;
  text += fmt::format("\nrecording {}: {} turns at {:.4g} Hz ({:.0f} rpm), {}, {} root mean square\n",
                      recording.name, recording.turns, recording.speed_hz, 60 * recording.speed_hz,
                      recording.probes == 2 ? "two probes" : "one probe",
                      model::length_text(recording.size_m, shown, model::LengthUnit::um, 3));
  for (const std::string& finding : recording.findings) text += fmt::format("  {}\n", finding);
  text += "\nprobabilities\n";
  for (const CandidateAnswer& candidate : answer.candidates)
    text += probability_line(candidate.name, candidate.probability, candidate.standard_error);
  text += probability_line("none of these", answer.none, answer.none_standard_error);
  text += trust_line(answer);
  text += signs_text(answer);
  const CandidateAnswer& first = answer.candidates.front();
  if (!answer.clipped && !first.numbers.empty()) {
    text += fmt::format("\nif it is {}\n", first.name);
    for (const NumberInterval& number : first.numbers) text += number_text(number, shown);
  }
  if (!answer.deciding.empty()) {
    text += fmt::format("\nwhat speaks for {} and against {}: recorded, and usual in the one and the other\n",
                        first.name, answer.candidates[1].name);
    for (const DecidingFeature& feature : answer.deciding)
      text +=
          fmt::format("  {:<42} {:.3g}; {:.3g} +- {:.2g}; {:.3g} +- {:.2g}\n", feature.name, feature.recorded,
                      feature.first, feature.first_spread, feature.second, feature.second_spread);
  }
  if (!answer.best.empty())
    text += fmt::format("\nclosest simulated motion, of {}: leaves {} of the recorded energy\n",
                        answer.best.front().candidate, percent(answer.best.front().overlay.unexplained));
  if (!answer.next.empty()) {
    text += "\na further measurement is expected to tell\n";
    for (const inference::NextMeasurement& next : answer.next)
      text += fmt::format("  {:<30} {:.2f} bits\n", next.name, next.information_bits);
  }
  return text;
}

}  // namespace rubsweep::diagnose::answer
