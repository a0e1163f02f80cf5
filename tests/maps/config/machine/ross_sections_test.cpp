#include "rubsweep/maps/config/machine/ross_sections.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/yaml/toml_document.hpp"

namespace rubsweep::config::machine {
namespace {

/// "class|tag" of the elements.
std::string said(const std::vector<RossElement>& elements) {
  std::string all;
  for (const RossElement& element : elements) all += element.type + "|" + element.tag + " ";
  return all;
}

/// The sections of a TOML text, their elements said one list after the other, or what is wrong.
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

}  // namespace
}  // namespace rubsweep::config::machine
