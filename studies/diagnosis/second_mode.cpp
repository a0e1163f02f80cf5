// second_mode DIRECTORY COUNT SEED MODES: recordings of rubs and of other causes in a two-disc rotor with
// MODES (1 or 2) bending modes in each plane. They are simulated by fixed RK4 steps, without library code and
// with another contact law. Writes NN_CAUSE.csv and its instrument NN_CAUSE.yaml. It also writes two
// descriptions of the machine: NN_CAUSE_one/machine.yaml, a Jeffcott rotor with the first mode, and
// NN_CAUSE_two/machine.yaml, matrices with both modes.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "two_mode_rotor.hpp"

namespace {

using namespace two_modes;

constexpr std::array<const char*, 7> names{"one_side", "two_sides", "annular", "annular_offset",
                                           "coupling", "whirl",     "loose"};
constexpr int steps_of_a_turn = 2048;

/// Share of the energy about the mean outside +1X and -1X.
double energy_off_1x(const std::vector<Complex>& z) {
  Complex mean = 0, forward = 0, backward = 0;
  double all = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const Complex turn = std::polar(1.0, 2 * pi * static_cast<double>(i % steps_of_a_turn) / steps_of_a_turn);
    mean += z[i];
    forward += z[i] * std::conj(turn);
    backward += z[i] * turn;
    all += std::norm(z[i]);
  }
  const auto n = static_cast<double>(z.size());
  all = all / n - std::norm(mean / n);
  return 1 - (std::norm(forward / n) + std::norm(backward / n)) / all;
}

