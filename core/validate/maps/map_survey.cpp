// SPDX-License-Identifier: Apache-2.0
#include "core/validate/maps/map_survey.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/validate/maps/jpeg_comb.h"

namespace etak {

namespace {

constexpr std::int64_t texels_looked_at = std::int64_t{1} << 20;

// Every how many bands one is looked at.
int band_step(const PictureHeader& map) {
  const std::int64_t texels = std::int64_t{map.width} * map.height;
  return static_cast<int>(std::max<std::int64_t>(1, (texels + texels_looked_at - 1) / texels_looked_at));
}

// The next rows of a picture as codes. Floats of maps are plain values of 0 to 1.
class MapRows {
 public:
  explicit MapRows(RowSource* source) : source_(source) {}

  bool is_there() const { return source_ != nullptr; }

  void read(int rows) {
    if (source_ == nullptr) return;
    const auto stride = 4 * static_cast<std::size_t>(source_->header().width);
    codes_.resize(stride * map_band_rows);
    if (!source_->header().floating) return source_->read_rows(codes_.data(), stride, rows);
    floats_.resize(codes_.size());
    source_->read_float_rows(floats_.data(), stride, rows);
    for (std::size_t i = 0; i < stride * static_cast<std::size_t>(rows); ++i)
      // NaN compares false with everything and becomes 0.
      codes_[i] = floats_[i] > 0 ? static_cast<std::uint8_t>(std::lround(255 * std::min(floats_[i], 1.0f)))
                                 : std::uint8_t{0};
  }

  const std::uint8_t* codes() const { return codes_.data(); }

 private:
  RowSource* source_;
  std::vector<std::uint8_t> codes_;
  std::vector<float> floats_;
};

// Calls look(first row, rows) for every band to be looked at; `read` reads each band.
template <class Read, class Look>
void for_each_band(const PictureHeader& map, Read read, Look look) {
  const int step = band_step(map);
  for (int band = 0, y = 0; y < map.height; ++band, y += map_band_rows) {
    const int rows = std::min(map_band_rows, map.height - y);
    read(rows);
    if (band % step == 0) look(rows);
  }
}

// A row of normals, a component each, with the surface's slope along the row and in green's direction.
struct NormalRow {
  std::vector<float> x, y, z, length, along, green;

  void resize(std::size_t width) {
    for (std::vector<float>* part : {&x, &y, &z, &length, &along, &green}) part->resize(width);
  }

  void decode(const std::uint8_t* rgba) {
    // Beyond 76 degrees a slope is held back, so that a few texels do not outweigh all others.
    constexpr float least_z = 0.1f, most_slope = 4;
    for (std::size_t i = 0; i < x.size(); ++i, rgba += 4) {
      const auto component = [](std::uint8_t code) { return static_cast<float>(2 * code - 255) / 255; };
      x[i] = component(rgba[0]);
      y[i] = component(rgba[1]);
      z[i] = component(rgba[2]);
      length[i] = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
      const float down = std::max(z[i], least_z);
      along[i] = std::clamp(-x[i] / down, -most_slope, most_slope);
      green[i] = std::clamp(-y[i] / down, -most_slope, most_slope);
    }
  }
};

class NormalSurvey {
 public:
  NormalSurvey(const PictureHeader& map, const BesideNormals& beside)
      : width_(static_cast<std::size_t>(map.width)), place_(beside.place) {
    for (NormalRow& row : rows_) row.resize(width_);
    const std::int64_t blocks = std::min(std::int64_t{map.width} * map.height, texels_looked_at) / 64;
    block_step_ =
        static_cast<std::size_t>(blocks / most_blocks) | 1u;  // odd: no column of blocks is preferred
    if (beside.gloss != nullptr) out_.gloss.emplace();
  }

