// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "app/python/members.h"
#include "app/python/module.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/color/srgb.h"
#include "core/exchange/f0_worker.h"
#include "core/material/catalogue.h"
#include "core/material/f0/f0_data.h"
#include "core/material/find.h"
#include "core/material/material.h"
#include "core/material/names.h"
#include "core/material/optics/optics_at.h"
#include "core/material/quality.h"

namespace etak::python {

std::vector<std::string> flag_names(Flags flags) {
  std::vector<std::string> out;
  flags.for_each([&](Flag flag) { out.emplace_back(name(flag)); });
  return out;
}

namespace {

// ---- what Python sees of a dataset

// Null: a formula, or a stack.
const Spectrum* table_of(const Dataset& dataset) {
  if (std::holds_alternative<Stack>(dataset.optics)) return nullptr;
  if (const auto* reflectance = std::get_if<Reflectance>(&dataset.optics)) return &reflectance->spectrum;
  return std::get_if<Spectrum>(&std::get<OpticalConstants>(dataset.optics).n);
}

std::pair<double, double> range_of(const Dataset& dataset) {
  if (const Spectrum* table = table_of(dataset)) return {table->first_nm(), table->last_nm()};
  // A stack reaches as far as all of its media.
  if (const auto* stack = std::get_if<Stack>(&dataset.optics)) {
    std::pair<double, double> out{0, std::numeric_limits<double>::infinity()};
    for (const StackMedium& medium : stack->media) {
      const Range range = etak::range_of(medium.constants);
      out = {std::max(out.first, range.first_nm), std::min(out.second, range.last_nm)};
    }
    return out;
  }
  const auto& formula = std::get<DispersionFormula>(std::get<OpticalConstants>(dataset.optics).n);
  return {formula.first_nm, formula.last_nm};
}

using Layer = std::tuple<std::string, std::string, std::optional<double>, bool>;

// None: no stack whose media are known.
std::optional<std::vector<Layer>> layer_tuples(const Dataset& dataset) {
  std::vector<Layer> out;
  for (const F0Layer& each : layers_of(dataset))
    out.emplace_back(each.id, each.dataset, each.thickness_nm, each.thickness_nm && each.coherent);
  return out.empty() ? std::nullopt : std::optional(std::move(out));
}

const OpticalConstants* constants_in(const DatasetOf& of) {
  return std::get_if<OpticalConstants>(&of.dataset().optics);
}

const OpticalConstants& constants_of(const DatasetOf& of) {
  const OpticalConstants* const out = constants_in(of);
  if (out == nullptr)
    throw Error::at(of.label(), without_constants(of.dataset().optics), "a dataset of n and k");
  return *out;
}

// The values of `read` at wavelengths of any shape: an array of that shape, or a number for a number.
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

template <class At>
auto constants_at(const At& at) {
  return [at](const DatasetOf& of, const py::object& wavelength, bool extrapolate,
              const std::string& interpolation) {
    return at_wavelengths(wavelength, extrapolate, interpolation, [&](auto nm, const ReadOptions& options) {
      return at(constants_of(of), nm, of.label(), options);
    });
  };
}

py::object reflectance_of(const DatasetOf& of, const py::object& wavelength, bool extrapolate,
                          const std::string& interpolation) {
  const auto* table = std::get_if<Reflectance>(&of.dataset().optics);
  if (table == nullptr) throw Error::at(of.label(), "has n and k", "a dataset of reflectance");
  return at_wavelengths(wavelength, extrapolate, interpolation, [&](auto at, const ReadOptions& options) {
    return values_at(table->spectrum, at, of.label(), options);
  });
}

const Spectrum* k_in(const DatasetOf& of) {
  const OpticalConstants* const constants = constants_in(of);
  return constants != nullptr && constants->k ? &*constants->k : nullptr;
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

void check_pickled(const OpticalConstants& constants) {
  if (const auto* n = std::get_if<Spectrum>(&constants.n)) validate(*n, "pickle");
  if (constants.k) validate(*constants.k, "pickle");
}

void check_pickled(const Stack& stack) {
  bool good = stack.media.empty() || stack.base < stack.media.size();
  for (const StackLayer& layer : stack.layers)
    good = good && layer.medium < stack.media.size() && layer.thickness_nm >= 0 &&
           std::isfinite(layer.thickness_nm);
  if (!good) throw Error::at("pickle", "layers that a stack cannot have", "a material");
  for (const StackMedium& medium : stack.media) check_pickled(medium.constants);
}

// A material of a pickle, whose numbers the solver must be able to rely on.
std::shared_ptr<Material> restored_material(const py::bytes& bytes) {
  auto out = std::make_shared<Material>(from_bytes<Material>(bytes));
  if (out->preferred >= out->datasets.size()) throw Error::at("pickle", "no preferred dataset", "a material");
  for (const Dataset& each : out->datasets) {
    if (const auto* constants = std::get_if<OpticalConstants>(&each.optics)) {
      check_pickled(*constants);
    } else if (const auto* stack = std::get_if<Stack>(&each.optics)) {
      check_pickled(*stack);
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
  const auto get = attributes_of(citation);
  get("authors", "In the order of the publication.", &Citation::authors);
  get("title", "Of the publication.", &Citation::title);
  get("published_in", "Journal, volume and pages, or the name of a report.", &Citation::published_in);
  get("year", "None: not known.",
      [](const Citation& c) { return c.year == 0 ? std::nullopt : std::optional(c.year); });
  get("doi", "Without resolver; may be empty.", &Citation::doi);
  get("url", "May be empty.", &Citation::url);
  get("licence", "Of the numbers: an SPDX id.", &Citation::licence);
  get("via", "The collection and page that the numbers were taken from.", &Citation::via);
  citation.def("__str__", [](const Citation& c) { return one_line(c); })
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
      .def("__iter__", [](const Library& l) { return Iterator<std::string>(py::cast(l.opened().ids())); })
      .def("__contains__",
           [](const Library& l, const py::object& name) {
             return py::isinstance<py::str>(name) && l.opened().look_up(name.cast<std::string>()).has_value();
           })
      .def("__getitem__", &material_named, py::arg("name"),
           "The material of that id, name, alias or formula; raises Error with the nearest names.")
      .def(
          "keys", [](const Library& l) { return l.opened().ids(); }, "The ids, as iterating gives them.")
      .def(
          "search", &ids_with, py::arg("text"), py::arg("classes") = std::vector<std::string>(),
          "Ids of the materials whose id, name, group or an alias holds the text, in any case; of these classes only.")
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

template <class Value>
auto of_dataset(Value Dataset::*member) {
  return [member](const DatasetOf& d) { return d.dataset().*member; };
}

void add_source(const auto& get) {
  get("id", "Unique within the material.", of_dataset(&Dataset::id));
  get("label", "\"gold/ID\", as f0() takes it.", &DatasetOf::label);
  get("material", "The material that it is of.",
      [](const DatasetOf& d) { return std::const_pointer_cast<Material>(d.material); });
  get("kind", "\"measured\", \"fit\" or \"computed\".",
      [](const DatasetOf& d) { return std::string(name(d.dataset().origin)); });
  get("sample", "State of the sample.", of_dataset(&Dataset::sample));
  get("temperature", "In kelvin, or None.", of_dataset(&Dataset::temperature_kelvin));
  get("axis", "Of a crystal; empty: none.", of_dataset(&Dataset::axis));
  get("citation", "Where the numbers are from.", of_dataset(&Dataset::citation));
  get("note", "A note; may be empty.", of_dataset(&Dataset::note));
  get("doubt", "Why the numbers should not be relied on; empty: nothing says so.",
      [](const DatasetOf& d) { return doubt(*d.material, d.dataset()); });
}

void add_numbers(const auto& get) {
  get("flags", "What was found in the data.", [](const DatasetOf& d) {
    Flags flags = d.dataset().flags;
    flags |= quality_flags(*d.material, d.dataset());
    return flag_names(flags);
  });
  get("has_n", "Whether it holds n, and not reflectance or layers.",
      [](const DatasetOf& d) { return constants_in(d) != nullptr; });
  get("has_k", "Whether it holds k.", [](const DatasetOf& d) { return k_in(d) != nullptr; });
  get("is_formula", "Whether n is a formula, which has no wavelengths of its own.", [](const DatasetOf& d) {
    return table_of(d.dataset()) == nullptr && !std::holds_alternative<Stack>(d.dataset().optics);
  });
  get("stack",
      "Of a stack: its layers from the outside as (id, dataset, thickness in nm, whether it is coherent), and the base, "
      "whose thickness is None; None for all else.",
      [](const DatasetOf& d) { return layer_tuples(d.dataset()); });
  get("wavelength", "Where n or the reflectance was measured, in nm; None for a formula or a stack.",
      [](const DatasetOf& d) {
        const Spectrum* const table = table_of(d.dataset());
        return table == nullptr ? std::nullopt : std::optional(array_of(table->wavelength_nm));
      });
  get("k_range",
      "First and last wavelength of k, in nm, which may have a table of its own; None: no k is given.",
      [](const DatasetOf& d) {
        const Spectrum* const k = k_in(d);
        return k == nullptr ? std::nullopt : std::optional(std::pair(k->first_nm(), k->last_nm()));
      });
  get("range", "First and last wavelength, in nm; of a stack those that all its media have.",
      [](const DatasetOf& d) { return range_of(d.dataset()); });
}

void add_dataset(py::class_<DatasetOf>& dataset) {
  be_value(
      dataset, [](const DatasetOf& d) { return py::make_tuple(bytes_of(*d.material), d.index); },
      [](const py::bytes& bytes, std::size_t index) {
        const auto of = restored_material(bytes);
        if (index >= of->datasets.size()) throw Error::at("pickle", "no such dataset", "one of its material");
        return DatasetOf{of, index};
      });
  const auto at = [&](const char* name, const char* what, const auto& read) {
    const std::string doc =
        std::string(what) +
        " at wavelengths in nm; raises Error outside of the data unless extrapolate is true.";
    dataset.def(name, read, py::arg("wavelength"), py::kw_only(), py::arg("extrapolate") = false,
                py::arg("interpolation") = "linear", doc.c_str());
  };
  at("n", "n", constants_at(&n_at));
  at("k", "k", constants_at(&k_at));
  at("reflectance", "Reflectance", &reflectance_of);
  const auto get = attributes_of(dataset);
  add_source(get);
  add_numbers(get);
  dataset.def("__repr__", [](const DatasetOf& d) { return repr_line("Dataset", d.label()); });
}

using MaterialClass = py::class_<Material, std::shared_ptr<Material>>;

void add_material(MaterialClass& material) {
  be_value(
      material, [](const Material& m) { return py::make_tuple(bytes_of(m)); }, &restored_material);
  const auto get = attributes_of(material);
  get("id", "Lower case: \"gold\".", &Material::id);
  get("name", "\"Gold\".", &Material::name);
  get("aliases", "Other names and formulas.", &Material::aliases);
  get("material_class", "\"metal\", \"glass\", ...", &Material::material_class);
  get("group", "Within the class, such as \"wood\"; may be empty.", &Material::group);
  get("preferred_reason", "Why that dataset is preferred.", &Material::preferred_reason);
  get("optical_kind",
      "\"conductor\", \"semiconductor\", \"dielectric\" or \"surface\"; None where the class is not known.",
      [](const Material& m) {
        return m.material_class.empty() ? std::nullopt
                                        : std::optional<std::string>(optical_kind(m.material_class));
      });
  get("datasets", "All of them.", &datasets_of);
  get("preferred", "The dataset that is taken where none is named.", [](const std::shared_ptr<Material>& m) {
    return DatasetOf{m, m->preferred};
  });
  material
      .def("dataset", &dataset_by_name, py::arg("name"), "The dataset of that id, or its unique beginning.")
      .def("__len__", [](const Material& m) { return m.datasets.size(); })
      .def("__iter__",
           [](const std::shared_ptr<Material>& m) { return Iterator<DatasetOf>(py::cast(datasets_of(m))); })
      .def("__repr__", [](const Material& m) { return repr_line("Material", m.id); });
}

DatasetOf read_call(const py::object& asked_for, const std::string& id, const py::dict& tables,
                    const Library& library) {
  const AskedMaterial asked = asked_material(asked_for, id);
  const TableSettings settings = table_settings({tables});
  LongWork work;
  return work.unlocked([&] { return read_one(asked, library, settings); });
}

}  // namespace

void add_library(py::module_& module) {
  // Types that others name in their signatures stand before these.
  add_citation(module);
  MaterialClass material(module, "Material", "A material and its datasets.");
  py::class_<DatasetOf> dataset(module, "Dataset", "What one source says of one sample.");
  add_dataset(dataset);
  add_material(material);
  add_library_type(module);
  module.attr("library") =
      py::cast(const_cast<Library*>(&standard_library()), py::return_value_policy::reference);
  module.def("dataset", &made_dataset);
  module.def("read", &read_call);
}

}  // namespace etak::python
