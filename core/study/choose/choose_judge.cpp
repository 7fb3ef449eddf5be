// SPDX-License-Identifier: Apache-2.0
#include "core/study/choose/choose_judge.h"

#include <algorithm>

namespace etak {
namespace {

constexpr std::size_t most_f0 = 16;  // colours of F0 of a texture that are judged at every angle

PictureDifference angle_difference(ErrorUnit unit, const FresnelTruth& truth, const FresnelForm& form,
                                   const FresnelValues& values) {
  PictureDifference out;
  for (std::size_t i = 0; i < truth.cosine.size(); ++i) {
    Vec3 rgb{};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = form.value(values[c].data(), truth.cosine[i]);
    const double miss = difference(unit, rgb, truth.rgb[i]);
    out.worst = std::max(out.worst, miss);
    out.mean += truth.weight[i] * miss;
  }
  return out;
}

TextureFilter full_filter(const ChooseSubject& subject) {
  return !subject.textured() ? TextureFilter::constant
         : subject.mipmaps   ? TextureFilter::trilinear
                             : TextureFilter::bilinear;
}

}  // namespace

Judge::Judge(const ChooseSubject& subject, ErrorUnit unit, const CostTable& costs)
    : subject_(subject), unit_(unit), costs_(costs), pictures_(subject) {
  everything_.filter = full_filter(subject);
  judge_.emplace(unit, pictures_.draw(everything_));
  if (subject.dataset)
    truths_ = {fresnel_truth(subject.dataset->optics, subject.library)};
  else if (subject.texture)
    for (const Vec3& f0 : subject.texture->some_f0(most_f0)) truths_.push_back(colour_truth(f0));
  else
    truths_ = {colour_truth(subject.texel.f0)};
}

double Judge::filter_cost(TextureFilter filter, int textures) const {
  return cost("filter/", name(filter)) * textures / textures_of_pair;
}

PictureDifference Judge::at_any_angle(const FresnelForm& form, const FresnelValues& values) const {
  PictureDifference out;
  for (const FresnelTruth& truth : truths_) {
    const PictureDifference one =
        angle_difference(unit_, truth, form, subject_.dataset ? values : form.fit(truth));
    out.worst = std::max(out.worst, one.worst);
    out.mean = std::max(out.mean, one.mean);
  }
  return out;
}

std::string_view Judge::full_form() const {
  if (subject_.dataset) return subject_.stack() ? "curve" : "index";
  bool low = false, high = false;
  for (const FresnelTruth& truth : truths_)
    for (const double f0 : truth.f0) (f0 < forbidden_zone_first ? low : high) = true;
  return low && high ? "by_f0" : low ? "from_f0" : "schlick";
}

}  // namespace etak
