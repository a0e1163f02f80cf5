#pragma once

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

/// Files in the formats of instruments, written by independent code. The readers of the library are tested
/// with these files.
namespace rubsweep::recording::files {

/// Readings of two probes at 1 kHz of a shaft that turns 25 times a second.
struct Signals {
  std::vector<double> x, y;
};

inline Signals signals(int count) {
  Signals all;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * 25 * k / 1000.0;
    all.x.push_back(60 * std::cos(angle) + 5);
    all.y.push_back(60 * std::sin(angle) + 2);
  }
  return all;
}

/// Collects the bytes of numbers, with the least or the most significant byte first.
class Bytes {
 public:
  explicit Bytes(bool big = false) : big_(big) {}

  Bytes& add(std::uint64_t number, int bytes) {
    for (int k = 0; k < bytes; ++k)
      text += static_cast<char>(number >> (8 * (big_ ? bytes - 1 - k : k)) & 0xff);
    return *this;
  }
  Bytes& add(double number) { return add(std::bit_cast<std::uint64_t>(number), 8); }
  Bytes& add(float number) { return add(std::bit_cast<std::uint32_t>(number), 4); }

  std::string text;

 private:
  bool big_;
};

/// Format of the numbers in a data set 58 of a universal file.
struct UniversalForm {
  int ordinate = 4;  ///< 2: single precision, 4: double
  bool even = true;
  int function = 1;  ///< 1: time history
  int direction = 1;
};

inline std::string universal_head(std::string_view name, std::size_t points, const UniversalForm& form) {
  std::string text = fmt::format("{:<80}\nNONE\n12-Mar-24 10:15:30\nNONE\nNONE\n", name);
  text += fmt::format("{:5}{:10}{:5}{:10} {:<10}{:10}{:4} {:<10}{:10}{:4}\n", form.function, 0, 0, 0, "NONE",
                      7, form.direction, "NONE", 0, 0);
  text += fmt::format("{:10}{:10}{:10}{:13.5e}{:13.5e}{:13.5e}\n", form.ordinate, points, form.even ? 1 : 0,
                      0.5, form.even ? 0.001 : 0, 0.0);
  text += fmt::format("{:10}{:5}{:5}{:5} {:<20} {:<20}\n", 17, 0, 0, 0, "Time", "s");
  text += fmt::format("{:10}{:5}{:5}{:5} {:<20} {:<20}\n", 8, 0, 0, 0, "Displacement", "um");
  const std::string none = fmt::format("{:10}{:5}{:5}{:5} {:<20} {:<20}\n", 0, 0, 0, 0, "NONE", "NONE");
  return text + none + none;
}

inline std::string universal_set(std::string_view name, const std::vector<double>& values,
                                 const UniversalForm& form = {}) {
  std::string text = "    -1\n    58\n" + universal_head(name, values.size(), form);
  int in_line = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!form.even) text += fmt::format("{:13.5e}", 0.5 + 0.001 * static_cast<double>(k));
    text += form.ordinate == 2 ? fmt::format("{:13.5e}", values[k]) : fmt::format("{:20.12e}", values[k]);
    if (++in_line == (form.even && form.ordinate == 2 ? 6 : 2) || k + 1 == values.size()) {
      text += '\n';
      in_line = 0;
    }
  }
  return text + "    -1\n";
}

/// The same data set with binary numbers. If the clock is uneven, times have four bytes.
inline std::string binary_universal_set(std::string_view name, const std::vector<double>& values, bool big,
                                        const UniversalForm& form = {}) {
  Bytes numbers(big);
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!form.even) numbers.add(static_cast<float>(0.5 + 0.001 * static_cast<double>(k)));
    if (form.ordinate == 2)
      numbers.add(static_cast<float>(values[k]));
    else
      numbers.add(values[k]);
  }
  const std::string first = fmt::format("{:6}b{:6}{:6}{:12}{:12}{:6}{:6}{:12}{:12}\n", 58, big ? 2 : 1, 2, 11,
                                        numbers.text.size(), 0, 0, 0, 0);
  return "    -1\n" + first + universal_head(name, values.size(), form) + numbers.text + "\n    -1\n";
}

