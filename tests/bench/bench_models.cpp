// SPDX-License-Identifier: Apache-2.0
// bench_models [ROUNDS]: nanoseconds an evaluation of every model of the registry, one channel's worth of
// three.
//   lanes     f32_batch: float, vector lanes, directions from arrays
//   cosines   its first channel alone, from arrays of nl, nv, nh, lh (other people's loops)
//   float     f32, one pair of directions a call
//   double    f64, the same
// 2048 inputs (fixed seed) that stay in the first-level cache; all models in turn, round after round;
// medians. Ratios to Schlick's F in the same kind of loop and to Schueler's Optimized. Errors: largest |lanes
// - double| over the inputs, relative to the model's largest value there.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "core/brdf/evaluate/evaluators.h"
#include "core/brdf/models.h"

namespace {

using namespace etak;

constexpr std::size_t count = 2048;

struct Inputs {
  std::array<std::vector<float>, 6> directions;
  std::array<std::vector<float>, 4> cosines;
  std::vector<Directions> each;
};

Inputs make_inputs() {
  Inputs in;
  for (auto& v : in.directions) v.resize(count);
  for (auto& v : in.cosines) v.resize(count);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0.02f, 1.0f), turn(0.0f, 6.2831853f);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, 6> d;
    for (int side = 0; side < 2; ++side) {
      const float z = unit(random), r = std::sqrt(1 - z * z), phi = turn(random);
      d[static_cast<std::size_t>(3 * side)] = r * std::cos(phi);
      d[static_cast<std::size_t>(3 * side + 1)] = r * std::sin(phi);
      d[static_cast<std::size_t>(3 * side + 2)] = z;
    }
    for (std::size_t c = 0; c < 6; ++c) in.directions[c][i] = d[c];
    in.each.push_back({d[0], d[1], d[2], d[3], d[4], d[5]});
    const float hx = d[0] + d[3], hy = d[1] + d[4], hz = d[2] + d[5],
                length = std::sqrt(hx * hx + hy * hy + hz * hz);
    in.cosines[0][i] = d[2];
    in.cosines[1][i] = d[5];
    in.cosines[2][i] = hz / length;
    in.cosines[3][i] = length / 2;
  }
  return in;
}

// Initial values of a model's parameters, colours three times.
std::vector<double> initial_values(const Model& model) {
  std::vector<double> values;
  for (const Parameter& p : model.parameters) values.insert(values.end(), p.color ? 3u : 1u, p.initial);
  return values;
}

struct Case {
  std::string name;
  std::vector<double> ns;
};

