// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "app/python/module.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/material/limits.h"
#include "core/material/quality.h"
#include "core/pages/f0/report.h"
#include "core/pages/f0/worker.h"

namespace etak::python {
namespace {

// The keywords of a dictionary that are settings; others are the fault of etak/__init__.py.
template <class Settings>
void set_texts(const py::dict& given, Settings& out,
               std::initializer_list<std::pair<const char*, std::string Settings::*>> members) {
  for (const auto& [name, member] : members)
    if (given.contains(name) && !given[name].is_none()) out.*member = text_of(given[name], name);
}

}  // namespace

F0Settings f0_settings(const py::dict& given) {
  F0Settings out;
  using S = F0Settings;
  set_texts<S>(given, out,
               {{"observer", &S::observer},
                {"illuminant", &S::illuminant},
                {"interpolation", &S::interpolation},
                {"method", &S::method},
                {"integration_bound", &S::integration_bound},
                {"space", &S::space},
                {"ocio", &S::ocio},
                {"outside", &S::outside}});
  if (given.contains("allow_extrapolation"))
    out.allow_extrapolation = given["allow_extrapolation"].cast<bool>();
  return out;
}

TableSettings table_settings(const py::dict& given) {
  TableSettings out;
  using S = TableSettings;
  set_texts<S>(given, out, {{"unit", &S::unit}, {"columns", &S::columns}, {"duplicates", &S::duplicates}});
  return out;
}

F0Options options_of(const F0Settings& settings, const Library& library) {
  return f0_options(settings, library.when_asked(), [](const std::string& config, const std::string& name) {
    return pictures(setting("space")).open_space(config, name);
  });
}

namespace {

// ---- one material

/// etak.F0: an answer, and what it was computed with.
struct F0Answer {
  F0Row row;
  std::shared_ptr<const F0Solver> solver;
  std::shared_ptr<const Material> material;  // null: of a file without one

