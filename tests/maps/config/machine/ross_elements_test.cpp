#include "rubsweep/maps/config/machine/ross_elements.hpp"

#include "maps/config/machine/ross_text.hpp"

namespace rubsweep::config::machine {
namespace {

const RossFiles files;

/// The error message for the small rotor after replacing one text by another.
std::string message_with(const std::string& from, const std::string& to) {
  return files.message(replaced(small_ross(), from, to));
}

void expect_said(const std::string& message, const std::string& what) {
  EXPECT_NE(message.find(what), std::string::npos) << message;
}

TEST(RossElements, ASoundFileSaysNothing) { EXPECT_EQ(files.message(small_ross()), "no error"); }

TEST(RossElements, FilesThatCannotBeReadAreNamed) {
  EXPECT_EQ(
      message_of(RossFiles::yaml("nothing.toml"), {}, files.path("kit.yaml"))
          .find(
              "rotor.file: 'nothing.toml' cannot be read: No such file or directory, allowed: a TOML or JSON "
              "file of ROSS, named relative to this one"),
      files.path("kit.yaml:1:28: ").size());
  expect_said(files.message(small_ross(), "rotor.yaml"),
              "rotor.file: 'rotor.yaml' ends neither in .toml nor in .json");
  expect_said(files.message("a = = 1", "rotor.toml"), "rotor.toml:1:5: rotor.file: no TOML: ");
  expect_said(files.message("{\"a\": }", "rotor.json"), "rotor.json:1:7: rotor.file: no JSON: ");
  expect_said(files.message("[1]", "rotor.json"), "rotor.file: is a list and no rotor");
  expect_said(files.message("", "rotor.toml"),
              "rotor.file: has no shaft element, allowed: at least one ShaftElement");
  expect_said(files.message(ross_shafts(2, 0.1), "rotor.toml"), "rotor.file: has no bearing");
}

TEST(RossElements, WhatCannotBeRepresentedIsNamed) {
  expect_said(files.message(small_ross() + "[\"GearElement_Gear 0\"]\nn = 1\nm = 3\n"),
              "GearElement_Gear 0: is of a class that cannot be represented");
  expect_said(files.message(small_ross() + "[\"CouplingElement_c\"]\nn = 1\nkxx = 3\n"),
              "CouplingElement_c: is of a class that cannot be represented");
  expect_said(files.message(small_ross() + "[\"ShaftElemnt_c\"]\nn = 1\n"), "(did you mean 'ShaftElement'?)");
  expect_said(files.message("x = 3\n" + small_ross()), "x: '3' and no element");
  expect_said(message_with("torque = 0", "torque = 5.0"),
              "ShaftElement_Shaft Element 0.torque: a torque that softens the shaft cannot be represented, "
              "allowed: 0");
  expect_said(message_with("axial_force = 0", "axial_force = -3"),
              "ShaftElement_Shaft Element 0.axial_force: a load along the shaft cannot be represented");
  expect_said(message_with("cxx = [50]", "cxx = [50]\nmxy = [0, 1]"),
              "BearingElement_Bearing 1.mxy: a mass that couples x and y cannot be represented, allowed: 0");
  expect_said(message_with("[\"ShaftElement_Shaft Element 0\".material]\nname = \"steel\"\nrho = 7810.0\nE = "
                           "211000000000.0\nG_s = 81200000000.0\ncolor = \"#525252\"",
                           "material = \"Steel\""),
              "ShaftElement_Shaft Element 0.material: names a material whose numbers are not in the file");
}

TEST(RossElements, NodesThatAreNotThereAreNamed) {
  expect_said(message_with("n = 2\n", "n = 4\n"),
              "ShaftElement_Shaft Element 2: stands on node 4, and no shaft element on node 2");
  expect_said(message_with("[\"DiskElement_Disk 0\"]\nn = 1", "[\"DiskElement_Disk 0\"]\nn = 4"),
              "DiskElement_Disk 0: stands on node 4, which is not of the shaft, allowed: a node from 0 to 3");
  expect_said(message_with("n = 3\nscale_factor", "n = 9\nscale_factor"),
              "BearingElement_Bearing 1: names node 9, where neither the shaft nor a PointMass stands");
  expect_said(message_with("cxx = [50]", "cxx = [50]\nn_link = 8"), "BearingElement_Bearing 1: names node 8");
  expect_said(message_with("cxx = [50]", "cxx = [50]\nn_link = 1"),
              "BearingElement_Bearing 1: is linked to node 1 of the shaft");
  expect_said(files.message(small_ross() + "[\"PointMass_p\"]\nn = 9\nm = 1\n"),
              "PointMass_p: stands on node 9, which no bearing reaches");
  expect_said(message_with("n = 2\n", "n = -1\n"), "ShaftElement_Shaft Element 2.n: -1 is out of range");
  expect_said(message_with("n = 2\n", "n = 1.5\n"), "ShaftElement_Shaft Element 2.n: 1.5 is not an integer");
}

TEST(RossElements, NumbersThatAreNoneAreNamedWithTheirPlace) {
  EXPECT_TRUE(message_with("odl = 0.05", "odl = nan")
                  .starts_with("rotor.toml:8:7: ShaftElement_Shaft Element 0.odl: "))
      << message_with("odl = 0.05", "odl = nan");
  expect_said(message_with("kxx = [2e6]", "kxx = [inf]"),
              "BearingElement_Bearing 1.kxx.0: 'inf' is not finite");
  expect_said(message_with("kxx = [2e6]", "kxx = [\"2e6\"]"),
              "BearingElement_Bearing 1.kxx.0: '2e6' is text in quotes");
  expect_said(message_with("L = 0.2", "L = 0"), "ShaftElement_Shaft Element 0.L: 0 is out of range");
  expect_said(message_with("L = 0.2\n", ""), "ShaftElement_Shaft Element 0.L: missing");
  expect_said(message_with("idl = 0.0", "idl = 0.05"),
              "ShaftElement_Shaft Element 0: its diameters leave no wall");
  expect_said(message_with("Ip = 0.1", "Ip = 0.2"), "DiskElement_Disk 0.Ip: is more than twice Id");
  expect_said(message_with("gyroscopic = true", "gyroscopic = 1"),
              "ShaftElement_Shaft Element 0.gyroscopic: '1' is unknown");
  expect_said(message_with("axial_force = 0", "axial_forc = 0"),
              "ShaftElement_Shaft Element 0.axial_forc: unknown key (did you mean 'axial_force'?)");
  expect_said(message_with("kxx = [2e6]", "kxx = [2e6]\nkrr = 1"),
              "BearingElement_Bearing 1.krr: unknown key");
  expect_said(message_with("G_s = 81200000000.0\n", ""),
              "ShaftElement_Shaft Element 0.material: does not say how stiff it is, allowed: two of E, G_s "
              "and Poisson");
  expect_said(message_with("G_s = 81200000000.0\n", "G_s = 81200000000.0\nPoisson = 0.2\n"),
              "ShaftElement_Shaft Element 0.material.Poisson: contradicts E and G_s");
}

TEST(RossElements, TablesThatAreNoneAreNamed) {
  expect_said(message_with("kxx = [2e6]", "kxx = [2e6, 3e6]"),
              "BearingElement_Bearing 1.kxx: has several numbers, and there are no speeds");
  expect_said(message_with("kxx = [2e6]", "kxx = [2e6, 3e6, 4e6]\nfrequency = [1, 2]"),
              "BearingElement_Bearing 1.kxx: has 3 numbers, allowed: 2, one for each speed, or one for all");
  expect_said(message_with("kxx = [2e6]", "kxx = [2e6, 3e6]\nfrequency = [2, 2]"),
              "BearingElement_Bearing 1.frequency: its speeds do not ascend");
  expect_said(message_with("kxx = [2e6]", "kxx = [2e6, 3e6]\nfrequency = [1, 2]\nspeed = [1, 2]"),
              "BearingElement_Bearing 1.speed: says the speeds a second time");
  expect_said(message_with("kxx = [2e6]", "kxx = []"), "BearingElement_Bearing 1.kxx: ");
}

TEST(RossElements, ShaftsThatNothingHoldsAreRefused) {
  expect_said(message_with("kxx = [2e6]", "kxx = [0]"), "rotor.file: leaves the shaft free to move in x");
}

TEST(RossElements, LayersHaveOneLength) {
  expect_said(files.message(small_ross() + ross_shaft(7, 1, 0.25, 0.04)),
              "ShaftElement_Shaft Element 7: is 0.25 m long, and 'Shaft Element 1' on the same node 0.2 m");
}

TEST(RossElements, ClassesThatComputeTheirCoefficientsSaveTheirGeometry) {
  const std::string ball =
      "[\"BallBearingElement_b\"]\nn = 3\nn_balls = 8.0\nd_balls = 0.03\nkxx = [2e6]\ncxx = [50]\n";
  EXPECT_EQ(files.message(ross_shafts(3, 0.2) + ross_bearing(0, 0, "kxx = [1e6]") + ball), "no error");
}

}  // namespace
}  // namespace rubsweep::config::machine
