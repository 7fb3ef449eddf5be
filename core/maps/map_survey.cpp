// SPDX-License-Identifier: Apache-2.0
#include "core/maps/map_survey.h"

#include <algorithm>
#include <array>
#include <bit>
#include <bitset>
#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

#include "core/base/random.h"
#include "core/image/blocks/budget.h"
#include "core/maps/jpeg_comb.h"
#include "core/maps/other_content.h"
#include "core/math/functions.h"

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

// The loops below run over whole rows, each with one thing to do and without a branch, so that compilers make
// vector code of them. A texel is read as one number for the same reason.
std::uint32_t texel_at(const std::uint8_t* rgba, std::size_t i) {
  std::uint32_t out = 0;
  std::memcpy(&out, rgba + 4 * i, sizeof out);
  return out;
}

// The code of a channel in such a number.
std::int32_t code_in(std::uint32_t texel, unsigned channel) {
  const unsigned byte = std::endian::native == std::endian::little ? channel : 3 - channel;
  return static_cast<std::int32_t>(texel >> 8 * byte & 255);
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
    const std::size_t width = x.size();
    const std::array<float*, 3> components{x.data(), y.data(), z.data()};
    for (unsigned channel = 0; channel < components.size(); ++channel) {
      float* const out = components[channel];
      for (std::size_t i = 0; i < width; ++i)
        out[i] = static_cast<float>(2 * code_in(texel_at(rgba, i), channel) - 255) / 255;
    }
    for (std::size_t i = 0; i < width; ++i) length[i] = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
    const auto slope = [&](const std::vector<float>& of, std::vector<float>& out) {
      for (std::size_t i = 0; i < width; ++i)
        out[i] = std::clamp(-of[i] / std::max(z[i], least_z), -most_slope, most_slope);
    };
    slope(x, along);
    slope(y, green);
  }
};

