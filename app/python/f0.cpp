// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "app/python/members.h"
#include "app/python/module.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/exchange/f0_worker.h"
#include "core/exchange/viewing_file.h"
#include "core/material/quality.h"
#include "core/pages/f0/report.h"
#include "core/spectrum/own_viewing.h"

namespace etak::python {
namespace {

// The setting as a table of the caller's: (wavelength, values), the values with `columns` columns. Nothing where the
// setting is None or a word.
std::optional<std::vector<Spectrum>> own_table(const Keywords& given, const char* name, std::size_t columns) {
  const py::object value = given.at(name);
  if (!py::isinstance<py::tuple>(value) && !py::isinstance<py::list>(value)) return std::nullopt;
  if (py::len(value) != 2)
    throw Error::at(name, "a list of " + std::to_string(py::len(value)), "(wavelength, values)");
  const Array nm = doubles(value[py::int_(0)], name), values = doubles(value[py::int_(1)], name);
  const auto rows = static_cast<std::size_t>(nm.size());
  if (nm.ndim() != 1 || static_cast<std::size_t>(values.size()) != rows * columns ||
      values.ndim() != (columns > 1 ? 2 : 1))
    throw Error::at(name, "shapes " + shape_text(nm) + " and " + shape_text(values),
                    columns > 1 ? "(M,) and (M, 3)" : "(M,) and (M,)");
  std::vector<Spectrum> out(columns, {{nm.data(), nm.data() + rows}, std::vector<double>(rows)});
  for (std::size_t c = 0; c < columns; ++c)
    for (std::size_t i = 0; i < rows; ++i) out[c].value[i] = values.data()[columns * i + c];
  return out;
}

}  // namespace

F0Settings f0_settings(const Keywords& given) {
  F0Settings out;
  if (const auto table = own_table(given, "observer", 3)) {
    out.own_observer = observer_of_table({{(*table)[0], (*table)[1], (*table)[2]}}, "observer");
  } else {
    out.observer = given.text("observer");
  }
  if (const auto table = own_table(given, "illuminant", 1))
    out.own_illuminant = illuminant_of_table(table->front(), "illuminant");
  else
    out.illuminant = given.text("illuminant");
  out.interpolation = given.text("interpolation");
  out.method = given.text("method");
  out.integration_bound = given.text("integration_bound");
  out.space = given.text("space");
  out.ocio = given.text("ocio");
  out.outside = given.text("outside");
  out.allow_extrapolation = given.yes("allow_extrapolation");
  out.aperture = given.text("aperture");
  out.scatter = given.text("scatter");
  return out;
}

TableSettings table_settings(const Keywords& given) {
  TableSettings out;
  out.unit = given.text("unit");
  out.columns = given.text("columns");
  if (!given.at("duplicates").is_none()) out.duplicates = given.text("duplicates");
  out.material_class = given.text("material_class");
  out.origin = given.text("origin");
  return out;
}

F0Options options_of(const F0Settings& settings, const Library& library) {
  F0Settings opened = settings;
  open_viewing(opened);
  return f0_options(opened, library.when_asked(), [](const std::string& config, const std::string& name) {
    return pictures(setting("space")).open_space(config, name);
  });
}

namespace {

// ---- one material

/// The parts of an answer that its row does not hold.
struct F0Words {
  std::string space, policy, text, json;
  std::optional<Spread> spread;
};

/// etak.F0: an answer, and what it was computed with.
struct F0Answer {
  F0Row row;
  std::shared_ptr<const F0Solver> solver;    // null: `words` are from a pickle
  std::shared_ptr<const Material> material;  // null: of a file without one
  F0Words words;

