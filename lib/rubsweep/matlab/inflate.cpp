#include "rubsweep/matlab/inflate.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>

#include "rubsweep/matlab/variable.hpp"

namespace rubsweep::matlab {
namespace {

/// Unpacks until the end, or until there are more than `most` bytes; `ended` says which.
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

}  // namespace

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
