#include "rubsweep/core/structure/assembly.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/jeffcott.hpp"

namespace rubsweep::structure {
namespace {

Assembly jeffcott(double mass_kg, double natural_frequency_hz, double casing_mass_kg = 0.05) {
  return assemble_jeffcott({mass_kg, natural_frequency_hz, 0.02}, {model::Casing{casing_mass_kg, 5e5, 0.1}});
}

TEST(AssemblyRefuseUnusable, TakesWhatCanBeComputed) {
  EXPECT_NO_THROW(refuse_unusable(jeffcott(0.8, 30)));
  // However far apart the masses of bodies are that do not share one.
  EXPECT_NO_THROW(refuse_unusable(jeffcott(1e9, 30, 1e-9)));
}

TEST(AssemblyRefuseUnusable, NumbersThatOverflow) {
  const auto message = [](const Assembly& assembly) {
    return message_of<ConfigError>([&] { refuse_unusable(assembly); });
  };
  EXPECT_NE(message(jeffcott(1e300, 1e100)).find("no finite number, allowed: less extreme ones"),
            std::string::npos);
  Assembly assembly = jeffcott(0.8, 30);
  assembly.bow_n = Eigen::VectorXcd::Constant(4, std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(message(assembly).find("no finite number"), std::string::npos);
  assembly = jeffcott(0.8, 30);
  assembly.system.mass(0, 0) = 0;
  EXPECT_NE(message(assembly).find("motion without mass, allowed:"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::structure
