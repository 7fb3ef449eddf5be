// SPDX-License-Identifier: Apache-2.0
// etak.nearest, etak.identify, etak.export, etak.eval, etak.curve and etak.delta_e: what the verbs of these names answer, and differences of colours.
#include <algorithm>

#include "app/python/module.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/certainty/publications.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/exchange/export_input.h"
#include "core/exchange/export_values.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_x.h"
#include "core/image/files/png.h"
#include "core/light/functions_csv.h"
#include "core/material/catalogue.h"
#include "core/material/quality.h"
#include "core/pages/asked_curves.h"
#include "core/pages/lists/identify.h"
#include "core/pages/lists/lists.h"
#include "core/pages/lists/sources.h"
#include "core/plot/svg_picture.h"

namespace etak::python {
namespace {

// ---- colours

// A colour as Python has it: "#ffe29b", three 8-bit codes, or linear values.
std::variant<LinearRgb, Srgb8> color_of(const py::object& value, bool linear) {
  if (py::isinstance<py::str>(value)) return parse_hex(value.cast<std::string>());
  const Array given = doubles(value, "color");
  if (given.ndim() != 1 || given.size() != 3)
    throw Error::at("color", "shape " + shape_text(given), "three numbers, or a hex text");
  const Vec3 rgb{given.data()[0], given.data()[1], given.data()[2]};
  for (const double each : rgb)
    if (!std::isfinite(each)) throw Error::at("color", number(each, 6), "finite numbers");
  if (linear) return to_rgb(rgb);
  return codes_of(rgb, "color");
}

// (material, hex, distance, distance over the band or None) of each.
py::list nearest(const py::object& color, bool linear, std::size_t count, const py::object& classes,
                 const Library& library, int threads) {
  const auto wanted = color_of(color, linear);
  const std::vector<std::string> only = texts_of(classes, "classes");
  check_classes(only);
  std::vector<CatalogueEntry> all;
  std::vector<NearMaterial> found;
  std::vector<BandOfF0> bands;
  LongWork work;
  work.unlocked([&] {
    const F0Solver solver{F0Options{}};
    all = catalogue(library.get(), solver, threads_of(threads));
    found = nearest_materials(all, wanted, only, count);
    bands = bands_of(found, solver);
    return true;
  });
  py::list out;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& band = bands[i].band;
    out.append(py::make_tuple(std::make_shared<Material>(found[i].entry->material),
                              hex(found[i].entry->result.srgb8), found[i].delta_e,
                              band ? std::optional(found[i].delta_e / band->de90) : std::nullopt));
  }
  return out;
}

// The document that `etak identify --format json` would write.
//   colors   of `given`: what is asked; empty: a measured spectrum is
std::string identify(const std::vector<py::object>& colors, const py::dict& given, const Library& library,
                     int threads) {
  const Keywords how{given};
  const bool linear = how.yes("linear");
  const auto asked_of = [&](const py::object& color) {
    const auto typed = color_of(color, linear);
    const auto* const values = std::get_if<LinearRgb>(&typed);
    return AskedColour{values ? *values : srgb_decode(std::get<Srgb8>(typed)), {}, values == nullptr};
  };
  const bool has_f82 = !how.at("f82").is_none();
  std::vector<std::pair<std::string, AskedColour>> questions;
  for (const py::object& each : colors) {
    auto& [text, asked] = questions.emplace_back(py::str(each).cast<std::string>(), asked_of(each));
    if (has_f82) asked.f82 = asked_of(how.at("f82")).f0;
    check_asked(asked, printable(text));
  }
  const std::string film = how.text("film"), measured = how.text("measured"), stack = how.text("stack"),
                    weights = how.text("prior");
  const std::vector<std::string> classes = how.texts("classes"), without = how.texts("without"),
                                 oxides = how.texts("oxide");
  LongWork work;
  return work.unlocked([&] {
    const F0Solver solver{has_f82 ? F0Options{} : without_f82()};
    const MaterialLibrary& known = library.get();
    if (!measured.empty()) return identify_json(identified_thickness(measured, stack, known, solver));
    if (!film.empty()) {
      std::vector<IdentifiedFilm> answers;
      for (const auto& [text, asked] : questions)
        answers.push_back({text, films_of_color({film, oxides}, asked, known, solver, threads_of(threads))});
      return identify_json(answers);
    }
    const Prior prior = weights.empty() ? Prior{} : parse_prior(weights, "prior", known);
    Identifier identifier(known, solver, classes, threads_of(threads));
    for (auto& [id, material] : materials_without(known, without))
      identifier.replace(id, std::move(material), solver);
    std::vector<IdentifiedColor> answers;
    for (const auto& [text, asked] : questions) answers.push_back({text, identifier.identify(asked, prior)});
    return identify_json(answers);
  });
}

// Differences of linear colours, three numbers each.
Array delta_e(const py::object& a, const py::object& b) {
  const Array one = doubles(a, "a"), other = doubles(b, "b");
  for (const auto& [array, name] : {std::pair(&one, "a"), std::pair(&other, "b")})
    if (array->ndim() == 0 || array->shape(array->ndim() - 1) != 3)
      throw Error::at(name, "shape " + shape_text(*array), "(..., 3)");
  const py::list both = py::module_::import("numpy").attr("broadcast_arrays")(one, other);
  const Array first = doubles(both[0], "a"), second = doubles(both[1], "b");
  Array out(std::vector<py::ssize_t>(first.shape(), first.shape() + first.ndim() - 1));
  double* const to = out.mutable_data();
  LongWork work;
  work.unlocked([&] {
    const double *x = first.data(), *y = second.data();
    for (py::ssize_t i = 0; i < out.size(); ++i, x += 3, y += 3) {
      if (i % 1024 == 0) work.go_on();
      to[i] = delta_e2000(to_lab(LinearRgb{x[0], x[1], x[2]}), to_lab(LinearRgb{y[0], y[1], y[2]}));
    }
    return true;
  });
  return out;
}

// ---- formulas

// The value of a function for inputs that are words, or arrays of one shape as numpy has broadcast them.
Array evaluated(const std::string& id, const py::dict& words, const py::dict& numbers) {
  const Function& function = function_named(id, {});
  std::vector<NamedText> inputs;
  for (const auto& [name, value] : words)
    inputs.emplace_back(name.cast<std::string>(), value.cast<std::string>());
  const std::size_t fixed = inputs.size();
  std::vector<Array> arrays;
  for (const auto& [name, value] : numbers) {
    inputs.emplace_back(name.cast<std::string>(), "");
    arrays.push_back(doubles(py::reinterpret_borrow<py::object>(value), inputs.back().first.c_str()));
  }
  Array out(arrays.empty()
                ? std::vector<py::ssize_t>()
                : std::vector<py::ssize_t>(arrays[0].shape(), arrays[0].shape() + arrays[0].ndim()));
  double* const to = out.mutable_data();
  LongWork work;
  work.unlocked([&] {
    for (py::ssize_t i = 0; i < out.size(); ++i) {
      if (i % 64 == 0) work.go_on();
      for (std::size_t k = 0; k < arrays.size(); ++k)
        inputs[fixed + k].second = number(arrays[k].data()[i], 17);
      to[i] = evaluate(function, inputs, {});
    }
    return true;
  });
  return out;
}

// ---- what is asked of a surface

std::optional<Gloss> gloss_of(const Keywords& how) {
  return given_gloss(how.number("gloss"), how.number("roughness"));
}

std::optional<LinearRgb> diffuse_of(const Keywords& how) {
  const py::object given = how.at("diffuse");
  if (given.is_none()) return std::nullopt;
  const auto color = color_of(given, true);
  const Srgb8* const codes = std::get_if<Srgb8>(&color);
  return codes != nullptr ? srgb_decode(*codes) : std::get<LinearRgb>(color);
}

// ---- export

struct ExportCall {
  std::vector<AskedMaterial> asked;
  std::string to;
  std::vector<std::string> targets;
  ExportWishes wishes;
  Fit fit = Fit::clamp;
  GltfMaterialForm form = GltfMaterialForm::metal_rough;
};

// The document, and remarks on what was assumed and changed.
struct Exported {
  std::string document;
  std::vector<std::string> remarks;
};

Exported exported(const ExportCall& call, const F0Options& options, const TableSettings& tables,
                  const Library& library, int threads, LongWork& work) {
  const F0Solver solver(options);
  std::vector<ExportSurface> surfaces;
  std::vector<std::string> datasets;
  Exported out;
  for (const AskedMaterial& each : call.asked) {
    work.go_on();
    ExportAnswer answer = export_answer(find_one(each, library), table_options(tables), solver, call.wishes);
    if (!answer.surface) throw Error(answer.refusal);
    if (!answer.remark.empty()) out.remarks.push_back(answer.remark);
    surfaces.push_back(std::move(*answer.surface));
    datasets.push_back(std::move(answer.dataset));
  }
  if (call.to == "values") {
    out.document =
        export_json(exported_values(std::move(surfaces), datasets, engine_targets_named(call.targets),
                                    call.fit, threads_of(threads)),
                    call.fit, policy(options));
    return out;
  }
  std::vector<Changes> changes;
  out.document =
      call.to == "mtlx"
          ? material_x(surfaces, call.fit, changes)
          : gltf_document(surfaces, call.form, call.to == "glb" ? GltfContainer::glb : GltfContainer::gltf,
                          call.fit, changes);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (const std::string& note : surfaces[i].notes) out.remarks.push_back(surfaces[i].id + ": " + note);
    for (const Change& change : changes[i]) out.remarks.push_back(surfaces[i].id + ": " + one_line(change));
  }
  return out;
}

