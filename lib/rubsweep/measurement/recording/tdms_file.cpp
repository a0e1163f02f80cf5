#include "rubsweep/measurement/recording/tdms_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/matlab/bytes.hpp"
#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::recording {
namespace {

using matlab::Bytes;
using matlab::FileError;
using matlab::Stored;

constexpr std::size_t most_tdms_channels = 4096, most_tdms_numbers = std::size_t{1} << 27;
constexpr const char* allowed_file = "a whole TDMS file";
constexpr const char* allowed_daqmx =
    "numbers that are scaled already, as LabVIEW, DIAdem and nptdms write them again";

/// Bits that tell the contents of a segment.
constexpr std::uint32_t has_metadata = 1u << 1, begins_new_list = 1u << 2, has_raw_data = 1u << 3,
                        is_interleaved = 1u << 5, is_big_endian = 1u << 6, has_daqmx = 1u << 7;
constexpr std::uint32_t text_type = 0x20, stamp_type = 0x44, no_data = 0xffffffff, as_before = 0;

[[noreturn]] void refuse(const std::string& wrong, const char* allowed = allowed_file) {
  throw FileError{wrong, allowed};
}

/// Type of values, with its code in the file.
struct Kind {
  std::uint32_t code = 0;
  std::size_t bytes = 0;
  std::optional<Stored> stored{};  ///< empty: complex numbers, time stamps
};

using enum Stored;
constexpr std::array<Kind, 16> kinds{{{0x01, 1, int8},
                                      {0x02, 2, int16},
                                      {0x03, 4, int32},
                                      {0x04, 8, int64},
                                      {0x05, 1, uint8},
                                      {0x06, 2, uint16},
                                      {0x07, 4, uint32},
                                      {0x08, 8, uint64},
                                      {0x09, 4, float32},
                                      {0x19, 4, float32},
                                      {0x0a, 8, float64},
                                      {0x1a, 8, float64},
                                      {0x21, 1, uint8},
                                      {stamp_type, 16},
                                      {0x08000c, 8},
                                      {0x10000d, 16}}};

/// The kind with this code; zero bytes for text and unknown types.
Kind kind_of(std::uint32_t type) {
  const auto kind = std::ranges::find(kinds, type, &Kind::code);
  return kind == kinds.end() ? Kind{} : *kind;
}
std::optional<Stored> stored_as(std::uint32_t type) { return kind_of(type).stored; }
std::size_t bytes_of(std::uint32_t type) { return kind_of(type).bytes; }

/// A group, a channel or the file itself.
struct Object {
  std::string group{}, name{};
  std::uint32_t type = 0;
  std::size_t count = 0, chunk_bytes = 0;  ///< sizes of the next chunk
  bool has_index = false, here = false;    ///< `here`: the present segment has data of this object
  bool has_scales = false, is_scaled = false;
  std::vector<double> values{};
  std::optional<std::int64_t> first_stamp_s{};
  std::optional<double> increment_s{};
  std::string unit{};

  bool is_signal() const { return stored_as(type).has_value() || type == stamp_type; }
};

std::string take_text(Bytes& in) { return std::string(in.take(in.number<std::uint32_t>())); }

/// Parts of a path, which are quoted and separated by slashes.
std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] != '\'') continue;
    parts.emplace_back();
    for (++i; i < path.size() && (path[i] != '\'' || (i + 1 < path.size() && path[i + 1] == '\'')); ++i) {
      parts.back() += path[i];
      if (path[i] == '\'') ++i;
    }
  }
  return parts;
}

void take_property(Bytes& in, Object& object) {
  const std::string name = take_text(in);
  const auto type = in.number<std::uint32_t>();
  if (type == text_type) {
    const std::string text = take_text(in);
    if (name == "unit_string" || (name == "NI_UnitDescription" && object.unit.empty())) object.unit = text;
    if (name == "NI_Scaling_Status") object.is_scaled = text == "scaled";
    return;
  }
  const std::size_t size = bytes_of(type);
  if (size == 0) refuse(fmt::format("has a property '{}' of the unknown type {}", name, type));
  Bytes value(in.take(size), in.swapped());
  if (!stored_as(type)) return;
  const double number = matlab::take_numbers(value, *stored_as(type), 1).front();
  if (name == "wf_increment" && std::isnormal(number)) object.increment_s = number;
  if (name == "NI_Number_Of_Scales") object.has_scales = number > 0;
}