// Adds pairs of a row, of which `counted` are real and the others (0, 0). The sums of four columns side by
// side are added at the end, always in the same order.
void add_pairs(PairSums& sums, const std::vector<float>& xs, const std::vector<float>& ys,
               std::uint64_t counted) {
  constexpr std::size_t lanes = 4;
  std::array<double, lanes> x{}, y{}, xx{}, yy{}, xy{};
  const auto add = [&](std::size_t lane, double a, double b) {
    x[lane] += a;
    y[lane] += b;
    xx[lane] += a * a;
    yy[lane] += b * b;
    xy[lane] += a * b;
  };
  std::size_t i = 0;
  for (; i + lanes <= xs.size(); i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      add(lane, static_cast<double>(xs[i + lane]), static_cast<double>(ys[i + lane]));
  for (; i < xs.size(); ++i) add(0, static_cast<double>(xs[i]), static_cast<double>(ys[i]));
  sums.count += counted;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    sums.x += x[lane];
    sums.y += y[lane];
    sums.xx += xx[lane];
    sums.yy += yy[lane];
    sums.xy += xy[lane];
  }
}

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
    out_.jpeg = jpeg_.finish();
    return std::move(out_);
  }

 private:
  static constexpr std::int64_t most_blocks = 4096;
  static constexpr float smooth_loss = 2e-5f;

  std::size_t at(std::size_t x, int y) const { return 4 * (static_cast<std::size_t>(y) * width_ + x); }

  void count_grey(const std::uint8_t* rgba) {
    std::uint32_t grey = 0;
    for (std::size_t i = 0; i < width_; ++i) {
      const std::uint32_t texel = texel_at(rgba, i);
      const std::int32_t red = code_in(texel, 0), green = code_in(texel, 1), blue = code_in(texel, 2);
      const std::int32_t least = std::min(std::min(red, green), blue),
                         most = std::max(std::max(red, green), blue);
      grey += most - least <= 2 ? 1u : 0u;
    }
    out_.shape.grey += grey;
  }

  void look_at_row(int y) {
    if (width_ < 3) return;
    const NormalRow &row = rows_[static_cast<std::size_t>(y)],
                    &above = rows_[static_cast<std::size_t>(y) - 1],
                    &below = rows_[static_cast<std::size_t>(y) + 1];
    const std::size_t inner = width_ - 2;  // the texels with a neighbour on each side
    for (std::vector<float>* part : {&lacks_, &loss_, &down_, &across_}) part->resize(inner);
    const auto half_squared = [](float a, float b) { return (a - b) * (a - b) / 4; };
    for (std::size_t i = 0; i < inner; ++i) lacks_[i] = 1 - row.length[i + 1];
    // The mean of 2 x 2 normals whose neighbours after the shrinking are d apart lacks d * d / 32 per axis.
    for (std::size_t i = 0; i < inner; ++i)
      loss_[i] = half_squared(row.x[i + 2], row.x[i]) + half_squared(row.y[i + 2], row.y[i]) +
                 half_squared(row.z[i + 2], row.z[i]);
    for (std::size_t i = 0; i < inner; ++i)
      loss_[i] =
          (loss_[i] + half_squared(below.x[i + 1], above.x[i + 1]) +
           half_squared(below.y[i + 1], above.y[i + 1]) + half_squared(below.z[i + 1], above.z[i + 1])) /
          32;
    count_lengths();
    add_pairs(out_.shape.loss, loss_, lacks_, inner);
    if (out_.shape.steep_colors < steep_colors_.size()) collect_steep_colors(row);

    for (std::size_t i = 0; i < inner; ++i) {
      down_[i] = (below.along[i + 1] - above.along[i + 1]) / 2;
      across_[i] = (row.green[i + 2] - row.green[i]) / 2;
    }
    add_twists();
  }

  void count_lengths() {
    constexpr float one_code = 1 / 127.5f;
    std::uint32_t off = 0, too_short = 0, too_long = 0, smooth = 0, smooth_short = 0;
    for (std::size_t i = 0; i < lacks_.size(); ++i) {
      const bool is_short = lacks_[i] > one_code, is_smooth = loss_[i] < smooth_loss;
      off += std::abs(lacks_[i]) > 2.5f * one_code ? 1u : 0u;
      too_short += is_short ? 1u : 0u;
      too_long += lacks_[i] < -one_code ? 1u : 0u;
      smooth += is_smooth ? 1u : 0u;
      smooth_short += is_short && is_smooth ? 1u : 0u;
    }
    NormalShape& shape = out_.shape;
    shape.texels += lacks_.size();
    shape.off += off;
    shape.too_short += too_short;
    shape.too_long += too_long;
    shape.smooth += smooth;
    shape.smooth_short += smooth_short;
  }

  // Marks the colours of texels with a loss, until there are as many as are counted.
  void collect_steep_colors(const NormalRow& row) {
    constexpr float steep = 2e-4f;
    bool any = false;
    for (std::size_t i = 0; i < loss_.size(); ++i) {
      if (!(loss_[i] > steep)) continue;
      any = true;
      const auto bits = static_cast<std::uint64_t>(row.x[i + 1] * 255 + 255) << 40 |
                        static_cast<std::uint64_t>(row.y[i + 1] * 255 + 255) << 20 |
                        static_cast<std::uint64_t>(row.z[i + 1] * 255 + 255);
      steep_colors_.set(SplitMix::mixed(bits) % steep_colors_.size());
    }
    if (any) out_.shape.steep_colors = static_cast<std::uint32_t>(steep_colors_.count());
  }

  // Adds the texels that are twisted one way or the other.
  void add_twists() {
    constexpr float twisted = 1.5f / 127.5f;
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < down_.size(); ++i) {
      const float down = down_[i], across = across_[i];
      const bool counts = std::max(std::abs(down), std::abs(across)) > twisted;
      count += counts ? 1u : 0u;
      down_[i] = counts ? std::clamp(down, -1.0f, 1.0f) : 0.0f;
      across_[i] = counts ? std::clamp(across, -1.0f, 1.0f) : 0.0f;
    }
    if (count > 0) add_pairs(out_.shape.twist, down_, across_, count);
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
      out.narrow += math::pow(rough, 4) < 2 / (exponent + 2);
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
  std::vector<float> lacks_, loss_, down_, across_;  // of the row that is looked at, without its ends
  std::bitset<4096> steep_colors_;
  JpegCombSearch jpeg_;
  std::size_t block_ = 0, block_step_ = 1;
};

