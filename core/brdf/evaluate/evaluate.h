// SPDX-License-Identifier: Apache-2.0
// Every term and model of terms.inc and models.inc as a C++ type. There is no include guard: each kind of
// evaluation includes this once, in an unnamed namespace, behind core/math/real_f64.h or real_f32.h. Nothing
// of it is visible outside, so that a source compiled for another instruction set leaves no function behind
// that other sources call.
#include "core/brdf/texts.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"  // a constant value does not use the angles

inline vec3 color(const real* p) {
  return vec3(p[0], p[1], p[2]);
}

// Each type is constructed from the `size` numbers at p and holds what is computed once for a surface; at(a)
// is the value for one pair of directions.
#define ETAK_D(id, numbers, call, ...)         \
  struct D_##id {                              \
    static constexpr int size = numbers;       \
    const real* p;                             \
    explicit D_##id(const real* p_) : p(p_) {} \
    real at(Angles a) const { return call; }   \
  };
#define ETAK_F(id, numbers, call, ...)         \
  struct F_##id {                              \
    static constexpr int size = numbers;       \
    const real* p;                             \
    explicit F_##id(const real* p_) : p(p_) {} \
    vec3 at(Angles a) const { return call; }   \
  };
#define ETAK_F_OF_INDEX(id, numbers, index, extinction, ...)      \
  struct F_##id {                                                 \
    static constexpr int size = numbers;                          \
    vec3 n, k;                                                    \
    explicit F_##id(const real* p) : n(index), k(extinction) {}   \
    vec3 at(Angles a) const { return fresnel_exact(n, k, a.lh); } \
  };
#define ETAK_F_OF_EXCESS(id, numbers, excess_, ...)                 \
  struct F_##id {                                                   \
    static constexpr int size = numbers;                            \
    vec3 excess;                                                    \
    explicit F_##id(const real* p) : excess(excess_) {}             \
    vec3 at(Angles a) const { return fresnel_clear(excess, a.lh); } \
  };
#define ETAK_F_OF_ENDS(id, numbers, ends_, ...)                \
  struct F_##id {                                              \
    static constexpr int size = numbers;                       \
    SchuelerEnds ends;                                         \
    explicit F_##id(const real* p) : ends(ends_) {}            \
    vec3 at(Angles a) const { return f_schueler(ends, a.lh); } \
  };
#define ETAK_V(id, numbers, call, ...)         \
  struct V_##id {                              \
    static constexpr int size = numbers;       \
    const real* p;                             \
    explicit V_##id(const real* p_) : p(p_) {} \
    auto at(Angles a) const { return call; }   \
  };
#include "core/brdf/terms.inc"
#undef ETAK_D
#undef ETAK_F
#undef ETAK_F_OF_INDEX
#undef ETAK_F_OF_EXCESS
#undef ETAK_F_OF_ENDS
#undef ETAK_V

// The mean of a Fresnel term over a diffuse hemisphere.
template <class Term>
struct Mean {
  static constexpr int size = Term::size;
  Term F;
  explicit Mean(const real* p) : F(p) {}
  vec3 at_cosine(real c) const {
    Angles a{};
    a.lh = c;
    return F.at(a);
  }
  vec3 at(Angles) const {
    return mean_fresnel(at_cosine(mean_cosine_1), at_cosine(mean_cosine_2), at_cosine(mean_cosine_3),
                        at_cosine(mean_cosine_4));
  }
};

// The product of three terms; with a V that compensates, the mean of F, which needs no angles, is taken too.
template <class Term>
vec3 product(const Mean<Term>& mean, Angles a, real D, real V) {
  return brdf_microfacet(mean.F.at(a), D, V);
}
template <class Term>
vec3 product(const Mean<Term>& mean, Angles a, real D, vec3 V) {
  return brdf_compensated(mean.F.at(a), mean.at(a), D, V);
}

#define ETAK_MODEL(entry, numbers, type, constant, call, ...)  \
  struct M_##entry {                                           \
    static constexpr int size = numbers;                       \
    const real* p;                                             \
    type q;                                                    \
    explicit M_##entry(const real* p_) : p(p_), q(constant) {} \
    vec3 at(Angles a) const { return call; }                   \
  };
// The parameters of D follow those of F. A V with a width takes the first parameter of D.
#define ETAK_MICROFACET(d, f, v)                                                                \
  struct M_##d##_##f##_##v {                                                                    \
    static constexpr int size = F_##f::size + D_##d::size;                                      \
    Mean<F_##f> F;                                                                              \
    D_##d D;                                                                                    \
    V_##v V;                                                                                    \
    explicit M_##d##_##f##_##v(const real* p) : F(p), D(p + F_##f::size), V(p + F_##f::size) {} \
    vec3 at(Angles a) const { return product(F, a, D.at(a), V.at(a)); }                         \
  };
#include "core/brdf/models.inc"
#undef ETAK_MODEL
#undef ETAK_MICROFACET
#pragma GCC diagnostic pop
