// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/lobe_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math/functions.h"
#include "core/math/mat3.h"
#include "core/render/lobe_density.h"

namespace etak {
namespace {

using std::numbers::pi;

// Each cell is integrated by steps * steps half vectors.
constexpr int steps = 4, each = steps * steps;

// A lobe of which half lies beyond this polar angle of half vectors, in radians, is wide.
constexpr double wide_lobe = 0.08;

struct CellPoint {
  Vec3 h;
  double solid_angle;
};

// The half vectors of all cells, cell by cell. Cells are about square, in rings around the normal, and their number in a
// solid angle goes as the square root of the lobe's density: so each adds about as much to the error.
//   ring_sectors   cells of each ring; computed where there are none yet
std::vector<CellPoint> cell_points(const LobeDensity& density, std::vector<int>& ring_sectors) {
  constexpr int nodes = 512, rings = 8;
  constexpr double first = 1e-4;
  std::vector<double> angles{0}, places{0};  // places: in a measure by which rings are equally wide
  for (int i = 0; i <= nodes; ++i) {
    const double angle = first * math::pow(pi / 2 / first, double(i) / nodes);
    const double middle = (angle + angles.back()) / 2;
    places.push_back(places.back() + math::pow(density.pdf(middle), 0.25) * (angle - angles.back()));
    angles.push_back(angle);
  }
  const auto angle_at = [&](double share) {
    const double place = share * places.back();
    const auto above = std::upper_bound(places.begin() + 1, places.end() - 1, place) - places.begin();
    const auto i = static_cast<std::size_t>(above);
    return std::lerp(angles[i - 1], angles[i], (place - places[i - 1]) / (places[i] - places[i - 1]));
  };
  std::vector<CellPoint> out;
  for (int ring = 0; ring < rings; ++ring) {
    const double inner = angle_at(double(ring) / rings), outer = angle_at((ring + 1.0) / rings);
    if (ring_sectors.size() == std::size_t(ring))
      ring_sectors.push_back(static_cast<int>(
          std::clamp(2 * pi * math::sin((inner + outer) / 2) / std::max(outer - inner, 1e-9), 3.0, 32.0) +
          0.5));
    const int sectors = ring_sectors[std::size_t(ring)];
    for (int i = 0; i < sectors * each; ++i) {
      const int step = i % each / steps;
      const double from = angle_at((ring + double(step) / steps) / rings),
                   to = angle_at((ring + (step + 1.0) / steps) / rings), s = math::sin((from + to) / 2);
      const double azimuth = 2 * pi * (i / each + 0.5 * (ring % 2) + (i % steps + 0.5) / steps) / sectors;
      out.push_back({{s * math::cos(azimuth), s * math::sin(azimuth), math::cos((from + to) / 2)},
                     (math::cos(from) - math::cos(to)) * 2 * pi / (sectors * steps)});
    }
  }
  return out;
}

double level_of_mean(double cosine) {
  // The level of the mean of round lobes whose exponent is above 16, within 0.01 of a level.
  const double exponent = 4 / std::max(1 - cosine, 1e-9) - 6.5;
  return std::clamp((12 - math::log2(std::max(exponent, 1.0))) / 1.5, sharpest_sample, dullest_sample);
}

// What each half vector sends to a viewer: the direction that the light comes from, the weight of f_r, and f_r behind
// the directions that it is taken for.
struct Reflected {
  std::vector<Vec3> lights;
  std::vector<double> weight;
  std::array<std::vector<float>, 9> numbers;