  const F0Result& result() const { return row.result; }
};

// A solver, kept alive together with the caller's tables that it reads.
std::shared_ptr<const F0Solver> solver_of(const F0Settings& settings, const Library& library) {
  F0Options options = options_of(settings, library);
  options.mean = !options.instrument.any();
  const auto both = std::make_shared<std::pair<F0Settings, F0Solver>>(settings, F0Solver(std::move(options)));
  return {both, &both->second};
}

// The settings of a call of F0, which hold for each material.
struct F0Call {
  std::shared_ptr<const F0Solver> solver;
  TableSettings tables;
  bool axis_average = false;
  std::optional<Coat> coat;
  MaterialsWithout without;
};

F0Answer answer(const AskedMaterial& asked, const F0Call& call, const Library& library) {
  F0Answer out;
  out.solver = call.solver;
  MaterialInput input = find_one(asked, library);
  leave_out(call.without, input.material);
  F0Job job{*out.solver, table_options(call.tables), call.axis_average, true, false};
  job.bands = true;
  job.coat = call.coat;
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
  if (!answer.solver) return answer.words.spread;
  if (!answer.material) return std::nullopt;
  LongWork work;
  return work.unlocked([&] {
    MaterialReport report{*answer.material, {}};
    for (const Dataset& dataset : report.material.datasets) {
      work.go_on();
      report.results.push_back(solve(*answer.solver, report.material, dataset));
    }
    return std::optional<Spread>(spread(report));
  });
}

std::string text_of_answer(const F0Answer& answer) {
  if (!answer.solver) return answer.words.text;
  const F0Options& options = answer.solver->options();
  std::string out = f0_table({&answer.row, 1}, options, false) + f0_legend({&answer.row, 1}, options);
  if (!answer.row.source.empty()) out += answer.row.source + '\n';
  while (out.ends_with('\n')) out.pop_back();
  return out;
}

std::string space_of(const F0Answer& answer) {
  return answer.solver ? space_name(answer.solver->options()) : answer.words.space;
}

std::string policy_of(const F0Answer& answer) {
  return answer.solver ? policy(answer.solver->options()) : answer.words.policy;
}

std::string json_of(const F0Answer& answer) {
  return answer.solver ? f0_json({&answer.row, 1}, answer.solver->options()) : answer.words.json;
}

F0Words words_of(const F0Answer& answer) {
  if (!answer.solver) return answer.words;
  return {space_of(answer), policy_of(answer), text_of_answer(answer), json_of(answer), spread_of(answer)};
}

std::string repr_of(const F0Answer& answer) {
  const LinearRgb& c = answer.result().linear;
  return repr_line("F0", answer.row.path + ": " + hex(answer.result().srgb8) + ", " + fixed(c.r, 4) + " " +
                             fixed(c.g, 4) + " " + fixed(c.b, 4) + " in " + space_of(answer));
}

// For notebooks: a swatch beside the text.
std::string html_of(const F0Answer& answer) {
  return "<div style=\"display:flex;gap:1em;align-items:flex-start\"><div style=\"width:4em;height:4em;flex:none;border-radius:.3em;background:" +
         hex(answer.result().srgb8) + "\"></div><pre style=\"margin:0;white-space:pre-wrap\">" +
         escape_html(repr_of(answer)) + "<br>" + escape_html(flags_text(answer.result())) + "<br>" +
         escape_html(answer.row.source) + "</pre></div>";
}

// The answers of materials, in their order; one object for those that ask the same.
py::list answers(const std::vector<py::object>& materials, const std::string& dataset, bool axis_average,
                 const py::dict& given, const Library& library, int threads) {
  const std::vector<AskedMaterial> asked = asked_materials(materials, dataset);
  const F0Settings settings = f0_settings({given});
  F0Call call{nullptr, table_settings({given}), axis_average, {}, {}};
  const std::string coat = Keywords{given}.text("coat");
  const std::vector<std::string> without = Keywords{given}.texts("without");
  LongWork work;
  std::vector<std::size_t> first;  // that asks the same
  const auto made = work.unlocked([&] {
    call.solver = solver_of(settings, library);
    if (!without.empty()) call.without = materials_without(library.get(), without);
    call.coat = coat_option(coat, library.when_asked(), call.solver->options(), axis_average);
    std::vector<std::shared_ptr<F0Answer>> out(asked.size());
    std::map<std::pair<std::string, const Material*>, std::size_t> places;
    for (const AskedMaterial& each : asked) {
      work.go_on();
      first.push_back(places.try_emplace({each.text, each.material.get()}, first.size()).first->second);
    }
    parallel_chunks(asked.size(), threads_of(threads), 1, [&](std::size_t i, std::size_t, unsigned) {
      work.go_on();
      if (first[i] == i) out[i] = std::make_shared<F0Answer>(answer(asked[i], call, library));
    });
    return out;
  });
  py::list out;
  for (const std::size_t i : first) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    out.append(made[i]);
  }
  return out;
}

// ---- what Python sees of it

template <class Value>
auto of_row(Value F0Row::*member) {
  return [member](const F0Answer& a) { return a.row.*member; };
}
template <class Value>
auto of_result(Value F0Result::*member) {
  return [member](const F0Answer& a) { return a.result().*member; };
}
template <class Color>
auto color_of(Color F0Result::*member) {
  return [member](const F0Answer& a) { return array_of_rgb(a.result().*member); };
}
auto color_of(std::optional<LinearRgb> F0Result::*member) {
  return [member](const F0Answer& a) {
    const std::optional<LinearRgb>& color = a.result().*member;
    return color ? std::optional(array_of_rgb(*color)) : std::nullopt;
  };
}
template <class Value>
auto of_coverage(Value Coverage::*member) {
  return [member](const F0Answer& a) { return a.result().coverage.*member; };
}

std::optional<std::string> zone_of(const F0Answer& answer) {
  const auto& zone = answer.result().zone;
  return zone ? std::optional<std::string>(name(*zone)) : std::nullopt;
}

// A colour as a tuple.
py::tuple tuple_of(const LinearRgb& c) {
  return py::make_tuple(c.r, c.g, c.b);
}

std::optional<py::dict> clear_of(const F0Answer& answer) {
  const std::optional<ClearBody>& body = answer.row.clear;
  if (!body) return std::nullopt;
  py::dict out;
  out["n_d"] = body->n_d;
  out["v_d"] = body->v_d;
  out["color"] = tuple_of(body->color);
  out["depth_m"] = body->depth_m;
  return out;
}

std::optional<py::dict> coat_of(const F0Answer& answer) {
  const std::optional<CoatedF0>& coat = answer.row.coat;
  if (!coat) return std::nullopt;
  py::dict out;
  out["n"] = coat->n;
  out["f0_under"] = tuple_of(coat->under.linear);
  out["f82_under"] = tuple_of(coat->under.f82.value());
  out["f0"] = tuple_of(coat->whole.linear);
  out["f82"] = tuple_of(coat->whole.f82.value());
  out["energy_left"] = tuple_of(coat->energy_left.linear);
  return out;
}

std::optional<py::dict> band_of(const F0Answer& answer) {
  const std::optional<Band>& band = answer.row.band;
  if (!band) return std::nullopt;
  py::dict out;
  out["publications"] = band->publications;
  out["class"] = std::string(name(band->kind));
  out["de50"] = band->de50;
  out["de90"] = band->de90;
  out["low90"] = tuple_of(band->low90);
  out["high90"] = tuple_of(band->high90);
  out["y90"] = py::make_tuple(band->y90[0], band->y90[1]);
  out["text"] = words(*band);
  return out;
}

py::dict meanings_of(const F0Answer& answer) {
  py::dict out;
  answer.result().flags.for_each(
      [&](Flag flag) { out[py::str(std::string(name(flag)))] = std::string(meaning(flag)); });
  return out;
}

void add_spread(py::module_& module) {
  py::class_<Spread> spread(module, "Spread", "How far the published datasets of a material disagree.");
  be_value(
      spread, [](const Spread& s) { return py::make_tuple(bytes_of(s)); }, &from_bytes<Spread>);
  const auto get = attributes_of(spread);
  get("count", "Datasets that were not refused.", &Spread::count);
  get("least", "Per channel.", [](const Spread& s) { return array_of_rgb(s.least); });
  get("most", "Per channel.", [](const Spread& s) { return array_of_rgb(s.most); });
  get("least_hex", "In 8-bit sRGB.", [](const Spread& s) { return hex(s.least8); });
  get("most_hex", "In 8-bit sRGB.", [](const Spread& s) { return hex(s.most8); });
  spread.def("__repr__", [](const Spread& s) {
    return "<etak.Spread of " + std::to_string(s.count) + (s.count == 1 ? " dataset: " : " datasets: ") +
           hex(s.least8) + " to " + hex(s.most8) + ">";
  });
}

void add_origin(const auto& get) {
  get("name", "What was asked for: \"gold\", or the path of a file.", of_row(&F0Row::path));
  get("material_name", "\"Gold\"; empty for bare files.", of_row(&F0Row::name));
  get("material_class", "\"metal\"; empty for bare files.", of_row(&F0Row::material_class));
  get("dataset", "Its id; empty for bare files.", of_row(&F0Row::dataset));
  get("citation", "Where the data are from; empty: not known.", of_row(&F0Row::source));
  get("kind", "\"measured\", \"fit\", \"computed\"; empty: not known.", of_row(&F0Row::kind));
  get("doubt", "Why the dataset is doubtful; empty: nothing says so.", of_row(&F0Row::doubt));
  get("alias_note", "What must be said of the name that was asked for.", of_row(&F0Row::alias_note));
  get("clear",
      "Of a clear body: n_d, Abbe's number v_d, and its colour in `space` through depth_m; None where it is not clear.",
      &clear_of);
  get("band",
      "How far a new publication would lie: publications, class, de50 and de90 (CIEDE2000), low90, high90 and y90 (linear sRGB and Y), text; None where band_reason says why.",
      &band_of);
  get("band_reason", "Why there is no band; empty: there is one.", of_row(&F0Row::band_reason));
  get("policy", "What the numbers were computed by.", &policy_of);
  get("spread", "Of all datasets of the material; None for a file without a material.", &spread_of);
}

void add_color(const auto& get) {
  get("space", "The space of rgb.", &space_of);
  get("rgb", "Linear, in `space`; never clipped.", color_of(&F0Result::linear));
  get("srgb", "Linear sRGB; never clipped.", color_of(&F0Result::srgb_linear));
  get("xyz", "Y = 1 for a perfect reflector.", color_of(&F0Result::xyz));
  get("rgb8", "8-bit sRGB, clipped.", [](const F0Answer& a) {
    const Srgb8& c = a.result().srgb8;
    return std::tuple(int{c.r}, int{c.g}, int{c.b});
  });
  get("hex", "8-bit sRGB: \"#ffe49c\".", [](const F0Answer& a) { return hex(a.result().srgb8); });
  get("luminance", "Y.", of_result(&F0Result::luminance));
  get("f82", "Reflectance at cos 1/7, in `space`; None for reflectance data.", color_of(&F0Result::f82));
  get("f82_tint", "f82 divided by Schlick's form there; None for reflectance data.",
      color_of(&F0Result::f82_tint));
  get("mean",
      "Mean of F over a diffuse hemisphere, in `space`; None for reflectance data and through an instrument.",
      color_of(&F0Result::mean));
  get("f82_mean", "The same of F82's curve through rgb and f82, in closed form; None without f82.",
      [](const F0Answer& a) {
        const auto mean = mean_of_f82(a.result());
        return mean ? std::optional(array_of_rgb(*mean)) : std::nullopt;
      });
  get("coat",
      "Of a coat: its n, and in `space` f0_under and f82_under of the base under it, f0 and f82 of the whole, and energy_left, the share that gets out; None without a coat.",
      &coat_of);
  get("zone",
      "Luminance against the forbidden zone, 0.20 to 0.45: \"below\", \"inside\", \"above\"; None for surfaces.",
      &zone_of);
  get("gamut_excess", "How far rgb is above 1 (positive) or below 0 (negative).",
      [](const F0Answer& a) { return array_of(a.result().gamut_excess); });
}

void add_data(const auto& get) {
  get("flags", "What was found in data and result, by name.",
      [](const F0Answer& a) { return flag_names(a.result().flags); });
  get("flag_meanings", "Those flags, each with a sentence.", &meanings_of);
  get("coverage", "Share of the visible weight that the data hold: the least of X, Y and Z.",
      [](const F0Answer& a) { return a.result().coverage.least(); });
  get("coverage_xyz", "Of X, Y and Z.",
      [](const F0Answer& a) { return array_of(a.result().coverage.weight); });
  get("range", "First and last wavelength of the data, in nm.",
      [](const F0Answer& a) { return std::pair(a.result().coverage.first_nm, a.result().coverage.last_nm); });
  get("samples", "Rows of the data within 400 to 700 nm; 0 for a formula.",
      of_coverage(&Coverage::samples_400_700));
  get("largest_gap", "Between rows within 400 to 700 nm, in nm; 0 for a formula.",
      of_coverage(&Coverage::largest_gap_nm));
}

}  // namespace

void add_f0(py::module_& module) {
  add_spread(module);
  py::class_<F0Answer, std::shared_ptr<F0Answer>> f0(
      module, "F0", "Reflectance at normal incidence as a colour, and what one must know to trust it.");
  be_value(
      f0,
      [](const F0Answer& a) {
        const F0Words words = words_of(a);
        return py::make_tuple(bytes_of(a.row), words.space, words.policy, words.text, words.json,
                              words.spread);
      },
      [](const py::bytes& row, const std::string& space, const std::string& policy, const std::string& text,
         const std::string& json, const std::optional<Spread>& spread) {
        return F0Answer{from_bytes<F0Row>(row), nullptr, nullptr, {space, policy, text, json, spread}};
      });
  const auto get = attributes_of(f0);
  add_origin(get);
  add_color(get);
  add_data(get);
  f0.def("json", &json_of, "As the command line's --format json.")
      .def("__str__", &text_of_answer)
      .def("__repr__", &repr_of)
      .def("_repr_html_", &html_of);
  module.def("f0", &answers);
}

}  // namespace etak::python
