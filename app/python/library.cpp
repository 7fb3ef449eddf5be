// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "app/python/members.h"
#include "app/python/module.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/color/srgb.h"
#include "core/material/catalogue.h"
#include "core/material/find.h"
#include "core/material/material.h"
#include "core/material/names.h"
#include "core/material/optics_at.h"
#include "core/material/quality.h"

namespace etak::python {

namespace {

// ---- what Python sees of a dataset

const Spectrum* table_of(const Dataset& dataset) {
  if (const auto* reflectance = std::get_if<Reflectance>(&dataset.optics)) return &reflectance->spectrum;
  return std::get_if<Spectrum>(&std::get<OpticalConstants>(dataset.optics).n);
}

std::pair<double, double> range_of(const Dataset& dataset) {
  if (const Spectrum* table = table_of(dataset)) return {table->first_nm(), table->last_nm()};
  const auto& formula = std::get<DispersionFormula>(std::get<OpticalConstants>(dataset.optics).n);
  return {formula.first_nm, formula.last_nm};
}

const OpticalConstants& constants_of(const DatasetOf& of) {
  const auto* out = std::get_if<OpticalConstants>(&of.dataset().optics);
  if (out == nullptr) throw Error::at(of.label(), "has reflectance data only", "a dataset of n and k");
  return *out;
}

// What `read` gives at wavelengths of any shape: an array of that shape, or a number for a number.
template <class Read>
py::object at_wavelengths(const py::object& wavelength, bool extrapolate, const std::string& interpolation,
                          const Read& read) {
  const Array given = doubles(wavelength, "wavelength");
  const std::vector<double> at(given.data(), given.data() + given.size());
  ReadOptions options;
  options.extrapolate = extrapolate;
  options.interpolation = setting_value("interpolation", interpolation, options.interpolation,
                                        interpolation_named, "linear or pchip");
  LongWork work;
  const std::vector<double> values = work.unlocked([&] {
    constexpr std::size_t block = 1 << 16;
    std::vector<double> out;
    std::span<const double> rest(at);
    do {
      work.go_on();
      const std::vector<double> some = read(rest.first(std::min(block, rest.size())), options);
      out.insert(out.end(), some.begin(), some.end());
      rest = rest.subspan(some.size());
    } while (!rest.empty());
    return out;
  });
  if (given.ndim() == 0) return py::float_(values[0]);
  Array out(std::vector<py::ssize_t>(given.shape(), given.shape() + given.ndim()));
  std::copy(values.begin(), values.end(), out.mutable_data());
  return out;
}

py::object n_of(const DatasetOf& of, const py::object& wavelength, bool extrapolate,
                const std::string& interpolation) {
  return at_wavelengths(wavelength, extrapolate, interpolation, [&](auto at, const ReadOptions& options) {
    return n_at(constants_of(of), at, of.label(), options);
  });
}

py::object k_of(const DatasetOf& of, const py::object& wavelength, bool extrapolate,
                const std::string& interpolation) {
  return at_wavelengths(wavelength, extrapolate, interpolation, [&](auto at, const ReadOptions& options) {
    return k_at(constants_of(of), at, of.label(), options);
  });
}

py::object reflectance_of(const DatasetOf& of, const py::object& wavelength, bool extrapolate,
                          const std::string& interpolation) {
  const auto* table = std::get_if<Reflectance>(&of.dataset().optics);
  if (table == nullptr) throw Error::at(of.label(), "has n and k", "a dataset of reflectance");
  return at_wavelengths(wavelength, extrapolate, interpolation, [&](auto at, const ReadOptions& options) {
    return values_at(table->spectrum, at, of.label(), options);
  });
}

std::vector<std::string> flag_names(Flags flags) {
  std::vector<std::string> out;
  flags.for_each([&](Flag flag) { out.emplace_back(name(flag)); });
  return out;
}

std::vector<DatasetOf> datasets_of(const std::shared_ptr<Material>& material) {
  std::vector<DatasetOf> out;
  for (std::size_t i = 0; i < material->datasets.size(); ++i) out.push_back({material, i});
  return out;
}

DatasetOf dataset_by_name(const std::shared_ptr<Material>& material, const std::string& name) {
  const Dataset& found = dataset_named(*material, name, material->id);
  return {material, static_cast<std::size_t>(&found - material->datasets.data())};
}

// A material of one dataset, of numbers that a program has.
DatasetOf made_dataset(const py::object& wavelength, const py::object& given_n, const py::object& given_k,
                       const py::object& reflectance, const std::string& name) {
  const auto [n, k] = parts_of_index(given_n, given_k);
  const Array at = doubles(wavelength, "wavelength");
  const auto table = [&](const py::object& value, const char* what) {
    const Array values = doubles(value, what);
    if (at.ndim() != 1 || values.ndim() != 1 || values.size() != at.size())
      throw Error::at(what, "shape " + shape_text(values),
                      "that of wavelength, (M,); it has " + shape_text(at));
    Spectrum out{{at.data(), at.data() + at.size()}, {values.data(), values.data() + values.size()}};
    validate(out, what);
    return out;
  };
  if (n.is_none() == reflectance.is_none())
    throw Error::at(n.is_none() ? "n" : "reflectance", n.is_none() ? "is not given" : "is given beside n",
                    "either n and k or reflectance");
  Dataset dataset;
  dataset.id = "given";
  if (reflectance.is_none()) {
    OpticalConstants constants;
    constants.n = table(n, "n");
    if (!k.is_none()) constants.k = table(k, "k");
    dataset.optics = std::move(constants);
  } else {
    dataset.optics = Reflectance{table(reflectance, "reflectance")};
  }
  auto material = std::make_shared<Material>();
  material->id = identifier(name, '_', "given");
  material->name = name;
  material->datasets.push_back(std::move(dataset));
  return {std::move(material), 0};
}

// The materials whose id, name, group or alias holds the text, in any case.
std::vector<std::string> ids_with(const Library& library, const std::string& text,
                                  const std::vector<std::string>& classes) {
  const MaterialLibrary& known = library.opened();
  std::vector<std::string> out;
  for (std::size_t i = 0; i < known.ids().size(); ++i)
    if (fits(CatalogueEntry{known.at(i), {}}, {classes, text, {}})) out.push_back(known.ids()[i]);
  return out;
}

// A material of a pickle, whose numbers the solver must be able to rely on.
std::shared_ptr<Material> restored_material(const py::bytes& bytes) {
  auto out = std::make_shared<Material>(from_bytes<Material>(bytes));
  if (out->preferred >= out->datasets.size()) throw Error::at("pickle", "no preferred dataset", "a material");
  for (const Dataset& each : out->datasets) {
    if (const auto* constants = std::get_if<OpticalConstants>(&each.optics)) {
      if (const auto* n = std::get_if<Spectrum>(&constants->n)) validate(*n, "pickle");
      if (constants->k) validate(*constants->k, "pickle");
    } else {
      validate(std::get<Reflectance>(each.optics).spectrum, "pickle");
    }
  }
  return out;
}

void add_citation(py::module_& module) {
  py::class_<Citation> citation(module, "Citation", "Who measured, and where it was published.");
  be_value(
      citation, [](const Citation& c) { return py::make_tuple(bytes_of(c)); }, &from_bytes<Citation>);
  citation.def_readonly("authors", &Citation::authors, "In the order of the publication.")
      .def_readonly("title", &Citation::title, "Of the publication.")
      .def_readonly("published_in", &Citation::published_in,
                    "Journal, volume and pages, or the name of a report.")
      .def_property_readonly(
          "year", [](const Citation& c) { return c.year == 0 ? std::nullopt : std::optional(c.year); },
          "None: not known.")
      .def_readonly("doi", &Citation::doi, "Without resolver; may be empty.")
      .def_readonly("url", &Citation::url, "May be empty.")
      .def_readonly("licence", &Citation::licence, "Of the numbers: an SPDX id.")
      .def_readonly("via", &Citation::via, "The collection and page that the numbers were taken from.")
      .def("__str__", [](const Citation& c) { return one_line(c); })
      .def("__repr__", [](const Citation& c) { return repr_line("Citation", one_line(c)); });
}

std::shared_ptr<Material> material_named(const Library& library, const std::string& name) {
  const MaterialLibrary& known = library.opened();
  auto found = known.find(name);
  if (!found)
    fail_unknown_name(known, name, {.place = {}, .found = "no material has this name", .instead = {}});
  return std::make_shared<Material>(std::move(*found));
}

// A library of folders, which Library(...) and pickles make.
std::unique_ptr<Library> library_of(const py::args& folders) {
  std::vector<std::string> paths;
  for (const auto& each : folders) paths.push_back(text_of(each, "folders"));
  return std::make_unique<Library>(std::move(paths));
}

void add_library_type(py::module_& module) {
  py::class_<Library> library(module, "Library", "The materials that names stand for.");
  be_value(
      library, [](const Library& l) { return py::tuple(py::cast(l.folders())); }, &library_of);
  library
      .def(
          py::init(&library_of),
          "The built-in library, those of ETAK_LIBRARY over it, and the folders of material files over both.")
      .def("__len__", [](const Library& l) { return l.opened().ids().size(); })
      .def("__iter__", [](const Library& l) { return py::iter(py::cast(l.opened().ids())); })
      .def("__contains__",
           [](const Library& l, const py::object& name) {
             return py::isinstance<py::str>(name) && l.opened().look_up(name.cast<std::string>()).has_value();
           })
      .def("__getitem__", &material_named, py::arg("name"),
           "The material of that id, name, alias or formula; raises Error with the nearest names.")
      .def(
          "keys", [](const Library& l) { return l.opened().ids(); }, "The ids, as iterating gives them.")
      .def("search", &ids_with, py::arg("text"), py::arg("classes") = std::vector<std::string>(),
           "Ids of the materials whose id, name, group or an alias holds the text, in any case; of these "
           "classes only.")
      .def(
          "suggest",
          [](const Library& l, const std::string& name) {
            std::vector<std::string> out;
            for (Suggestion& each : l.opened().suggest(name)) out.push_back(std::move(each.text));
            return out;
          },
          py::arg("name"), "Names that come near.")
      .def("__repr__", [](const Library& l) {
        return "<etak.Library of " + std::to_string(l.opened().ids().size()) + " materials>";
      });
  // Type.__new__(Type) makes a whole library too, which __init__ then leaves as it is.
  reinterpret_cast<PyTypeObject*>(library.ptr())->tp_new =  // NOLINT: an object of Python is its type
      [](PyTypeObject*, PyObject* arguments, PyObject*) -> PyObject* {
    try {
      return py::cast(library_of(py::reinterpret_borrow<py::args>(arguments))).release().ptr();
    } catch (py::error_already_set& error) {
      error.restore();
    } catch (const std::exception& error) {
      PyErr_SetString(PyExc_TypeError, error.what());
    }
    return nullptr;
  };
}

}  // namespace

void add_library(py::module_& module) {
  add_citation(module);
  py::class_<Material, std::shared_ptr<Material>> material(module, "Material",
                                                           "A material and its datasets.");
  be_value(
      material, [](const Material& m) { return py::make_tuple(bytes_of(m)); }, &restored_material);
  py::class_<DatasetOf> dataset(module, "Dataset", "What one source says of one sample.");
  be_value(
      dataset, [](const DatasetOf& d) { return py::make_tuple(bytes_of(*d.material), d.index); },
      [](const py::bytes& bytes, std::size_t index) {
        const auto of = restored_material(bytes);
        if (index >= of->datasets.size()) throw Error::at("pickle", "no such dataset", "one of its material");
        return DatasetOf{of, index};
      });

  const auto at = [&](const char* name, auto read, const char* doc) {
    dataset.def(name, read, py::arg("wavelength"), py::kw_only(), py::arg("extrapolate") = false,
                py::arg("interpolation") = "linear", doc);
  };
  at("n", &n_of, "n at wavelengths in nm; raises Error outside of the data unless extrapolate is true.");
  at("k", &k_of, "k at wavelengths in nm; raises Error outside of the data unless extrapolate is true.");
  at("reflectance", &reflectance_of,
     "Reflectance at wavelengths in nm; raises Error outside of the data unless extrapolate is true.");
  const auto text = [&](const char* name, auto get, const char* doc) {
    dataset.def_property_readonly(name, get, doc);
  };
  text(
      "id", [](const DatasetOf& d) { return d.dataset().id; }, "Unique within the material.");
  text("label", &DatasetOf::label, "\"gold/ID\", as f0() takes it.");
  text(
      "material", [](const DatasetOf& d) { return std::const_pointer_cast<Material>(d.material); },
      "The material that it is of.");
  text(
      "kind", [](const DatasetOf& d) { return std::string(name(d.dataset().origin)); },
      "\"measured\", \"fit\" or \"computed\".");
  text(
      "sample", [](const DatasetOf& d) { return d.dataset().sample; }, "State of the sample.");
  text(
      "temperature", [](const DatasetOf& d) { return d.dataset().temperature_kelvin; },
      "In kelvin, or None.");
  text(
      "axis", [](const DatasetOf& d) { return d.dataset().axis; }, "Of a crystal; empty: none.");
  text(
      "citation", [](const DatasetOf& d) { return d.dataset().citation; }, "Where the numbers are from.");
  text(
      "note", [](const DatasetOf& d) { return d.dataset().note; }, "A note; may be empty.");
  text(
      "doubt", [](const DatasetOf& d) { return doubt(*d.material, d.dataset()); },
      "Why the numbers should not be relied on; empty: nothing says so.");
  text(
      "flags",
      [](const DatasetOf& d) {
        Flags flags = d.dataset().flags;
        flags |= quality_flags(*d.material, d.dataset());
        return flag_names(flags);
      },
      "What was found in the data.");
  text(
      "has_n",
      [](const DatasetOf& d) { return std::holds_alternative<OpticalConstants>(d.dataset().optics); },
      "Whether it holds n, and not reflectance.");
  text(
      "has_k",
      [](const DatasetOf& d) {
        const auto* constants = std::get_if<OpticalConstants>(&d.dataset().optics);
        return constants != nullptr && constants->k.has_value();
      },
      "Whether it holds k.");
  text(
      "is_formula", [](const DatasetOf& d) { return table_of(d.dataset()) == nullptr; },
      "Whether n is a formula, which has no wavelengths of its own.");
  text(
      "wavelength",
      [](const DatasetOf& d) -> py::object {
        const Spectrum* table = table_of(d.dataset());
        return table == nullptr ? py::object(py::none()) : py::object(array_of(table->wavelength_nm));
      },
      "Where n or the reflectance was measured, in nm; None for a formula.");
  text(
      "k_range",
      [](const DatasetOf& d) -> std::optional<std::pair<double, double>> {
        const auto* constants = std::get_if<OpticalConstants>(&d.dataset().optics);
        if (constants == nullptr || !constants->k) return std::nullopt;
        return std::pair(constants->k->first_nm(), constants->k->last_nm());
      },
      "First and last wavelength of k, in nm, which may have a table of its own; None: no k is given.");
  text(
      "range", [](const DatasetOf& d) { return range_of(d.dataset()); }, "First and last wavelength, in nm.");
  dataset.def("__repr__", [](const DatasetOf& d) { return repr_line("Dataset", d.label()); });

  material.def_readonly("id", &Material::id, "Lower case: \"gold\".")
      .def_readonly("name", &Material::name, "\"Gold\".")
      .def_readonly("aliases", &Material::aliases, "Other names and formulas.")
      .def_readonly("material_class", &Material::material_class, "\"metal\", \"glass\", ...")
      .def_readonly("group", &Material::group, "Within the class, such as \"wood\"; may be empty.")
      .def_readonly("preferred_reason", &Material::preferred_reason, "Why that dataset is preferred.")
      .def_property_readonly(
          "optical_kind",
          [](const Material& m) -> std::optional<std::string> {
            if (m.material_class.empty()) return std::nullopt;
            return std::string(optical_kind(m.material_class));
          },
          "\"conductor\", \"semiconductor\", \"dielectric\" or \"surface\"; None where the class is not "
          "known.")
      .def_property_readonly("datasets", &datasets_of, "All of them.")
      .def_property_readonly(
          "preferred",
          [](const std::shared_ptr<Material>& m) {
            return DatasetOf{m, m->preferred};
          },
          "The dataset that is taken where none is named.")
      .def("dataset", &dataset_by_name, py::arg("name"), "The dataset of that id, or its unique beginning.")
      .def("__len__", [](const Material& m) { return m.datasets.size(); })
      .def("__iter__", [](const std::shared_ptr<Material>& m) { return py::iter(py::cast(datasets_of(m))); })
      .def("__repr__", [](const Material& m) { return repr_line("Material", m.id); });

  add_library_type(module);
  module.attr("library") =
      py::cast(const_cast<Library*>(&standard_library()), py::return_value_policy::reference);

  module.def("dataset", &made_dataset, py::arg("wavelength"), py::arg("n"), py::arg("k"),
             py::arg("reflectance"), py::arg("name"));
  module.def(
      "read",
      [](const py::object& asked_for, const std::string& id, const py::dict& tables, const Library& library) {
        const AskedMaterial asked = asked_material(asked_for, id);
        const TableSettings settings = table_settings(tables);
        LongWork work;
        return work.unlocked([&] { return read_one(asked, library, settings); });
      },
      py::arg("material"), py::arg("dataset"), py::arg("tables"), py::arg("library"));
}

}  // namespace etak::python