  explicit Reflected(std::size_t count) : lights(count), weight(count) {
    for (auto& list : numbers) list.resize(count);
  }
  double light(std::size_t i, std::size_t channel) const {
    return weight[i] * double{numbers[6 + channel][i]};
  }
};

//   v         viewer in the frame of the half vectors, which is turned by `azimuth` about the normal
void reflect(const Model& model, const std::vector<double>& values, const std::vector<CellPoint>& halves,
             const Vec3& v, double azimuth, Reflected& out) {
  const double turn_cos = math::cos(azimuth), turn_sin = math::sin(azimuth);
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const Vec3& h = halves[i].h;
    const double vh = dot(h, v);
    const Vec3 l{2 * vh * h[0] - v[0], 2 * vh * h[1] - v[1], 2 * vh * h[2] - v[2]};
    out.lights[i] = l;
    out.weight[i] = vh > 0 && l[2] > 0 ? 4 * vh * l[2] * halves[i].solid_angle : 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3& d = k == 0 ? l : v;
      out.numbers[3 * k][i] = static_cast<float>(d[0] * turn_cos - d[1] * turn_sin);
      out.numbers[3 * k + 1][i] = static_cast<float>(d[0] * turn_sin + d[1] * turn_cos);
      out.numbers[3 * k + 2][i] = static_cast<float>(d[2]);
    }
  }
  const float* in[6];
  float* rgb[3];
  for (std::size_t k = 0; k < 6; ++k) in[k] = out.numbers[k].data();
  for (std::size_t k = 0; k < 3; ++k) rgb[k] = out.numbers[6 + k].data();
  model.f32_batch(halves.size(), in, values.data(), rgb);
}

// Writes the samples of a view into a line of the picture.
void write_samples(const std::vector<CellPoint>& halves, const Reflected& from, const Vec3& v, bool grey,
                   int line, LobeSamples& out) {
  std::vector<Vec3> shares(static_cast<std::size_t>(out.count));
  Vec3 total{};
  for (std::size_t cell = 0; cell < shares.size(); ++cell) {
    Vec3 mean{};
    double all = 0;
    for (std::size_t i = cell * each; i < (cell + 1) * each; ++i) {
      if (!(from.weight[i] > 0)) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const double light = from.light(i, c);
        shares[cell][c] += light;
        all += light;
        for (std::size_t axis = 0; axis < 3; ++axis) mean[axis] += light * from.lights[i][axis];
      }
    }
    const double length = std::sqrt(dot(mean, mean));
    Vec3 h = halves[cell * each + each / 2].h;
    double level = dullest_sample;
    if (length > 0) {
      for (std::size_t axis = 0; axis < 3; ++axis) h[axis] = mean[axis] / length + v[axis];
      h = scaled(h, 1 / std::sqrt(dot(h, h)));
      level = level_of_mean(length / all);
    }
    const auto to = out.picture.at(int(cell), line);
    for (std::size_t axis = 0; axis < 3; ++axis) to[axis] = static_cast<float>(h[axis]);
    to[3] = static_cast<float>(level);
    for (std::size_t c = 0; c < 3; ++c) total[c] += shares[cell][c];
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t of = grey ? 1 : c;
    for (std::size_t cell = 0; cell < shares.size(); ++cell)
      out.picture.at(out.count + int(cell), line)[c] =
          static_cast<float>(total[of] > 0 ? shares[cell][of] / total[of] : 1.0 / out.count);
    out.picture.at(2 * out.count, line)[c] = static_cast<float>(total[c]);
  }
}

}  // namespace

void set_lobe_samples(const Model& model, const std::vector<double>& values, bool grey, double azimuth,
                      int row, LobeSamples& out) {
  const LobeDensity density(model, values);
  if (out.empty()) out.wide = out.rows == 1 && density.polar(0.5) > wide_lobe;
  const std::vector<CellPoint> halves = cell_points(density, out.sectors);
  if (out.empty()) {
    out.count = int(halves.size() / each);
    out.picture = Image(2 * out.count + 1, out.views * out.rows, 4);
  }
  Reflected light(halves.size());
  for (int view = 0; view < out.views; ++view) {
    const double root = double(view) / (out.views - 1), nv = std::max(root * root, 1e-3);
    const Vec3 v{std::sqrt((1 - nv) * (1 + nv)), 0, nv};
    reflect(model, values, halves, v, azimuth, light);
    write_samples(halves, light, v, grey, row * out.views + view, out);
  }
}

}  // namespace etak
