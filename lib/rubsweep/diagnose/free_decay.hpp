#pragma once

namespace rubsweep::diagnose {

/// Turns of the shaft in which free vibration of a damped rotor falls to the share `left` of what it was: its
/// envelope is exp(-damping_ratio * natural angular frequency * time). At most a million.
int turns_to_decay(double natural_frequency_hz, double damping_ratio, double speed_hz, double left);

}  // namespace rubsweep::diagnose
