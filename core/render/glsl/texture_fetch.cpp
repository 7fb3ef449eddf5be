// SPDX-License-Identifier: Apache-2.0
#include "core/render/glsl/texture_fetch.h"

#include <algorithm>

#include "core/base/error.h"

namespace etak {

TextureUse texture_use(std::span<const std::string> defines) {
  TextureUse out;
  out.diffuse = out.specular = out.gloss = false;
  for (const std::string& define : defines) {
    if (define == "ETAK_DIFFUSE_TEXTURE")
      out.diffuse = true;
    else if (define == "ETAK_SPECULAR_TEXTURE")
      out.specular = true;
    else if (define == "ETAK_GLOSS_TEXTURE")
      out.gloss = true;
    else if (define == "ETAK_NO_DIFFUSE")
      out.no_diffuse = true;
    else if (define == "ETAK_SCALAR_F0")
      out.scalar_f0 = true;
    else if (define == "ETAK_ALPHA_TEST")
      out.alpha = TextureUse::Alpha::test;
    else if (define == "ETAK_ALPHA_BLEND")
      out.alpha = TextureUse::Alpha::blend;
    else if (define == "ETAK_ALPHA_TEXTURE")
      out.fetch_alpha = true;
    else
      throw Error::at(printable(define), "is no define that etak pack lists",
                      "ETAK_DIFFUSE_TEXTURE, ETAK_SPECULAR_TEXTURE, ETAK_GLOSS_TEXTURE, ETAK_NO_DIFFUSE, "
                      "ETAK_SCALAR_F0, ETAK_ALPHA_TEST, ETAK_ALPHA_BLEND or ETAK_ALPHA_TEXTURE");
  }
  return out;
}

TextureUse texture_use(std::string_view text) {
  std::vector<std::string> defines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    if (line.starts_with("#define ")) line.remove_prefix(8);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    if (!line.empty()) defines.emplace_back(line);
  }
  return texture_use(defines);
}

TextureFetch texture_fetch(const TextureUse& use, double opacity) {
  TextureFetch out;
  const auto line = [&](const std::string& code) { out.code += code + '\n'; };
  const auto uniform = [&](const char* name, std::vector<float> values) {
    const auto width = static_cast<int>(values.size());
    out.uniforms.push_back({name, width, 1, false, std::move(values)});
  };
  const bool a = use.diffuse || use.fetch_alpha, b = use.specular || use.gloss;
  const bool blend = use.alpha == TextureUse::Alpha::blend, test = use.alpha == TextureUse::Alpha::test;
  if (a) line("uniform sampler2D diffuse_alpha;");
  if (b) line("uniform sampler2D specular_gloss;");
  if (use.diffuse) line("vec3 texel_diffuse;");
  if (use.fetch_alpha)
    line("float texel_opacity;");
  else if (blend)
    uniform("texel_opacity", {static_cast<float>(opacity)});
  if (use.specular) line("vec3 texel_f0;");
  if (use.gloss) line("float texel_gloss;");
  const bool roughness = use.gloss && use.gloss_form != GlossForm::schueler;
  // e = 2 / r^4 - 2 is the exponent of the lobe whose width is r^2; Schueler's g holds 1 to 4096 of it.
  if (roughness)
    line(
        "float gloss_of_roughness(float r) {\n  float r4 = max(r * r * r * r, 1e-8);\n"
        "  return clamp(log2(max(2.0 / r4 - 2.0, 1.0)) / 12.0, 0.0, 1.0);\n}");
  const auto share = [&](std::size_t i) { return static_cast<float>(use.region[i]); };
  if (a || b) {
    uniform("region_corner", {share(0), share(1)});
    uniform("region_size", {share(2), share(3)});
  }
  // A mask of one number shows all or nothing.
  const bool one_mask = test && !use.fetch_alpha;
  const bool all_hidden = one_mask && opacity < use.cutoff;
  out.any = a || b || all_hidden;
  if (out.any) line("void fetch(vec2 at) {");
  if (a || b) {
    line("  vec2 uv = vec2(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y);");
    if (use.rotated) line("  uv = vec2(1.0 - uv.y, uv.x);");
    line("  uv = region_corner + region_size * uv;");
  }
  if (a) line("  vec4 a = texture(diffuse_alpha, uv);");
  if (b) line("  vec4 b = texture(specular_gloss, uv);");
  if (use.diffuse) line("  texel_diffuse = a.rgb;");
  if (use.fetch_alpha) line("  texel_opacity = a.a;");
  if (use.specular) line(use.scalar_f0 ? "  texel_f0 = vec3(b.r);" : "  texel_f0 = b.rgb;");
  if (use.gloss)
    line(std::string("  texel_gloss = ") +
         (!roughness                               ? "b.a"
          : use.gloss_form == GlossForm::roughness ? "gloss_of_roughness(b.a)"
                                                   : "gloss_of_roughness(1.0 - b.a)") +
         ";");
  if (test && use.fetch_alpha) {
    uniform("alpha_cutoff", {static_cast<float>(use.cutoff)});
    line("  if (texel_opacity < alpha_cutoff) discard;");
  }
  if (blend && use.diffuse) line("  texel_diffuse *= texel_opacity;");
  if (all_hidden) line("  discard;");
  if (out.any) line("}\n");

  const auto tell = [&](const char* what, bool in, const char* reason) {
    out.features.push_back({what, in, in ? "varies" : reason});
  };
  tell("diffuse texture", use.diffuse, use.no_diffuse ? "K_d is 0" : "one colour everywhere");
  tell("F0 texture", use.specular, use.scalar_f0 ? "one grey number everywhere" : "one colour everywhere");
  tell("gloss texture", use.gloss, "one number everywhere");
  tell("alpha texture", use.fetch_alpha, "no alpha, or one number everywhere");
  tell("alpha test", test && (use.fetch_alpha || all_hidden),
       one_mask ? "the mask hides nothing"
       : blend  ? "alpha blends"
                : "opaque");
  return out;
}

}  // namespace etak