MapEvidence with_size(MapEvidence map, const PictureHeader& header, FileRole role) {
  map.role = role;
  map.width = header.width;
  map.blocks = header.blocks;
  map.height = header.height;
  return map;
}

//   two_channels   z follows from x and y
double degrees_between(const std::array<std::uint8_t, 4>& a, const std::array<std::uint8_t, 4>& b,
                       bool two_channels) {
  const auto normal = [&](const std::array<std::uint8_t, 4>& code) {
    Vec3 out{2.0 * code[0] - 255, 2.0 * code[1] - 255, 2.0 * code[2] - 255};
    if (two_channels) out[2] = std::sqrt(std::max(0.0, 255.0 * 255 - out[0] * out[0] - out[1] * out[1]));
    return out;
  };
  const Vec3 from = normal(a), to = normal(b);
  const double cosine = dot(from, to) / std::sqrt(dot(from, from) * dot(to, to));
  return math::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
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
          if (role == FileRole::occlusion) out.grey.coloured += is_coloured(texel);
          if (!cover.is_there() || cover.codes()[4 * i + 3] != 0) continue;
          ++out.grey.hidden;
          out.grey.hidden_lit += code > lit;
        }
        out.grey.texels += texels;
      });
  return with_size(std::move(out), header, role);
}

BlockLoss survey_loss(RowSource& blocks, RowSource& source, FileRole role, std::optional<GlossPlace> gloss) {
  const PictureHeader header = blocks.header();
  const bool is_f0 = role == FileRole::specular_gloss || role == FileRole::f0_only;
  const bool has_colour = !header.floating && !source.header().floating &&
                          (is_f0 || role == FileRole::diffuse_alpha || role == FileRole::base_color ||
                           role == FileRole::emissive);
  const GlossForm form = is_f0                      ? GlossForm::schueler
                         : gloss && gloss->is_gloss ? GlossForm::one_minus_roughness
                                                    : GlossForm::roughness;
  if (!has_colour && !gloss && role != FileRole::normal) return {};
  const BlockMeasure measure(Texture::specular_gloss, form, {});
  const bool two_channels = header.blocks == "BC5";
  TexelSpread colour(0.05), exponent(1), degrees(0.1);
  MapRows held(&blocks), exact(&source);
  for_each_band(
      header,
      [&](int rows) {
        held.read(rows);
        exact.read(rows);
      },
      [&](int rows) {
        const std::size_t texels = static_cast<std::size_t>(header.width) * static_cast<std::size_t>(rows);
        for (std::size_t i = 0; i < texels; ++i) {
          std::array<std::uint8_t, 4> from{}, to{};
          std::memcpy(from.data(), exact.codes() + 4 * i, from.size());
          std::memcpy(to.data(), held.codes() + 4 * i, to.size());
          if (has_colour && (is_f0 || from[3] != 0)) colour.add(measure.colour(from, to));
          if (role == FileRole::normal) degrees.add(degrees_between(from, to, two_channels));
          if (!gloss) continue;
          const std::uint8_t was = from[gloss->channel], is = to[gloss->channel];
          exponent.add(std::abs(was - is) <= 1 ? 0 : measure.fourth(was, is, -1));
        }
      });
  BlockLoss out;
  out.blocks = header.blocks;
  if (has_colour) out.colour = colour.percentile_99();
  if (gloss) out.exponent = exponent.percentile_99();
  if (role == FileRole::normal) out.degrees = degrees.percentile_99();
  return out;
}

}  // namespace etak