py::tuple export_call(const std::vector<py::object>& materials, const std::string& to, const py::dict& given,
                      const Library& library, int threads) {
  const Keywords how{given};
  ExportCall call;
  call.asked = asked_materials(materials, how.text("dataset"));
  if (call.asked.empty()) throw Error::at("materials", "no material", "one, or several");
  // A target's id is short for the values of that target.
  call.to = to == "mtlx" || to == "gltf" || to == "glb" ? to : "values";
  call.targets = to == call.to ? how.texts("target") : std::vector{to};
  call.wishes = {diffuse_of(how), gloss_of(how), how.at("opacity").cast<double>(), how.yes("axis_average")};
  call.fit = setting_value("fit", how.text("fit"), call.fit, fit_named, "clamp or preserve-hue");
  call.form = setting_value("gltf-form", how.text("gltf_form"), call.form, gltf_material_form_named,
                            "specular-ior or specular-glossiness");
  const F0Settings settings = f0_settings(how);
  const TableSettings tables = table_settings(how);
  LongWork work;
  const std::string coat = how.text("coat");
  Exported out = work.unlocked([&] {
    const F0Options options = options_of(settings, library);
    require_export_space(call.to, options);
    call.wishes.coat = coat_option(coat, library.when_asked(), options, call.wishes.axis_average);
    validate(call.wishes, options);
    return exported(call, options, tables, library, threads, work);
  });
  if (how.text("gltf_form") == "metal-rough")
    out.remarks.push_back(setting("gltf-form") + " " + std::string(gltf_form_renamed));
  const py::object document = call.to == "values" ? py::module_::import("json").attr("loads")(out.document)
                              : call.to == "glb"  ? py::object(py::bytes(out.document))
                                                  : py::cast(out.document);
  return py::make_tuple(document, out.remarks);
}

