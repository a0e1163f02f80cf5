#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace rubsweep::response::spectrum {

/// Two-sided amplitude spectrum of z = x + iy over a whole number of turns. Forward whirl (from +x to +y) has
/// positive orders, backward whirl negative ones. Amplitudes are not doubled: a forward circle of radius a is
/// a line a at +1X; x = a cos(omega t) gives a line a/2 at +1X and one at -1X.
struct FullSpectrum {
  int turns = 0;
  int samples_per_revolution = 0;
  std::vector<double> amplitude_m;  ///< N = turns x samples_per_revolution lines from k = first_line().

  /// Smallest k: -N/2, rounded towards zero.
  int first_line() const { return -(static_cast<int>(amplitude_m.size()) / 2); }

  /// Largest k: N/2 - 1 for even N.
  int last_line() const { return first_line() + static_cast<int>(amplitude_m.size()) - 1; }

  /// Amplitude of line k in metres, which is at order k / turns. SolverError when there is no such line.
  double amplitude(int k) const {
    if (k < first_line() || k > last_line()) refuse(k);
    return amplitude_m[static_cast<std::size_t>(k - first_line())];
  }

  /// Order of line k in multiples of the shaft speed, negative for backward whirl.
  double order(int k) const { return static_cast<double>(k) / turns; }

  /// Energy of all lines except 0X: sum of their squared amplitudes in m^2, the mean of |z - mean z|^2
  /// (Parseval).
  double energy_without_mean() const;

 private:
  [[noreturn]] void refuse(int k) const;
};

/// One line of a spectrum.
struct SpectralLine {
  double order = 0;  ///< multiple of the shaft speed, negative for backward whirl
  double amplitude_m = 0;
};

/// Index k of the largest line except 0X; 0 when there is no other line. If lines +k and -k are equal to 1e-9
/// (a straight orbit), the forward one is returned, so that rounding never decides the sign.
int dominant_line(const FullSpectrum& spectrum);

/// Buffers of one thread for `full_spectrum`, aligned for FFTW's vector code. They grow to the longest window
/// so far.
class SpectrumWorkspace {
  friend std::span<const std::complex<double>> transform(std::span<const std::complex<double>>,
                                                         SpectrumWorkspace&);

  struct Free {
    void operator()(std::complex<double>* buffer) const noexcept;
  };
  using Buffer = std::unique_ptr<std::complex<double>[], Free>;

  void reserve(std::size_t length);

  std::size_t capacity_ = 0;
  Buffer samples_;
  Buffer lines_;
};

/// Discrete Fourier transform sum_j z_j exp(-2 pi i k j / N), k = 0 .. N - 1, in the workspace. SolverError
/// when N is zero. Thread-safe in the same way as full_spectrum.
std::span<const std::complex<double>> transform(std::span<const std::complex<double>> z,
                                                SpectrumWorkspace& workspace);

/// Full spectrum A_k = |1/N sum_j z_j exp(-2 pi i k j / N)| of `displacement_m`: N equidistant samples of x +
/// iy in metres over `turns` turns, without the end point. SolverError when N is zero or no multiple of
/// `turns`.
///
/// Several threads may call it at once, each with its own workspace: FFTW plans are made once per length and
/// shared, and only the lookup takes a lock. The result depends bit by bit only on samples, processor and
/// FFTW build, not on history, because plans are estimated, never measured. For this, FFTW's wisdom in this
/// process is forgotten whenever a new length is planned.
FullSpectrum full_spectrum(std::span<const std::complex<double>> displacement_m, int turns,
                           SpectrumWorkspace& workspace);

}  // namespace rubsweep::response::spectrum
