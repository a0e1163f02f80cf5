#include "rubsweep/measurement/diagnose/answer/answer_json.hpp"

#include <nlohmann/json.hpp>

namespace rubsweep::diagnose::answer {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

}  // namespace

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
  root["simulations"] = {{"motions", answer.cases},
                         {"rounds", answer.rounds},
                         {"stands_still", answer.stands_still},
                         {"interrupted", answer.interrupted}};
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
  root["next_measurements"] = Json::array();
  for (const inference::NextMeasurement& next : answer.next)
    root["next_measurements"].push_back({{"name", next.name}, {"information_bits", next.information_bits}});
  return root.dump(2) + '\n';
}

}  // namespace rubsweep::diagnose::answer
