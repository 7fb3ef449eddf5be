// SPDX-License-Identifier: Apache-2.0
#include "core/material/embedded/blob.h"

#include <cassert>
#include <cstdint>
#include <cstring>

namespace etak {
namespace {

// One list of fields serves both directions: Archive is BlobWriter or BlobReader.
class BlobWriter {
 public:
  void number(std::size_t value) { bytes(&value, sizeof value); }
  void real(double value) { bytes(&value, sizeof value); }
  void text(const std::string& value) {
    number(value.size());
    bytes(value.data(), value.size());
  }
  void reals(const std::vector<double>& values) {
    number(values.size());
    bytes(values.data(), values.size() * sizeof(double));
  }
  void texts(const std::vector<std::string>& values) {
    number(values.size());
    for (const auto& value : values) text(value);
  }
  std::string out;

 private:
  void bytes(const void* data, std::size_t size) { out.append(static_cast<const char*>(data), size); }
};

class BlobReader {
 public:
  BlobReader(std::string_view blob, std::size_t offset) : rest_(blob.substr(offset)) {}
  std::size_t number() {
    std::size_t value = 0;
    bytes(&value, sizeof value);
    return value;
  }
  double real() {
    double value = 0;
    bytes(&value, sizeof value);
    return value;
  }
  std::string text() {
    std::string value(number(), '\0');
    bytes(value.data(), value.size());
    return value;
  }
  std::vector<double> reals() {
    std::vector<double> values(number());
    bytes(values.data(), values.size() * sizeof(double));
    return values;
  }
  std::vector<std::string> texts() {
    std::vector<std::string> values(number());
    for (auto& value : values) value = text();
    return values;
  }

