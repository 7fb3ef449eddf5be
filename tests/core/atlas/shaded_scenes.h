// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace etak::test {

/// The largest difference in codes between two scenes of the same triangles, of what they look like in places
/// all over their triangles: each place is shaded by glTF's own model (specification, appendix B; with
/// KHR_materials_specular, _ior and _pbrSpecularGlossiness) and normal map under the key, fill and rim of
/// default_lights(), each by itself, seen at 0, 20, 40, 60 and 75 degrees. The rim, which comes from behind, is
/// turned to the front.
///   nearest, bilinear   how textures are filtered, at level 0; colours in linear light
struct ShadedDifference {
  double nearest = 0, bilinear = 0;
  std::size_t places = 0;
};
ShadedDifference shaded_difference(const std::string& before, const std::string& after, std::size_t places);

}  // namespace etak::test
