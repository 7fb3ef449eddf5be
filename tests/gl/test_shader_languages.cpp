// SPDX-License-Identifier: Apache-2.0
// The BRDF of every model in HLSL, MSL and WGSL against double precision, and the texts that SPIR-V compilers take.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>
#include <sstream>

#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/glsl/glsl_text.h"
#include "core/glsl/shader_function.h"
#include "tests/gl/scenes.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

constexpr std::size_t direction_count = 1000;

// Directions above the surface, every other pair near the mirror direction, as the floats that the texts get.
std::vector<Directions> directions() {
  std::mt19937_64 random(11);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto rounded = [](double x) { return double{static_cast<float>(x)}; };
  std::vector<Directions> out;
  while (out.size() < direction_count) {
    const double z = uniform(0.05, 1), phi = uniform(0, 2 * std::numbers::pi), s = std::sqrt(1 - z * z);
    const double vz = uniform(0.05, 1), v_phi = out.size() % 2 == 0
                                                    ? phi + std::numbers::pi + uniform(-0.1, 0.1)
                                                    : uniform(0, 2 * std::numbers::pi);
    const double v_z = out.size() % 2 == 0 ? z : vz, v_s = std::sqrt(1 - v_z * v_z);
    out.push_back({rounded(s * std::cos(phi)), rounded(s * std::sin(phi)), rounded(z),
                   rounded(v_s * std::cos(v_phi)), rounded(v_s * std::sin(v_phi)), rounded(v_z)});
  }
  return out;
}

// What one model's text is compared with: the model and the values of its scene.
struct Subject {
  const Model* model;
  Scene scene;
  std::vector<double> values;
};

std::vector<Subject> subjects() {
  std::vector<Subject> out;
  for (const Model& model : models()) {
    Subject each{&model, bare_scene(model), {}};
    each.scene.surface.diffuse = {0.5, 0.4, 0.3};
    std::vector<double>& values =
        each.scene.specular == &model ? each.scene.specular_values : each.scene.diffuse_values;
    values = model_values(model, each.scene.surface, {});
    each.values = values;
    for (double& value : each.values) value = double{static_cast<float>(value)};
    out.push_back(std::move(each));
  }
  return out;
}

// Checks rows of direction_count * 3 numbers, one for each subject, against double precision.
void check_rows(const std::vector<std::string>& rows, const std::string& language) {
  const std::vector<Subject> all = subjects();
  const std::vector<Directions> given = directions();
  REQUIRE(rows.size() == all.size());
  for (std::size_t m = 0; m < all.size(); ++m) {
    std::istringstream row(rows[m]);
    std::vector<std::array<double, 3>> expected(given.size());
    double peak = 0, worst = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
      all[m].model->f64(given[i], all[m].values.data(), expected[i].data());
      for (const double value : expected[i]) peak = std::max(peak, std::abs(value));
    }
    for (const auto& rgb : expected)
      for (const double value : rgb) {
        std::string word;
        row >> word;
        const double found = std::strtod(word.c_str(), nullptr);
        const double error = std::abs(found - value) / std::max(std::abs(value), 1e-4 * peak);
        if (!(error <= worst)) worst = std::isnan(error) ? 1e30 : error;
      }
    INFO(language << ", " << all[m].model->id << ": " << worst);
    CHECK(worst <= 1e-3);
  }
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

// A C++ program that prints the values of all subjects' texts in a language.
std::string program(ShaderLanguage language) {
  std::string out = "#include \"" + source_folder() + "/tests/gl/shader_words.h\"\n#include <cstdio>\n",
              calls;
  std::size_t count = 0;
  for (const Subject& each : subjects()) {
    const std::string space = "model_" + std::to_string(count++);
    std::string text = shader_function(each.scene, language);
    if (const std::size_t at = text.find("#include <metal_stdlib>"); at != text.npos) text.erase(at, 23);
    out += "namespace " + space + " {\nusing namespace shader_words;\n" + text + "}\n";
    calls += "  print(" + space + "::etak_brdf);\n";
  }
  out += "using shader_words::float3;\nstatic const float given[][6] = {\n";
  for (const Directions& d : directions()) {
    out += '{';
    for (const double value : {d.lx, d.ly, d.lz, d.vx, d.vy, d.vz})
      out += number(value, 9) + (value == std::floor(value) ? ".0" : "") + "f, ";
    out += "},\n";
  }
  return out +
         "};\ntemplate <class Brdf> void print(Brdf brdf) {\n  for (const auto& d : given) {\n"
         "    const float3 value = brdf(float3(d[0], d[1], d[2]), float3(d[3], d[4], d[5]));\n"
         "    std::printf(\"%.9g %.9g %.9g \", value.x, value.y, value.z);\n  }\n  std::puts(\"\");\n}\n"
         "int main() {\n" +
         calls + "}\n";
}

}  // namespace