  const F0Result& result() const { return row.result; }
};

F0Answer answer(const AskedMaterial& asked, bool axis_average, const F0Settings& settings,
                const TableSettings& tables, const Library& library) {
  F0Answer out;
  out.solver = std::make_shared<const F0Solver>(options_of(settings, library));
  const MaterialInput input = find_one(asked, library);
  const F0Job job{*out.solver, table_options(tables), axis_average, true, false};
  F0Worker worker;
  F0Outcome outcome = worker.answer(input, job);
  if (outcome.row.result.refused())
    throw Error::at(outcome.row.path, "refused: " + outcome.row.result.refusal);
  out.row = std::move(outcome.row);
  out.material = input.material;
  // A material file has datasets to compare, too.
  if (!out.material && input.file == MaterialFileKind::material)
    out.material = std::make_shared<const Material>(read_material(input, job.tables));
  return out;
}

std::optional<Spread> spread_of(const F0Answer& answer) {
  if (!answer.material) return std::nullopt;
  const Unlocked unlocked;
  MaterialReport report{*answer.material, {}};
  for (const Dataset& dataset : report.material.datasets)
    report.results.push_back(solve(*answer.solver, report.material, dataset));
  return spread(report);
}

std::vector<std::string> flags_of(const F0Result& result) {
  std::vector<std::string> out;
  result.flags.for_each([&](Flag flag) { out.emplace_back(name(flag)); });
  return out;
}

std::string text_of_answer(const F0Answer& answer) {
  const F0Options& options = answer.solver->options();
  std::string out = f0_table({&answer.row, 1}, options, false) + f0_legend({&answer.row, 1}, options);
  if (!answer.row.source.empty()) out += answer.row.source + '\n';
  while (out.ends_with('\n')) out.pop_back();
  return out;
}

std::string repr_of(const F0Answer& answer) {
  const LinearRgb& c = answer.result().linear;
  return "<etak.F0 " + answer.row.path + ": " + hex(answer.result().srgb8) + ", " + fixed(c.r, 4) + " " +
         fixed(c.g, 4) + " " + fixed(c.b, 4) + " in " + space_name(answer.solver->options()) + ">";
}

// For notebooks: a swatch beside the text.
std::string html_of(const F0Answer& answer) {
  return "<div style=\"display:flex;gap:1em;align-items:flex-start\"><div style=\"width:4em;height:4em;"
         "flex:none;border-radius:.3em;background:" +
         hex(answer.result().srgb8) + "\"></div><pre style=\"margin:0;white-space:pre-wrap\">" +
         escape_html(repr_of(answer)) + "<br>" + escape_html(flags_text(answer.result())) + "<br>" +
         escape_html(answer.row.source) + "</pre></div>";
}

// ---- arrays

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

Rows rows_of(const py::object& n, const py::object& k, const py::object& reflectance,
             const py::object& wavelength) {
  Rows out;
  if (wavelength.is_none())
    throw Error::at("wavelength", "is not given", "wavelengths in nm, one for each sample");
  out.is_reflectance = !reflectance.is_none();
  if (out.is_reflectance == !n.is_none())
    throw Error::at(out.is_reflectance ? "reflectance" : "n",
                    out.is_reflectance ? "is given beside n" : "is not given",
                    "either n and k or reflectance");
  if (out.is_reflectance && !k.is_none())
    throw Error::at("k", "is given beside reflectance", "one of the two");
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
class RowOptics {
 public:
  RowOptics(const Rows& rows, std::span<const double> wavelength) {
    const Spectrum blank{{wavelength.begin(), wavelength.end()}, std::vector<double>(wavelength.size())};
    if (rows.is_reflectance)
      optics_ = Reflectance{blank};
    else if (rows.has_k)
      optics_ = OpticalConstants{blank, blank};
    else
      optics_ = OpticalConstants{blank, std::nullopt};
  }
  void set(std::span<const double> first, std::span<const double> second) {
    if (auto* reflectance = std::get_if<Reflectance>(&optics_)) {
      copy(first, reflectance->spectrum);
      return;
    }
    auto& constants = std::get<OpticalConstants>(optics_);
    copy(first, std::get<Spectrum>(constants.n));
    if (constants.k) copy(second, *constants.k);
  }
  const Optics& optics() const { return optics_; }
  std::span<const double> first() const {
    if (const auto* reflectance = std::get_if<Reflectance>(&optics_)) return reflectance->spectrum.value;
    return std::get<Spectrum>(std::get<OpticalConstants>(optics_).n).value;
  }
  std::span<const double> second() const { return std::get<OpticalConstants>(optics_).k->value; }

 private:
  static void copy(std::span<const double> from, Spectrum& to) {
    std::copy(from.begin(), from.end(), to.value.begin());
  }
  Optics optics_;
};

// Linear colours of all rows into `colors`, three for each.
void solve_rows(const Rows& rows, const F0Solver& solver, int threads, LongWork& work,
                std::span<double> colors) {
  const std::span<const double> nm = values_of(rows.wavelength), first = values_of(rows.first),
                                second = rows.has_k ? values_of(rows.second) : std::span<const double>();
  validate(Spectrum{{nm.begin(), nm.end()}, std::vector<double>(nm.size())}, "wavelength");
  const double most = rows.is_reflectance ? 1 : most_n;
  // Below some thousand samples, starting a thread takes longer than the work.
  const unsigned most_workers = threads_of(threads);
  constexpr std::size_t chunk = 8, least_samples = 1 << 14;
  const unsigned workers = rows.count * rows.samples < least_samples ? 1 : most_workers;
  std::vector<std::optional<RowOptics>> rooms(workers);
  parallel_chunks(rows.count, workers, chunk, [&](std::size_t begin, std::size_t end, unsigned worker) {
    work.go_on();
    std::optional<RowOptics>& room = rooms[worker];
    if (!room) room.emplace(rows, nm);
    for (std::size_t row = begin; row < end; ++row) {
      const auto of = [&](std::span<const double> all) {
        return all.subspan(row * rows.samples, rows.samples);
      };
      room->set(of(first), rows.has_k ? of(second) : second);
      // The copies are checked, because another thread may change the arrays meanwhile.
      check_values(room->first(), most, nm, rows.name(), [&] { return rows.place(row); });
      if (rows.has_k) check_values(room->second(), most_k, nm, "k", [&] { return rows.k_place(row); });
      const F0Result result = solver.solve(room->optics());
      if (result.refused()) throw Error::at(rows.place(row), "refused: " + result.refusal);
      colors[3 * row] = result.linear.r;
      colors[3 * row + 1] = result.linear.g;
      colors[3 * row + 2] = result.linear.b;
    }
  });
}

Array f0_of_rows(const py::object& n, const py::object& k, const py::object& reflectance,
                 const py::object& wavelength, const py::dict& given, const Library& library, int threads) {
  const Rows rows = rows_of(n, k, reflectance, wavelength);
  const F0Settings settings = f0_settings(given);
  std::vector<py::ssize_t> shape{3};
  if (!rows.one) shape.insert(shape.begin(), static_cast<py::ssize_t>(rows.count));
  Array out(shape);
  const std::span<double> colors(out.mutable_data(), 3 * rows.count);
  LongWork work;
  work.unlocked([&] {
    const F0Solver solver(options_of(settings, library));
    solve_rows(rows, solver, threads, work, colors);
    return true;
  });
  return out;
}

}  // namespace

void add_f0(py::module_& module) {
  py::class_<Spread>(module, "Spread", "How far the published datasets of a material disagree.")
      .def_readonly("count", &Spread::count, "Datasets that were not refused.")
      .def_property_readonly(
          "least", [](const Spread& s) { return array_of_rgb(s.least); }, "Per channel.")
      .def_property_readonly(
          "most", [](const Spread& s) { return array_of_rgb(s.most); }, "Per channel.")
      .def_property_readonly(
          "least_hex", [](const Spread& s) { return hex(s.least8); }, "In 8-bit sRGB.")
      .def_property_readonly(
          "most_hex", [](const Spread& s) { return hex(s.most8); }, "In 8-bit sRGB.")
      .def("__repr__", [](const Spread& s) {
        return "<etak.Spread of " + std::to_string(s.count) + (s.count == 1 ? " dataset: " : " datasets: ") +
               hex(s.least8) + " to " + hex(s.most8) + ">";
      });

  py::class_<F0Answer> f0(module, "F0",
                          "Reflectance at normal incidence as a colour, and what one must know to trust it.");
  const auto get = [&](const char* name, auto read, const char* doc) {
    f0.def_property_readonly(name, read, doc);
  };
  get(
      "name", [](const F0Answer& a) { return a.row.path; },
      "What was asked for: \"gold\", or the path of a file.");
  get(
      "material_name", [](const F0Answer& a) { return a.row.name; }, "\"Gold\"; empty for bare files.");
  get(
      "material_class", [](const F0Answer& a) { return a.row.material_class; },
      "\"metal\"; empty for bare files.");
  get(
      "dataset", [](const F0Answer& a) { return a.row.dataset; }, "Its id; empty for bare files.");
  get(
      "citation", [](const F0Answer& a) { return a.row.source; },
      "Where the data are from; empty: not known.");
  get(
      "kind", [](const F0Answer& a) { return a.row.kind; },
      "\"measured\", \"fit\", \"computed\"; empty: not known.");
  get(
      "doubt", [](const F0Answer& a) { return a.row.doubt; },
      "Why the dataset is doubtful; empty: nothing says so.");
  get(
      "alias_note", [](const F0Answer& a) { return a.row.alias_note; },
      "What must be said of the name that was asked for.");
  get(
      "space", [](const F0Answer& a) { return space_name(a.solver->options()); }, "The space of rgb.");
  get(
      "rgb", [](const F0Answer& a) { return array_of_rgb(a.result().linear); },
      "Linear, in `space`; never clipped.");
  get(
      "srgb", [](const F0Answer& a) { return array_of_rgb(a.result().srgb_linear); },
      "Linear sRGB; never clipped.");
  get(
      "xyz", [](const F0Answer& a) { return array_of_rgb(a.result().xyz); },
      "Y = 1 for a perfect reflector.");
  get(
      "rgb8",
      [](const F0Answer& a) {
        const Srgb8& c = a.result().srgb8;
        return py::make_tuple(int{c.r}, int{c.g}, int{c.b});
      },
      "8-bit sRGB, clipped.");
  get(
      "hex", [](const F0Answer& a) { return hex(a.result().srgb8); }, "8-bit sRGB: \"#ffe49c\".");
  get(
      "luminance", [](const F0Answer& a) { return a.result().luminance; }, "Y.");
  const auto optional_rgb = [](const std::optional<LinearRgb>& c) {
    return c ? py::object(array_of_rgb(*c)) : py::object(py::none());
  };
  get(
      "f82", [optional_rgb](const F0Answer& a) { return optional_rgb(a.result().f82); },
      "Reflectance at cos 1/7, in `space`; None for reflectance data.");
  get(
      "f82_tint", [optional_rgb](const F0Answer& a) { return optional_rgb(a.result().f82_tint); },
      "f82 divided by Schlick's form there; None for reflectance data.");
  get(
      "zone",
      [](const F0Answer& a) -> std::optional<std::string> {
        if (!a.result().zone) return std::nullopt;
        return std::string(name(*a.result().zone));
      },
      "Luminance against the forbidden zone, 0.20 to 0.45: \"below\", \"inside\", \"above\"; None for "
      "surfaces.");
  get(
      "flags", [](const F0Answer& a) { return flags_of(a.result()); },
      "What was found in data and result, by name.");
  get(
      "flag_meanings",
      [](const F0Answer& a) {
        py::dict out;
        a.result().flags.for_each(
            [&](Flag flag) { out[py::str(std::string(name(flag)))] = std::string(meaning(flag)); });
        return out;
      },
      "Those flags, each with a sentence.");
  get(
      "gamut_excess", [](const F0Answer& a) { return array_of(a.result().gamut_excess); },
      "How far rgb is above 1 (positive) or below 0 (negative).");
  get(
      "coverage", [](const F0Answer& a) { return a.result().coverage.least(); },
      "Share of the visible weight that the data hold: the least of X, Y and Z.");
  get(
      "coverage_xyz", [](const F0Answer& a) { return array_of(a.result().coverage.weight); },
      "Of X, Y and Z.");
  get(
      "range",
      [](const F0Answer& a) { return std::pair(a.result().coverage.first_nm, a.result().coverage.last_nm); },
      "First and last wavelength of the data, in nm.");
  get(
      "samples", [](const F0Answer& a) { return a.result().coverage.samples_400_700; },
      "Rows of the data within 400 to 700 nm; 0 for a formula.");
  get(
      "largest_gap", [](const F0Answer& a) { return a.result().coverage.largest_gap_nm; },
      "Between rows within 400 to 700 nm, in nm; 0 for a formula.");
  get(
      "policy", [](const F0Answer& a) { return policy(a.solver->options()); },
      "What the numbers were computed by.");
  get("spread", &spread_of, "Of all datasets of the material; None for a file without a material.");
  f0.def(
      "json",
      [](const F0Answer& a) {
        return f0_json({&a.row, 1}, a.solver->options());
      },
      "As the command line's --format json.");
  f0.def("__str__", &text_of_answer).def("__repr__", &repr_of).def("_repr_html_", &html_of);

  module.def(
      "f0",
      [](const py::object& material, const std::string& dataset, bool axis_average, const py::dict& settings,
         const Library& library) {
        const AskedMaterial asked = asked_material(material, dataset);
        const F0Settings how = f0_settings(settings);
        const TableSettings tables = table_settings(settings);
        const Unlocked unlocked;
        return answer(asked, axis_average, how, tables, library);
      },
      py::arg("material"), py::arg("dataset"), py::arg("axis_average"), py::arg("settings"),
      py::arg("library"));
  module.def("f0_of_rows", &f0_of_rows, py::arg("n"), py::arg("k"), py::arg("reflectance"),
             py::arg("wavelength"), py::arg("settings"), py::arg("library"), py::arg("threads"));
}

}  // namespace etak::python