  void look(const std::uint8_t* normals, const std::uint8_t* heights, const std::uint8_t* gloss, int rows) {
    for (int y = 0; y < rows; ++y) {
      const std::uint8_t* row = normals + at(0, y);
      add_normals(out_.normals, row, static_cast<int>(width_));
      count_grey(row);
      rows_[static_cast<std::size_t>(y)].decode(row);
    }
    for (int y = 1; y + 1 < rows; ++y) look_at_row(y);
    if (heights != nullptr)
      for (int y = 1; y + 1 < rows; ++y) compare_with_heights(y, heights);
    if (gloss != nullptr)
      for (int y = 0; y + 4 <= rows; y += 4) compare_with_gloss(y, gloss);
    for (int y = 0; y + 8 <= rows; y += 8) look_for_jpeg(normals, y, rows);
  }

  MapEvidence finish() {
    out_.shape.steep_colors = static_cast<std::uint32_t>(steep_colors_.count());
    out_.jpeg = jpeg_.finish();
    return std::move(out_);
  }

 private:
  static constexpr std::int64_t most_blocks = 4096;

  std::size_t at(std::size_t x, int y) const { return 4 * (static_cast<std::size_t>(y) * width_ + x); }

  void count_grey(const std::uint8_t* rgba) {
    std::uint64_t grey = 0;
    for (std::size_t i = 0; i < width_; ++i, rgba += 4) {
      const auto [least, most] = std::minmax({rgba[0], rgba[1], rgba[2]});
      grey += most - least <= 2;
    }
    out_.shape.grey += grey;
  }

  void look_at_row(int y) {
    const NormalRow &row = rows_[static_cast<std::size_t>(y)],
                    &above = rows_[static_cast<std::size_t>(y) - 1],
                    &below = rows_[static_cast<std::size_t>(y) + 1];
    NormalShape& shape = out_.shape;
    constexpr float one_code = 1 / 127.5f, smooth = 2e-5f, steep = 2e-4f, twisted = 1.5f / 127.5f;
    for (std::size_t i = 1; i + 1 < width_; ++i) {
      const float lacks = 1 - row.length[i];
      ++shape.texels;
      shape.off += std::abs(lacks) > 2.5f * one_code;
      shape.too_short += lacks > one_code;
      shape.too_long += lacks < -one_code;
      const auto half_squared = [](float a, float b) { return (a - b) * (a - b) / 4; };
      // The mean of 2 x 2 normals whose neighbours after the shrinking are d apart lacks d * d / 32 per axis.
      const float loss =
          (half_squared(row.x[i + 1], row.x[i - 1]) + half_squared(row.y[i + 1], row.y[i - 1]) +
           half_squared(row.z[i + 1], row.z[i - 1]) + half_squared(below.x[i], above.x[i]) +
           half_squared(below.y[i], above.y[i]) + half_squared(below.z[i], above.z[i])) /
          32;
      shape.loss.add(loss, lacks);
      if (loss < smooth) {
        ++shape.smooth;
        shape.smooth_short += lacks > one_code;
      } else if (loss > steep) {
        const auto bits = static_cast<std::uint64_t>(row.x[i] * 255 + 255) << 40 |
                          static_cast<std::uint64_t>(row.y[i] * 255 + 255) << 20 |
                          static_cast<std::uint64_t>(row.z[i] * 255 + 255);
        steep_colors_.set(SplitMix::mixed(bits) % steep_colors_.size());
      }
      const float down = (below.along[i] - above.along[i]) / 2,
                  across = (row.green[i + 1] - row.green[i - 1]) / 2;
      if (std::max(std::abs(down), std::abs(across)) > twisted)
        shape.twist.add(std::clamp(down, -1.0f, 1.0f), std::clamp(across, -1.0f, 1.0f));
    }
  }

  void compare_with_heights(int y, const std::uint8_t* heights) {
    const NormalRow& row = rows_[static_cast<std::size_t>(y)];
    for (std::size_t i = 1; i + 1 < width_; ++i) {
      const int right = heights[at(i + 1, y)] - heights[at(i - 1, y)],
                down = heights[at(i, y + 1)] - heights[at(i, y - 1)];
      if (std::abs(right) > 2) out_.shape.relief_x.add(row.along[i], right);
      if (std::abs(down) > 2) out_.shape.relief_y.add(row.green[i], down);
    }
  }

