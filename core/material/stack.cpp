// SPDX-License-Identifier: Apache-2.0
#include "core/material/stack.h"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/material/appearance.h"
#include "core/material/limits.h"
#include "core/material/names.h"
#include "core/material/stack_text.h"

namespace etak {
namespace {

// The media of a stack, each once.
//   names   of the text, the outermost first and the base last; a medium of one name is one
//   of_layer, base   indices in names
struct Media {
  std::vector<std::string> names;
  std::vector<StackPart> parts;
  std::vector<std::size_t> of_layer;
  std::size_t base = 0;
};

void take_body(StackPart& part) {
  part.body = clear_body(part.found.material, part.found.chosen());
}

Media find_media(const StackText& text, std::string_view place, const FindStackPart& find) {
  Media out;
  const auto index_of = [&](const std::string& name, const std::string& where) {
    const auto known = std::find(out.names.begin(), out.names.end(), name);
    const auto index = static_cast<std::size_t>(known - out.names.begin());
    if (known != out.names.end()) return index;
    out.names.push_back(name);
    const FoundDataset& found = out.parts.emplace_back(find(name, where)).found;
    if (const Dataset& of = found.chosen(); !std::holds_alternative<OpticalConstants>(of.optics))
      throw Error::at(where,
                      found.material.id + "/" + of.id + " " + std::string(without_constants(of.optics)),
                      "a medium of n and k");
    return index;
  };
  for (std::size_t i = 0; i < text.layers.size(); ++i) {
    const std::string where = layer_place(place, i);
    if (!text.layers[i].thickness_nm)
      throw Error::at(where, text.layers[i].name + " has an unknown thickness", "a number in place of ?");
    out.of_layer.push_back(index_of(text.layers[i].name, where));
  }
  out.base = index_of(text.base, std::string(place) + " base");
  take_body(out.parts[out.base]);
  return out;
}

// Makes the optics of `made` the stack with these datasets of the media, adds what the importers found in them, and where it
// has no id makes one of theirs.
//   written   the text of the stack; empty: one that names every dataset
void open(const StackText& text, const Media& media, std::string written, Dataset& made) {
  Stack out;
  out.base = media.base;
  std::string id;
  for (const StackPart& part : media.parts) {
    const Dataset& dataset = part.found.chosen();
    out.media.push_back({part.found.material.id, dataset.id, dataset.citation,
                         std::get<OpticalConstants>(dataset.optics), part.body});
    append(id, id.empty() ? "" : "+", dataset.id);
    made.flags |= dataset.flags;
  }
  for (std::size_t i = 0; i < text.layers.size(); ++i) {
    const StackText::Layer& layer = text.layers[i];
    out.layers.push_back({media.of_layer[i], *layer.thickness_nm, layer.coherent});
    if (written.empty()) append(out.text, media.parts[media.of_layer[i]].written, layer.rest, '/');
  }
  out.text += written.empty() ? media.parts[media.base].written : written;
  made.optics = std::move(out);
  if (made.id.empty()) made.id = std::move(id);
}

// Adds the stacks in which one medium has another of its datasets. All else they have of the dataset at `of`.
void add_others(Material& material, std::size_t of, const StackText& text, Media media) {
  for (StackPart& part : media.parts) {
    if (part.named) continue;
    const StackPart preferred = part;
    const bool is_base = &part == &media.parts[media.base];
    for (std::size_t i = 0; i < preferred.found.material.datasets.size(); ++i) {
      const Dataset& other = preferred.found.material.datasets[i];
      if (i == preferred.found.dataset || !std::holds_alternative<OpticalConstants>(other.optics)) continue;
      part.found.dataset = i;
      part.written = preferred.found.material.id + "/" + other.id;
      if (is_base) take_body(part);
      Dataset dataset = material.datasets[of];
      dataset.id.clear();
      dataset.flags = {};
      open(text, media, {}, dataset);
      if (!other.doubtful.empty()) dataset.doubtful = other.doubtful;
      if (material.dataset(dataset.id) == nullptr) material.datasets.push_back(std::move(dataset));
    }
    part = preferred;
  }
}

}  // namespace

StackPart library_part(const MaterialLibrary& library, std::string_view name, const std::string& place) {
  StackPart out;
  auto found = library.look_up(name);
  const std::size_t slash = found ? name.npos : name.find('/');
  const std::string_view material = name.substr(0, slash);
  if (auto mixed = found ? std::nullopt : library.find(name)) {
    out.found.material = std::move(*mixed);
    out.written = name;
    return out;
  }
  if (!found) found = library.look_up(material);
  if (!found) fail_unknown_name(library, name, {.place = place, .instead = {}});
  out.found.material = library.as_filed(found->index);
  out.named = slash != name.npos;
  const Material& of = out.found.material;
  const Dataset& dataset = dataset_named(of, out.named ? name.substr(slash + 1) : "", place + ": " + of.id);
  out.found.dataset = static_cast<std::size_t>(&dataset - of.datasets.data());
  out.written = of.id + "/" + dataset.id;
  return out;
}

void open_stacks(Material& material, std::string_view place, const FindStackPart& find) {
  for (std::size_t i = 0, count = material.datasets.size(); i < count; ++i) {
    Stack* const stack = std::get_if<Stack>(&material.datasets[i].optics);
    if (stack == nullptr || stack->is_open()) continue;
    const StackText text = parse_stack(stack->text, place);
    const Media media = find_media(text, place, find);
    open(text, media, stack->text, material.datasets[i]);
    if (material.class_by != ClassBy::stated) {
      const Material& base = media.parts[media.base].found.material;
      material.material_class = base.material_class;
      material.class_by = base.class_by;
    }
    add_others(material, i, text, media);
  }
}

Material stack_material(std::string_view text, const FindStackPart& find) {
  const std::string place = printable(text, 80);
  Material out;
  out.name = printable(text, most_name_bytes / 4);
  out.id = identifier(out.name, '_', "stack");
  out.class_by = ClassBy::nobody;
  out.group = "film";
  out.preferred_reason = "the preferred datasets of its media";
  Dataset& dataset = out.datasets.emplace_back();
  dataset.origin = Origin::computed;
  dataset.optics = Stack{std::string(text), {}, {}, 0};
  open_stacks(out, place, find);
  return out;
}

Stack with_thickness(Stack stack, std::size_t layer, double thickness_nm) {
  if (layer < 1 || layer > stack.layers.size())
    throw Error::at(printable(stack.text, 80), "has no layer " + std::to_string(layer),
                    "a layer from 1 to " + std::to_string(stack.layers.size()) + ", the outermost being 1");
  StackLayer& changed = stack.layers[layer - 1];
  changed.thickness_nm = thickness_nm;
  StackText text = parse_stack(stack.text, printable(stack.text, 80));
  set_thickness(text.layers[layer - 1], thickness_nm);
  stack.text = format_stack(text);
  return stack;
}

}  // namespace etak