/// A text in a TDMS file; numbers have the least significant byte first.
inline std::string tdms_text(std::string_view words) {
  return Bytes().add(words.size(), 4).text + std::string(words);
}
inline std::string tdms_object(std::string_view path, const std::string& index, const std::string& properties,
                               std::uint32_t count) {
  return tdms_text(path) + index + Bytes().add(count, 4).text + properties;
}
inline std::string tdms_index(std::uint32_t type, std::uint64_t count) {
  return Bytes().add(20, 4).add(type, 4).add(1, 4).add(count, 8).text;
}
inline std::string tdms_clock(double step_s) {
  return tdms_text("wf_increment") + Bytes().add(10, 4).add(step_s).text + tdms_text("unit_string") +
         Bytes().add(0x20, 4).text + tdms_text("um");
}
inline std::string tdms_segment(std::uint32_t contents, const std::string& metadata, const std::string& raw) {
  return "TDSm" +
         Bytes()
             .add(contents, 4)
             .add(4713, 4)
             .add(metadata.size() + raw.size(), 8)
             .add(metadata.size(), 8)
             .text +
         metadata + raw;
}
inline constexpr std::uint32_t tdms_whole = 0x0e, tdms_raw = 0x08, tdms_interleaved = 0x20, tdms_daqmx = 0x80;

inline const std::string tdms_no_data = Bytes().add(0xffffffff, 4).text;

/// Metadata of a file, a group and two channels of doubles, with `count` readings in a chunk.
inline std::string tdms_metadata(std::size_t count) {
  return Bytes().add(4, 4).text + tdms_object("/", tdms_no_data, "", 0) +
         tdms_object("/'run'", tdms_no_data, "", 0) +
         tdms_object("/'run'/'X'", tdms_index(10, count), tdms_clock(0.001), 2) +
         tdms_object("/'run'/'Y''s'", tdms_index(10, count), tdms_clock(0.001), 2);
}

inline std::string tdms_chunk(const Signals& all, std::size_t first, std::size_t end) {
  Bytes raw;
  for (std::size_t k = first; k < end; ++k) raw.add(all.x[k]);
  for (std::size_t k = first; k < end; ++k) raw.add(all.y[k]);
  return raw.text;
}

/// Head of a LabVIEW measurement file, up to the head of its first segment.
inline std::string labview_head(std::string_view columns, char separator = '\t') {
  std::string text =
      "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\n"
      "Decimal_Separator\t.\nMulti_Headings\tYes\nX_Columns\t" +
      std::string(columns) +
      "\nTime_Pref\tRelative\nDate\t2024/03/12\nTime\t10:15:30.123\n***End_of_Header***\t\n\t\n";
  for (char& c : text)
    if (c == '\t') c = separator;
  return text;
}

/// A segment of two signals, whose clock begins at a time of day; `row` writes one row.
template <class Row>
std::string labview_segment(std::size_t count, std::string_view time, std::string_view names,
                            const Row& row) {
  std::string text = fmt::format(
      "Channels\t2\t\t\nSamples\t{0}\t{0}\t\nDate\t2024/03/12\t2024/03/12\t\nTime\t{1}\t{1}\t\n"
      "Y_Unit_Label\tum\tVolts\t\nX_Dimension\tTime\tTime\t\nX0\t0.0E+0\t0.0E+0\t\n"
      "Delta_X\t0.001000\t0.001000\t\n***End_of_Header***\t\t\t\n{2}\n",
      count, time, names);
  for (std::size_t k = 0; k < count; ++k) text += row(k) + '\n';
  return text + '\n';
}

}  // namespace rubsweep::recording::files