// One pass over all inputs, in nanoseconds an input; repeated until it lasts long enough to be timed.
template <class Pass>
double nanoseconds(Pass pass) {
  using Clock = std::chrono::steady_clock;
  for (int repeats = 1;; repeats *= 4) {
    const auto begin = Clock::now();
    for (int r = 0; r < repeats; ++r) pass();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (seconds > 2e-4) return seconds * 1e9 / repeats / static_cast<double>(count);
  }
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

volatile float sink;

// F0 + (1 - F0)(1 - c)^5 over the array: the base of the ratios.
double schlick_pass(const Inputs& in, std::vector<float>& out) {
  const float* c = in.cosines[3].data();
  const double ns = nanoseconds([&] {
    for (std::size_t i = 0; i < count; ++i) {
      const float m = 1 - c[i], m2 = m * m;
      out[i] = 0.04f + 0.96f * (m2 * m2 * m);
    }
    sink = out[count / 2];
  });
  return ns;
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 31;
  const Inputs in = make_inputs();
  std::array<std::vector<float>, 3> out;
  for (auto& v : out) v.resize(count);
  const float* const directions[6] = {in.directions[0].data(), in.directions[1].data(),
                                      in.directions[2].data(), in.directions[3].data(),
                                      in.directions[4].data(), in.directions[5].data()};
  const float* const cosines[4] = {in.cosines[0].data(), in.cosines[1].data(), in.cosines[2].data(),
                                   in.cosines[3].data()};
  float* const rgb[3] = {out[0].data(), out[1].data(), out[2].data()};

  struct Row {
    const Model* model;
    std::vector<double> values, numbers;
    const evaluators::Many* many;
    std::array<std::vector<double>, 4> ns;
    double error = 0;
  };
  std::vector<Row> rows;
  for (const Model& model : models()) {
    Row row{&model, initial_values(model), {}, nullptr, {}};
    row.numbers = row.values;
    row.numbers.resize(row.values.size() + model.derived_count());
    model.derive(row.values.data(), row.numbers.data() + row.values.size());
    const evaluators::ManyTable table = evaluators::many();
    for (std::size_t i = 0; i < table.count; ++i)
      if (model.entry == table.rows[i].entry ||
          model.entry == std::string("brdf_microfacet_") + table.rows[i].entry)
        row.many = &table.rows[i];
    double most = 0;
    model.f32_batch(count, directions, row.values.data(), rgb);
    for (std::size_t i = 0; i < count; ++i) {
      double exact[3];
      model.f64(in.each[i], row.values.data(), exact);
      most = std::max(most, std::abs(exact[0]));
      row.error = std::max(row.error, std::abs(static_cast<double>(out[0][i]) - exact[0]));
    }
    row.error /= std::max(most, 1e-300);
    rows.push_back(std::move(row));
  }

  std::vector<double> schlick;
  for (int round = 0; round < rounds; ++round) {
    schlick.push_back(schlick_pass(in, out[0]));
    for (Row& row : rows) {
      row.ns[0].push_back(
          nanoseconds([&] { row.model->f32_batch(count, directions, row.values.data(), rgb); }));
      if (row.many && row.many->evaluate_cosines)
        row.ns[1].push_back(
            nanoseconds([&] { row.many->evaluate_cosines(count, cosines, row.numbers.data(), rgb[0]); }));
      if (round % 8 != 0) continue;  // the slow ones need fewer rounds
      row.ns[2].push_back(nanoseconds([&] {
        for (const Directions& d : in.each) row.model->f32(d, row.values.data(), out[0].data());
      }));
      row.ns[3].push_back(nanoseconds([&] {
        double value[3];
        for (const Directions& d : in.each) row.model->f64(d, row.values.data(), value);
        sink = static_cast<float>(value[0]);
      }));
    }
  }

  const double base = median(schlick);
  double optimized = 0;
  for (const Row& row : rows)
    if (row.model->id == "schueler-optimized") optimized = median(row.ns[0]);
  std::printf("%s, compiler %s, -O3 -fno-math-errno -fno-trapping-math, %zu inputs, %d rounds\n",
              evaluators::instruction_set(), __VERSION__, count, rounds);
  std::printf("Schlick's F alone, float loop (%s baseline): %.3f ns\n", "x86-64", base);
  std::printf("%-28s %8s %8s %8s %8s %9s %10s %10s\n", "ns an evaluation", "lanes", "cosines", "float",
              "double", "/Schlick", "/Optimized", "error");
  for (const Row& row : rows) {
    std::printf("%-28s %8.3f ", std::string(row.model->id).c_str(), median(row.ns[0]));
    if (row.ns[1].empty())
      std::printf("%8s", "-");
    else
      std::printf("%8.3f", median(row.ns[1]));
    std::printf(" %8.2f %8.2f %9.1f %10.2f %10.1e\n", median(row.ns[2]), median(row.ns[3]),
                median(row.ns[0]) / base, median(row.ns[0]) / optimized, row.error);
  }

  // (n.h)^e underflows over most of the sphere for high gloss: subnormal numbers would show as a cliff here.
  const Model& lobe = *find_model("schueler-optimized");
  std::printf("schueler-optimized by gloss, lanes:");
  for (const double g : {0.0, 0.25, 0.5, 0.75, 0.9, 1.0}) {
    std::vector<double> values = initial_values(lobe), ns;
    values.back() = g;
    for (int round = 0; round < rounds; ++round)
      ns.push_back(nanoseconds([&] { lobe.f32_batch(count, directions, values.data(), rgb); }));
    std::printf("  g %.2f (e %.0f) %.3f ns", g, std::exp2(12 * g), median(ns));
  }
  std::printf("\n");
}
