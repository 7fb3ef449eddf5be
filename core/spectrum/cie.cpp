// SPDX-License-Identifier: Apache-2.0
#include "core/spectrum/cie.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/math/functions.h"
#include "core/spectrum/integration.h"
#include "core/spectrum/interpolate.h"
#include "core/spectrum/own_viewing.h"

namespace etak {
namespace {

// Rows of resources/cie/*.csv: wavelength first.
constexpr double observer_rows[][7] = {
#include "observer_rows.inc"
};
constexpr double illuminant_rows[][4] = {
#include "illuminant_rows.inc"
};
constexpr int illuminant_step_nm = 5;

template <std::size_t Rows, std::size_t Columns>
constexpr bool ascends_evenly(const double (&rows)[Rows][Columns], double step) {
  for (std::size_t i = 1; i < Rows; ++i)
    if (rows[i][0] - rows[i - 1][0] != step) return false;
  return true;
}

// True when column c sums to `sum` within the last printed digits: with a wrong figure etak does not compile.
template <std::size_t Rows, std::size_t Columns>
constexpr bool sums_to(const double (&rows)[Rows][Columns], std::size_t c, double sum) {
  double total = 0;
  for (const auto& row : rows) total += row[c];
  const double gap = total - sum;
  return gap < 1e-7 * sum && gap > -1e-7 * sum;
}

static_assert(std::size(observer_rows) == grid_size && observer_rows[0][0] == grid_first_nm &&
              ascends_evenly(observer_rows, 1));
static_assert(illuminant_rows[0][0] <= grid_first_nm &&
              illuminant_rows[std::size(illuminant_rows) - 1][0] == grid_last_nm &&
              ascends_evenly(illuminant_rows, illuminant_step_nm));
static_assert(sums_to(observer_rows, 1, 106.86546949) && sums_to(observer_rows, 2, 106.85691710) &&
              sums_to(observer_rows, 3, 106.89225128) && sums_to(observer_rows, 4, 116.64851951) &&
              sums_to(observer_rows, 5, 116.66187710) && sums_to(observer_rows, 6, 116.67398051));
static_assert(sums_to(illuminant_rows, 1, 8194.57705) && sums_to(illuminant_rows, 2, 7926.77875) &&
              sums_to(illuminant_rows, 3, 12155.31843853));

constexpr auto columns_of_observer(std::size_t first) {
  std::array<std::array<double, 3>, grid_size> out{};
  for (std::size_t i = 0; i < grid_size; ++i)
    out[i] = {observer_rows[i][first], observer_rows[i][first + 1], observer_rows[i][first + 2]};
  return out;
}

constexpr auto column_of_illuminant(std::size_t column) {
  std::array<double, grid_size> out{};
  for (std::size_t i = 0; i < grid_size; ++i) {
    const int nm = grid_first_nm + static_cast<int>(i), first = static_cast<int>(illuminant_rows[0][0]);
    const auto row = static_cast<std::size_t>((nm - first) / illuminant_step_nm);
    const double t = static_cast<double>((nm - first) % illuminant_step_nm) / illuminant_step_nm;
    out[i] = illuminant_rows[row][column];
    if (t > 0) out[i] += t * (illuminant_rows[row + 1][column] - illuminant_rows[row][column]);
  }
  return out;
}

constexpr auto equal_energy() {
  std::array<double, grid_size> out{};
  out.fill(1);
  return out;
}

constexpr auto cie1931 = columns_of_observer(1);
constexpr auto cie1964 = columns_of_observer(4);
constexpr auto power_d65 = column_of_illuminant(1);
constexpr auto power_d50 = column_of_illuminant(2);
constexpr auto power_a = column_of_illuminant(3);
constexpr auto power_e = equal_energy();

// Tables in use, by values of an enumeration that lie above those of CIE and are never given twice.
template <class Id, class Row>
class OwnTables {
 public:
  std::shared_ptr<const Id> add(std::span<const Row, grid_size> rows, std::string label) {
    const std::lock_guard lock(lock_);
    last_ = static_cast<Id>(static_cast<int>(last_) + 1);
    Table& table = tables_[last_];
    std::copy(rows.begin(), rows.end(), table.rows.begin());
    table.label = std::move(label);
    return {new Id(last_), [this](const Id* id) {
              const std::lock_guard ending(lock_);
              tables_.erase(*id);
              delete id;
            }};
  }
  /// The table behind a value that is in use.
  std::span<const Row, grid_size> find(Id id) {
    const std::lock_guard lock(lock_);
    return tables_.find(id)->second.rows;
  }
  std::string_view label(Id id) {
    const std::lock_guard lock(lock_);
    const auto found = tables_.find(id);
    return found == tables_.end() ? "own" : std::string_view(found->second.label);
  }

