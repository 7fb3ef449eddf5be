// SPDX-License-Identifier: Apache-2.0
#include "core/pack/blocks/report_blocks.h"

#include <algorithm>

#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/text.h"

namespace etak {
namespace {

bool is_diffuse(const BlockLevel& level) {
  return level.texture == Texture::diffuse_alpha;
}

std::string texture_name(const BlockLevel& level) {
  return "page " + std::to_string(level.page) + ' ' + std::string(name(level.texture));
}

std::string errors_text(const BlockLevel& level, double colour, double fourth) {
  return "dE " + number(colour, 3) + (is_diffuse(level) ? " of diffuse, " : " of F0, ") + number(fourth, 3) +
         (is_diffuse(level) ? " % of coverage" : " % of the gloss exponent");
}

std::string worst_text(const BlockLevel& level) {
  double colour = 0, fourth = 0;
  for (const BlockMaterial& each : level.materials) {
    colour = std::max(colour, each.colour_p99);
    fourth = std::max(fourth, each.fourth_p99);
  }
  return errors_text(level, colour, fourth);
}

std::string material_json(const BlockLevel& level, const BlockMaterial& m) {
  const std::string colour = is_diffuse(level) ? "diffuse_de" : "f0_de",
                    fourth = is_diffuse(level) ? "alpha" : "gloss";
  return "{\"id\": " + json(m.id) + ", \"" + colour + "_p99\": " + json(m.colour_p99) + ", \"" + colour +
         "_max\": " + json(m.colour_largest) + ", \"" + fourth + "_p99\": " + json(m.fourth_p99) + ", \"" +
         fourth + "_max\": " + json(m.fourth_largest) +
         (m.shaded ? ", \"shaded_de_p99\": " + json(m.shaded->p99) + ", \"shaded_de_max\": " +
                         json(m.shaded->largest) + ", \"shaded_flip\": " + json(m.shaded->flip)
                   : "") +
         ", \"met\": " + json(m.met) + "}";
}

// What the worst material looks like under light.
std::string shaded_text(const std::vector<BlockLevel>& levels) {
  const BlockMaterial *usual = nullptr, *most = nullptr, *seen = nullptr;
  for (const BlockLevel& level : levels)
    for (const BlockMaterial& m : level.materials) {
      if (!m.shaded) continue;
      if (usual == nullptr || m.shaded->p99 > usual->shaded->p99) usual = &m;
      if (most == nullptr || m.shaded->largest > most->shaded->largest) most = &m;
      if (seen == nullptr || m.shaded->flip > seen->shaded->flip) seen = &m;
    }
  if (usual == nullptr) return {};
  return "shaded under three lights from five angles, materials change by dE " +
         number(usual->shaded->p99, 3) + " at most (99 % of texels, " + line_text(usual->id) +
         "), no texel by more than " + number(most->shaded->largest, 3) + " (" + line_text(most->id) +
         "), and by a mean FLIP of " + number(seen->shaded->flip, 2) + " at most (" + line_text(seen->id) +
         ")\n";
}

}  // namespace

std::string blocks_text(const std::vector<BlockLevel>& levels) {
  std::string out;
  for (const BlockLevel& first : levels) {
    if (first.level != 0) continue;
    std::size_t shared = 0, of = 0;
    std::string missed;
    for (const BlockLevel& each : levels) {
      if (each.page != first.page || each.texture != first.texture) continue;
      shared += each.shared;
      if (each.tail) {
        if (!each.materials.empty())
          missed += "  level " + std::to_string(each.level) +
                    " and smaller ones stay RGBA8, in a file of their own: " + each.tried + " would change " +
                    worst_text(each) + '\n';
        continue;
      }
      ++of;
      for (const BlockMaterial& m : each.materials)
        if (!m.met)
          missed += "  " + line_text(m.id) + " on level " + std::to_string(each.level) +
                    " misses the budget: " + errors_text(each, m.colour_p99, m.fourth_p99) + "\n";
    }
    out += texture_name(first) + " in " + first.format +
           (first.fourth_apart ? is_diffuse(first) ? " with alpha in R8" : " with gloss in R8" : "") +
           (first.fallback ? ", since " + first.tried + " would change " : ": ") + worst_text(first) +
           " at most (99 % of a material's texels, level 0)";
    if (!first.fallback)
      out += "; " + std::to_string(of) + (of == 1 ? " level, " : " levels, ") + std::to_string(shared) +
             " blocks with texels of two regions";
    out += '\n' + missed;
  }
  return out.empty() ? out : '\n' + out + shaded_text(levels);
}

std::string block_level_json(const BlockLevel& level, bool seconds) {
  return "{\"page\": " + std::to_string(level.page) + ", \"texture\": " + json(name(level.texture)) +
         ", \"level\": " + std::to_string(level.level) + ", \"format\": " + json(level.format) +
         (level.fourth_apart ? ", \"fourth\": \"R8\"" : "") + (level.tail ? ", \"tail\": true" : "") +
         ", \"bits_per_texel\": " +
         json(8 * static_cast<double>(level.bytes) / static_cast<double>(level.texels)) +
         (seconds ? ", \"seconds\": " + json(level.seconds) : "") + ", \"blocks\": " + json(level.blocks) +
         ", \"escalated\": " + json(level.escalated) + ", \"shared_blocks\": " + json(level.shared) +
         ", \"fallback\": " + json(level.fallback) + ", \"materials\": [" +
         joined(level.materials, ", ", [&](const BlockMaterial& m) { return material_json(level, m); }) +
         "]}";
}

}  // namespace etak