struct Random {
  std::mt19937_64 bits;
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  double logarithmic(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
  double normal() { return std::sqrt(-2 * std::log(1 - between(0, 1))) * std::cos(2 * pi * between(0, 1)); }
};

void write_matrix(std::FILE* out, const char* name, double a, double b, double c) {
  std::fprintf(out, "  %s: |\n    %%%%MatrixMarket matrix coordinate real symmetric\n    4 4 6\n", name);
  for (int plane = 0; plane < 2; ++plane)
    std::fprintf(out, "    %d %d %.15g\n    %d %d %.15g\n    %d %d %.15g\n", plane + 1, plane + 1, a,
                 plane + 3, plane + 1, b, plane + 3, plane + 3, c);
}

void write_rest(std::FILE* out, const Setting& setting, const char* place) {
  std::fprintf(out,
               "stops:\n  - {kind: one_side, angle_deg: 90, %sclearance_m: 3.0e-4, stiffness_n_per_m: 2.0e6, "
               "restitution: 0.7, contact_radius_m: %.4g}\n"
               "kick: {force_n: 100, duration_s: 0.005}\nsweep: {speed_hz: {values: [%.6g]}, whirl_ratio: "
               "{values: [0.3]}}\noutput: {directory: out}\n",
               place, setting.radius_m, setting.speed_hz);
}

void write_machines(const std::string& stem, const Machine& machine, bool probe_at_a) {
  const Rotor& r = machine.rotor;
  for (const char* folder : {"_one", "_two"}) std::filesystem::create_directories(stem + folder);
  std::FILE* out = std::fopen((stem + "_one/machine.yaml").c_str(), "w");
  std::fprintf(out,
               "rotor: {kind: jeffcott, mass_kg: %.6g, natural_frequency_hz: %.6g, damping_ratio: %.4g}\n",
               r.mass_kg / (machine.at_a[0] * machine.at_a[0]), r.frequency_hz, r.damping);
  write_rest(out, machine.setting, "");
  std::fclose(out);
  out = std::fopen((stem + "_two/machine.yaml").c_str(), "w");
  const double c = std::cos(r.lean_rad), s = std::sin(r.lean_rad);
  std::fprintf(out, "rotor:\n  kind: matrices\n");
  write_matrix(out, "mass", r.mass_kg, 0, r.mass_kg);
  const auto write = [&](const char* name, double of_first, double of_second) {
    write_matrix(out, name, of_first * c * c + of_second * s * s, (of_first - of_second) * c * s,
                 of_first * s * s + of_second * c * c);
  };
  write("stiffness", r.mass_kg * machine.angular[0] * machine.angular[0],
        r.mass_kg * machine.angular[1] * machine.angular[1]);
  write("damping", 2 * r.mass_kg * r.damping * machine.angular[0],
        2 * r.mass_kg * r.damping_of_second * machine.angular[1]);
  std::fprintf(
      out,
      "  degrees_of_freedom: {node: [A, A, B, B], direction: [x, y, x, y], position_m: [0.3, 0.3, 0.7, "
      "0.7]}\n  unbalance: [{node: A, mass_kg: %.6g}]\n  sensors: [{position_m: %s}]\n",
      r.mass_kg, probe_at_a ? "0.3" : "0.7");
  write_rest(out, machine.setting, "position_m: 0.3, ");
  std::fclose(out);
}

/// Writes a recording as an instrument makes it: 10 kHz, 0.5 % noise, gains with 1 % error.
void write_recording(const std::string& stem, const std::vector<Complex>& z, double speed_hz, int probes,
                     Random& random) {
  std::FILE* out = std::fopen((stem + ".yaml").c_str(), "w");
  std::fprintf(out, "time: t\nkeyphasor: {column: KP, mark: dark}\nprobes:\n  - {column: X, angle_deg: 0}\n");
  if (probes == 2) std::fprintf(out, "  - {column: Y, angle_deg: 90}\n");
  std::fclose(out);
  out = std::fopen((stem + ".csv").c_str(), "w");
  std::fprintf(out, probes == 2 ? "t (s),X (um),Y (um),KP (V)\n" : "t (s),X (um),KP (V)\n");
  double size = 0;
  for (const Complex w : z) size += std::norm(w);
  const double noise = 0.005 * std::sqrt(size / static_cast<double>(z.size())),
               gain_x = 1 + 0.01 * random.normal(), gain_y = 1 + 0.01 * random.normal(), rate_hz = 1e4;
  for (int k = 0;; ++k) {
    const double t = k / rate_hz, at = t * speed_hz * steps_of_a_turn;
    const auto i = static_cast<std::size_t>(at);
    if (i + 1 >= z.size()) break;
    const double share = at - static_cast<double>(i);
    const Complex w = (1 - share) * z[i] + share * z[i + 1];
    const double turn = t * speed_hz - std::round(t * speed_hz),
                 key = -1 - 8 * std::clamp(4 - std::abs(turn) / 0.01, 0.0, 1.0);
    const double x = gain_x * w.real() + noise * random.normal(),
                 y = gain_y * w.imag() + noise * random.normal();
    std::fprintf(out, "%.6f,%.4f", t, 1e6 * x);
    if (probes == 2) std::fprintf(out, ",%.4f", 1e6 * y);
    std::fprintf(out, ",%.3f\n", key);
  }
  std::fclose(out);
}

Rotor draw_rotor(bool two_modes, Random& random) {
  Rotor rotor;
  rotor.two_modes = two_modes;
  rotor.mass_kg = random.logarithmic(1, 10);
  rotor.frequency_hz = random.between(20, 60);
  rotor.ratio = random.between(2.5, 5.5);
  rotor.damping = random.logarithmic(0.01, 0.04);
  rotor.damping_of_second = random.logarithmic(0.01, 0.04);
  rotor.lean_rad = random.between(25, 65) * pi / 180;
  return rotor;
}

Setting draw_setting(const Rotor& rotor, Cause cause, Random& random) {
  Setting setting;
  setting.cause = cause;
  do {
    setting.speed_hz = rotor.frequency_hz * random.between(1.3, 4);
  } while (std::abs(setting.speed_hz / (rotor.frequency_hz * rotor.ratio) - 1) < 0.1);
  setting.clearance_m = random.logarithmic(1e-4, 5e-4);
  setting.second_clearance = random.logarithmic(0.7, 1.43);
  setting.offset = cause == Cause::annular_offset ? random.between(0.15, 0.9) : 0;
  setting.stiffness = rotor.mass_kg * std::pow(2 * pi * rotor.frequency_hz, 2) * random.logarithmic(10, 300);
  setting.loss = random.between(0.05, 1.0) /
                 (setting.clearance_m * 2 * pi * rotor.frequency_hz);  // relative to the velocity in a rub
  setting.friction = random.between(0.02, 0.3);
  setting.angle_rad = random.between(-pi, pi);
  setting.strength = random.between(0.3, 1);
  setting.unbalance_a = 1;
  setting.unbalance_b = std::polar(random.between(0, 1), random.between(-pi, pi));
  const double quiet = std::abs(Machine(rotor, setting).quiet_at_a());
  const double wanted = setting.clearance_m * random.logarithmic(0.2, 1.5);
  setting.unbalance_a *= wanted / quiet;
  setting.unbalance_b *= wanted / quiet;
  return setting;
}

struct Run {
  std::vector<Complex> at_a, at_b;
  double deepest = 0;
};

/// Recorded turns after 300 turns of settling.
Run run_of(const Machine& machine, int turns, Random& random) {
  State state;
  const double fast = machine.setting.clearance_m * machine.angular[0] * random.logarithmic(0.5, 10);
  state.v[0] = std::polar(fast, random.between(-pi, pi));
  const double h = 1 / machine.setting.speed_hz / steps_of_a_turn;
  Run run;
  for (int k = 0; k < (300 + turns) * steps_of_a_turn; ++k) {
    if (k >= 300 * steps_of_a_turn) {
      run.at_a.push_back(machine.a(state));
      run.at_b.push_back(machine.b(state));
      run.deepest = std::max(run.deepest, machine.depth(state) / machine.setting.clearance_m);
    }
    state = stepped(machine, state, k * h, h);
    if (!(std::abs(state.q[0]) < 1)) return {};
  }
  return run;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return std::fprintf(stderr, "second_mode DIRECTORY COUNT SEED MODES\n"), 1;
  const std::string directory = argv[1];
  std::filesystem::create_directories(directory);
  const bool two_modes = std::atoi(argv[4]) == 2;
  for (int k = 0; k < std::atoi(argv[2]); ++k) {
    // Four rubs, then one of the other causes, in turn.
    const int kind = k % 5;
    const Cause cause = kind < 4 ? static_cast<Cause>(kind) : static_cast<Cause>(4 + k / 5 % 3);
    Random random{std::mt19937_64(static_cast<std::uint64_t>(std::atoi(argv[3]) * 1000 + k))};
    for (int attempt = 0; attempt < 400; ++attempt) {
      const Rotor rotor = draw_rotor(two_modes, random);
      const Setting setting = draw_setting(rotor, cause, random);
      const Machine machine(rotor, setting);
      const int turns = 64 + static_cast<int>(random.between(0, 40));
      const bool probe_at_a = random.between(0, 1) < 0.5;
      const Run run = run_of(machine, turns, random);
      const std::vector<Complex>& z = probe_at_a ? run.at_a : run.at_b;
      const bool rubs = cause <= Cause::annular_offset;
      if (z.empty() || (rubs && !(run.deepest > 0 && run.deepest < 0.5)) || energy_off_1x(z) < 0.03) continue;
      char stem[32];
      std::snprintf(stem, sizeof stem, "/%02d_%s", k, names[static_cast<std::size_t>(cause)]);
      write_machines(directory + stem, machine, probe_at_a);
      write_recording(directory + stem, z, setting.speed_hz, k % 4 == 3 ? 1 : 2, random);
      std::printf("%02d,%s,speed/f1 %.3f,f2/f1 %.3f,deepest %.3f,off 1X %.3f,attempts %d\n", k,
                  names[static_cast<std::size_t>(cause)], setting.speed_hz / rotor.frequency_hz, rotor.ratio,
                  run.deepest, energy_off_1x(z), attempt + 1);
      break;
    }
  }
}
