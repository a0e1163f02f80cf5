#pragma once

#include "rubsweep/core/model/range.hpp"

/// Ranges of the numbers of a shaft line. They are far wider than any machine ever built, yet narrow enough
/// that products of them (bending stiffness E d^4 / l^3, and its inverse) do not overflow.
namespace rubsweep::model::physical {

inline constexpr Range length_m{.low = 1e-6, .high = 1e4};
inline constexpr Range diameter_m{.low = 1e-6, .high = 1e2};
inline constexpr Range hole_m{.low = 0, .high = 1e2};
inline constexpr Range deflection_m{.low = -1e2, .high = 1e2};
inline constexpr Range amplitude_m{.low = 0, .high = 1e2};
inline constexpr Range modulus_pa{.low = 1, .high = 1e15};
inline constexpr Range density_kg_per_m3{.low = 1e-9, .high = 1e6};
inline constexpr Range mass_kg{.low = 0, .high = 1e9};
inline constexpr Range moving_mass_kg{.low = 1e-9, .high = 1e9};
inline constexpr Range inertia_kg_m2{.low = 0, .high = 1e12};
inline constexpr Range per_eccentricity{.low = 0, .high = 1e6};
inline constexpr Range stiffness{.low = 0, .high = 1e15};  ///< N/m or N m/rad
inline constexpr Range holding_stiffness{.low = 1e-6, .high = 1e15};
inline constexpr Range cross_stiffness{.low = -1e15, .high = 1e15};
inline constexpr Range damping{.low = 0, .high = 1e12};  ///< N s/m or N m s/rad
inline constexpr Range cross_damping{.low = -1e12, .high = 1e12};
inline constexpr Range added_mass_kg{.low = -1e7, .high = 1e7};  ///< mass of fluid that moves with the shaft
inline constexpr Range force_n{.low = -1e12, .high = 1e12};
inline constexpr Range tilt_rad{.low = 0, .high = 1};
inline constexpr Range rate_per_s{.low = 0, .high = 1e6};
inline constexpr Range duration_s{.low = 0, .high = 1};
inline constexpr Range impulse_ns{.low = 0, .high = 1e9};
inline constexpr Range frequency_hz{.low = 1e-3, .high = 1e6};

}  // namespace rubsweep::model::physical