class Reader {
 public:
  void read(std::string_view bytes) {
    while (!bytes.empty()) read_segment(bytes);
  }

  std::vector<Object> objects{};
  bool unfinished = false;  ///< the last segment was not closed, or its last chunk is incomplete

 private:
  void read_segment(std::string_view& bytes) {
    constexpr std::size_t lead_in = 28;
    constexpr bool here_little = std::endian::native == std::endian::little;
    if (!bytes.starts_with("TDSm") || bytes.size() < lead_in) refuse("is damaged: a segment does not begin");
    const auto contents = Bytes(bytes.substr(4, 4), !here_little).number<std::uint32_t>();
    const bool swapped = ((contents & is_big_endian) != 0) == here_little;
    Bytes head(bytes.substr(12, 16), swapped);
    auto next = head.number<std::uint64_t>();
    const auto raw = head.number<std::uint64_t>();
    bytes.remove_prefix(lead_in);
    if (next == std::numeric_limits<std::uint64_t>::max()) {  // the writing program did not close the segment
      next = bytes.size();
      unfinished = true;
    }
    if (next > bytes.size() || raw > next) refuse("breaks off");
    if ((contents & has_daqmx) != 0) refuse("holds raw data of DAQmx", allowed_daqmx);
    if ((contents & has_metadata) != 0 && (contents & begins_new_list) != 0) active_.clear();
    if ((contents & has_metadata) != 0) read_metadata(Bytes(bytes.substr(0, raw), swapped));
    if ((contents & has_raw_data) != 0)
      read_chunks(bytes.substr(raw, next - raw), swapped, (contents & is_interleaved) != 0);
    bytes.remove_prefix(next);
  }

  void read_metadata(Bytes in) {
    for (auto left = in.number<std::uint32_t>(); left > 0; --left) {
      const std::string path = take_text(in);
      const auto [found, added] = place_of_.try_emplace(path, objects.size());
      if (added) {
        const auto parts = parts_of(path);
        objects.push_back(
            {.group = parts.empty() ? "" : parts[0], .name = parts.size() == 2 ? parts[1] : ""});
        if (objects.size() > most_tdms_channels)
          refuse(fmt::format("has more than {} channels", most_tdms_channels), "fewer");
      }
      Object& object = objects[found->second];
      read_index(in, object);
      const bool listed = std::ranges::find(active_, found->second) != active_.end();
      if (object.here && object.chunk_bytes > 0 && !listed) active_.push_back(found->second);
      for (auto count = in.number<std::uint32_t>(); count > 0; --count) take_property(in, object);
    }
  }

  static void read_index(Bytes& in, Object& object) {
    constexpr std::uint32_t format_scaler = 0x1269, digital_scaler = 0x1369;
    const auto length = in.number<std::uint32_t>();
    if (length == format_scaler || length == digital_scaler) refuse("holds raw data of DAQmx", allowed_daqmx);
    object.here = length != no_data;
    if (length == as_before && !object.has_index) refuse("is damaged: a channel without its kind");
    if (length == no_data || length == as_before) return;
    const auto type = in.number<std::uint32_t>(), dimension = in.number<std::uint32_t>();
    const auto count = in.number<std::uint64_t>();
    const std::size_t size = bytes_of(type);
    if (dimension != 1 || (size == 0 && type != text_type))
      refuse(fmt::format("has a channel '{}' of the unknown type {}", object.name, type));
    if (object.has_index && object.type != type && !object.values.empty())
      refuse(fmt::format("changes the type of '{}'", object.name));
    if (count > most_tdms_numbers)
      refuse(fmt::format("holds more than {} numbers", most_tdms_numbers), "fewer");
    object.type = type;
    object.has_index = true;
    object.count = static_cast<std::size_t>(count);
    object.chunk_bytes =
        type == text_type ? static_cast<std::size_t>(in.number<std::uint64_t>()) : size * object.count;
  }