 private:
  void bytes(void* data, std::size_t size) {
    assert(size <= rest_.size());
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_.remove_prefix(size);
  }
  std::string_view rest_;
};

void write(BlobWriter& w, const Spectrum& s) {
  w.reals(s.wavelength_nm);
  w.reals(s.value);
}

Spectrum read_spectrum(BlobReader& r) {
  Spectrum s;
  s.wavelength_nm = r.reals();
  s.value = r.reals();
  return s;
}

enum class Shape : std::size_t { reflectance, table, formula };

void write(BlobWriter& w, const Optics& optics) {
  if (const auto* reflectance = std::get_if<Reflectance>(&optics)) {
    w.number(static_cast<std::size_t>(Shape::reflectance));
    return write(w, reflectance->spectrum);
  }
  const auto& constants = std::get<OpticalConstants>(optics);
  if (const auto* formula = std::get_if<DispersionFormula>(&constants.n)) {
    w.number(static_cast<std::size_t>(Shape::formula));
    w.number(static_cast<std::size_t>(formula->number));
    w.reals(formula->coefficients);
    w.real(formula->first_nm);
    w.real(formula->last_nm);
  } else {
    w.number(static_cast<std::size_t>(Shape::table));
    write(w, std::get<Spectrum>(constants.n));
  }
  w.number(constants.k.has_value());
  if (constants.k) write(w, *constants.k);
}

Optics read_optics(BlobReader& r) {
  const auto shape = static_cast<Shape>(r.number());
  if (shape == Shape::reflectance) return Reflectance{read_spectrum(r)};
  OpticalConstants constants;
  if (shape == Shape::formula) {
    DispersionFormula formula;
    formula.number = static_cast<int>(r.number());
    formula.coefficients = r.reals();
    formula.first_nm = r.real();
    formula.last_nm = r.real();
    constants.n = std::move(formula);
  } else {
    constants.n = read_spectrum(r);
  }
  if (r.number() != 0) constants.k = read_spectrum(r);
  return constants;
}

void write(BlobWriter& w, const Citation& c) {
  w.texts(c.authors);
  w.text(c.title);
  w.text(c.published_in);
  w.number(static_cast<std::size_t>(c.year));
  for (const auto* field : {&c.doi, &c.url, &c.licence, &c.via}) w.text(*field);
}

Citation read_citation(BlobReader& r) {
  Citation c;
  c.authors = r.texts();
  c.title = r.text();
  c.published_in = r.text();
  c.year = static_cast<int>(r.number());
  for (auto* field : {&c.doi, &c.url, &c.licence, &c.via}) *field = r.text();
  return c;
}

void write(BlobWriter& w, const Dataset& d) {
  w.text(d.id);
  write(w, d.optics);
  w.number(static_cast<std::size_t>(d.origin));
  w.text(d.sample);
  w.number(d.temperature_kelvin.has_value());
  w.real(d.temperature_kelvin.value_or(0));
  w.text(d.axis);
  write(w, d.citation);
  w.number(d.flags.bits());
  w.text(d.note);
  w.text(d.doubtful);
}

Dataset read_dataset(BlobReader& r) {
  Dataset d;
  d.id = r.text();
  d.optics = read_optics(r);
  d.origin = static_cast<Origin>(r.number());
  d.sample = r.text();
  const bool has_temperature = r.number() != 0;
  const double kelvin = r.real();
  if (has_temperature) d.temperature_kelvin = kelvin;
  d.axis = r.text();
  d.citation = read_citation(r);
  d.flags = Flags::from_bits(static_cast<std::uint32_t>(r.number()));
  d.note = r.text();
  d.doubtful = r.text();
  return d;
}

}  // namespace

// Layout: size of the index, the index (count, then id, name, aliases, offset of each material; count, then
// words, reason, nearest of each thing without a measurement), the materials. Offsets count from the end of
// the index.
std::string encode_library(const std::vector<Material>& materials,
                           const std::vector<Unmeasured>& unmeasured) {
  BlobWriter index, body;
  index.number(materials.size());
  for (const Material& m : materials) {
    index.text(m.id);
    index.text(m.name);
    index.texts(m.aliases);
    index.number(body.out.size());
    body.number(m.alias_notes.size());
    for (const AliasNote& each : m.alias_notes) {
      body.text(each.alias);
      body.text(each.note);
    }
    body.text(m.material_class);
    body.text(m.group);
    body.number(m.common ? 1 : 0);
    body.number(m.preferred);
    body.text(m.preferred_reason);
    body.number(m.datasets.size());
    for (const Dataset& d : m.datasets) write(body, d);
  }
  index.number(unmeasured.size());
  for (const Unmeasured& each : unmeasured) {
    index.texts(each.words);
    index.text(each.why);
    index.texts(each.nearest);
  }
  BlobWriter whole;
  whole.text(index.out);
  return whole.out + body.out;
}

BlobIndex decode_index(std::string_view blob) {
  BlobReader size(blob, 0);
  const std::size_t body = sizeof(std::size_t) + size.number();
  BlobReader r(blob, sizeof(std::size_t));
  BlobIndex index;
  index.materials.resize(r.number());
  for (BlobEntry& e : index.materials) {
    e.id = r.text();
    e.name = r.text();
    e.aliases = r.texts();
    e.offset = body + r.number();
  }
  index.unmeasured.resize(r.number());
  for (Unmeasured& each : index.unmeasured) {
    each.words = r.texts();
    each.why = r.text();
    each.nearest = r.texts();
  }
  return index;
}

Material decode_material(std::string_view blob, std::size_t offset) {
  BlobReader r(blob, offset);
  Material m;
  m.alias_notes.resize(r.number());
  for (AliasNote& each : m.alias_notes) {
    each.alias = r.text();
    each.note = r.text();
  }
  m.material_class = r.text();
  m.group = r.text();
  m.common = r.number() != 0;
  m.preferred = r.number();
  m.preferred_reason = r.text();
  m.datasets.resize(r.number());
  for (Dataset& d : m.datasets) d = read_dataset(r);
  return m;
}

}  // namespace etak
