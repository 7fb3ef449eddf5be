// SPDX-License-Identifier: Apache-2.0
#include "core/material/json.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json/json_text.h"
#include "core/base/json/node_json.h"
#include "core/base/number.h"
#include "core/material/dispersion.h"
#include "core/material/limits.h"
#include "core/material/material_node_json.h"
#include "core/material/optics/medium.h"
#include "core/material/optics/optics_class.h"
#include "core/material/stack_text.h"

namespace etak {
namespace {

using Node = JsonNode;

constexpr std::string_view schema_name = "etak-material/1";
constexpr int most_depth = 16;

bool is_made_of(std::string_view text, std::string_view characters) {
  return !text.empty() && text.find_first_not_of(characters) == text.npos;
}

double read_scale(const Node& node) {
  const std::string unit = node.text();
  if (unit == "nm") return 1;
  if (unit == "um") return 1000;
  node.fail("unit " + in_quotes(unit), "\"nm\" or \"um\"");
}

// Column `column` of rows as a spectrum over column 0; every value within [lo, hi].
Spectrum read_column(const Node& rows, std::size_t columns, std::size_t column, double scale, double lo,
                     double hi) {
  rows.expect_array();
  if (rows.value.empty()) rows.fail("no rows", "at least one");
  Spectrum out;
  out.wavelength_nm.reserve(rows.value.size());
  out.value.reserve(rows.value.size());
  for (std::size_t i = 0; i < rows.value.size(); ++i) {
    const Json& row = rows.value[i];
    if (!row.is_array() || row.size() != columns || !row[0].is_number() || !row[column].is_number())
      rows.at(i).fail_type("an array of " + std::to_string(columns) + " numbers");
    const double nm = row[0].get<double>() * scale, value = row[column].get<double>();
    if (!(nm > 0) || !std::isfinite(nm)) rows.at(i).fail_type("a wavelength above 0 first");
    if (!out.empty() && nm <= out.last_nm()) rows.at(i).fail_type("ascending wavelengths");
    if (!(value >= lo && value <= hi))
      rows.at(i).fail("value " + etak::number(value, 9),
                      "at least " + etak::number(lo, 3) + ", at most " + etak::number(hi, 3));
    out.wavelength_nm.push_back(nm);
    out.value.push_back(value);
  }
  return out;
}

Optics read_optics(const Node& node) {
  const double scale = read_scale(node.at("unit"));
  const std::string quantity = node.at("quantity").text();
  const Node range = node.at("valid_range");
  range.expect_array();
  if (range.value.size() != 2) range.fail_type("two numbers");
  const double first_nm = range.at(0).number() * scale, last_nm = range.at(1).number() * scale;

  const auto check_range = [&](const Spectrum& s) {
    if (s.first_nm() != first_nm || s.last_nm() != last_nm)
      range.fail_type("the first and last wavelength of the rows");
  };
  const auto read_k = [&](OpticalConstants& optics) {
    if (node.has("k_rows")) optics.k = read_column(node.at("k_rows"), 2, 1, scale, 0, most_k);
  };

  if (node.has("formula")) {
    const Node formula = node.at("formula");
    formula.expect_object({"number", "coefficients"});
    for (const char* key : {"columns", "rows"})
      if (node.has(key)) node.at(key).fail("rows beside a formula", "one of them");
    DispersionFormula f;
    f.number = formula.at("number").integer();
    f.coefficients = formula.at("coefficients").each(&Node::number);
    f.first_nm = first_nm;
    f.last_nm = last_nm;
    validate(f, std::string(node.file) + "#" + formula.pointer);
    OpticalConstants optics{std::move(f), {}};
    read_k(optics);
    if (quantity != (optics.k ? "n,k" : "n")) node.at("quantity").fail_type(optics.k ? "\"n,k\"" : "\"n\"");
    return optics;
  }

  const std::vector<std::string> columns = node.at("columns").texts();
  const Node rows = node.at("rows");
  using Columns = std::vector<std::string>;
  if (columns == Columns{"wavelength", "reflectance"} && quantity == "reflectance") {
    if (node.has("k_rows")) node.at("k_rows").fail("k beside reflectance");
    Reflectance out{read_column(rows, 2, 1, scale, 0, 1)};
    check_range(out.spectrum);
    return out;
  }
  OpticalConstants optics;
  if (columns == Columns{"wavelength", "n", "k"} && quantity == "n,k") {
    if (node.has("k_rows")) node.at("k_rows").fail("k twice", "a k column or k_rows");
    optics.n = read_column(rows, 3, 1, scale, 0, most_n);
    optics.k = read_column(rows, 3, 2, scale, 0, most_k);
  } else if (columns == Columns{"wavelength", "n"} && quantity == (node.has("k_rows") ? "n,k" : "n")) {
    optics.n = read_column(rows, 2, 1, scale, 0, most_n);
    read_k(optics);
  } else {
    node.at("columns").fail_type("wavelength first, then what \"quantity\" says");
  }
  check_range(std::get<Spectrum>(optics.n));
  if (const auto nm = no_medium_at(optics))
    rows.fail("n = 0 with k = 0 at " + etak::number(*nm, 9) + " nm", "n above 0, or k above 0");
  return optics;
}

// A stack by its text, whose names are looked up later.
Optics read_stack(const Node& node) {
  if (node.at("quantity").text() != "stack") node.at("quantity").fail_type("\"stack\"");
  for (const char* key : {"unit", "valid_range", "formula", "columns", "rows", "k_rows"})
    if (node.has(key)) node.at(key).fail("data beside a stack, whose media have theirs");
  const Node text = node.at("stack");
  (void)parse_stack(text.text(), std::string(node.file) + "#" + text.pointer);
  return Stack{text.text(), {}, {}, 0};
}

Citation read_citation(const Node& node) {
  node.expect_object({"authors", "title", "published_in", "year", "doi", "url", "licence", "via"});
  Citation c;
  c.authors = node.at("authors").texts();
  c.title = node.at("title").text();
  c.published_in = node.at("published_in").text();
  if (node.has("year")) c.year = node.at("year").integer();
  c.doi = node.text_or_empty("doi");
  c.url = node.text_or_empty("url");
  c.licence = node.at("licence").text();
  c.via = node.at("via").text();
  return c;
}

Dataset read_dataset(const Node& node) {
  node.expect_object({"id", "quantity", "origin", "sample", "temperature_kelvin", "axis", "citation", "flags",
                      "note", "doubtful", "stack", "unit", "valid_range", "formula", "columns", "rows",
                      "k_rows"});
  Dataset d;
  d.id = node.at("id").text();
  // The id of a stack may be that of its media's datasets, with '+' between.
  const bool stack = node.has("stack");
  if (!is_made_of(
          d.id, stack ? "abcdefghijklmnopqrstuvwxyz0123456789-.+" : "abcdefghijklmnopqrstuvwxyz0123456789-."))
    node.at("id").fail_type("a-z, 0-9, - and . only");
  if (node.has("origin"))
    d.origin = node.at("origin").word(origin_named, "measured, fit, computed or unknown");
  d.sample = node.at("sample").text();
  if (node.has("temperature_kelvin")) d.temperature_kelvin = node.at("temperature_kelvin").number();
  d.axis = node.text_or_empty("axis");
  d.citation = read_citation(node.at("citation"));
  if (node.has("flags"))
    for (const std::string& text : node.at("flags").texts()) {
      const auto flag = flag_named(text);
      if (!flag) node.at("flags").fail("flag " + in_quotes(text), "a known flag");
      d.flags.set(*flag);
    }
  d.note = node.text_or_empty("note");
  if (node.has("doubtful")) {
    d.doubtful = node.at("doubtful").text();
    if (d.doubtful.empty()) node.at("doubtful").fail_type("the reason, or no \"doubtful\" at all");
  }
  d.optics = stack ? read_stack(node) : read_optics(node);
  return d;
}

using Members = std::vector<JsonMember>;

std::string rows_json(const std::vector<const Spectrum*>& columns, bool micrometres) {
  const Spectrum& first = *columns.front();
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < first.size(); ++i) {
    std::vector<double> row{micrometres ? *in_micrometres(first.wavelength_nm[i]) : first.wavelength_nm[i]};
    for (const Spectrum* column : columns) row.push_back(column->value[i]);
    rows.push_back(json_array_of(row));
  }
  return json_lines(rows, 6);
}

// All wavelengths of the optics: rows, k rows, range of a formula.
std::vector<double> wavelengths_of(const Optics& optics) {
  if (const auto* reflectance = std::get_if<Reflectance>(&optics)) return reflectance->spectrum.wavelength_nm;
  const auto& constants = std::get<OpticalConstants>(optics);
  std::vector<double> all;
  if (const auto* formula = std::get_if<DispersionFormula>(&constants.n))
    all = {formula->first_nm, formula->last_nm};
  else
    all = std::get<Spectrum>(constants.n).wavelength_nm;
  if (constants.k)
    all.insert(all.end(), constants.k->wavelength_nm.begin(), constants.k->wavelength_nm.end());
  return all;
}

void add_optics(Members& out, const Optics& optics) {
  if (const auto* stack = std::get_if<Stack>(&optics)) return out.push_back({"stack", json(stack->text)});
  // Micrometres as databases print them where they have few digits, else nanometres.
  const bool micrometres = in_micrometres(wavelengths_of(optics)).has_value();
  const auto add_columns = [&](double first, double last, std::initializer_list<std::string_view> columns) {
    const auto shown = [&](double nm) { return json(micrometres ? *in_micrometres(nm) : nm); };
    out.push_back({"unit", json(micrometres ? "um" : "nm")});
    out.push_back({"valid_range", "[" + shown(first) + ", " + shown(last) + "]"});
    if (columns.size() > 0) out.push_back({"columns", json_array_of(columns)});
  };
  if (const auto* reflectance = std::get_if<Reflectance>(&optics)) {
    const Spectrum& spectrum = reflectance->spectrum;
    add_columns(spectrum.first_nm(), spectrum.last_nm(), {"wavelength", "reflectance"});
    out.push_back({"rows", rows_json({&spectrum}, micrometres)});
    return;
  }
  const auto& constants = std::get<OpticalConstants>(optics);
  const Spectrum* const k = constants.k ? &*constants.k : nullptr;
  if (const auto* formula = std::get_if<DispersionFormula>(&constants.n)) {
    add_columns(formula->first_nm, formula->last_nm, {});
    out.push_back({"formula", json_object({{"number", std::to_string(formula->number)},
                                           {"coefficients", json_array_of(formula->coefficients)}},
                                          -1)});
  } else {
    const auto& n = std::get<Spectrum>(constants.n);
    if (k != nullptr && k->wavelength_nm == n.wavelength_nm) {
      add_columns(n.first_nm(), n.last_nm(), {"wavelength", "n", "k"});
      out.push_back({"rows", rows_json({&n, k}, micrometres)});
      return;
    }
    add_columns(n.first_nm(), n.last_nm(), {"wavelength", "n"});
    out.push_back({"rows", rows_json({&n}, micrometres)});
  }
  if (k != nullptr) out.push_back({"k_rows", rows_json({k}, micrometres)});
}

std::string citation_json(const Citation& c) {
  Members out{{"authors", json_array_of(c.authors)},
              {"title", json(c.title)},
              {"published_in", json(c.published_in)}};
  if (c.year != 0) out.push_back({"year", std::to_string(c.year)});
  if (!c.doi.empty()) out.push_back({"doi", json(c.doi)});
  if (!c.url.empty()) out.push_back({"url", json(c.url)});
  out.push_back({"licence", json(c.licence)});
  out.push_back({"via", json(c.via)});
  return json_object(out, 6);
}

std::string dataset_json(const Dataset& d) {
  const auto* constants = std::get_if<OpticalConstants>(&d.optics);
  const bool stack = std::holds_alternative<Stack>(d.optics);
  Members out{{"id", json(d.id)},
              {"quantity", json(constants ? constants->k ? "n,k" : "n"
                                : stack   ? "stack"
                                          : "reflectance")},
              {"origin", json(name(d.origin))},
              {"sample", json(d.sample)}};
  if (d.temperature_kelvin) out.push_back({"temperature_kelvin", json(*d.temperature_kelvin)});
  if (!d.axis.empty()) out.push_back({"axis", json(d.axis)});
  out.push_back({"citation", citation_json(d.citation)});
  if (!d.flags.none()) {
    std::vector<std::string> flags;
    d.flags.for_each([&](Flag flag) { flags.push_back(json(name(flag))); });
    out.push_back({"flags", json_array(flags)});
  }
  if (!d.note.empty()) out.push_back({"note", json(d.note)});
  if (!d.doubtful.empty()) out.push_back({"doubtful", json(d.doubtful)});
  add_optics(out, d.optics);
  return json_object(out, 4);
}

// Notes by a name of the material, or by the id of a dataset where `datasets` says so.
std::vector<AliasNote> read_alias_notes(const Node& node, const Material& m, bool datasets) {
  node.expect_object();
  std::vector<AliasNote> out;
  for (const auto& [alias, ignored] : node.value.items()) {
    if (alias != m.id && alias != m.name &&
        std::find(m.aliases.begin(), m.aliases.end(), alias) == m.aliases.end() &&
        !(datasets && m.dataset(alias)))
      node.fail("a note on " + in_quotes(alias), std::string("the id, the name or an alias of the material") +
                                                     (datasets ? ", or the id of a dataset" : ""));
    const std::string note = node.at(alias).text();
    if (note.empty()) node.at(alias).fail_type("a sentence");
    out.push_back({alias, note});
  }
  return out;
}

}  // namespace

