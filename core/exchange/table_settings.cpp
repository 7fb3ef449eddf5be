// SPDX-License-Identifier: Apache-2.0
// What a user says of tables and of their materials, as options.
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/base/text/edit_distance.h"
#include "core/base/text/text.h"
#include "core/exchange/table.h"

namespace etak {

TableOptions table_options(const TableSettings& settings) {
  TableOptions out;
  if (!settings.unit.empty())
    out.unit = setting_value("unit", settings.unit, WavelengthUnit::nanometre, wavelength_unit_named,
                             "nm, um, A or eV");
  out.columns = parts_of(settings.columns, ',');
  const auto duplicates = [](const std::string& text) -> std::optional<Duplicates> {
    if (text == "refuse") return Duplicates::refuse;
    if (text == "first") return Duplicates::first;
    if (text == "mean") return Duplicates::mean;
    return std::nullopt;
  };
  out.duplicates =
      setting_value("duplicates", settings.duplicates, out.duplicates, duplicates, "refuse, first or mean");
  if (!settings.material_class.empty() && !is_class(settings.material_class))
    throw Error::at(
        setting("material-class"), printable(settings.material_class),
        joined(material_classes) +
            did_you_mean(settings.material_class, {material_classes.begin(), material_classes.end()}));
  out.material_class = settings.material_class;
  if (!settings.origin.empty())
    out.origin = setting_value("origin", settings.origin, Origin::unknown, origin_named,
                               "measured, fit, computed or unknown");
  return out;
}

void state(Material& material, const TableOptions& options) {
  if (!options.material_class.empty()) {
    material.material_class = options.material_class;
    material.class_by = ClassBy::stated;
  }
  if (options.origin)
    for (Dataset& dataset : material.datasets) dataset.origin = *options.origin;
}

}  // namespace etak