  // Toksvig 2005: a mean normal of length m allows no exponent above m / (1 - m); that of GGX's width a is
  // 2 / a^2 - 2, and a is roughness squared.
  void compare_with_gloss(int y, const std::uint8_t* gloss) {
    constexpr double varies = 0.9, most_times = 4;
    GlossBesideNormals& out = *out_.gloss;
    for (std::size_t i = 0; i + 4 <= width_; i += 4) {
      double x = 0, green = 0, z = 0, rough = 0;
      for (int v = y; v < y + 4; ++v)
        for (std::size_t u = i; u < i + 4; ++u) {
          const NormalRow& row = rows_[static_cast<std::size_t>(v)];
          const double length = std::max(row.length[u], 0.1f);
          x += row.x[u] / length;
          green += row.y[u] / length;
          z += row.z[u] / length;
          const double value = gloss[at(u, v) + place_.channel] / 255.0;
          rough += place_.is_gloss ? 1 - value : value;
        }
      const double mean = std::min(std::sqrt(x * x + green * green + z * z) / 16, 1.0);
      rough /= 16;
      ++out.blocks;
      out.relation.add(1 - mean, rough);
      if (mean >= varies) continue;
      ++out.varying;
      const double exponent = most_times * mean / (1 - mean);
      out.narrow += std::pow(rough, 4) < 2 / (exponent + 2);
    }
  }

  void look_for_jpeg(const std::uint8_t* normals, int y, int rows) {
    for (std::size_t i = 0; i + 8 <= width_; i += 8, ++block_) {
      if (block_ % block_step_ != 0) continue;
      jpeg_.add_block(normals + at(i, y), 4 * width_, true);
      if (i + 12 <= width_ && y + 12 <= rows) jpeg_.add_block(normals + at(i + 4, y + 4), 4 * width_, false);
    }
  }

  const std::size_t width_;
  const GlossPlace place_;
  MapEvidence out_;
  std::array<NormalRow, map_band_rows> rows_;
  std::bitset<4096> steep_colors_;
  JpegCombSearch jpeg_;
  std::size_t block_ = 0, block_step_ = 1;
};

MapEvidence with_size(MapEvidence map, const PictureHeader& header, FileRole role) {
  map.role = role;
  map.width = header.width;
  map.height = header.height;
  return map;
}

}  // namespace

MapEvidence survey_normals(RowSource& normals, const BesideNormals& beside) {
  const PictureHeader header = normals.header();
  MapRows map(&normals), heights(beside.height), gloss(beside.gloss);
  NormalSurvey survey(header, beside);
  for_each_band(
      header,
      [&](int rows) {
        for (MapRows* part : {&map, &heights, &gloss}) part->read(rows);
      },
      [&](int rows) {
        survey.look(map.codes(), heights.is_there() ? heights.codes() : nullptr,
                    gloss.is_there() ? gloss.codes() : nullptr, rows);
      });
  return with_size(survey.finish(), header, FileRole::normal);
}

MapEvidence survey_grey(RowSource& source, FileRole role, RowSource* alpha) {
  constexpr int lit = 16;
  const PictureHeader header = source.header();
  MapRows map(&source), cover(alpha);
  MapEvidence out;
  for_each_band(
      header,
      [&](int rows) {
        map.read(rows);
        cover.read(rows);
      },
      [&](int rows) {
        const std::size_t texels = static_cast<std::size_t>(header.width) * static_cast<std::size_t>(rows);
        for (std::size_t i = 0; i < texels; ++i) {
          const std::uint8_t* texel = map.codes() + 4 * i;
          const std::uint8_t code =
              role == FileRole::occlusion ? texel[0] : std::max({texel[0], texel[1], texel[2]});
          ++out.grey.codes[code];
          if (!cover.is_there() || cover.codes()[4 * i + 3] != 0) continue;
          ++out.grey.hidden;
          out.grey.hidden_lit += code > lit;
        }
        out.grey.texels += texels;
      });
  return with_size(std::move(out), header, role);
}

}  // namespace etak
