// SPDX-License-Identifier: Apache-2.0
// Makes microfacet models from any three terms, and evaluates models.
#include "core/brdf/compose.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

#include "core/base/text/text.h"

namespace etak {
namespace {

constexpr std::size_t most_numbers = 64;
constexpr Parameter mean_of_fresnel{"f_mean", "mean of F over a diffuse hemisphere", "", 0, 1, 0, Role::other,
                                    true};

void add_files(std::span<const std::string_view> from, std::vector<std::string_view>& files) {
  for (const std::string_view file : from)
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
}

// Index of the first number of parameter `name` among the numbers of `list`; the count of all numbers where
// the list has no such parameter.
std::size_t place_of(std::string_view name, std::span<const Parameter> list) {
  std::size_t at = 0;
  for (const Parameter& each : list) {
    if (each.name == name) return at;
    at += each.color ? 3 : 1;
  }
  return at;
}

Model::Compiled::Piece piece(const Term& term, std::span<const Parameter> all) {
  Model::Compiled::Piece out{&evaluators::compiled<double>(term), &evaluators::compiled<float>(term), {}};
  const auto add = [&](std::span<const Parameter> list) {
    for (const Parameter& each : list)
      for (std::size_t i = 0; i < (each.color ? 3u : 1u); ++i) out.at.push_back(place_of(each.name, all) + i);
  };
  add(term.parameters);
  add(term.derived);
  return out;
}

std::string names(std::span<const Parameter> list, const char* before, const char* after) {
  std::string out;
  for (const Parameter& each : list) out += before + std::string(each.name) + after;
  return out;
}

std::string typed_names(std::span<const Parameter> list) {
  std::string out;
  for (const Parameter& each : list) out += (each.color ? ", vec3 " : ", real ") + std::string(each.name);
  return out;
}

template <class Real>
void evaluate_piece(const Model::Compiled::Piece& piece, decltype(evaluators::One<Real>::evaluate) evaluate,
                    const Directions& d, const double* numbers, Real rgb[3]) {
  double own[most_numbers];
  for (std::size_t i = 0; i < piece.at.size(); ++i) own[i] = numbers[piece.at[i]];
  evaluate(d, own, rgb);
}

// Computes what brdf_microfacet() of microfacet.glsl and brdf_compensated() of compensated.glsl do.
template <class Real, class Choose>
void evaluate_pieces(const Model::Compiled& compiled, Choose choose, const Directions& d,
                     const double* numbers, Real rgb[3]) {
  Real D[3], V[3];
  evaluate_piece<Real>(compiled.fresnel, choose(compiled.fresnel).evaluate, d, numbers, rgb);
  evaluate_piece<Real>(compiled.distribution, choose(compiled.distribution).evaluate, d, numbers, D);
  evaluate_piece<Real>(compiled.visibility, choose(compiled.visibility).evaluate, d, numbers, V);
  for (int i = 0; i < 3; ++i) rgb[i] = std::max(rgb[i], Real(0)) * (D[0] * V[0]);
  if (!compiled.compensated) return;
  Real mean[3];
  evaluate_piece<Real>(compiled.fresnel, choose(compiled.fresnel).mean, d, numbers, mean);
  for (int i = 0; i < 3; ++i) {
    const Real f = std::clamp(mean[i], Real(0), Real(1));
    rgb[i] += f * f * (1 - V[2]) / (1 - f * V[2]) * V[1];
  }
}

// The numbers that the entry takes: `values`, then the derived numbers. To derive a number can take a
// quadrature, so each thread keeps the numbers of its last call.
const double* entry_numbers(const Model& model, const double* values) {
  if (model.derived.empty()) return values;
  struct Last {
    const Model* model = nullptr;
    double numbers[most_numbers] = {};
  };
  thread_local Last last;
  static_assert(std::is_trivially_destructible_v<decltype(last)>);
  const std::size_t count = model.value_count();
  if (last.model != &model || std::memcmp(last.numbers, values, count * sizeof(double)) != 0) {
    last.model = &model;
    std::copy(values, values + count, last.numbers);
    model.derive(values, last.numbers + count);
  }
  return last.numbers;
}

}  // namespace

Model::Compiled find_compiled(std::string_view name) {
  Model::Compiled out;
  for (const auto& each : evaluators::all_f64())
    if (each.entry == name) out.f64 = each.evaluate;
  for (const auto& each : evaluators::all_f32())
    if (each.entry == name) out.f32 = each.evaluate;
  const evaluators::ManyTable many = evaluators::many();
  for (std::size_t i = 0; i < many.count; ++i)
    if (many.rows[i].entry == name) {
      out.many = many.rows[i].evaluate;
      out.far = many.rows[i].evaluate_far;
    }
  return out;
}

void compose(const Term& distribution, const Term& fresnel, const Term& visibility, ComposedModel& out) {
  const auto add_parameters = [&](const Term& term) {
    for (const Parameter& each : term.parameters)
      if (std::none_of(out.parameters.begin(), out.parameters.end(),
                       [&](const Parameter& p) { return p.name == each.name; }))
        out.parameters.push_back(each);
  };
  add_parameters(fresnel);
  add_parameters(distribution);
  add_parameters(visibility);
  const std::string name = evaluators::compiled_name(distribution.id) + '_' +
                           evaluators::compiled_name(fresnel.id) + '_' +
                           evaluators::compiled_name(visibility.id);
  out.compiled = find_compiled(name);
  out.derived.assign(distribution.derived.begin(), distribution.derived.end());
  // F's mean is computed beforehand where no texture can hold what it is computed from.
  const bool mean_is_known =
      visibility.compensated && std::ranges::any_of(fresnel.parameters, [](const Parameter& p) {
        return p.role == Role::n || p.role == Role::curve;
      });
  if (mean_is_known) out.derived.push_back(mean_of_fresnel);
  std::vector<Parameter> numbers = out.parameters;
  numbers.insert(numbers.end(), out.derived.begin(), out.derived.end());
  out.compiled.distribution = piece(distribution, numbers);
  out.compiled.fresnel = piece(fresnel, numbers);
  out.compiled.visibility = piece(visibility, numbers);
  out.compiled.compensated = visibility.compensated;

  add_files(fresnel.files, out.files);
  add_files(distribution.files, out.files);
  add_files(visibility.files, out.files);
  add_files(std::array<std::string_view, 1>{"brdf/microfacet.glsl"}, out.files);
  out.entry = "brdf_microfacet_" + name;
  const auto fresnel_at = [&](const std::string& cosine) {
    return std::string(fresnel.entry) + '(' + names(fresnel.parameters, "", ", ") + cosine + ")";
  };
  std::string mean;
  if (mean_is_known)
    mean = ", " + std::string(mean_of_fresnel.name);
  else if (visibility.compensated)
    mean = ",\n                         mean_fresnel(" +
           joined(std::array{1, 2, 3, 4}, ",\n                                      ",
                  [&](int i) { return fresnel_at("mean_cosine_" + std::to_string(i)); }) +
           ")";
  out.text = "vec3 " + out.entry + "(Angles a" + typed_names(out.parameters) + typed_names(out.derived) +
             ") {\n" + "  return " + (visibility.compensated ? "brdf_compensated(" : "brdf_microfacet(") +
             fresnel_at("a.lh") + mean + ",\n                         " + std::string(distribution.entry) +
             '(' + names(distribution.parameters, "", ", ") + names(distribution.derived, "", ", ") +
             "a.nh, a.s2),\n                         " + std::string(visibility.entry) + "(a" +
             names(visibility.parameters, ", ", "") + "));\n}\n";

  Model& model = out.model;
  model.kind = ModelKind::specular;
  model.parameters = out.parameters;
  model.derived = out.derived;
  model.files = out.files;
  model.entry = out.entry;
  model.text = out.text;
  model.distribution = &distribution;
  model.fresnel = &fresnel;
  model.visibility = &visibility;
  model.compiled = &out.compiled;
}

bool Model::compensated() const {
  return visibility != nullptr && visibility->compensated;
}
std::size_t Model::value_count() const {
  return number_count(parameters);
}
std::size_t Model::derived_count() const {
  return number_count(derived);
}

void Model::derive(const double* values, double* out) const {
  if (derived.empty()) return;
  double own[most_numbers] = {};
  const std::vector<std::size_t>& at = compiled->distribution.at;
  for (std::size_t i = 0; i < number_count(distribution->parameters); ++i) own[i] = values[at[i]];
  evaluators::derive(*distribution, own, out);
  if (derived.back().name == mean_of_fresnel.name)
    evaluate_piece<double>(compiled->fresnel, compiled->fresnel.f64->mean, {0, 0, 1, 0, 0, 1}, values,
                           out + number_count(distribution->derived));
}

bool Model::derives_from_width() const {
  return distribution != nullptr && !distribution->derived.empty();
}

void Model::f64(const Directions& d, const double* values, double rgb[3]) const {
  const double* numbers = entry_numbers(*this, values);
  if (compiled->f64) return compiled->f64(d, numbers, rgb);
  evaluate_pieces<double>(
      *compiled, [](const Compiled::Piece& p) -> auto& { return *p.f64; }, d, numbers, rgb);
}

void Model::f32(const Directions& d, const double* values, float rgb[3]) const {
  const double* numbers = entry_numbers(*this, values);
  if (compiled->f32) return compiled->f32(d, numbers, rgb);
  evaluate_pieces<float>(
      *compiled, [](const Compiled::Piece& p) -> auto& { return *p.f32; }, d, numbers, rgb);
}

void Model::f32_batch(std::size_t count, const float* const directions[6], const double* values,
                      float* const rgb[3]) const {
  const double* numbers = entry_numbers(*this, values);
  if (compiled->many) return compiled->many(count, directions, numbers, rgb);
  for (std::size_t i = 0; i < count; ++i) {
    const Directions d{directions[0][i], directions[1][i], directions[2][i],
                       directions[3][i], directions[4][i], directions[5][i]};
    float one[3];
    f32(d, values, one);
    for (int c = 0; c < 3; ++c) rgb[c][i] = one[c];
  }
}

bool Model::has_far_loop() const {
  return compiled->far != nullptr;
}

void Model::f32_batch_far(std::size_t count, double lh, const float* const turned[5], const double* values,
                          float* const rgb[3]) const {
  compiled->far(count, static_cast<float>(lh), turned, entry_numbers(*this, values), rgb);
}

std::string_view batch_instruction_set() {
  return evaluators::instruction_set();
}

}  // namespace etak
