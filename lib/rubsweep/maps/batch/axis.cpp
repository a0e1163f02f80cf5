#include "rubsweep/maps/batch/axis.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <stdexcept>

namespace rubsweep::batch {
namespace {

/// Decimal number: digits * 10^exponent.
struct Decimal {
  std::int64_t digits = 0;
  int exponent = 0;
};

/// Shortest decimal that reads back as the same finite number.
Decimal shortest_decimal(double value) {
  std::array<char, 32> written{};
  const char* end = std::to_chars(written.begin(), written.end(), value, std::chars_format::scientific).ptr;
  const char* mark = std::find<const char*>(written.begin(), end, 'e');
  std::string digits(written.cbegin(), mark);
  Decimal decimal{.exponent = std::stoi(std::string(mark + 1, end))};
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    decimal.exponent -= static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  decimal.digits = std::stoll(digits);
  return decimal;
}

/// Multiple m with number = m * 10^exponent; empty where m has too many digits. `exponent` is not larger than
/// the number's.
std::optional<std::int64_t> multiple_of(const Decimal& number, int exponent) {
  constexpr std::int64_t largest = 1'000'000'000'000'000;  // 15 digits, which a double holds
  std::int64_t multiple = number.digits;
  for (int i = number.digits == 0 ? exponent : number.exponent; i > exponent; --i) {
    if (std::abs(multiple) > largest / 10) return std::nullopt;
    multiple *= 10;
  }
  return std::abs(multiple) < largest ? std::optional(multiple) : std::nullopt;
}

/// Three numbers as integer multiples of 10^exponent.
struct Lattice {
  std::int64_t from = 0, to = 0, step = 0;
  int exponent = 0;
};

std::optional<Lattice> lattice(double from, double to, double step) {
  const std::array numbers{shortest_decimal(from), shortest_decimal(to), shortest_decimal(step)};
  int exponent = numbers[2].exponent;
  for (const Decimal& number : numbers)
    if (number.digits != 0) exponent = std::min(exponent, number.exponent);
  // Powers of ten up to this exponent are exact doubles, so that only the last multiplication or division
  // rounds.
  constexpr int largest_exact_power = 22;
  if (std::abs(exponent) > largest_exact_power) return std::nullopt;
  const auto first = multiple_of(numbers[0], exponent), last = multiple_of(numbers[1], exponent),
             size = multiple_of(numbers[2], exponent);
  if (!first || !last || !size || *size <= 0) return std::nullopt;
  return Lattice{*first, *last, *size, exponent};
}

/// Value after `steps` steps towards the end: the double nearest to its decimal.
double value_after(const Lattice& all, std::int64_t steps) {
  const auto multiple = static_cast<double>(all.from + (all.to < all.from ? -steps : steps) * all.step);
  const double power = std::pow(10.0, std::abs(all.exponent));
  return all.exponent < 0 ? multiple / power : multiple * power;
}

}  // namespace

std::optional<std::int64_t> whole_steps(double from, double to, double step) {
  const auto all = lattice(from, to, step);
  if (!all || (all->to - all->from) % all->step != 0) return std::nullopt;
  return std::abs(all->to - all->from) / all->step;
}

std::optional<std::pair<double, double>> steps_beside(double from, double to, double step) {
  const auto all = lattice(from, to, step);
  if (!all) return std::nullopt;
  const std::int64_t before = std::abs(all->to - all->from) / all->step;
  return std::pair(value_after(*all, before), value_after(*all, before + 1));
}

std::vector<double> decimal_steps(double from, double to, double step) {
  const auto count = whole_steps(from, to, step);
  if (!count) throw std::invalid_argument("decimal_steps: no whole number of steps");
  const Lattice all = *lattice(from, to, step);
  std::vector<double> values;
  for (std::int64_t i = 0; i <= *count; ++i) values.push_back(value_after(all, i));
  return values;
}

}  // namespace rubsweep::batch
