// SPDX-License-Identifier: Apache-2.0
// The table of the terms, made from the rows of terms.inc: titles, sources and parameters.
#include <algorithm>
#include <array>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "core/brdf/evaluate/evaluators.h"
#include "core/brdf/integrals/normalise.h"
#include "core/brdf/parameters.h"

namespace etak {
namespace {

namespace p = parameters;

constexpr TermKind D = TermKind::distribution, F = TermKind::fresnel, V = TermKind::visibility;

struct TermRow {
  TermKind kind;
  std::string_view id, title, source;
  Few<Parameter> parameters, derived;
  Few<std::string_view> files;
  std::string_view entry, note;
  bool normalised = true, compensated = false;
};

constexpr TermRow rows[] = {
#define ETAK_D(name, numbers, call, ...) {D, __VA_ARGS__},
#define ETAK_F(name, numbers, call, ...) {F, __VA_ARGS__},
#define ETAK_F_OF_INDEX(name, numbers, index, extinction, ...) {F, __VA_ARGS__},
#define ETAK_F_OF_EXCESS(name, numbers, excess, ...) {F, __VA_ARGS__},
#define ETAK_F_OF_ENDS(name, numbers, ends, ...) {F, __VA_ARGS__},
#define ETAK_V(name, numbers, call, ...) {V, __VA_ARGS__},
#include "core/brdf/terms.inc"
#undef ETAK_D
#undef ETAK_F
#undef ETAK_F_OF_INDEX
#undef ETAK_F_OF_EXCESS
#undef ETAK_F_OF_ENDS
#undef ETAK_V
};

constexpr auto made_of_rows() {
  std::array<Term, std::size(rows)> out{};
  std::ranges::transform(rows, out.begin(), [](const TermRow& row) {
    return Term{row.id,    row.title, row.source, row.kind,       row.parameters, row.derived,
                row.files, row.entry, row.note,   row.normalised, row.compensated};
  });
  return out;
}

constexpr std::array all_terms = made_of_rows();

}  // namespace

std::string_view name(TermKind kind) {
  return kind == D ? "D" : kind == F ? "F" : "V";
}

std::size_t number_count(std::span<const Parameter> list) {
  std::size_t count = 0;
  for (const Parameter& each : list) count += each.color ? 3 : 1;
  return count;
}

std::span<const Term> terms() {
  return all_terms;
}

const Term* find_term(TermKind kind, std::string_view id) {
  const auto found =
      std::ranges::find_if(all_terms, [&](const Term& t) { return t.kind == kind && t.id == id; });
  return found == all_terms.end() ? nullptr : &*found;
}

void Term::f64(const Directions& d, const double* values, double rgb[3]) const {
  double numbers[64];
  const std::size_t count = number_count(parameters);
  std::copy(values, values + count, numbers);
  evaluators::derive(*this, values, numbers + count);
  evaluators::compiled<double>(*this).evaluate(d, numbers, rgb);
}

namespace evaluators {

void derive(const Term& term, const double* values, double* out) {
  if (term.derived.empty()) return;
  *out = term.entry == "d_abc_s2" ? abc_norm(values[0], values[1]) : log_sgd_norm(values[0], values[1]);
}

std::string compiled_name(std::string_view id) {
  std::string out(id);
  std::replace(out.begin(), out.end(), '-', '_');
  return out;
}

namespace {

template <class Real>
const One<Real>& compiled_by_name(const Term& term) {
  std::span<const One<Real>> all;
  if constexpr (std::is_same_v<Real, double>)
    all = all_f64();
  else
    all = all_f32();
  const std::string name = std::string(etak::name(term.kind)) + '_' + compiled_name(term.id);
  for (const One<Real>& each : all)
    if (each.entry == name) return each;
  throw std::logic_error("term " + name + " is not compiled");
}

}  // namespace

template <class Real>
const One<Real>& compiled(const Term& term) {
  // The table saves comparing names, which took a quarter of the time when millions of terms were evaluated.
  static const std::vector<const One<Real>*> of_terms = [] {
    std::vector<const One<Real>*> out;
    for (const Term& each : all_terms) out.push_back(&compiled_by_name<Real>(each));
    return out;
  }();
  return *of_terms[static_cast<std::size_t>(&term - all_terms.data())];
}
template const One<double>& compiled(const Term&);
template const One<float>& compiled(const Term&);

}  // namespace evaluators
}  // namespace etak