// ---- curves

// The answer of etak.curve(): the curves in a form of AskedCurves or as "png", and the remarks on what was assumed.
py::tuple curve_call(const std::vector<py::object>& materials, const std::string& form, const py::dict& given,
                     const Library& library) {
  const Keywords how{given};
  CurveRequest request;
  request.of = how.text("of");
  request.channel = how.text("channel");
  request.models = how.texts("model");
  request.terms = how.texts("term");
  request.set = how.texts("set");
  request.light_deg = how.at("light").cast<double>();
  request.step_deg = how.at("step").cast<double>();
  if (given.contains("scale")) request.scale = how.text("scale");
  request.straight = how.yes("straight");
  request.surface.gloss = gloss_of(how);
  if (const auto diffuse = diffuse_of(how)) request.surface.diffuse = vec(*diffuse);
  request.surface.compute = f0_settings(how);
  const TableSettings tables = table_settings(how);
  std::vector<std::string> words;
  std::vector<AskedMaterial> asked;  // of each word; one without a text for a surface in numbers
  for (const py::object& each : materials) {
    const bool number =
        py::isinstance<py::str>(each) && each.cast<std::string>().find('=') != std::string::npos;
    words.push_back(number ? each.cast<std::string>() : "");
    asked.push_back(number ? AskedMaterial() : asked_material(each, how.text("dataset")));
  }
  LongWork work;
  std::vector<std::string> remarks;
  const bool dark = how.yes("dark");
  const std::string out = work.unlocked([&] {
    auto groups = curve_groups(words);
    check(request, groups.size());
    request.options = options_of(request.surface.compute, library);
    if (groups.empty()) groups.emplace_back();
    std::vector<CurveSubject> subjects;
    std::size_t at = 0;
    for (const auto& group : groups) {
      CurveSubject& subject = subjects.emplace_back(CurveSubject{group, nullptr, 0});
      if (group == std::vector<std::string>{""}) {
        const DatasetOf found = read_one(asked[at], library, tables);
        subject.material = found.material;
        subject.dataset = found.index;
      }
      at += group.size();
    }
    const AskedCurves curves = asked_curves(request, subjects, remarks);
    if (form != "png") return curves.text(form, request.of, dark);
    return png_bytes(svg_picture(curves.text("svg", request.of, dark), pictures("form").picture_door().text),
                     {.srgb = true});
  });
  return py::make_tuple(py::bytes(out), remarks);
}

}  // namespace

void add_questions(py::module_& module) {
  module.def("nearest", &nearest);
  module.def("identify", &identify);
  module.def("hex_color", [](const std::string& text) { return array_of_rgb(srgb_decode(parse_hex(text))); });
  module.def("delta_e", &delta_e);
  module.def("evaluated", &evaluated);
  const auto list_of = [](const std::string& document, const char* member) {
    return py::module_::import("json").attr("loads")(document)[member].cast<py::list>();
  };
  module.def("functions", [list_of] { return list_of(functions_json(), "functions"); });
  module.def("sources",
             [list_of] { return list_of(sources_json(source_rows(MaterialLibrary::builtin())), "rows"); });
  module.def("write_file", [](const std::string& path, const py::bytes& bytes, bool force) {
    write_file(path, std::string_view(bytes), force);
  });
  module.def("curve", &curve_call);
  module.def("export", &export_call);
}

}  // namespace etak::python
