// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/material_evidence.h"

#include <algorithm>
#include <cmath>

#include "core/base/files/input.h"
#include "core/base/json/node_json.h"
#include "core/exchange/content_kind.h"
#include "core/exchange/material_file.h"
#include "core/exchange/rii/rii_page.h"
#include "core/exchange/table.h"
#include "core/material/dispersion.h"
#include "core/material/f0.h"
#include "core/material/json.h"
#include "core/material/material_node_json.h"

namespace etak {

namespace {

std::string text_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

std::string dataset_pointer(std::size_t index) {
  return "/datasets/" + std::to_string(index);
}

// Reads rows by the names of their columns. Values that are no numbers are left out; ETK611 has reported
// them.
void read_rows(const Json& dataset, SpectralRows& rows) {
  const double scale = text_at(dataset, "unit") == "um" ? 1000 : 1;
  std::vector<std::string> columns;
  if (const auto found = dataset.find("columns"); found != dataset.end() && found->is_array())
    for (const Json& column : *found) columns.push_back(column.is_string() ? column.get<std::string>() : "");
  const auto table = dataset.find("rows");
  if (table == dataset.end() || !table->is_array()) return;
  for (const Json& row : *table) {
    if (!row.is_array() || row.size() < columns.size()) continue;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (!row[c].is_number()) continue;
      const double value = row[c].get<double>();
      if (columns[c] == "wavelength") rows.wavelength_nm.push_back(value * scale);
      if (columns[c] == "n") rows.n.push_back(value);
      if (columns[c] == "k") rows.k.push_back(value);
      if (columns[c] == "reflectance") rows.reflectance.push_back(value);
    }
  }
}

SpectralRows rows_of(const Json& dataset, std::size_t index, const std::string& preferred) {
  SpectralRows rows;
  rows.pointer = dataset_pointer(index);
  if (!dataset.is_object()) return rows;
  rows.id = text_at(dataset, "id");
  rows.preferred = preferred.empty() ? index == 0 : rows.id == preferred;
  rows.sample = text_at(dataset, "sample");
  rows.flagged = dataset.contains("flags") && !dataset["flags"].empty();
  rows.is_formula = dataset.contains("formula");
  if (const auto range = dataset.find("valid_range"); range != dataset.end() && range->is_array() &&
                                                      range->size() == 2 && (*range)[0].is_number() &&
                                                      (*range)[1].is_number()) {
    const double scale = text_at(dataset, "unit") == "um" ? 1000 : 1;
    rows.first_nm = (*range)[0].get<double>() * scale;
    rows.last_nm = (*range)[1].get<double>() * scale;
  }
  if (const auto citation = dataset.find("citation"); citation != dataset.end() && citation->is_object()) {
    rows.doi = text_at(*citation, "doi");
    rows.url = text_at(*citation, "url");
    rows.via = text_at(*citation, "via");
    rows.licence = text_at(*citation, "licence");
  }
  if (!rows.is_formula) read_rows(dataset, rows);
  return rows;
}

template <class Value>
std::optional<std::array<Value, 3>> triple(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array() || found->size() != 3) return std::nullopt;
  std::array<Value, 3> out{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (!(*found)[c].is_number()) return std::nullopt;
    out[c] = (*found)[c].get<Value>();
  }
  return out;
}

