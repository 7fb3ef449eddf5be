// SPDX-License-Identifier: Apache-2.0
#include "core/iridescence/fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/math/functions.h"
#include "core/math/solve.h"

namespace etak {
namespace {

Lab lab_of(const Vec3& seen) {
  return to_lab(
      LinearRgb{std::clamp(seen[0], 0.0, 1.0), std::clamp(seen[1], 0.0, 1.0), std::clamp(seen[2], 0.0, 1.0)});
}

// A form over its ranges, each taken as 0 to 1.
class Search {
 public:
  Search(const FilmForm& form, const FilmTruth& truth)
      : form_(form), truth_(truth), count_(form.numbers.size()) {}

  std::size_t count() const { return count_; }

  FilmNumbers numbers(const FilmNumbers& place) const {
    FilmNumbers out{};
    for (std::size_t i = 0; i < count_; ++i)
      out[i] = form_.numbers[i].least + place[i] * (form_.numbers[i].most - form_.numbers[i].least);
    return out;
  }
  FilmNumbers place(const FilmNumbers& numbers) const {
    FilmNumbers out{};
    for (std::size_t i = 0; i < count_; ++i)
      out[i] = std::clamp(
          (numbers[i] - form_.numbers[i].least) / (form_.numbers[i].most - form_.numbers[i].least), 0.0, 1.0);
    return out;
  }

  double mean(const FilmNumbers& place) const { return film_error(form_, numbers(place), truth_).mean; }

  // Three differences an angle in the units of CIE94, whose weights are those of the true colour: smooth, where CIEDE2000
  // is not. Returns the sum of their squares.
  double differences(const FilmNumbers& place, std::vector<double>& out) const {
    const FilmNumbers x = numbers(place);
    out.clear();
    double sum = 0;
    for (std::size_t i = 0; i < truth_.cosines.size(); ++i) {
      if (truth_.weights[i] == 0) continue;
      const Lab& want = truth_.seen[i];
      const Lab got = lab_of(form_.seen(x, truth_.cosines[i]));
      const double chroma = math::hypot(want.a, want.b), root = std::sqrt(truth_.weights[i]);
      const double along = chroma > 0 ? want.a / chroma : 1, across = chroma > 0 ? want.b / chroma : 0;
      const double da = got.a - want.a, db = got.b - want.b;
      out.push_back(root * (got.l - want.l));
      out.push_back(root * (da * along + db * across) / (1 + 0.045 * chroma));
      out.push_back(root * (db * along - da * across) / (1 + 0.015 * chroma));
    }
    for (const double each : out) sum += each * each;
    return sum;
  }

 private:
  const FilmForm& form_;
  const FilmTruth& truth_;
  std::size_t count_;
};

using Matrix = std::array<FilmNumbers, most_film_numbers>;

// Levenberg and Marquardt's descent, held inside the ranges.
double descend(const Search& search, FilmNumbers& place, int rounds) {
  const std::size_t count = search.count();
  std::vector<double> here, there;
  double cost = search.differences(place, here), damping = 1e-2;
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::vector<double>> slopes(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double step = place[i] > 0.5 ? -1e-6 : 1e-6;
      FilmNumbers moved = place;
      moved[i] += step;
      search.differences(moved, slopes[i]);
      for (std::size_t m = 0; m < here.size(); ++m) slopes[i][m] = (slopes[i][m] - here[m]) / step;
    }
    Matrix normal{};
    FilmNumbers gradient{};
    for (std::size_t i = 0; i < count; ++i) {
      gradient[i] = -std::inner_product(here.begin(), here.end(), slopes[i].begin(), 0.0);
      for (std::size_t j = 0; j <= i; ++j)
        normal[i][j] = normal[j][i] =
            std::inner_product(slopes[i].begin(), slopes[i].end(), slopes[j].begin(), 0.0);
    }
    bool better = false;
    const double before = cost;
    for (int tries = 0; tries < 6 && !better; ++tries) {
      Matrix damped = normal;
      for (std::size_t i = 0; i < count; ++i) damped[i][i] += damping * (normal[i][i] + 1e-3);
      FilmNumbers step = gradient;
      solve_definite(damped, step, count);
      FilmNumbers next = place;
      for (std::size_t i = 0; i < count; ++i) next[i] = std::clamp(place[i] + step[i], 0.0, 1.0);
      const double cost_there = search.differences(next, there);
      better = cost_there < cost;
      damping = std::clamp(damping * (better ? 0.3 : 4.0), 1e-9, 1e6);
      if (!better) continue;
      place = next;
      cost = cost_there;
      here.swap(there);
    }
    if (!better || before - cost < 1e-6 * before) break;
  }
  return cost;
}

// Nelder and Mead's simplex on the mean error, held inside the ranges.
double polish(const Search& search, FilmNumbers& place, int evaluations) {
  struct Corner {
    FilmNumbers place;
    double error;
  };
  const std::size_t count = search.count();
  const auto corner = [&](FilmNumbers at) {
    for (std::size_t i = 0; i < count; ++i) at[i] = std::clamp(at[i], 0.0, 1.0);
    --evaluations;
    return Corner{at, search.mean(at)};
  };
  std::vector<Corner> all{corner(place)};
  for (std::size_t i = 0; i < count; ++i) {
    FilmNumbers moved = place;
    moved[i] += moved[i] > 0.5 ? -0.03 : 0.03;
    all.push_back(corner(moved));
  }
  const auto less = [](const Corner& a, const Corner& b) { return a.error < b.error; };
  while (evaluations > 0) {
    std::stable_sort(all.begin(), all.end(), less);
    if (all.back().error - all.front().error < 1e-7) break;
    FilmNumbers middle{};
    for (std::size_t c = 0; c < count; ++c)
      for (std::size_t i = 0; i < count; ++i) middle[i] += all[c].place[i] / double(count);
    const auto beyond = [&](double by) {
      FilmNumbers at{};
      for (std::size_t i = 0; i < count; ++i) at[i] = middle[i] + by * (all.back().place[i] - middle[i]);
      return corner(at);
    };
    Corner next = beyond(-1);
    if (next.error < all.front().error) {
      const Corner further = beyond(-2);
      if (further.error < next.error) next = further;
    } else if (!(next.error < all[count - 1].error)) {
      next = beyond(next.error < all.back().error ? -0.5 : 0.5);
      if (!(next.error < all.back().error)) {
        for (std::size_t c = 1; c <= count; ++c) {
          FilmNumbers at{};
          for (std::size_t i = 0; i < count; ++i) at[i] = (all[0].place[i] + all[c].place[i]) / 2;
          all[c] = corner(at);
        }
        continue;
      }
    }
    all.back() = next;
  }
  std::stable_sort(all.begin(), all.end(), less);
  place = all.front().place;
  return all.front().error;
}

// Halton's sequence: points that fill [0, 1] evenly.
double halton(std::size_t index, std::size_t dimension) {
  constexpr std::array<std::size_t, most_film_numbers> primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  double out = 0, share = 1;
  for (std::size_t left = index + 1; left > 0; left /= primes[dimension]) {
    share /= double(primes[dimension]);
    out += share * double(left % primes[dimension]);
  }
  return out;
}

}  // namespace

