// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/project_check.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/color/luminance.h"
#include "core/judge/check_pictures.h"
#include "core/judge/engine.h"
#include "core/judge/nearest.h"
#include "core/judge/rules.h"
#include "core/material/appearance.h"
#include "core/material/names.h"
#include "core/validate/files/check.h"
#include "core/validate/files/check_maps.h"
#include "core/validate/files/material_evidence.h"

namespace etak {
namespace {

void add(CheckedFile& to, CheckedFile from) {
  for (Finding& each : from.findings) to.findings.push_back(std::move(each));
  to.unreadable = to.unreadable || from.unreadable;
}

// Whether the black diffuse colour of a dielectric is right, because light goes through its body.
bool black_is_right(const ProjectMaterial& material, const MaterialLibrary& library) {
  if (!material.measured) return false;
  const auto record = library.find(material.measured->material);
  return record && is_clear_body(*record, dataset_named(*record, material.measured->dataset, record->id),
                                 material.diffuse);
}

// Whether the F0 of a material is that of its record: not of a texture, nor beside a measured body.
bool takes_measured_f0(const ProjectMaterial& material, const MaterialLibrary& library) {
  if (!material.measured || gives(material, Channel::specular)) return false;
  const auto record = library.find(material.measured->material);
  return record && gives_f0(record->material_class);
}

// "; it is measured: this dataset (jones) lies in the zone; titanium's others at 0.59 (smith), 0.57 (brown)".
std::string measured_text(const MeasuredF0& measured, const MaterialLibrary& library,
                          const KnownMaterials& known) {
  const auto record = library.find(measured.material);
  if (!record) return {};
  const std::string own = dataset_named(*record, measured.dataset, record->id).id;
  // An imported record may be of a material that the library has as well: "Ti, Palm 2018" of "Ti".
  const std::string of = record->name.substr(0, record->name.find(','));
  NamedDataset out{of, own, 0, {}};
  for (const Dataset& each : record->datasets) {
    MeasuredF0 other = measured;
    other.dataset = each.id;
    if (each.id == own) continue;
    try {
      out.others.emplace_back(each.id, luminance_of(vec(find_f0(other, library).result.srgb_linear)));
    } catch (const Error&) {
      continue;  // its data give no F0
    }
  }
  for (const KnownF0* each : known.f0_of(of))
    if (each->id != record->id) out.others.emplace_back(each->id + '/' + each->dataset, each->luminance);
  return "; it is measured: " + dataset_in_zone(out);
}

CheckedFile check_texels(const ProjectMaterial& material, const MaterialCheck& by) {
  const auto& [library, door, settings, most_texels, threads, kept] = by;
  CheckTarget target;
  target.label = material.name;
  target.files = {{FileRole::diffuse_alpha, "", material.name + " (diffuse, alpha)", false},
                  {FileRole::specular_gloss, "", material.name + " (specular, gloss)", false}};
  // etak itself has encoded the codes as sRGB, and a material without textures is meant to be constant.
  Settings own = settings;
  own.transfer_stated = true;
  if (!has_packed_textures(material)) {
    for (const char* rule : {"ETK301", "ETK503"}) own.rules[rule].severity = Severity::off;
    target.manifest.transparent = material.alpha_mode == AlphaMode::blend;
  }
  if (material.measured) target.manifest.material = material.measured->material;
  target.manifest.layers = text_of_layers(material, library);
  // In the mode opaque nothing reads the alpha, constant or not.
  const bool opaque = material.alpha_mode == AlphaMode::opaque;
  if (opaque) own.rules["ETK503"].severity = Severity::off;
  if (!has_packed_textures(material) && black_is_right(material, library))
    own.rules["ETK202"].severity = Severity::off;
  const bool measured_f0 = takes_measured_f0(material, library);
  const Rule& zone = *find_rule("ETK101");
  if (measured_f0 && severity_of(zone, settings) > Severity::info)
    own.rules["ETK101"].severity = Severity::info;
  CheckedFile out;
  const auto look = [&](MaterialPair& pair) {
    if (opaque || !has_packed_textures(material)) {
      // A constant alpha hides no texel: the surface reflects by its F0 even where the body is transparent.
      std::vector<std::uint8_t>& texels = pair.diffuse_alpha.values;
      for (std::size_t i = 3; i < texels.size(); i += 4) texels[i] = 255;
    }
    const auto open = [&](Needs) {
      return PictureRows{rows_of(pair.diffuse_alpha), rows_of(pair.specular_gloss), nullptr};
    };
    out = check_rows(target, open, own, by.threads);
  };
  if (kept != nullptr && has_packed_textures(material)) {
    kept->use(material, library, door, most_texels, look);
  } else {
    MaterialPair pair = pictures_of(material, library, door, most_texels);
    look(pair);
  }
  for (Finding& each : out.findings)
    if (measured_f0 && each.rule == zone.id)
      each.message += measured_text(*material.measured, library, known_materials(settings));
  return out;
}

// Checks the normal map against the convention that the material says.
CheckedFile check_normals(const ProjectMaterial& material, const ImageSource& map, const MaterialCheck& by) {
  CheckTarget target;
  target.label = material.name;
  target.files = {{FileRole::normal, map.path, material.name + " (normal)", false}};
  return check_by(target, by.settings, [&](const Settings&, Evidence& evidence, CheckedFile&) {
    const auto read = [&] { return maps_of(target, by.door).front(); };
    MapEvidence& normals =
        evidence.maps.emplace_back(by.kept != nullptr ? by.kept->normals(material, read) : read());
    normals.label = target.files.front().label;
    normals.green = material.green_down ? GreenAxis::directx : GreenAxis::opengl;
    normals.said_by = "the material";
  });
}

// The record of a measured material, with the dataset that the material uses as the preferred one.
Material used_record(const MeasuredF0& measured, const MaterialLibrary& library) {
  auto record = library.find(measured.material);
  if (!record) throw Error::at(measured.material, "is no material of the library or the project");
  const Dataset& used = dataset_named(*record, measured.dataset, record->id);
  record->preferred = static_cast<std::size_t>(&used - record->datasets.data());
  return std::move(*record);
}

// Checks the record of a measured material. Findings about other datasets than the one in use are left out.
//   layers   of the F0 that the material takes from it
CheckedFile check_record(const MeasuredF0& measured, const MaterialLibrary& library,
                         const std::string& layers, const Settings& settings) {
  const Material record = used_record(measured, library);
  const std::string& label = measured.material;
  CheckTarget target;
  target.label = label;
  target.manifest.layers = layers;
  target.files = {{FileRole::material, "", label, false}};
  CheckedFile file = checked_file_of(target);
  const std::string own = "/datasets/" + std::to_string(record.preferred);
  Evidence evidence;
  evidence.material = evidence_of_material(record);
  judge(target, evidence, settings, file);
  std::erase_if(file.findings, [&](const Finding& each) {
    return each.pointer.starts_with("/datasets/") && each.pointer != own &&
           !each.pointer.starts_with(own + "/");
  });
  return file;
}

}  // namespace

CheckedFile check_material(const ProjectMaterial& material, const MaterialCheck& by) {
  CheckedFile out;
  out.path = material.name;
  const auto fail = [&](const Rule& rule, Severity severity, const std::string& message) {
    out.findings.push_back(finding_of(rule, severity, "", message));
    out.unreadable = true;
  };
  const auto part = [&](auto check) {
    try {
      add(out, check());
    } catch (const Error& error) {
      fail(rule_of_unreadable(error.what()), Severity::error, error.what());
    } catch (const std::bad_alloc&) {
      fail(*find_rule("ETK902"), Severity::warning, "not enough memory to check the pictures");
    }
  };
  part([&] { return check_texels(material, by); });
  if (const auto& map = material.texture(Channel::normal))
    part([&] { return check_normals(material, *map, by); });
  if (material.measured)
    part([&] {
      return check_record(*material.measured, by.library, text_of_layers(material, by.library), by.settings);
    });
  for (Finding& each : out.findings) each.material = material.name;
  return out;
}

std::optional<Channel> field_of(std::string_view rule) {
  if (!rule.starts_with("ETK") || rule.size() < 4) return std::nullopt;
  // Rules about F0 and transfer curves that speak of the diffuse colour.
  if (rule == "ETK108" || rule == "ETK109" || rule == "ETK407") return Channel::diffuse;
  switch (rule[3]) {
    case '1':
    case '4':
      return Channel::specular;
    case '2':
      return Channel::diffuse;
    case '3':
      return Channel::gloss;
    case '5':
      return Channel::alpha;
    case '7':
      return Channel::normal;
    default:
      return std::nullopt;
  }
}

}  // namespace etak
