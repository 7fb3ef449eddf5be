// SPDX-License-Identifier: Apache-2.0
// Finds the material that a caller means by a name, a path or an object.
#include "app/python/module.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/material/names.h"

namespace etak::python {

// ---- Library

const MaterialLibrary& Library::get() const {
  std::call_once(opened_, [this] { library_ = known_library(folders_); });
  return *library_;
}

const MaterialLibrary& Library::opened() const {
  LongWork work;
  return *work.unlocked([&] { return &get(); });
}

std::shared_ptr<const KnownMaterials> Library::known() const {
  if (folders_.empty() && environment_libraries().empty()) return nullptr;
  std::call_once(knows_, [this] { known_ = std::make_shared<const KnownMaterials>(get()); });
  return known_;
}

const Library& standard_library() {
  static const Library library{{}};
  return library;
}

// ---- finding

AskedMaterial asked_material(const py::object& value, const std::string& dataset) {
  AskedMaterial out;
  out.dataset = dataset;
  if (py::isinstance<DatasetOf>(value)) {
    const auto& of = value.cast<const DatasetOf&>();
    if (!dataset.empty()) throw Error::at(setting("dataset"), "given beside a Dataset", "one of the two");
    return {of.label(), of.material, of.dataset().id};
  }
  if (py::isinstance<Material>(value)) {
    out.material = value.cast<std::shared_ptr<Material>>();
    out.text = out.material->id;
    return out;
  }
  if (py::isinstance<py::str>(value)) {
    out.text = value.cast<std::string>();
    return out;
  }
  if (!py::hasattr(value, "__fspath__"))
    throw py::type_error("a name, a path, a Material or a Dataset is expected, not " +
                         printable(py::repr(value).cast<std::string>(), 200));
  out.text = text_of(value, "material");
  // A path is never taken for the name of a material.
  if (!out.text.starts_with('/') && !out.text.starts_with('.')) out.text = "./" + out.text;
  return out;
}

std::vector<AskedMaterial> asked_materials(const std::vector<py::object>& values,
                                           const std::string& dataset) {
  std::vector<AskedMaterial> out;
  for (const py::object& each : values) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    out.push_back(asked_material(each, dataset));
  }
  return out;
}

MaterialInput find_one(const AskedMaterial& asked, const Library& library) {
  if (asked.material) {
    MaterialInput out;
    out.kind = MaterialInput::Kind::material;
    out.path = asked.text;
    out.material = asked.material;
    out.dataset = asked.dataset;
    return out;
  }
  InputNames names;
  names.names = {asked.text};
  names.dataset = asked.dataset;
  std::vector<MaterialInput> found = find_inputs(names, library.when_asked(), 1);
  if (found.size() != 1)
    throw Error::at(printable(asked.text), "stands for " + std::to_string(found.size()) + " of them",
                    "one material, dataset or file");
  if (found[0].kind == MaterialInput::Kind::failed) throw Error(found[0].path);
  return std::move(found[0]);
}

DatasetOf read_one(const AskedMaterial& asked, const Library& library, const TableSettings& tables) {
  const MaterialInput input = find_one(asked, library);
  DatasetOf out;
  out.material = input.material
                     ? input.material
                     : std::make_shared<const Material>(read_material(input, table_options(tables)));
  const Dataset& chosen = dataset_named(*out.material, input.dataset, input.label());
  out.index = static_cast<std::size_t>(&chosen - out.material->datasets.data());
  return out;
}

}  // namespace etak::python
