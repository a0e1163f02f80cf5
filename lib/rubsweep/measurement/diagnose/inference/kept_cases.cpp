#include "rubsweep/measurement/diagnose/inference/kept_cases.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/matlab/bytes.hpp"

namespace rubsweep::diagnose::inference {
namespace {

static_assert(std::endian::native == std::endian::little, "kept cases are little-endian");

template <class Number>
void put(std::string& bytes, Number number) {
  static_assert(std::is_arithmetic_v<Number>);
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof number);
}

std::filesystem::path file_of(const std::filesystem::path& directory, const std::string& digest) {
  return directory / (digest.substr(0, 16) + ".cases");
}

/// First line of a file: digest of the problem, then digest of the bytes that follow.
std::string head_of(const std::string& digest, std::string_view body) {
  return fmt::format("rubdiagnose cases {} {}\n", digest, batch::sha256_of(body));
}

/// Calls `pass` with each number of a case, in the order of the file.
void visit_numbers(SimulatedCase& one, auto&& pass) {
  const auto visit_lines = [&](MotionLines& lines) {
    auto* numbers = reinterpret_cast<double*>(lines.amplitude.data());
    for (Eigen::Index k = 0; k < 2 * lines.amplitude.size(); ++k) pass(numbers[k]);
  };
  response::motion::ContactFacts& facts = one.motion.contact;
  pass(one.candidate);
  for (double& place : one.unit) pass(place);
  pass(facts.hits);
  for (double* number : {&facts.contact_fraction, &facts.peak_displacement_m, &facts.peak_contact_force_n,
                         &facts.peak_casing_displacement_m, &one.motion.eccentricity_m})
    pass(*number);
  visit_lines(one.motion.lines);
  for (MotionLines& lines : one.further) visit_lines(lines);
}

/// A case whose numbers are not read yet.
SimulatedCase empty_case(const DiagnosisProblem& problem) {
  SimulatedCase one;
  one.motion.lines = {problem.turns, Eigen::VectorXcd(2 * static_cast<int>(most_order * problem.turns) + 1)};
  one.further.resize(problem.further_speeds_hz.size(), one.motion.lines);
  return one;
}

}  // namespace

double simulated_speed_hz(double speed_hz) {
  constexpr double step = 0.005;
  return std::exp(std::round(std::log(speed_hz) / step) * step);
}

std::string cases_digest(const DiagnosisProblem& problem, const CaseOptions& options) {
  std::string text = fmt::format(
      "{} {} {} {} {} {}\n{} {} {} {} {}\n", cases_version, problem.speed_hz, problem.turns, problem.seed,
      options.cases_per_candidate, options.most_draws_per_case, problem.fixed.rotor_mass_kg,
      problem.fixed.contact_radius_m, problem.fixed.casing_damping_ratio,
      problem.fixed.rotating_damping_ratio, problem.fixed.kit ? problem.fixed.kit->digest : "");
  const auto add = [&](const Spread& spread) {
    text += fmt::format(" {}:{}:{}:{}", spread.low, spread.high, spread.logarithmic, spread.at_low);
  };
  for (const double speed_hz : problem.further_speeds_hz) text += fmt::format(" {}\n", speed_hz);
  for (const Candidate& candidate : problem.candidates) {
    text += fmt::format("{}", to_string(candidate.cause));
    for (const Spread& spread : candidate.spreads) add(spread);
    add(candidate.clearance_m);
    text += '\n';
  }
  return batch::sha256_of(text);
}

void keep_cases(const std::filesystem::path& directory, const std::string& digest, const CaseSet& set) {
  std::string body;
  put(body, static_cast<std::uint64_t>(set.cases.size()));
  for (SimulatedCase one : set.cases) visit_numbers(one, [&](auto number) { put(body, number); });
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw IoError(fmt::format("{}: {}", directory.string(), error.message()));
  batch::write_whole_file(file_of(directory, digest), head_of(digest, body) + body);
}

std::optional<CaseSet> kept_cases(const std::filesystem::path& directory, const std::string& digest,
                                  const DiagnosisProblem& problem) {
  const std::filesystem::path file = file_of(directory, digest);
  if (!std::filesystem::exists(file)) return std::nullopt;
  const std::string bytes = batch::read_input(file);
  const std::size_t end = bytes.find('\n');
  if (end == std::string::npos) return std::nullopt;
  const std::string_view body = std::string_view(bytes).substr(end + 1);
  if (std::string_view(bytes).substr(0, end + 1) != head_of(digest, body)) return std::nullopt;
  try {
    matlab::Bytes numbers(body, false);
    CaseSet set;
    for (auto left = numbers.number<std::uint64_t>(); left > 0; --left)
      visit_numbers(set.cases.emplace_back(empty_case(problem)),
                    [&]<class Number>(Number& number) { number = numbers.number<Number>(); });
    if (numbers.left() == 0) return set;
  } catch (const matlab::FileError&) {
  }
  return std::nullopt;
}

}  // namespace rubsweep::diagnose::inference
