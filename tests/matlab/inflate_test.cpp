#include "rubsweep/matlab/inflate.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include "rubsweep/matlab/variable.hpp"

namespace rubsweep::matlab {
namespace {

std::string packed(const std::string& text) {
  uLongf size = compressBound(text.size());
  std::string bytes(size, '\0');
  compress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
           text.size());
  bytes.resize(size);
  return bytes;
}

TEST(Inflate, GivesAllOrTheBegin) {
  std::string text;
  for (int i = 0; i < 50000; ++i) text += std::to_string(i);
  EXPECT_EQ(inflate_all(packed(text), text.size()), text);
  EXPECT_EQ(inflate_begin(packed(text), 8), "01234567");
  EXPECT_EQ(inflate_begin(packed("abc"), 8), "abc");
  EXPECT_EQ(inflate_all(packed(""), 0), "");
}

TEST(Inflate, RefusesWhatIsLongerOrDamaged) {
  const std::string good = packed("a rotor that touches its casing");
  EXPECT_THROW(inflate_all(packed(std::string(100000, 'a')), 99999), FileError);
  EXPECT_THROW(inflate_all(good.substr(0, good.size() - 1), 100), FileError);
  std::string changed = good;
  changed.back() = static_cast<char>(changed.back() ^ 1);  // of the checksum
  EXPECT_THROW(inflate_all(changed, 100), FileError);
  EXPECT_THROW(inflate_all("", 100), FileError);
}

}  // namespace
}  // namespace rubsweep::matlab
