#include "rubreport/compressed.hpp"

#include <gtest/gtest.h>

#include "apps/rubreport/decoded.hpp"

namespace rubsweep::page {
namespace {

TEST(Compressed, Base64IsThatOfTheStandard) {
  // Test vectors of RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(Compressed, ComesBackWhateverTheBytes) {
  std::string bytes;
  for (int i = 0; i < 5000; ++i) bytes.push_back(static_cast<char>(i * i % 251));
  EXPECT_EQ(decompressed(compressed(bytes)), bytes);
  EXPECT_EQ(decompressed(compressed("")), "");
  EXPECT_LT(compressed(std::string(100000, 'a')).size(), 400u);
}

}  // namespace
}  // namespace rubsweep::page