Material parse_material(std::string_view text, std::string_view file) {
  const JsonDocument document = parse_json_strictly(text, file, most_depth, "a material file");
  const Node root{document, file, ""};
  // The output of `etak show --format json` holds the material of a file as one member.
  const bool shown = root.value.is_object() && root.has("schema") && root.value["schema"] == "etak-show/1";
  return read_material(shown ? root.at("material") : root);
}

Material read_material(const Node& node) {
  if (node.value.is_object() && !node.has("schema"))
    node.fail("is no etak material: it has no field \"schema\"",
              "\"" + std::string(schema_name) + "\" in it");
  node.expect_object({"schema", "id", "name", "aliases", "alias_notes", "bodies", "class", "group", "common",
                      "preferred", "preferred_reason", "datasets"});
  if (node.at("schema").text() != schema_name)
    node.at("schema").fail_type("\"" + std::string(schema_name) + "\"");

  Material m;
  m.id = node.at("id").text();
  if (!is_made_of(m.id, "abcdefghijklmnopqrstuvwxyz0123456789_"))
    node.at("id").fail_type("a-z, 0-9 and _ only");
  m.name = node.at("name").text();
  if (m.name.empty()) node.at("name").fail_type("a name");
  if (m.name.size() > most_name_bytes)
    node.at("name").fail("a name of " + std::to_string(m.name.size()) + " bytes",
                         "at most " + std::to_string(most_name_bytes));
  m.aliases = node.at("aliases").texts();
  const bool stated = node.has("class");
  if (stated) m.material_class = node.at("class").text();
  if (stated && !is_class(m.material_class)) node.at("class").fail_type("a known class");
  if (node.has("alias_notes")) m.alias_notes = read_alias_notes(node.at("alias_notes"), m, false);
  m.group = node.text_or_empty("group");
  if (node.has("group") && !is_made_of(m.group, "abcdefghijklmnopqrstuvwxyz"))
    node.at("group").fail_type("a word of a-z");
  m.common = node.has("common") && node.at("common").boolean();
  const Node datasets = node.at("datasets");
  datasets.expect_array();
  if (datasets.value.empty()) datasets.fail("no datasets", "at least one");
  for (std::size_t i = 0; i < datasets.value.size(); ++i) {
    Dataset d = read_dataset(datasets.at(i));
    if (m.dataset(d.id)) datasets.at(i).fail("dataset \"" + d.id + "\" twice", "each id once");
    m.datasets.push_back(std::move(d));
  }
  const std::string preferred = node.at("preferred").text();
  const Dataset* chosen = m.dataset(preferred);
  if (!chosen) node.at("preferred").fail_type("the id of a dataset");
  m.preferred = static_cast<std::size_t>(chosen - m.datasets.data());
  m.preferred_reason = node.at("preferred_reason").text();
  if (node.has("bodies")) m.bodies = read_alias_notes(node.at("bodies"), m, true);
  if (!stated) decide_class(m);
  return m;
}

std::string format_material(const Material& m) {
  Members out{{"schema", json(schema_name)},
              {"id", json(m.id)},
              {"name", json(m.name)},
              {"aliases", json_array_of(m.aliases)}};
  const auto add_notes = [&](const char* key, const std::vector<AliasNote>& all) {
    Members notes;
    for (const AliasNote& each : all) notes.push_back({each.alias, json(each.note)});
    if (!all.empty()) out.push_back({key, json_object(notes, 2)});
  };
  add_notes("alias_notes", m.alias_notes);
  add_notes("bodies", m.bodies);
  if (m.class_by == ClassBy::stated) out.push_back({"class", json(m.material_class)});
  if (!m.group.empty()) out.push_back({"group", json(m.group)});
  if (m.common) out.push_back({"common", json(true)});
  out.push_back({"preferred", json(m.preferred_dataset().id)});
  out.push_back({"preferred_reason", json(m.preferred_reason)});
  out.push_back({"datasets", json_lines_of(m.datasets, 2, dataset_json)});
  return json_object(out, 0) + '\n';
}

}  // namespace etak
