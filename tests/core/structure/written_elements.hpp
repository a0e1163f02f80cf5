#pragma once

#include <Eigen/Core>
#include <array>

namespace rubsweep::structure {

/// Numerical element matrices of one plane; coordinates: deflection and angle of the near end, then of the
/// far end. They are exact integrals in rational numbers and do not use closed-form elements. The deflection
/// w(z) of an unloaded Timoshenko beam is cubic; the angle is w' + E I / (k G A) times the third derivative
/// of w, with the section at half length.
struct WrittenElement {
  Eigen::Matrix4d translation, rotary, stiffness;
};

inline Eigen::Matrix4d symmetric(const std::array<double, 10>& upper) {
  Eigen::Matrix4d matrix;
  std::size_t next = 0;
  for (Eigen::Index row = 0; row < 4; ++row) {
    for (Eigen::Index column = row; column < 4; ++column) {
      matrix(row, column) = matrix(column, row) = upper[next++];
    }
  }
  return matrix;
}

// Elements of 0.3 m length; steel with E = 211 GPa, G = 81.2 GPa and 7810 kg/m3 unless stated otherwise.

/// Outer diameter 50 mm, inner diameter 20 mm, Cowper's shear coefficient.
inline const WrittenElement written_tube{
    .translation = symmetric({1.42132676955663, 0.059448893614996, 0.510870522125598, -0.0371609709691156,
                              0.00324459139461462, 0.0371609709691156, -0.00255200048043208, 1.42132676955663,
                              -0.059448893614996, 0.00324459139461462}),
    .rotary =
        symmetric({0.00781088642105871, 0.000104031199293725, -0.00781088642105871, 0.000104031199293725,
                   8.89382547258997e-05, -0.000104031199293725, -2.77986649799019e-05, 0.00781088642105871,
                   -0.000104031199293725, 8.89382547258997e-05}),
    .stiffness = symmetric({25638238.4038164, 3845735.76057246, -25638238.4038164, 3845735.76057246,
                            787116.361165888, -3845735.76057246, 366604.367005852, 25638238.4038164,
                            -3845735.76057246, 787116.361165888})};

/// The same tube with Hutchinson's shear coefficient.
inline const WrittenElement written_hutchinson_tube{
    .translation = symmetric({1.42200897598572, 0.0595106780573721, 0.510188315696514, -0.0370991865267395,
                              0.00324777708267306, 0.0370991865267395, -0.00254881479237364, 1.42200897598572,
                              -0.0595106780573721, 0.00324777708267306}),
    .rotary =
        symmetric({0.00788274138504342, 0.000109910072484729, -0.00788274138504342, 0.000109910072484729,
                   8.90851799935448e-05, -0.000109910072484729, -2.76517397122567e-05, 0.00788274138504342,
                   -0.000109910072484729, 8.90851799935448e-05}),
    .stiffness = symmetric({25755895.8079211, 3863384.37118816, -25755895.8079211, 3863384.37118816,
                            789763.652758242, -3863384.37118816, 369251.658598206, 25755895.8079211,
                            -3863384.37118816, 789763.652758242})};

/// Taper from 60 mm / 10 mm to 40 mm / 20 mm (outer / inner diameter), Cowper's shear coefficient.
inline const WrittenElement written_taper{
    .translation = symmetric({1.9801888254467, 0.076681718158547, 0.554038923346449, -0.0420490759366377,
                              0.00396315764477672, 0.0384653870154333, -0.00276590149067022, 1.14416549059291,
                              -0.0535053330775873, 0.0031234706665015}),
    .rotary =
        symmetric({0.00842478724971719, -7.16935129859917e-05, -0.00842478724971719, 0.00029435119088894,
                   0.000148701920317215, 7.16935129859917e-05, -3.16889711609097e-05, 0.00842478724971719,
                   -0.00029435119088894, 5.94683406381438e-05}),
    .stiffness = symmetric({29929892.8016615, 5595875.13157486, -29929892.8016615, 3383092.70892358,
                            1236310.8250747, -5595875.13157486, 442451.714397757, 29929892.8016615,
                            -3383092.70892358, 572476.098279317})};

/// Sleeve of 80 mm over 50 mm with 70 GPa, 26 GPa and 2700 kg/m3, Cowper's shear coefficient.
inline const WrittenElement written_sleeve{
    .translation = symmetric({0.895042880516567, 0.036604611816622, 0.345493518569702, -0.0254222081376915,
                              0.00200774632514025, 0.0254222081376915, -0.00171386287211856,
                              0.895042880516567, -0.036604611816622, 0.00200774632514025}),
    .rotary = symmetric({0.010171632846251, -0.000184386486878893, -0.010171632846251, -0.000184386486878893,
                         0.000175854562890177, 0.000184386486878893, -5.41615611070688e-05, 0.010171632846251,
                         0.000184386486878893, 0.000175854562890177}),
    .stiffness = symmetric({39410435.8739614, 5911565.3810942, -39410435.8739614, 5911565.3810942,
                            1284293.53999888, -5911565.3810942, 489176.074329385, 39410435.8739614,
                            -5911565.3810942, 1284293.53999888})};

}  // namespace rubsweep::structure