 private:
  struct Table {
    std::array<Row, grid_size> rows;
    std::string label;
  };
  std::mutex lock_;
  std::map<Id, Table> tables_;  // whose elements stay where they are
  Id last_{16};
};

OwnTables<Observer, std::array<double, 3>>& own_observers() {
  static OwnTables<Observer, std::array<double, 3>> tables;
  return tables;
}
OwnTables<Illuminant, double>& own_illuminants() {
  static OwnTables<Illuminant, double> tables;
  return tables;
}

// A table on the reference grid.
std::array<double, grid_size> on_grid(const Spectrum& table, const std::string& place) {
  validate(table, place);
  if (table.first_nm() > visible_first_nm || table.last_nm() < visible_last_nm)
    throw Error::at(place,
                    "a table of " + number(table.first_nm(), 6) + "-" + number(table.last_nm(), 6) + " nm",
                    "one that holds 380-780 nm");
  std::array<double, grid_size> out{};
  resample_to_grid(table, out);
  for (std::size_t i = 0; i < grid_size; ++i)
    if (const double at = grid_first_nm + static_cast<double>(i);
        at < table.first_nm() || at > table.last_nm())
      out[i] = 0;
  return out;
}

}  // namespace

std::shared_ptr<const Observer> own_observer(std::span<const std::array<double, 3>, grid_size> functions,
                                             std::string label, const std::string& place) {
  double sum = 0;
  for (const auto& row : functions)
    for (const double value : row)
      if (!std::isfinite(value)) throw Error::at(place, "a value that is not finite", "finite values");
  for (const auto& row : functions) sum += row[1];
  if (!(sum > 0)) throw Error::at(place, "the sum of y is not above 0", "an observer that sees light");
  return own_observers().add(functions, std::move(label));
}

std::shared_ptr<const Observer> observer_of_table(const std::array<Spectrum, 3>& functions,
                                                  const std::string& place, std::string label) {
  std::array<std::array<double, 3>, grid_size> rows{};
  for (std::size_t c = 0; c < functions.size(); ++c) {
    const auto column = on_grid(functions[c], place);
    for (std::size_t i = 0; i < grid_size; ++i) rows[i][c] = column[i];
  }
  return own_observer(rows, std::move(label), place);
}

std::shared_ptr<const Illuminant> illuminant_of_table(const Spectrum& power, const std::string& place,
                                                      std::string label) {
  return own_illuminant(on_grid(power, place), std::move(label), place);
}

std::shared_ptr<const Illuminant> own_illuminant(std::span<const double, grid_size> power, std::string label,
                                                 const std::string& place) {
  double sum = 0;
  for (const double value : power) {
    if (!(value >= 0) || !std::isfinite(value))
      throw Error::at(place, "power that is negative or not finite", "finite power of at least 0");
    sum += value;
  }
  if (!(sum > 0)) throw Error::at(place, "no power at 360-830 nm", "power above 0");
  return own_illuminants().add(power, std::move(label));
}

std::string light_remark(Illuminant illuminant) {
  const auto power = relative_power(illuminant);
  std::vector<double> most_first(power.begin(), power.end());
  std::ranges::sort(most_first, std::greater());
  double all = 0, within = 0;
  for (const double each : most_first) all += each;
  constexpr std::size_t few_nm = 40;
  for (std::size_t i = 0; i < few_nm; ++i)
    if ((within += most_first[i]) >= 0.9 * all)
      return "light of lines: 90 % of its power lies within " + std::to_string(i + 1) +
             " nm, and what matches under it need not match under any other";
  const auto xyz = [](Illuminant light) {
    return make_quadrature(Method::nm1, {Observer::cie1931_2deg, light}).white();
  };
  const auto own = xyz(illuminant);
  for (const Illuminant each : {Illuminant::d65, Illuminant::d50, Illuminant::a, Illuminant::e}) {
    if (each == illuminant) return {};
    const auto white = xyz(each);
    const auto known = relative_power(each);
    // Both whites have Y = 1; the spectra are compared at equal Y too.
    double of_own = 0, of_known = 0, apart = 0, size = 0;
    for (std::size_t i = 0; i < grid_size; ++i) {
      of_own += power[i] * cie1931[i][1];
      of_known += known[i] * cie1931[i][1];
    }
    for (std::size_t i = 0; i < grid_size; ++i) {
      apart += math::pow(power[i] / of_own - known[i] / of_known, 2);
      size += math::pow(known[i] / of_known, 2);
    }
    if (std::abs(own[0] - white[0]) < 0.01 && std::abs(own[2] - white[2]) < 0.01 && apart > 0.04 * size)
      return "a metamer of " + std::string(name(each)) +
             ": of its colour by another spectrum, so that what matches under one need not match under the other";
  }
  return {};
}

std::string_view name(Observer observer) {
  return observer == Observer::cie1931_2deg    ? "1931-2deg"
         : observer == Observer::cie1964_10deg ? "1964-10deg"
                                               : own_observers().label(observer);
}

std::string_view name(Illuminant illuminant) {
  switch (illuminant) {
    case Illuminant::d65:
      return "D65";
    case Illuminant::d50:
      return "D50";
    case Illuminant::a:
      return "A";
    case Illuminant::e:
      return "E";
  }
  return own_illuminants().label(illuminant);
}

std::optional<Observer> observer_named(std::string_view text) {
  for (const Observer o : {Observer::cie1931_2deg, Observer::cie1964_10deg})
    if (text == name(o)) return o;
  return std::nullopt;
}

std::optional<Illuminant> illuminant_named(std::string_view text) {
  for (const Illuminant i : {Illuminant::d65, Illuminant::d50, Illuminant::a, Illuminant::e})
    if (lower_case(text) == lower_case(name(i))) return i;
  return std::nullopt;
}

std::span<const std::array<double, 3>, grid_size> matching_functions(Observer observer) {
  if (observer == Observer::cie1931_2deg) return cie1931;
  if (observer == Observer::cie1964_10deg) return cie1964;
  return own_observers().find(observer);
}

std::span<const double, grid_size> relative_power(Illuminant illuminant) {
  switch (illuminant) {
    case Illuminant::d65:
      return power_d65;
    case Illuminant::d50:
      return power_d50;
    case Illuminant::a:
      return power_a;
    case Illuminant::e:
      return power_e;
  }
  return own_illuminants().find(illuminant);
}

}  // namespace etak
