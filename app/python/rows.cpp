// SPDX-License-Identifier: Apache-2.0
// F0 of many spectra at once: etak.f0(n=, k=, wavelength=).
#include <algorithm>
#include <cmath>

#include "app/python/module.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/material/f0/f0_steps.h"
#include "core/material/limits.h"
#include "core/spectrum/refinement.h"

namespace etak::python {
namespace {

/// Spectra in rows: n and k, or reflectances, all at the same wavelengths.
struct Rows {
  Array wavelength, first, second;  // n and k, or reflectances and nothing
  bool has_k = false, is_reflectance = false;
  std::size_t count = 1, samples = 0;
  bool one = false;  // a single spectrum, without a first axis

  const char* name() const { return is_reflectance ? "reflectance" : "n"; }
  // "n[17]" or "n".
  std::string place(std::size_t row) const {
    return one ? name() : name() + ("[" + std::to_string(row) + "]");
  }
  std::string k_place(std::size_t row) const { return one ? "k" : "k[" + std::to_string(row) + "]"; }
};

void check_shape(const Array& array, const char* name, const Rows& rows) {
  const py::ssize_t samples = rows.wavelength.size();
  if ((array.ndim() != 1 && array.ndim() != 2) || array.shape(array.ndim() - 1) != samples)
    throw Error::at(name, "shape " + shape_text(array),
                    "(N, M) or (M,) with M = " + std::to_string(samples) + " as wavelength has");
}

Rows rows_of(const Keywords& given) {
  const py::object given_n = given.at("n"), given_k = given.at("k"), reflectance = given.at("reflectance"),
                   wavelength = given.at("wavelength");
  Rows out;
  if (wavelength.is_none())
    throw Error::at("wavelength", "is not given", "wavelengths in nm, one for each sample");
  out.is_reflectance = !reflectance.is_none();
  if (out.is_reflectance == !given_n.is_none())
    throw Error::at(out.is_reflectance ? "reflectance" : "n",
                    out.is_reflectance ? "is given beside n" : "is not given",
                    "either n and k or reflectance");
  if (out.is_reflectance && !given_k.is_none())
    throw Error::at("k", "is given beside reflectance", "one of the two");
  const auto [n, k] = parts_of_index(given_n, given_k);
  out.wavelength = doubles(wavelength, "wavelength");
  if (out.wavelength.ndim() != 1)
    throw Error::at("wavelength", "shape " + shape_text(out.wavelength), "(M,)");
  out.first = doubles(out.is_reflectance ? reflectance : n, out.name());
  check_shape(out.first, out.name(), out);
  out.has_k = !k.is_none();
  if (out.has_k) {
    out.second = doubles(k, "k");
    if (out.second.ndim() != out.first.ndim() ||
        !std::equal(out.first.shape(), out.first.shape() + out.first.ndim(), out.second.shape()))
      throw Error::at("k", "shape " + shape_text(out.second), shape_text(out.first) + " as n has");
  }
  out.samples = static_cast<std::size_t>(out.wavelength.size());
  out.one = out.first.ndim() == 1;
  out.count = out.one ? 1 : static_cast<std::size_t>(out.first.shape(0));
  return out;
}

// Throws the Error of the first value outside [0, most]. The first loop has no branches, so that it takes no
// time beside the work on the row.
//   place   gives the place for the message
template <class Place>
void check_values(std::span<const double> values, double most, std::span<const double> wavelength,
                  const char* name, const Place& place) {
  bool fine = true;
  for (const double value : values) fine &= value >= 0 && value <= most;
  if (fine) return;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(values[i] >= 0 && values[i] <= most))
      throw Error::at(
          place(),
          std::string(name) + " = " + number(values[i], 9) + " at " + number(wavelength[i], 9) + " nm",
          "0 <= " + std::string(name) + " <= " + number(most, 9));
}

// The optics of one thread, whose wavelengths are set once and whose values are those of one row after the
// other.
struct RowOptics {
  Optics optics;