  void read_chunks(std::string_view raw, bool swapped, bool interleaved) {
    std::vector<Object*> with_data;
    std::size_t chunk = 0;
    for (const std::size_t place : active_) {
      Object& object = objects[place];
      if (!object.here || object.chunk_bytes == 0) continue;
      if (object.chunk_bytes > raw.size()) refuse("breaks off");
      chunk += object.chunk_bytes;
      with_data.push_back(&object);
    }
    if (with_data.empty()) return;
    if (interleaved && std::ranges::any_of(with_data, [&](const Object* one) {
          return one->count != with_data.front()->count || one->type == text_type;
        }))
      refuse("is damaged: interleaved channels of different lengths");
    while (raw.size() >= chunk) {
      Bytes in(raw.substr(0, chunk), swapped);
      for (std::size_t k = 0; k < (interleaved ? with_data.front()->count : 1); ++k)
        for (Object* object : with_data) take_values(in, *object, interleaved ? 1 : object->count);
      raw.remove_prefix(chunk);
    }
    unfinished = unfinished || !raw.empty();
  }

  void take_values(Bytes& in, Object& object, std::size_t count) {
    if (object.type == stamp_type) {
      for (std::size_t k = 0; k < count; ++k) object.values.push_back(take_stamp(in, object));
    } else if (const auto stored = stored_as(object.type)) {
      const std::vector<double> values = matlab::take_numbers(in, *stored, count);
      object.values.insert(object.values.end(), values.begin(), values.end());
    } else {
      in.take(object.type == text_type ? object.chunk_bytes : count * bytes_of(object.type));
    }
    numbers_ += count;
    if (numbers_ > most_tdms_numbers)
      refuse(fmt::format("holds more than {} numbers", most_tdms_numbers), "fewer");
  }

  /// Seconds since the first stamp. Stamps have a fraction of 64 bits, so whole seconds are subtracted
  /// separately.
  static double take_stamp(Bytes& in, Object& object) {
    const auto first = in.number<std::uint64_t>(), second = in.number<std::uint64_t>();
    constexpr bool here_little = std::endian::native == std::endian::little;
    const bool little = in.swapped() != here_little;
    const auto whole_s = static_cast<std::int64_t>(little ? second : first);
    const double fraction_s = std::ldexp(static_cast<double>(little ? first : second), -64);
    object.first_stamp_s = object.first_stamp_s.value_or(whole_s);
    return static_cast<double>(whole_s) - static_cast<double>(*object.first_stamp_s) + fraction_s;
  }

  std::map<std::string, std::size_t> place_of_;
  std::vector<std::size_t> active_;
  std::size_t numbers_ = 0;
};

void add_signals(std::vector<Object>& objects, Channels& table) {
  std::size_t longest = 2;
  for (const Object& object : objects) longest = std::max(longest, object.values.size());
  std::optional<double> step_s;
  bool same = true;
  for (Object& object : objects) {
    if (!object.has_index) continue;
    const auto names = std::ranges::count_if(
        objects, [&](const Object& other) { return other.has_index && other.name == object.name; });
    const std::string name = names > 1 ? object.group + '/' + object.name : object.name;
    if (object.has_scales && !object.is_scaled)
      refuse(fmt::format("holds '{}' with scales that are not applied", name), allowed_daqmx);
    if (!object.is_signal()) {
      table.left_out.push_back({name, object.type == text_type ? "holds text" : "is complex"});
    } else if (object.values.size() < longest) {
      table.left_out.push_back({name, fmt::format("has {} of {} numbers", object.values.size(), longest)});
    } else {
      same = same && object.increment_s && object.increment_s == step_s.value_or(*object.increment_s);
      step_s = object.increment_s;
      table.channels.push_back(
          {name, object.type == stamp_type ? "s" : object.unit, std::move(object.values)});
    }
  }
  if (same && step_s && *step_s > 0) table.sampling_rate_hz = 1 / *step_s;
}

}  // namespace

Channels read_tdms_file(std::string_view bytes, const std::string& name) {
  Channels table;
  try {
    Reader reader;
    reader.read(bytes);
    add_signals(reader.objects, table);
    if (reader.unfinished)
      table.notes.push_back("the file was not closed by the program that wrote it: what there is is read");
  } catch (const FileError& error) {
    throw ConfigError(fmt::format("{}: {}, allowed: {}", name, table::printable(error.wrong),
                                  error.allowed == FileError{}.allowed ? allowed_file : error.allowed));
  }
  if (table.channels.empty())
    throw ConfigError(
        fmt::format("{}: holds no signal{}, allowed: channels of numbers", name, table.left_out_text()));
  return table;
}

}  // namespace rubsweep::recording
