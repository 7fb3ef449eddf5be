// SPDX-License-Identifier: Apache-2.0
#include "core/glsl/texture_fetch.h"

#include <algorithm>

#include "core/base/error.h"

namespace etak {
namespace {

// What a shader reads from the two textures A and B of an atlas.
struct FetchedTextures {
  const TextureUse& use;
  double opacity;  // used where it is not fetched

  bool a() const { return use.diffuse || (use.fetch_alpha && !use.alpha_apart); }
  bool b() const { return use.specular || (use.gloss && !use.gloss_apart); }
  bool alpha_apart() const { return use.fetch_alpha && use.alpha_apart; }
  bool gloss_apart() const { return use.gloss && use.gloss_apart; }
  bool any() const { return use.diffuse || use.fetch_alpha || use.specular || use.gloss; }
  bool blends() const { return use.alpha == TextureUse::Alpha::blend; }
  bool tests() const { return use.alpha == TextureUse::Alpha::test; }
  bool roughness() const { return use.gloss && use.gloss_form != GlossForm::schueler; }
  // The format of the texture does not decode F0.
  bool encoded() const { return use.specular && use.channels == TextureUse::Channels::f0_gloss; }
  std::string gloss_channel() const {
    return use.gloss_apart                                     ? ".r"
           : use.channels == TextureUse::Channels::rgb_alpha   ? ".a"
           : use.channels == TextureUse::Channels::gloss_alone ? ".r"
                                                               : ".g";
  }
  // A mask whose alpha is one number shows all texels or none.
  bool one_mask() const { return tests() && !use.fetch_alpha; }
  bool all_hidden() const { return one_mask() && opacity < use.cutoff; }
  // All parts of the material lie at one place.
  bool one_place() const { return std::ranges::count(use.places, use.places[0]) == std::ssize(use.places); }
};

constexpr std::array<const char*, 4> part_names{"diffuse", "alpha", "f0", "gloss"};

void add_line(TextureFetch& out, const std::string& code) {
  out.code += code + '\n';
}

void add_uniform(TextureFetch& out, const std::string& name, std::vector<float> values) {
  const auto width = static_cast<int>(values.size());
  out.uniforms.push_back({name, width, 1, false, std::move(values)});
}

// Writes the samplers, variables and uniforms, and the function that fetch() calls.
void declare_textures(const FetchedTextures& of, TextureFetch& out) {
  const TextureUse& use = of.use;
  if (of.a()) add_line(out, "uniform sampler2D diffuse_alpha;");
  if (of.b()) add_line(out, "uniform sampler2D specular_gloss;");
  if (of.alpha_apart()) add_line(out, "uniform sampler2D alpha_apart;");
  if (of.gloss_apart()) add_line(out, "uniform sampler2D gloss_apart;");
  if (of.a() && use.diffuse_tail) add_line(out, "uniform sampler2D diffuse_alpha_tail;");
  if (of.b() && use.specular_tail) add_line(out, "uniform sampler2D specular_gloss_tail;");
  // Between the last level of the one and the first of the other it is as between two levels of one texture.
  if ((of.a() && use.diffuse_tail) || (of.b() && use.specular_tail))
    add_line(out,
             "vec4 with_tail(sampler2D levels, sampler2D tail, vec2 uv) {\n"
             "  vec2 size = vec2(textureSize(tail, 0)), x = size * dFdx(uv), y = size * dFdy(uv);\n"
             "  float level = 1.0 + 0.5 * log2(max(max(dot(x, x), dot(y, y)), 1e-20));\n"
             "  return mix(texture(levels, uv), texture(tail, uv), clamp(level, 0.0, 1.0));\n}");
  if (use.diffuse) add_line(out, "vec3 texel_diffuse;");
  if (use.fetch_alpha)
    add_line(out, "float texel_opacity;");
  else if (of.blends())
    add_uniform(out, "texel_opacity", {static_cast<float>(of.opacity)});
  if (use.specular) add_line(out, "vec3 texel_f0;");
  if (use.gloss) add_line(out, "float texel_gloss;");
  // e = 2 / r^4 - 2 is the exponent of the lobe whose width is r^2; Schueler's g in [0, 1] has exponents 1 to
  // 4096.
  if (of.roughness())
    add_line(out,
             "float gloss_of_roughness(float r) {\n  float r4 = max(r * r * r * r, 1e-8);\n"
             "  return clamp(log2(max(2.0 / r4 - 2.0, 1.0)) / 12.0, 0.0, 1.0);\n}");
  if (of.encoded())
    add_line(out,
             "float f0_of_code(float code) {\n"
             "  return code <= 0.04045 ? code / 12.92 : pow((code + 0.055) / 1.055, 2.4);\n}");
  const auto add_place = [&](const std::string& name, std::size_t part) {
    const auto share = [&](std::size_t i) { return static_cast<float>(use.places[part].region[i]); };
    add_uniform(out, name + "_corner", {share(0), share(1)});
    add_uniform(out, name + "_size", {share(2), share(3)});
  };
  if (of.any() && of.one_place()) return add_place("region", 0);
  const std::array fetched{use.diffuse, use.fetch_alpha, use.specular, use.gloss};
  for (std::size_t part = 0; part < fetched.size(); ++part)
    if (fetched[part]) add_place(part_names[part], part);
}

std::string read_of(const std::string& sampler, const std::string& uv, bool tail) {
  return tail ? "with_tail(" + sampler + ", " + sampler + "_tail, " + uv + ")"
              : "texture(" + sampler + ", " + uv + ")";
}

// The texel that a part is read from.
std::string texel_of(const FetchedTextures& of, std::size_t part) {
  const bool a = part < 2;
  const bool apart = (part == 1 && of.alpha_apart()) || (part == 3 && of.gloss_apart());
  if (of.one_place() && !apart) return a ? "a" : "b";
  const std::string name = part_names[part], sampler = apart ? name + "_apart"
                                                       : a   ? "diffuse_alpha"
                                                             : "specular_gloss";
  if (of.one_place()) return read_of(sampler, "uv", false);
  return read_of(sampler,
                 name + "_corner + " + name + "_size * " +
                     (of.use.places[part].rotated ? "vec2(1.0 - uv.y, uv.x)" : "uv"),
                 !apart && (a ? of.use.diffuse_tail : of.use.specular_tail));
}

void add_fetch(const FetchedTextures& of, TextureFetch& out) {
  const TextureUse& use = of.use;
  const auto line = [&](const std::string& code) { add_line(out, code); };
  line("void fetch(vec2 at) {");
  if (of.any()) line("  vec2 uv = vec2(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y);");
  if (of.one_place() && of.any()) {
    if (use.places[0].rotated) line("  uv = vec2(1.0 - uv.y, uv.x);");
    line("  uv = region_corner + region_size * uv;");
    if (of.a()) line("  vec4 a = " + read_of("diffuse_alpha", "uv", use.diffuse_tail) + ";");
    if (of.b()) line("  vec4 b = " + read_of("specular_gloss", "uv", use.specular_tail) + ";");
  }
  if (use.diffuse) line("  texel_diffuse = " + texel_of(of, 0) + ".rgb;");
  if (use.fetch_alpha) line("  texel_opacity = " + texel_of(of, 1) + (of.alpha_apart() ? ".r;" : ".a;"));
  const std::string f0 = texel_of(of, 2), gloss = texel_of(of, 3) + of.gloss_channel();
  if (use.specular)
    line("  texel_f0 = " + (of.encoded()    ? "vec3(f0_of_code(" + f0 + ".r));"
                            : use.scalar_f0 ? "vec3(" + f0 + ".r);"
                                            : f0 + ".rgb;"));
  if (use.gloss)
    line("  texel_gloss = " +
         (!of.roughness()                          ? gloss
          : use.gloss_form == GlossForm::roughness ? "gloss_of_roughness(" + gloss + ")"
                                                   : "gloss_of_roughness(1.0 - " + gloss + ")") +
         ";");
  if (of.tests() && use.fetch_alpha) {
    add_uniform(out, "alpha_cutoff", {static_cast<float>(use.cutoff)});
    line("  if (texel_opacity < alpha_cutoff) discard;");
  }
  if (of.blends() && use.diffuse) line("  texel_diffuse *= texel_opacity;");
  if (of.all_hidden()) line("  discard;");
  line("}\n");
}

// Lists which features the text has, and why it lacks the others.
void tell_features(const FetchedTextures& of, TextureFetch& out) {
  const TextureUse& use = of.use;
  const auto tell = [&](const char* what, bool in, const char* reason) {
    out.features.push_back({what, in, in ? "varies" : reason});
  };
  tell("diffuse texture", use.diffuse, use.no_diffuse ? "K_d is 0" : "one colour everywhere");
  tell("F0 texture", use.specular, use.scalar_f0 ? "one grey number everywhere" : "one colour everywhere");
  tell("gloss texture", use.gloss, "one number everywhere");
  tell("alpha texture", use.fetch_alpha, "no alpha, or one number everywhere");
  tell("alpha test", of.tests() && (use.fetch_alpha || of.all_hidden()),
       of.one_mask() ? "the mask hides nothing"
       : of.blends() ? "alpha blends"
                     : "opaque");
}

}  // namespace

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
    else if (define == "ETAK_GLOSS_IN_RED")
      out.channels = TextureUse::Channels::gloss_alone;
    else if (define == "ETAK_F0_GLOSS_IN_RED_GREEN")
      out.channels = TextureUse::Channels::f0_gloss;
    else if (define == "ETAK_ALPHA_APART")
      out.alpha_apart = true;
    else if (define == "ETAK_GLOSS_APART")
      out.gloss_apart = true;
    else if (define == "ETAK_DIFFUSE_ALPHA_TAIL")
      out.diffuse_tail = true;
    else if (define == "ETAK_SPECULAR_GLOSS_TAIL")
      out.specular_tail = true;
    else
      throw Error::at(
          printable(define), "is no define that etak pack lists",
          "ETAK_DIFFUSE_TEXTURE, ETAK_SPECULAR_TEXTURE, ETAK_GLOSS_TEXTURE, ETAK_NO_DIFFUSE, ETAK_SCALAR_F0, ETAK_ALPHA_TEST, ETAK_ALPHA_BLEND, ETAK_ALPHA_TEXTURE, ETAK_GLOSS_IN_RED, ETAK_F0_GLOSS_IN_RED_GREEN, ETAK_ALPHA_APART, ETAK_GLOSS_APART, ETAK_DIFFUSE_ALPHA_TAIL or ETAK_SPECULAR_GLOSS_TAIL");
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
  const FetchedTextures of{use, opacity};
  TextureFetch out;
  out.any = of.any() || of.all_hidden();
  declare_textures(of, out);
  if (out.any) add_fetch(of, out);
  tell_features(of, out);
  return out;
}

}  // namespace etak
