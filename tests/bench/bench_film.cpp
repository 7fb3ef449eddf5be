// SPDX-License-Identifier: Apache-2.0
// Speed of exact films over a spectrum, beside a plain loop over std::complex.
//   bench_film [SECONDS [PYTHON]]   default 2, for each row; with a Python that has numpy (and colour-science, where that
//                                   is to be had), theirs in the same run (film_numpy.py)
// One film on an absorbing base, 471 wavelengths, normal incidence (and cos 0.5), on one thread and on two. Prints films
// a second, how many times the plain loop that is, and the largest difference between the two.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "core/film/stack.h"

using namespace etak;

namespace {

constexpr std::size_t wavelengths = 471;

// An oxide on a metal, both with dispersion.
struct Spectra {
  std::vector<double> nm, outside, n1, n, k;

  Spectra() {
    for (std::size_t i = 0; i < wavelengths; ++i) {
      const double each = 360 + static_cast<double>(i);
      nm.push_back(each);
      outside.push_back(1);
      n1.push_back(2.2 + 5e4 / (each * each));
      n.push_back(1.5 + each / 500);
      k.push_back(2 + each / 400);
    }
  }
};

void plain(const Spectra& of, double thickness_nm, double cosine, std::vector<double>& out) {
  using C = std::complex<double>;
  const double sine2 = 1 - cosine * cosine;
  for (std::size_t i = 0; i < wavelengths; ++i) {
    const C n1 = of.n1[i], n2(of.n[i], of.k[i]);
    const C c1 = std::sqrt(1.0 - sine2 / (n1 * n1)), c2 = std::sqrt(1.0 - sine2 / (n2 * n2));
    const C way = std::exp(C(0, 4 * std::numbers::pi * thickness_nm / of.nm[i]) * n1 * c1);
    const auto joined = [&](C above, C below) {
      return std::norm((above + below * way) / (1.0 + above * below * way));
    };
    const double s =
        joined((cosine - n1 * c1) / (cosine + n1 * c1), (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2));
    if (cosine == 1) {
      out[i] = s;
      continue;
    }
    const double p =
        joined((n1 * cosine - c1) / (n1 * cosine + c1), (n2 * c1 - n1 * c2) / (n2 * c1 + n1 * c2));
    out[i] = (s + p) / 2;
  }
}

void ours(const Spectra& of, double thickness_nm, double cosine, std::vector<double>& out) {
  film_reflectance({{of.outside, {{{of.n1, {}}, thickness_nm, true}}, {of.n, of.k}}, of.nm}, cosine, out);
}

using Way = void (*)(const Spectra&, double, double, std::vector<double>&);

// Films a second.
double speed(Way way, const Spectra& of, double cosine, unsigned threads, double seconds) {
  std::atomic<long> done{0};
  const auto begin = std::chrono::steady_clock::now();
  const auto passed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  std::vector<std::thread> all;
  for (unsigned t = 0; t < threads; ++t)
    all.emplace_back([&] {
      std::vector<double> out(wavelengths);
      for (long i = 0; passed() < seconds;) {
        for (int j = 0; j < 64; ++j, ++i) way(of, static_cast<double>(i % 400), cosine, out);
        done += 64;
      }
    });
  for (std::thread& each : all) each.join();
  return static_cast<double>(done) / passed();
}

// The same films by numpy, in a process of its own.
void by_numpy(const Spectra& of, const std::string& python, double seconds) {
  std::fflush(stdout);
  const std::string command = "'" + python + "' '" BENCH_SOURCES "/film_numpy.py' " + std::to_string(seconds);
  std::FILE* const pipe = popen(command.c_str(), "w");
  if (pipe == nullptr) return std::perror("film_numpy.py");
  for (std::size_t i = 0; i < wavelengths; ++i)
    std::fprintf(pipe, "%.17g %.17g %.17g %.17g\n", of.nm[i], of.n1[i], of.n[i], of.k[i]);
  if (pclose(pipe) != 0) std::fprintf(stderr, "film_numpy.py has failed\n");
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 2;
  const Spectra spectra;
  std::printf("cos  threads  films/s   plain/s   ratio  largest difference\n");
  for (const double cosine : {1.0, 0.5}) {
    std::vector<double> a(wavelengths), b(wavelengths);
    double most = 0;
    for (int nm = 0; nm <= 400; nm += 10) {
      ours(spectra, nm, cosine, a);
      plain(spectra, nm, cosine, b);
      for (std::size_t i = 0; i < wavelengths; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    }
    for (const unsigned threads : {1u, 2u}) {
      // Halves of each take turns, so that a machine that slows down slows both.
      double fast = 0, slow = 0;
      for (int half = 0; half < 2; ++half) {
        fast += speed(ours, spectra, cosine, threads, seconds / 2) / 2;
        slow += speed(plain, spectra, cosine, threads, seconds / 2) / 2;
      }
      std::printf("%-4g %7u %8.0f  %8.0f  %6.2f  %.1e\n", cosine, threads, fast, slow, fast / slow, most);
    }
  }
  if (argc > 2) by_numpy(spectra, argv[2], seconds);
}
