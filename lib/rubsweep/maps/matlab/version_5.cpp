#include "rubsweep/maps/matlab/version_5.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <new>

namespace rubsweep::matlab {
namespace {

/// Unpacks until the end, or until there are more than `most` bytes; `ended` tells whether the end was
/// reached.
std::string unpack(std::string_view packed, std::size_t most, bool& ended) {
  struct Stream : z_stream {
    Stream() : z_stream{} {
      if (inflateInit(this) != Z_OK) throw std::bad_alloc();
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    ~Stream() { inflateEnd(this); }
  } stream;
  std::string bytes;
  std::array<char, 65536> piece;
  ended = false;
  while (!ended && bytes.size() <= most) {
    constexpr std::size_t most_at_once = std::numeric_limits<uInt>::max();
    if (stream.avail_in == 0) {
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
      stream.avail_in = static_cast<uInt>(std::min(packed.size(), most_at_once));
      packed.remove_prefix(stream.avail_in);
    }
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    const int result = inflate(&stream, Z_NO_FLUSH);
    if (result == Z_MEM_ERROR) throw std::bad_alloc();
    if (result != Z_OK && result != Z_STREAM_END)
      throw FileError{"is damaged: what zlib compressed in it breaks off, or does not meet its checksum"};
    bytes.append(piece.data(), piece.size() - stream.avail_out);
    ended = result == Z_STREAM_END;
  }
  return bytes;
}

constexpr std::uint32_t matrix_type = 14, compressed_type = 15;

/// Classes of arrays.
constexpr std::uint32_t cell_class = 1, structure_class = 2, sparse_class = 5, last_number_class = 15,
                        opaque_class = 17;

/// Data element: a tag, and the bytes whose type and size the tag gives.
struct Element {
  std::uint32_t type = 0;
  Bytes data;
};

Element take_element(Bytes& in) {
  const auto tag = in.number<std::uint32_t>();
  if (const std::uint32_t size = tag >> 16; size > 0) {  // small element of up to four bytes inside the tag
    if (size > 4) throw FileError{"is damaged: an element of another size than it can have"};
    return {tag & 0xffff, Bytes(in.take(4).substr(0, size), in.swapped())};
  }
  const std::size_t size = in.number<std::uint32_t>();
  const Element element{tag, Bytes(in.take(size), in.swapped())};
  if (tag != compressed_type) in.take(std::min(in.left(), (8 - size % 8) % 8));
  return element;
}

std::vector<double> all_numbers(Element element) {
  const std::size_t size = element.type == 9 || element.type >= 12 ? 8
                           : element.type >= 5                     ? 4
                           : element.type >= 3                     ? 2
                                                                   : 1;
  return take_numbers(element.data, static_cast<Stored>(element.type), element.data.left() / size);
}

std::string text_of(Element element) { return std::string(element.data.take(element.data.left())); }

std::vector<double> read_numbers(Bytes& in, const Variable& head) {
  std::vector<double> values = all_numbers(take_element(in));
  if (values.size() != count_of(head))
    throw FileError{"is damaged: '" + head.name + "' has " + std::to_string(values.size()) +
                    " numbers instead of " + std::to_string(count_of(head))};
  return values;
}

std::vector<double> read_sparse(Bytes& in, const Variable& head) {
  const std::vector<double> row = all_numbers(take_element(in)), begin = all_numbers(take_element(in));
  return full_matrix(head, row, begin, all_numbers(take_element(in)));
}

Variable read_array(Bytes in, const Wanted& wanted, int depth);

/// An array in another one.
Variable read_part(Bytes& in, const Wanted& wanted, int depth) {
  const Element part = take_element(in);
  if (part.type != matrix_type) throw FileError{"is damaged: a field that is no array"};
  return part.data.left() > 0 ? read_array(part.data, wanted, depth + 1) : Variable{};
}

void add_part(Bytes& in, Variable& variable, const Wanted& wanted, int depth) {
  constexpr std::size_t most_parts = 100000;
  if (variable.fields.size() >= most_parts) throw FileError{"holds more than 100000 arrays in one", "fewer"};
  variable.fields.push_back(read_part(in, wanted, depth));
}

void read_fields(Bytes& in, Variable& variable, const Wanted& wanted, int depth) {
  const std::vector<double> length = all_numbers(take_element(in));
  const std::string names = text_of(take_element(in));
  if (length.size() != 1 || !(length[0] >= 1)) throw FileError{"is damaged: a structure without names"};
  const auto step = static_cast<std::size_t>(length[0]);
  if (names.size() < step) return;
  for (std::size_t one = 1; one <= count_of(variable) && in.left() > 0; ++one) {
    for (std::size_t begin = 0; begin + step <= names.size() && in.left() > 0; begin += step) {
      add_part(in, variable, wanted, depth);
      const std::string name = names.substr(begin, step);
      variable.fields.back().name = field_name(name.substr(0, name.find('\0')), one);
    }
  }
}

void read_cells(Bytes& in, Variable& variable, const Wanted& wanted, int depth) {
  for (std::size_t one = 1; one <= count_of(variable) && in.left() > 0; ++one) {
    add_part(in, variable, wanted, depth);
    variable.fields.back().name = cell_name(one);
  }
}

/// Reads an array; `in` begins with its flags.
Variable read_array(Bytes in, const Wanted& wanted, int depth) {
  const std::vector<double> flags = all_numbers(take_element(in));
  if (flags.empty()) throw FileError{"is damaged: an array without flags"};
  const auto flag = static_cast<std::uint32_t>(flags[0]), kind = flag & 0xff;
  Variable variable{.complex = (flag & 0x0800) != 0};
  if (kind != opaque_class) {
    for (const double size : all_numbers(take_element(in))) {
      if (!(size >= 0)) throw FileError{"is damaged: a size below 0"};
      variable.dims.push_back(static_cast<std::size_t>(size));
    }
    if (variable.dims.size() < 2) throw FileError{"is damaged: an array of fewer than two dimensions"};
  }
  variable.name = text_of(take_element(in));
  if (kind == structure_class || kind == cell_class) {
    variable.kind = Variable::Kind::structure;
    if (depth < most_depth && kind == cell_class) read_cells(in, variable, wanted, depth);
    if (depth < most_depth && kind == structure_class) read_fields(in, variable, wanted, depth);
  } else if (kind >= sparse_class && kind <= last_number_class) {
    variable.kind = Variable::Kind::numbers;
    if (wanted(variable))
      variable.values = kind == sparse_class ? read_sparse(in, variable) : read_numbers(in, variable);
  }
  return variable;
}

void append(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xff);
}

void append_element(std::string& bytes, std::uint32_t type, std::string_view data) {
  append(bytes, type);
  append(bytes, static_cast<std::uint32_t>(data.size()));
  bytes += data;
  bytes.append((8 - data.size() % 8) % 8, '\0');
}

}  // namespace

std::vector<Variable> read_version_5(Bytes bytes, const Wanted& wanted) {
  std::vector<Variable> variables;
  std::size_t room = most_numbers * sizeof(double) + 65536;
  while (bytes.left() > 0) {
    Element element = take_element(bytes);
    std::string unpacked;
    if (element.type == compressed_type) {
      const std::string_view packed = element.data.take(element.data.left());
      // libmatio writes a size that is a few bytes too small.
      constexpr std::size_t tag_bytes = 8, slack = 64;
      const std::string begin = inflate_begin(packed, tag_bytes);
      Bytes tag(begin, bytes.swapped());
      const auto type = tag.number<std::uint32_t>();
      const std::size_t size = tag.number<std::uint32_t>();
      if (size > room)
        throw FileError{"holds more than " + std::to_string(most_numbers) + " numbers", "at most so many"};
      unpacked = inflate_all(packed, size + tag_bytes + slack);
      if (unpacked.size() < size + tag_bytes) throw FileError{"breaks off"};
      room -= size;
      element = {type, Bytes(std::string_view(unpacked).substr(tag_bytes), bytes.swapped())};
    }
    if (element.type != matrix_type) throw FileError{"is damaged: an element that is no array"};
    variables.push_back(read_array(element.data, wanted, 0));
  }
  return variables;
}

std::string version_5_file(std::string_view words, std::span<const NamedVector> columns) {
  std::string file(words);
  file.resize(124, ' ');
  std::fill(file.begin() + 116, file.end(), '\0');
  file += std::string_view("\0\1IM", 4);
  for (const auto& [name, values] : columns) {
    std::string flags, dims, data, array, element;
    append(flags, 6);  // class of doubles
    append(flags, 0);
    append(dims, static_cast<std::uint32_t>(values.size()));
    append(dims, 1);
    for (const double value : values) {
      const auto raw = std::bit_cast<std::uint64_t>(value);
      append(data, static_cast<std::uint32_t>(raw));
      append(data, static_cast<std::uint32_t>(raw >> 32));
    }
    append_element(array, static_cast<std::uint32_t>(Stored::uint32), flags);
    append_element(array, static_cast<std::uint32_t>(Stored::int32), dims);
    append_element(array, static_cast<std::uint32_t>(Stored::int8), name);
    append_element(array, static_cast<std::uint32_t>(Stored::float64), data);
    append_element(element, matrix_type, array);
    uLongf size = compressBound(static_cast<uLong>(element.size()));
    std::string packed(size, '\0');
    if (compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                 reinterpret_cast<const Bytef*>(element.data()), static_cast<uLong>(element.size())) != Z_OK)
      throw std::bad_alloc();
    packed.resize(size);
    append(file, compressed_type);
    append(file, static_cast<std::uint32_t>(packed.size()));
    file += packed;
  }
  return file;
}

std::string inflate_begin(std::string_view packed, std::size_t count) {
  bool ended = false;
  std::string bytes = unpack(packed, count - 1, ended);
  bytes.resize(std::min(bytes.size(), count));
  return bytes;
}

std::string inflate_all(std::string_view packed, std::size_t most) {
  bool ended = false;
  std::string bytes = unpack(packed, most, ended);
  if (bytes.size() > most) throw FileError{"is damaged: a variable that is longer than it says"};
  return bytes;
}

}  // namespace rubsweep::matlab
