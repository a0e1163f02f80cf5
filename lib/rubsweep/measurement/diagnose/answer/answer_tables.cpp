#include "rubsweep/measurement/diagnose/answer/answer_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace rubsweep::diagnose::answer {

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
  const Eigen::Index count = points_of_a_turn * std::min(recorded.turns, most_turns);
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

}  // namespace rubsweep::diagnose::answer
