#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "maps/config/machine/ross_text.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"
#include "rubsweep/maps/config/machine/ross_elements.hpp"
#include "rubsweep/maps/config/yaml/other_documents.hpp"

namespace rubsweep::config::machine {
namespace {

/// Text "class|tag" for all elements.
std::string said(const std::vector<RossElement>& elements) {
  std::string all;
  for (const RossElement& element : elements) all += element.type + "|" + element.tag + " ";
  return all;
}

/// The sections of a TOML text as texts of their element lists, or the error message.
std::string sorted(const std::string& text) {
  yaml::Diagnostics diagnostics("kit.yaml", {});
  const auto root = yaml::parse_toml(text, "rotor.file", diagnostics, diagnostics.add_file("rotor.toml"));
  if (!root) return "no document";
  const RossSections sections = read_ross_sections({*root, "", diagnostics});
  try {
    diagnostics.throw_if_any();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "shaft " + said(sections.shaft) + "discs " + said(sections.discs) + "masses " +
         said(sections.masses) + "supports " + said(sections.supports);
}

TEST(RossSections, AreSortedByTheirClassAndNamedByTheRest) {
  EXPECT_EQ(sorted("ross_version = \"2.3.0\"\n"
                   "[\"SealElement_Seal_of stage 2\"]\nkxx = [1]\n"
                   "[\"ShaftElement_Shaft Element 0\"]\nn = 0\n"
                   "[\"PointMass_m\"]\nm = 1\n"
                   "[\"DiskElement_a\"]\nm = 1\n[\"DiskElement_b\"]\nm = 1\n"
                   "[\"TiltingPad_drive end\"]\nkxx = [1]\n"),
            "shaft ShaftElement|Shaft Element 0 discs DiskElement|a DiskElement|b masses PointMass|m "
            "supports SealElement|Seal_of stage 2 TiltingPad|drive end ");
}

TEST(RossSections, AClassWithAxialMotionIsTheOneWithout) {
  EXPECT_EQ(sorted("[\"BearingElement6DoF_b\"]\nkxx = [1]\nkzz = [1]\n[\"ShaftElement6DoF_s\"]\nn = 0\n"),
            "shaft ShaftElement|s discs masses supports BearingElement|b ");
}

TEST(RossSections, WhatActsAlongTheAxisAloneIsLeftOut) {
  EXPECT_EQ(sorted("[\"ThrustPad_t\"]\nkzz = [1]\n[\"BearingElement_b\"]\nkxx = [1]\n"),
            "shaft discs masses supports BearingElement|b ");
}

TEST(RossSections, OfAnUnknownClassOrWithoutAnElementAreNamed) {
  const std::string unknown = sorted("[\"DiscElement_d\"]\nm = 1\n");
  EXPECT_NE(unknown.find("rotor.toml:1:"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("DiscElement_d: is of a class that cannot be represented, 'DiscElement' is unknown "
                         "(did you mean 'DiskElement'?)"),
            std::string::npos)
      << unknown;
  EXPECT_NE(sorted("DiskElement_d = 3\n").find("DiskElement_d: '3' and no element"), std::string::npos)
      << sorted("DiskElement_d = 3\n");
}

TEST(RossSections, AreRefusedWhereTwoHaveOneName) {
  const std::string twice = sorted("[DiskElement_d]\nm = 1\n[DiskElement_d]\nm = 2\n");
  EXPECT_EQ(twice.find("shaft"), std::string::npos) << twice;
}

const RossFiles setting_files;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string version_3(const std::string& text) { return replaced(text, "2.3.0", "3.1.0"); }

std::string with_parameters(const std::string& numbers) {
  return version_3(replaced(small_ross(), "[parameters]\n", "[parameters]\n" + numbers + "\n"));
}

void expect_setting_said(const std::string& found, const std::string& said) {
  EXPECT_NE(found.find(said), std::string::npos) << found;
}

/// Damping alpha M + beta K of shaft and discs, without the bearings.
TEST(RossSectionsRossSettings, DampTheWholeRotor) {
  const model::RotorKit plain = setting_files.kit(version_3(small_ross())),
                        damped = setting_files.kit(with_parameters("min_w = 0\nalpha = 8.0\nbeta = 1e-5"));
  const structure::BeamShaft before = structure::assemble_beam_shaft(plain, {}),
                             after = structure::assemble_beam_shaft(damped, {});
  const Eigen::MatrixXd expected = 8 * before.mass + 1e-5 * before.elastic;
  EXPECT_LT((after.damping - expected).norm(), 1e-12 * expected.norm());
  EXPECT_EQ(after.support_damping[0][0], before.support_damping[0][0]);
  EXPECT_TRUE(before.damping.isZero(0));
}

TEST(RossSectionsRossSettings, DampPointMassesByTheirOwn) {
  const std::string mass = "[\"PointMass_p\"]\nn = 2\nmx = 3\nmy = 5\nscale_factor = 1.0\n";
  const structure::BeamShaft shaft =
      structure::assemble_beam_shaft(setting_files.kit(with_parameters("alpha = 2") + mass), {});
  const Eigen::Index w = shaft.deflection(0.4);
  EXPECT_DOUBLE_EQ(shaft.support_damping[0][0](w, w), 6);
  EXPECT_DOUBLE_EQ(shaft.support_damping[1][1](w, w), 10);
}

TEST(RossSectionsRossSettings, NothingIsDroppedSilently) {
  expect_setting_said(
      setting_files.message(with_parameters("modal_damping_ratio = [0.02]\ndefault_damping_ratio = 0.05")),
      "parameters.modal_damping_ratio: counts modes of torsion");
  expect_setting_said(setting_files.message(with_parameters("gamma = 1")), "parameters.gamma: unknown key");
  expect_setting_said(setting_files.message(with_parameters("alpha = -1")),
                      "parameters.alpha: -1 is out of range");
  for (const std::string version : {"4.0.0", "next", "-1"})
    expect_setting_said(setting_files.message(replaced(small_ross(), "2.3.0", version)),
                        "ross_version: '" + version + "' is no version whose files are known");
  EXPECT_EQ(setting_files.message(with_parameters("alpha = 0\nmodal_damping_ratio = []\nrated_w = 100")),
            "no error");
  EXPECT_EQ(setting_files.message(replaced(small_ross(), "2.3.0", "0.4")), "no error");
}

/// `frequency` is the shaft speed up to version 2 and the whirl frequency from version 3 on; `speed` is
/// always the shaft speed.
TEST(RossSectionsRossSettings, TheVersionTellsWhatFrequencyIs) {
  const auto table = [](const std::string& axis) {
    return replaced(small_ross(), "kxx = [2e6]", "kxx = [2e6, 3e6]\n" + axis + " = [1, 900]");
  };
  EXPECT_EQ(setting_files.message(table("frequency")), "no error");
  EXPECT_EQ(setting_files.message(version_3(table("speed"))), "no error");
  const std::string found = setting_files.message(version_3(table("frequency")));
  expect_setting_said(found, "BearingElement_Bearing 1.frequency: is the whirl frequency since version 3");
  EXPECT_EQ(found.find('\n'), found.rfind('\n')) << "one problem: " << found;
}

TEST(RossSectionsRossSettings, ClassesThatNobodyKnowsAreRefused) {
  expect_setting_said(setting_files.message(small_ross() + "[\"FoilBearing_f\"]\nn = 1\nkxx = 1e6\n"),
                      "FoilBearing_f: is of a class that cannot be represented");
  EXPECT_EQ(setting_files.message(small_ross() + "[\"BearingElement6DoF_b\"]\nn = 1\nkxx = 1e6\n"),
            "no error");
  EXPECT_EQ(
      setting_files.message(small_ross() + "[\"BearingElement_Thrust\"]\nn = 1\nkzz = 1e6\nczz = 3.0\n"),
      "no error");
}

/// An element that cannot be read causes no further problem in other elements.
TEST(RossSectionsRossSettings, OneProblemMakesNoOther) {
  const std::string pedestal = replaced(small_ross(), "cxx = [50]", "cxx = [50]\nn_link = 9") +
                               ross_bearing(2, 9, "kxx = [1e7]") +
                               "[\"PointMass_p\"]\nn = 9\nm = \"heavy\"\n";
  const std::string found = setting_files.message(pedestal);
  expect_setting_said(found, "PointMass_p.m: ");
  EXPECT_EQ(found.find("names node 9"), std::string::npos) << found;
}

TEST(RossSectionsRossSettings, SealsMayCarryMassAway) {
  const model::RotorKit kit =
      setting_files.kit(replaced(small_ross(), "cxx = [50]", "cxx = [50]\nmxx = [-0.4]"));
  EXPECT_EQ(kit.supports[1].mass_x_kg, -0.4);
  EXPECT_EQ(kit.supports[1].mass_y_kg, -0.4);
}

TEST(RossSectionsRossSettings, DiscsAndMassesKeepTheirTags) {
  const model::RotorKit kit = setting_files.kit(small_ross() + "[\"PointMass_Nut_1\"]\nn = 2\nm = 0.3\n");
  EXPECT_TRUE(kit.from_file);
  EXPECT_EQ(kit.discs.at(0).name, "Disk 0");
  EXPECT_EQ(kit.point_masses.at(0).name, "Nut_1");
}

/// Messages about a bearing use its name from the file.
TEST(RossSectionsRossSettings, BearingsKeepTheirNames) {
  const std::string table = replaced(small_ross(), "kxx = [2e6]", "kxx = [2e6, 3e6]\nspeed = [600, 900]");
  expect_setting_said(setting_files.message(table),
                      "is beyond the table of rotor.file.BearingElement_Bearing 1");
}

}  // namespace
}  // namespace rubsweep::config::machine
