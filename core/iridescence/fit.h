// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/color/delta_e.h"
#include "core/iridescence/form.h"

namespace etak {

/// What a surface shows at the angles by which a form is judged: 0 to 84 degrees in steps of 6, colours cut to [0, 1] of
/// linear sRGB, D65. An angle counts by cos sin of it, as the parts of a sphere do: normal incidence counts nothing in
/// the mean, and is told by itself.
struct FilmTruth {
  std::vector<double> cosines, weights;  // weights sum to 1
  std::vector<Lab> seen;
  friend bool operator==(const FilmTruth&, const FilmTruth&) = default;
};
FilmTruth film_truth(const std::function<Vec3(double cosine)>& seen);

/// dE2000 between what a form (or any F) shows and the truth, both cut to [0, 1].
struct FilmError {
  double mean = 0, largest = 0, normal = 0;
  friend bool operator==(const FilmError&, const FilmError&) = default;
};
FilmError film_error(const std::function<Vec3(double cosine)>& seen, const FilmTruth& truth);
FilmError film_error(const FilmForm& form, const FilmNumbers& numbers, const FilmTruth& truth);

/// The numbers brought into the ranges of the form.
FilmNumbers in_range(const FilmForm& form, FilmNumbers numbers);

/// The numbers of a form, within its ranges, of the least mean error that was found: from the given start and points spread
/// over the ranges, by least squares and then by the error itself. The same on every machine with the same arithmetic and
/// for any number of threads; 20 to 100 ms.
///   path_nm   optical thickness of the film (index times thickness): the search looks around it
FilmNumbers fitted_film(const FilmForm& form, const FilmTruth& truth, const FilmNumbers& start,
                        double path_nm);

}  // namespace etak
