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

std::optional<ClearBody> body_of(const StackPart& part) {
  return clear_body(part.found.material, part.found.chosen());
}

const OpticalConstants& constants_of(const FoundDataset& found, const std::string& place) {
  const Optics& optics = found.chosen().optics;
  const std::string what = found.material.id + "/" + found.chosen().id;
  if (const auto* constants = std::get_if<OpticalConstants>(&optics)) return *constants;
  throw Error::at(place, what + " " + std::string(without_constants(optics)), "a medium of n and k");
}

Media find_media(const StackText& text, std::string_view place, const FindStackPart& find) {
  Media out;
  const auto index_of = [&](const std::string& name, const std::string& where) {
    const auto known = std::find(out.names.begin(), out.names.end(), name);
    const auto index = static_cast<std::size_t>(known - out.names.begin());
    if (known != out.names.end()) return index;
    out.names.push_back(name);
    (void)constants_of(out.parts.emplace_back(find(name, where)).found, where);
    return index;
  };
  for (std::size_t i = 0; i < text.layers.size(); ++i) {
    const std::string where = layer_place(place, i);
    if (!text.layers[i].thickness_nm)
      throw Error::at(where, text.layers[i].name + " has an unknown thickness", "a number in place of ?");
    out.of_layer.push_back(index_of(text.layers[i].name, where));
  }
  out.base = index_of(text.base, std::string(place) + " base");
  out.parts[out.base].body = body_of(out.parts[out.base]);
  return out;
}

// The stack with these datasets of the media.
//   written   its text; empty: one that names every dataset
Stack opened(const StackText& text, const Media& media, std::string written) {
  Stack out;
  out.base = media.base;
  for (const StackPart& part : media.parts) {
    const Dataset& dataset = part.found.chosen();
    out.media.push_back({part.found.material.id, dataset.id, dataset.citation,
                         std::get<OpticalConstants>(dataset.optics), part.body});
  }
  for (std::size_t i = 0; i < text.layers.size(); ++i) {
    const StackText::Layer& layer = text.layers[i];
    out.layers.push_back({media.of_layer[i], *layer.thickness_nm, layer.coherent});
    if (written.empty()) append(out.text, media.parts[media.of_layer[i]].written, layer.rest, '/');
  }
  const StackPart& base = media.parts[media.base];
  out.text += written.empty() ? base.written : written;
  return out;
}

// What the importers found in the data of all media.
Flags flags_of(const Media& media) {
  Flags out;
  for (const StackPart& part : media.parts) out |= part.found.chosen().flags;
  return out;
}

std::string joined_datasets(const Stack& stack) {
  std::string out;
  for (const StackMedium& medium : stack.media) append(out, out.empty() ? "" : "+", medium.dataset);
  return out;
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
      if (is_base) part.body = body_of(part);
      Dataset dataset = material.datasets[of];
      dataset.optics = opened(text, media, {});
      dataset.id = joined_datasets(std::get<Stack>(dataset.optics));
      dataset.flags = flags_of(media);
      if (!other.doubtful.empty()) dataset.doubtful = other.doubtful;
      if (material.dataset(dataset.id) == nullptr) material.datasets.push_back(std::move(dataset));
    }
    part = preferred;
  }
}

}  // namespace

StackPart library_part(const MaterialLibrary& library, std::string_view name, const std::string& place) {
  StackPart out;
  const NameWords words{.place = place, .instead = {}};
  auto found = library.look_up(name);
  const std::size_t slash = found ? name.npos : name.find('/');
  const std::string_view material = name.substr(0, slash);
  if (auto mixed = found ? std::nullopt : library.find(name)) {
    out.found.material = std::move(*mixed);
    out.written = name;
    return out;
  }
  if (!found) found = library.look_up(material);
  if (!found) fail_unknown_name(library, name, words);
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
    *stack = opened(text, media, stack->text);
    Dataset& dataset = material.datasets[i];
    if (dataset.id.empty()) dataset.id = joined_datasets(*stack);
    dataset.flags |= flags_of(media);
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