// Reflectance at 550 nm, normal incidence.
std::optional<double> reflectance_at_550(const Optics& optics) {
  const double nm = 550;
  const auto value = [&](const Spectrum& spectrum) {
    double out = 0;
    resample(spectrum, Interpolation::linear, {&nm, 1}, {&out, 1});
    return out;
  };
  const auto inside = [&](const Spectrum& s) {
    return !s.empty() && s.first_nm() <= nm && s.last_nm() >= nm;
  };
  if (const auto* measured = std::get_if<Reflectance>(&optics))
    return inside(measured->spectrum) ? std::optional(value(measured->spectrum)) : std::nullopt;
  if (std::holds_alternative<Stack>(optics)) return std::nullopt;
  const auto& constants = std::get<OpticalConstants>(optics);
  double n = 1, k = 0;
  if (const auto* table = std::get_if<Spectrum>(&constants.n)) {
    if (!inside(*table)) return std::nullopt;
    n = value(*table);
  } else {
    evaluate(std::get<DispersionFormula>(constants.n), {&nm, 1}, {&n, 1});
  }
  if (constants.k && inside(*constants.k)) k = value(*constants.k);
  return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

void add_f0(MaterialEvidence& evidence, const F0Solver& solver, const Optics& optics, Flags flags) {
  const F0Result f0 = solver.solve(optics, flags);
  if (f0.refused()) return;
  evidence.computed_f0 = {f0.srgb_linear.r, f0.srgb_linear.g, f0.srgb_linear.b};
  evidence.computed_bytes = {f0.srgb8.r, f0.srgb8.g, f0.srgb8.b};
  evidence.luminance = f0.luminance;
}

const F0Solver& default_solver() {
  static const F0Solver solver{F0Options{}};
  return solver;
}

// The rows of a table, or the range of a formula.
void set_rows(SpectralRows& rows, const Optics& optics) {
  if (const auto* measured = std::get_if<Reflectance>(&optics)) {
    rows.wavelength_nm = measured->spectrum.wavelength_nm;
    rows.reflectance = measured->spectrum.value;
  } else if (const auto* constants = std::get_if<OpticalConstants>(&optics)) {
    if (const auto* table = std::get_if<Spectrum>(&constants->n)) {
      rows.wavelength_nm = table->wavelength_nm;
      rows.n = table->value;
      if (constants->k && constants->k->wavelength_nm == table->wavelength_nm) rows.k = constants->k->value;
    } else {
      const auto& formula = std::get<DispersionFormula>(constants->n);
      rows.is_formula = true;
      rows.first_nm = formula.first_nm;
      rows.last_nm = formula.last_nm;
    }
  }
}

void add_optics(MaterialEvidence& evidence, const Optics& optics, Flags flags, const std::string& id) {
  SpectralRows& rows = evidence.datasets.emplace_back();
  rows.id = id;
  rows.preferred = true;
  rows.contradicts = flags.has(Flag::duplicate_wavelength);
  set_rows(rows, optics);
  add_f0(evidence, default_solver(), optics, flags);
}

// Adds a dataset, and its reflectance at 550 nm where no flag makes it doubtful.
void add_dataset(MaterialEvidence& evidence, const Dataset& dataset, bool preferred) {
  SpectralRows rows;
  rows.pointer = dataset_pointer(evidence.datasets.size());
  rows.id = dataset.id;
  rows.preferred = preferred;
  rows.flagged = !dataset.flags.none();
  rows.doi = dataset.citation.doi;
  rows.url = dataset.citation.url;
  rows.via = dataset.citation.via;
  rows.licence = dataset.citation.licence;
  rows.sample = dataset.sample;
  set_rows(rows, dataset.optics);
  evidence.datasets.push_back(std::move(rows));
  if (!dataset.flags.none()) return;
  if (const auto r = reflectance_at_550(dataset.optics)) evidence.at_550.emplace_back(dataset.id, *r);
}

void note_refusal(MaterialEvidence& evidence, const Error& error) {
  evidence.schema_error = error.what();
  const std::size_t hash = evidence.schema_error.find('#'), end = evidence.schema_error.find(": ");
  if (hash != std::string::npos && end != std::string::npos && hash < end)
    evidence.schema_pointer = evidence.schema_error.substr(hash + 1, end - hash - 1);
}

JsonDocument without(JsonDocument object, const char* key) {
  Json value = std::move(object).take();
  value.erase(key);
  return JsonDocument(std::move(value));
}

// The numbers of a file that the strict reader refuses.
MaterialEvidence lenient_evidence(const Json& document) {
  MaterialEvidence out;
  out.name = text_at(document, "name");
  if (const auto datasets = document.find("datasets"); datasets != document.end() && datasets->is_array())
    for (std::size_t i = 0; i < datasets->size(); ++i)
      out.datasets.push_back(rows_of((*datasets)[i], i, text_at(document, "preferred")));
  return out;
}

}  // namespace

MaterialEvidence evidence_of_material(const Material& material) {
  MaterialEvidence out;
  out.name = material.name;
  if (material.class_by != ClassBy::nobody) out.material_class = material.material_class;
  for (std::size_t i = 0; i < material.datasets.size(); ++i)
    add_dataset(out, material.datasets[i], i == material.preferred);
  const Dataset& preferred = material.preferred_dataset();
  add_f0(out, default_solver(), preferred.optics, preferred.flags);
  return out;
}

MaterialEvidence evidence_of_material(std::string_view text, const std::string& label) {
  MaterialEvidence refused;
  try {
    return evidence_of_material(parse_material(text, label));
  } catch (const Error& error) {
    note_refusal(refused, error);
  }
  std::optional<JsonDocument> read;
  try {
    read.emplace(parse_json_strictly(text, label, 32, "a material file"));
  } catch (const Error&) {
    return refused;  // which has the message of the strict reader
  }
  const Json& document = **read;
  if (!document.is_object()) return refused;
  MaterialEvidence out = lenient_evidence(document);
  out.schema_error = refused.schema_error;
  out.schema_pointer = refused.schema_pointer;
  const auto f0 = document.find("f0");
  if (f0 == document.end() || !f0->is_object()) return out;
  const auto linear = triple<double>(*f0, "linear");
  const auto bytes = triple<int>(*f0, "srgb8");
  // The strict reader refuses a file with a stored F0 for that key. The file is read again without it, so
  // that the rest is judged all the same.
  const JsonDocument rest = without(std::move(*read), "f0");
  try {
    out = evidence_of_material(read_material(JsonNode{rest, label, ""}));
  } catch (const Error& error) {
    note_refusal(out, error);
  }
  out.stored_f0 = linear;
  out.stored_bytes = bytes;
  return out;
}

MaterialEvidence evidence_of_spectrum(std::string_view text, const std::string& path,
                                      const std::string& label) {
  MaterialEvidence evidence;
  evidence.is_material_file = false;
  const bool page = material_file_kind(path) == MaterialFileKind::page ||
                    (is_pipe_input(path) && content_kind(text) == ContentKind::page);
  if (page) {
    RiiPage content;
    parse_rii_page(text, label, content);
    if (content.kind != PageKind::constants)
      throw Error::at(label, "no optical constants", "a page with n or n and k");
    if (!content.refusal.empty()) throw Error::at(label, content.refusal);
    add_optics(evidence, content.optics, content.flags, "page");
  } else {
    TableOptions options;
    options.duplicates = Duplicates::mean;
    const Table table = parse_table(text, label, options);
    add_optics(evidence, table.optics, table.flags, "table");
  }
  return evidence;
}

}  // namespace etak
