// SPDX-License-Identifier: Apache-2.0
#include "core/material/qualifiers.h"

#include <algorithm>
#include <array>

#include "core/base/text/ascii.h"
#include "core/base/text/text.h"
#include "core/material/names.h"

namespace etak {
namespace {

constexpr std::string_view a_thing = "a thing made of it, whose shape is not in the answer";
constexpr std::string_view outdoors = "a thing out of doors, whose surface changes by weather";
constexpr std::string_view by_time = "a change of the surface by air and time, which is not in the answer";
constexpr std::string_view by_use = "a change of the surface by use, which is not in the answer";
constexpr std::string_view a_state = "a state that the measured sample need not share";
constexpr std::string_view below = "it is what is seen, not what lies below";

constexpr std::array qualifiers{
    Qualifier{
        "brushed polished burnished buffed satin matte matt glossy shiny smooth rough sanded sandblasted blasted hammered honed etched frosted scratched machined",
        "a roughness, not an F0",
        "a roughness, with which a body also looks lighter or darker; the measured colour has its own"},
    Qualifier{"wet damp", "a film of water, which is not in the answer",
              "darker than the sample that was measured, unless that is named wet"},
    Qualifier{"anodised anodized anodising anodizing",
              "a layer of oxide, often dyed, which is not in the answer",
              "a layer of oxide, often dyed, which is not in the answer"},
    Qualifier{"tarnished oxidised oxidized patinated corroded weathered aged", by_time, by_time},
    Qualifier{"worn used", by_use, by_use},
    Qualifier{"varnished lacquered oiled waxed sealed", "a clear coat, which is not in the answer",
              "a clear coat, under which a body looks darker and glossy"},
    Qualifier{"photo", "", "a glossy coat, which is not in the answer", "paper"},
    Qualifier{"car automotive", "",
              "a lacquer of several layers, whose clear coat and flakes are not in the answer",
              "paint pigment"},
    Qualifier{"pure solid", "a purity, of which the record of the sample tells", ""},
    Qualifier{"clean new dry fresh raw ripe", a_state, a_state},
    Qualifier{"old dirty dusty and", "", ""},  // no answer, and no suggestion by these words alone
    Qualifier{"faded bleached", "", "paler than what was measured"},
    Qualifier{"dyed printed", "", "a colour of its own, which is not in the answer"},
    Qualifier{"roasted toasted baked fried grilled", "", "browned by heat, darker than what was measured",
              "food"},
    Qualifier{"frozen", "", "ice in and on it, which is not in the answer"},
    Qualifier{"dried cooked boiled", "", "of another colour than what was measured", "food plant"},
    Qualifier{
        "red green blue yellow orange purple violet pink brown black white grey gray dark light pale bright coloured colored tinted",
        "a colour of the body, not an F0", "", "dielectric"},
    Qualifier{
        "pipe tube rod bar beam wire sheet plate panel slab block ingot coin ring foil bowl cup pot pan vase table desk chair bench door wall floor flooring tile plank mat fabric cloth textile yarn thread "
        "bottle jar pane knife fork spoon key nail screw bolt chain box board sink handle rope sack blanket shirt sweater jacket trousers sock socks hat glove gloves shoe shoes boot boots",
        a_thing, a_thing, solid_families},
    Qualifier{"roof gutter flashing cladding facade statue road fence gate bridge", outdoors, outdoors,
              solid_families},
    Qualifier{"painted", below, below, "", "paint"},
    Qualifier{"chromed", below, below, "", "chrome"},
    Qualifier{"gilded gilt", below, below, "", "gold"},
    Qualifier{"rusty rusted", below, below, "", "rust"},
    Qualifier{"galvanised galvanized", below, below, "", "galvanized steel"},
    Qualifier{"plated plating coated coating", below, below, "", {}, true}};

bool has_word(std::string_view words, std::string_view word) {
  return (" " + std::string(words) + " ").find(" " + std::string(word) + " ") != std::string::npos;
}

bool is_true_of(const Qualifier& q, const Material& m) {
  return q.of.empty() || has_word(q.of, m.group.empty() ? m.material_class : m.group) ||
         (has_word(q.of, "dielectric") && optical_kind(m.material_class) == "dielectric");
}

}  // namespace

const Qualifier* qualifier(std::string_view word) {
  if (word.empty() || word.find(' ') != word.npos) return nullptr;
  const auto found = std::find_if(qualifiers.begin(), qualifiers.end(), [&](const Qualifier& each) {
    return has_word(each.words, lower_case(word));
  });
  return found == qualifiers.end() ? nullptr : &*found;
}

std::vector<NameWithQualifiers> qualified_names(std::string_view name) {
  constexpr std::size_t most_words = 6;
  std::vector<std::string_view> words = words_of(name);
  if (words.size() < 2 || words.size() > most_words) return {};
  std::vector<const Qualifier*> known;
  for (const std::string_view word : words) known.push_back(qualifier(word));
  const auto hiding =
      std::find_if(known.begin(), known.end(), [](const Qualifier* q) { return q && q->hides; });
  if (hiding != known.end()) {
    known.erase(hiding + 1, known.end());
    words.resize(known.size());
  }
  // Bit i of a choice sets word i aside.
  unsigned settable = 0;
  for (std::size_t i = 0; i < known.size(); ++i) settable |= known[i] != nullptr ? 1U << i : 0;
  const unsigned all = (1U << words.size()) - 1;
  std::vector<NameWithQualifiers> out;
  for (unsigned choice = 1; choice < all; ++choice) {
    if ((choice & ~settable) != 0) continue;
    NameWithQualifiers& each = out.emplace_back();
    for (std::size_t i = 0; i < words.size(); ++i)
      if ((choice >> i & 1U) != 0)
        each.words.emplace_back(words[i], known[i]);
      else
        append(each.base, each.base.empty() ? "" : " ", words[i]);
  }
  std::stable_sort(out.begin(), out.end(), [](const NameWithQualifiers& a, const NameWithQualifiers& b) {
    return a.words.size() < b.words.size();
  });
  return out;
}

std::string qualifier_note(const NameWithQualifiers& name, const Material& material) {
  const bool surface = !gives_f0(material.material_class);
  std::string out;
  for (const auto& [word, q] : name.words) {
    const std::string_view says = surface ? q->of_surface : q->of_f0;
    if (says.empty() || !is_true_of(*q, material)) return {};
    append(out, out.empty() ? "" : "; ", lower_case(word), ": ", says);
  }
  return out;
}

}  // namespace etak
