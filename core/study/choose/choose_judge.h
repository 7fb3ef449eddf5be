// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/study/choose/choose_pictures.h"

namespace etak {

/// Textures that the filters of the cost table read.
inline constexpr int textures_of_pair = 2;

/// Compares the candidates of each step of choose() with "everything", at all angles and in all pixels.
///   subject, costs   have to live as long
class Judge {
 public:
  Judge(const ChooseSubject& subject, ErrorUnit unit, const CostTable& costs);

  const ChooseSubject& subject() const { return subject_; }
  ErrorUnit unit() const { return unit_; }
  const Look& everything() const { return everything_; }

  /// The cost of reading the textures that are not one colour.
  double filter_cost(TextureFilter filter, int textures) const;
  std::size_t pixels() const { return judge_->pixels(); }
  double cost(const char* of_what, std::string_view id) const { return costs_.of(of_what + std::string(id)); }

  /// F over angle of the spectrum, or of the first colour of F0.
  const FresnelTruth& truth() const { return truths_.front(); }

  PictureDifference picture(const Look& look) const { return judge_->difference_of(pictures_.draw(look)); }

  /// The largest error over all angles and all colours of F0 that occur. `values` are used with a spectrum;
  /// for colours the form is fitted to each of them.
  PictureDifference at_any_angle(const FresnelForm& form, const FresnelValues& values) const;

  /// The simplest form that equals "everything" for the spectrum, or for the colours of F0 that occur.
  std::string_view full_form() const;

 private:
  const ChooseSubject& subject_;
  const ErrorUnit unit_;
  const CostTable& costs_;
  const ChoosePictures pictures_;
  std::vector<FresnelTruth> truths_;  // that of the spectrum, or one for each colour of F0
  Look everything_;
  std::optional<PictureJudge> judge_;
};

}  // namespace etak