FilmTruth film_truth(const std::function<Vec3(double)>& seen) {
  FilmTruth out;
  double sum = 0;
  for (int degrees = 0; degrees <= 84; degrees += 6) {
    const double angle = degrees * std::numbers::pi / 180;
    out.cosines.push_back(math::cos(angle));
    out.weights.push_back(degrees == 0 ? 0 : math::cos(angle) * math::sin(angle));
    out.seen.push_back(lab_of(seen(math::cos(angle))));
    sum += out.weights.back();
  }
  for (double& weight : out.weights) weight /= sum;
  return out;
}

FilmError film_error(const std::function<Vec3(double)>& seen, const FilmTruth& truth) {
  FilmError out;
  for (std::size_t i = 0; i < truth.cosines.size(); ++i) {
    const double off = delta_e2000(lab_of(seen(truth.cosines[i])), truth.seen[i]);
    if (i == 0) out.normal = off;
    out.mean += truth.weights[i] * off;
    out.largest = std::max(out.largest, off);
  }
  return out;
}

FilmError film_error(const FilmForm& form, const FilmNumbers& numbers, const FilmTruth& truth) {
  return film_error([&](double cosine) { return form.seen(numbers, cosine); }, truth);
}

FilmNumbers in_range(const FilmForm& form, FilmNumbers numbers) {
  for (std::size_t i = 0; i < form.numbers.size(); ++i)
    numbers[i] = std::clamp(numbers[i], form.numbers[i].least, form.numbers[i].most);
  return numbers;
}

FilmNumbers fitted_film(const FilmForm& form, const FilmTruth& truth, const FilmNumbers& start,
                        double path_nm) {
  constexpr std::size_t points = 1500, descents = 14, polished = 3;
  const Search search(form, truth);
  struct Candidate {
    FilmNumbers place;
    double cost;
  };
  std::vector<double> differences;
  std::vector<Candidate> all{{search.place(start), 0}};
  for (std::size_t i = 0; i < points; ++i) {
    FilmNumbers place{};
    for (std::size_t d = 0; d < search.count(); ++d) place[d] = halton(i, d);
    if (form.index < search.count()) {
      // Half a fringe of red light to both sides of the thickness that is known: beyond it the colours come again.
      FilmNumbers x = search.numbers(place);
      const double path = std::max(path_nm - 350 + 700 * halton(i, form.index + 1), 0.0);
      x[form.index + 1] = path / x[form.index];
      place[form.index + 1] = search.place(x)[form.index + 1];
    }
    all.push_back({place, 0});
  }
  for (Candidate& each : all) each.cost = search.differences(each.place, differences);
  const auto less = [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; };
  std::stable_sort(all.begin() + 1, all.end(), less);
  all.resize(descents);
  for (Candidate& each : all) {
    descend(search, each.place, 15);
    each.cost = search.mean(each.place);
  }
  std::stable_sort(all.begin(), all.end(), less);
  all.resize(polished);
  for (Candidate& each : all) each.cost = polish(search, each.place, 400);
  return search.numbers(std::min_element(all.begin(), all.end(), less)->place);
}

}  // namespace etak