TEST_CASE("every model in HLSL and in MSL, compiled as C++, gives the values of double precision") {
  for (const ShaderLanguage language : {ShaderLanguage::hlsl, ShaderLanguage::msl}) {
    const TempFolder folder;
    spit(folder.file("a.cpp"), program(language));
    const auto [compiled, status] =
        run("g++ -std=c++20 -O1 -w -o '" + folder.file("a") + "' '" + folder.file("a.cpp") + "'");
    INFO(compiled.substr(0, 4000));
    REQUIRE(status == 0);
    check_rows(lines_of(run("'" + folder.file("a") + "'").first), std::string(name(language)));
  }
}

TEST_CASE("glslangValidator takes the HLSL of every model, and what --vulkan and --mesh write") {
  if (run("glslangValidator --version").second != 0) {
    std::puts("skipped: glslangValidator is not installed (Debian: glslang-tools)");
    return;
  }
  const TempFolder folder;
  const auto take = [&](const std::string& options, const std::string& files) {
    const auto [output, status] = run("cd '" + folder.path() + "' && glslangValidator " + options + files);
    INFO(options << '\n' << output.substr(0, 4000));
    CHECK(status == 0);
  };
  std::string hlsl, spirv, plain;
  std::size_t count = 0;
  for (const Subject& each : subjects()) {
    const std::string id(each.model->id);
    spit(folder.file(id + ".hlsl.frag"),
         shader_function(each.scene, ShaderLanguage::hlsl) +
             "float4 main(float3 l : A, float3 v : B) : SV_Target { return float4(etak_brdf(l, v), 1); }\n");
    hlsl += " " + id + ".hlsl.frag";
    if (count++ % 6 != 0) continue;  // the texts around the models are the same for all
    for (const bool mesh : {false, true}) {
      const std::string file = id + (mesh ? ".mesh" : "");
      const Scene scene = mesh ? each.scene : full_scene(*each.model);
      const auto text = [&](GlslVersion version) {
        return mesh ? glsl_mesh_text(scene, nullptr, version) : glsl_text(scene, version);
      };
      spit(folder.file(file + ".450.frag"), text(GlslVersion::vulkan_450).fragment);
      spit(folder.file(file + ".450.vert"), text(GlslVersion::vulkan_450).vertex);
      spirv += " " + file + ".450.frag " + file + ".450.vert";
      if (!mesh) continue;
      spit(folder.file(file + ".330.frag"), text(GlslVersion::core_330).fragment);
      spit(folder.file(file + ".330.vert"), text(GlslVersion::core_330).vertex);
      spit(folder.file(file + ".es.frag"), text(GlslVersion::es_300).fragment);
      plain += " " + file + ".330.frag " + file + ".330.vert " + file + ".es.frag";
    }
  }
  take("", plain);
  const std::pair<const char*, const std::string*> rows[] = {
      {"-D -V -e main -o a.spv ", &hlsl}, {"-V -o a.spv ", &spirv}, {"-G -o a.spv ", &spirv}};
  for (const auto& [options, files] : rows) {
    std::istringstream names(*files);
    for (std::string file; names >> file;) take(options, file);
  }
}

TEST_CASE("every model in WGSL gives the values of double precision in Chromium's WebGPU") {
  if (run("node -e \"require('webgpu')\"").second != 0) {
    std::puts("skipped: node has no webgpu (npm install webgpu; NODE_PATH)");
    return;
  }
  const TempFolder folder;
  std::string texts, given;
  for (const Subject& each : subjects())
    texts += (texts.empty() ? "" : ",\n") + json(shader_function(each.scene, ShaderLanguage::wgsl));
  for (const Directions& d : directions()) {
    given += given.empty() ? "[" : ",\n[";
    for (const double value : {d.lx, d.ly, d.lz, d.vx, d.vy, d.vz}) given += number(value, 9) + ", ";
    given.replace(given.size() - 2, 2, "]");
  }
  spit(folder.file("a.json"), "{\"texts\": [" + texts + "],\n\"directions\": [" + given + "]}\n");
  const auto [output, status] = run("(EGL_PLATFORM=surfaceless node '" + source_folder() +
                                    "/tests/gl/run_wgsl.cjs' '" + folder.file("a.json") + "' 2>/dev/null)");
  if (status == 77 << 8) {
    std::puts("skipped: WebGPU finds no adapter here (Debian: libgl1-mesa-dri)");
    return;
  }
  std::vector<std::string> rows;
  for (const std::string& line : lines_of(output))
    if (line.starts_with("MESSAGE"))
      FAIL_CHECK(line);
    else
      rows.push_back(line);
  check_rows(rows, "WGSL");
}
