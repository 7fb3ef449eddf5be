// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/iridescence/fit.h"
#include "core/material/f0.h"
#include "core/material/material.h"

namespace etak {

/// The numbers of a form for a stack, and what they miss.
struct FilmValues {
  FilmNumbers numbers{};
  FilmError error;
  friend bool operator==(const FilmValues&, const FilmValues&) = default;
};

/// A stack in a form.
///   honest   what an author types who knows the film, brought into the form's ranges; none: FilmParameters::no_honest
///   fitted   the numbers that come nearest to what the stack shows
///   note     a thickness that the form does not reach; else empty
struct FilmInForm {
  const FilmForm* form = nullptr;
  std::optional<FilmValues> honest;
  FilmValues fitted;
  std::string note;

  /// Whether the honest numbers are as good as the fitted ones: they miss at most 0.5 more on the mean.
  bool use_honest() const;
  const FilmValues& used() const { return use_honest() ? *honest : fitted; }
  /// Which numbers to use and why, a sentence.
  std::string advice() const;
  friend bool operator==(const FilmInForm&, const FilmInForm&) = default;
};

/// What renderers are told of a stack.
///   no_honest   why no form has honest numbers: several layers, or one that shows no interference; else empty
///   notes       what no form takes: extinction of the film
struct FilmParameters {
  FilmBase base = FilmBase::metal;
  std::string no_honest;
  std::vector<std::string> notes;
  std::vector<FilmInForm> forms;  // those asked for that have the base
  const FilmInForm* in(std::string_view form_id) const;
  friend bool operator==(const FilmParameters&, const FilmParameters&) = default;
};

/// Why no film of a renderer can be fitted under these options; empty: it can. No renderer's film has another outside medium
/// than vacuum or air, or another space than linear sRGB.
std::string film_refusal(const F0Options& options);

/// Fits the forms to a stack, one after the other. Throws Error (naming the stack) where film_refusal() says why, and as
/// SeenStack does.
FilmParameters film_parameters(const Stack& stack, FilmBase base, const F0Options& options,
                               std::span<const FilmForm* const> forms);

/// What renderers are told of a stack, each form fitted when it is first asked for; for several threads at once.
class FilmFits {
 public:
  /// Throws Error as film_parameters() does.
  FilmFits(const Stack& stack, FilmBase base, const F0Options& options);

  /// What holds for all forms: base, no_honest, notes.
  const FilmParameters& known() const { return known_; }
  /// Null: there is no such form on the base.
  const FilmInForm* in(std::string_view form) const;

 private:
  Stack stack_;
  F0Options options_;
  FilmParameters known_;
  mutable std::mutex fitting_;
  mutable std::map<std::string_view, FilmParameters> fitted_;  // by form, one form each
};

/// The base that the class of a stack's material tells: dielectric as optical_kind() has it, all others are metals to a
/// renderer.
FilmBase film_base(std::string_view material_class);

}  // namespace etak
