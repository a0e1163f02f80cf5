#pragma once

/// \file
/// A design check of a machine over an operating range of speeds (Hz): the unbalance response at probes and
/// stops, scaled by the rules of API 617, clearances, dry whip, lock speeds and, on request, the smallest
/// kick that starts a rub. Lengths are in metres, vibrations peak to peak. Throws ConfigError where a table
/// does not reach a speed, or where neither a disc's unbalance nor an eccentricity is given. design_page
/// gives the page of `rubtrace --design-check`.
///
/// ```cpp
/// using namespace rubsweep;
/// const auto study = config::read_run_config("configs/reference/rotor_kit.yaml", {}).study;
/// const auto prepared = scene::prepare_machine(study.machine);
/// design::DesignQuestions questions{.operating = {20, 30}, .eccentricity_m = 1e-5, .kick_speeds = 0};
/// const auto check = design::check_design(study, prepared, questions);
/// std::puts(design::design_page(check).c_str());
/// ```

#include "rubsweep/analysis/design/design_check.hpp"
#include "rubsweep/analysis/design/design_page.hpp"