  RowOptics(const Rows& rows, const std::vector<double>& nm) {
    const Spectrum blank{nm, std::vector<double>(nm.size())};
    if (rows.is_reflectance)
      optics = Reflectance{blank};
    else
      optics = OpticalConstants{blank, rows.has_k ? std::optional(blank) : std::nullopt};
  }
  std::vector<double>& first() {
    if (auto* reflectance = std::get_if<Reflectance>(&optics)) return reflectance->spectrum.value;
    return std::get<Spectrum>(std::get<OpticalConstants>(optics).n).value;
  }
  std::vector<double>& second() { return std::get<OpticalConstants>(optics).k->value; }
};

// The linear colour of one row after the other: of F0Solver's steps those alone that it needs.
class RowSolver {
 public:
  RowSolver(const F0Options& options, const std::vector<double>& nm) : setup_(f0_setup(options)) {
    const bool may_be_spiky = options.method == Method::nm1 && finest_spacing_nm(nm) < 1 - 1e-9;
    if (setup_.needs_knots() || may_be_spiky) {
      solver_.emplace(options);
      return;
    }
    const Range range{nm.front(), nm.back()};
    refusal_ = coverage_refusal(setup_, range, coverage_of(range, nullptr, setup_.sums));
  }
  /// Throws Error where the row is refused.
  LinearRgb operator()(const Optics& optics, F0Spectra& room, const Rows& rows, std::size_t row) const {
    F0Result result;
    result.refusal = refusal_;
    if (solver_)
      result = solver_->solve(optics);
    else if (!result.refused()) {
      const Quadrature& q = setup_.quadrature;
      for (auto* each : {&room.n, &room.k, &room.r0}) each->resize(q.wavelength_nm.size());
      Stopwatch watch(false);
      F0Timing ignored;
      result.refusal = reflectance_at(setup_, optics, q, room, watch, ignored);
      if (!result.refused()) result = with_colour({}, setup_.options, q, setup_.spaces, room.r0, {});
    }
    if (result.refused()) throw Error::at(rows.place(row), "refused: " + result.refusal);
    return result.linear;
  }

 private:
  F0Setup setup_;
  std::optional<F0Solver> solver_;  // where each row is asked for its knots
  std::string refusal_;
};

// Linear colours of all rows into `colors`, three for each.
void solve_rows(const Rows& rows, const F0Options& options, int threads, LongWork& work,
                std::span<double> colors) {
  const std::span<const double> given_nm = values_of(rows.wavelength), first = values_of(rows.first),
                                second = rows.has_k ? values_of(rows.second) : std::span<const double>();
  const std::vector<double> nm(given_nm.begin(), given_nm.end());
  validate(Spectrum{nm, std::vector<double>(nm.size())}, "wavelength");
  const RowSolver solver(options, nm);
  const double most = rows.is_reflectance ? 1 : most_n;
  // Below some thousand samples, starting a thread takes longer than the work.
  const unsigned most_workers = threads_of(threads);
  constexpr std::size_t chunk = 8, least_samples = 1 << 14;
  const unsigned workers = rows.count * rows.samples < least_samples ? 1 : most_workers;
  struct Room {
    RowOptics optics;
    F0Spectra spectra;
  };
  std::vector<std::optional<Room>> rooms(workers);
  parallel_chunks(rows.count, workers, chunk, [&](std::size_t begin, std::size_t end, unsigned worker) {
    work.go_on();
    if (!rooms[worker]) rooms[worker].emplace(Room{RowOptics(rows, nm), {}});
    RowOptics& room = rooms[worker]->optics;
    for (std::size_t row = begin; row < end; ++row) {
      // The copies are checked, because another thread may change the arrays meanwhile.
      std::copy_n(&first[row * rows.samples], rows.samples, room.first().begin());
      check_values(room.first(), most, nm, rows.name(), [&] { return rows.place(row); });
      if (rows.has_k) {
        std::copy_n(&second[row * rows.samples], rows.samples, room.second().begin());
        check_values(room.second(), most_k, nm, "k", [&] { return rows.k_place(row); });
      }
      const Vec3 color = vec(solver(room.optics, rooms[worker]->spectra, rows, row));
      std::copy(color.begin(), color.end(), colors.begin() + static_cast<std::ptrdiff_t>(3 * row));
    }
  });
}

// The unit of the wavelengths of arrays, which for photon energies run the other way.
void in_nm(Rows& rows, const Keywords& given) {
  const auto unit = table_options(table_settings(given)).unit.value_or(WavelengthUnit::nanometre);
  if (unit == WavelengthUnit::nanometre) return;
  const std::span<const double> values = values_of(rows.wavelength);
  std::vector<double> nm;
  for (const double value : values) nm.push_back(to_nm(value, unit));
  rows.wavelength = array_of(nm);
  if (unit != WavelengthUnit::electronvolt) return;
  const auto turned = [](const py::object& array) {
    const auto backward = py::slice(py::none(), py::none(), py::int_(-1));
    return doubles(array[py::make_tuple(py::ellipsis(), backward)], "wavelength");
  };
  rows.wavelength = turned(rows.wavelength);
  rows.first = turned(rows.first);
  if (rows.has_k) rows.second = turned(rows.second);
}

Array f0_of_rows(const py::dict& keywords, const Library& library, int threads) {
  const Keywords given{keywords};
  Rows rows = rows_of(given);
  in_nm(rows, given);
  const F0Settings settings = f0_settings(given);
  std::vector<py::ssize_t> shape{3};
  if (!rows.one) shape.insert(shape.begin(), static_cast<py::ssize_t>(rows.count));
  Array out(shape);
  const std::span<double> colors(out.mutable_data(), 3 * rows.count);
  LongWork work;
  work.unlocked([&] {
    solve_rows(rows, options_of(settings, library), threads, work, colors);
    return true;
  });
  return out;
}

}  // namespace

void add_rows(py::module_& module) {
  module.def("f0_of_rows", &f0_of_rows);
}

}  // namespace etak::python
