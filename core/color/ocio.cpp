// SPDX-License-Identifier: Apache-2.0
#include "core/color/ocio.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <sstream>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/paths.h"
#include "core/base/setting.h"
#include "core/base/text/edit_distance.h"
#include "core/base/text/text.h"
#include "core/color/aces.h"
#include "core/color/colorspace.h"
#include "core/color/ocio_config.h"
#include "core/color/ocio_files.inc"

namespace etak {
namespace {

namespace ocio = OCIO_NAMESPACE;
using Config = ocio::ConstConfigRcPtr;

static_assert(OCIO_VERSION_HEX >= 0x02000000, "OpenColorIO 2.0 brought the interchange roles");

// Larger than any config of the ACES series by a factor of fifty.
constexpr std::uintmax_t max_config_bytes = 16u << 20;

constexpr std::string_view usable = "transforms and tables that OpenColorIO can use";

// Messages of OpenColorIO name what failed inside of it ("stoi"). A user is helped by the table that a
// transform names and by the line, where the message holds them: ", in its table 'luts/film.cube', at line
// 3".
std::string where(std::string_view text) {
  std::string out;
  constexpr std::string_view table = "transform file '", missing = "file reference '", line = "ine ";
  if (const std::size_t at = text.find(table); at != text.npos) {
    const std::string_view name = text.substr(at + table.size());
    out += ", in its table '" + printable(name.substr(0, name.find('\'')), 200) + "'";
  }
  if (const std::size_t at = text.find(missing); at != text.npos) {
    const std::string_view name = text.substr(at + missing.size());
    return ", there is no table '" + printable(name.substr(0, name.find('\'')), 200) + "'";
  }
  for (std::size_t at = text.find(line); at != text.npos; at = text.find(line, at + 1)) {
    if (at == 0 || (text[at - 1] != 'l' && text[at - 1] != 'L')) continue;
    std::string_view number = text.substr(at + line.size());
    if (number.starts_with('(')) number.remove_prefix(1);
    number = number.substr(0, std::min(number.find_first_not_of("0123456789"), number.size()));
    if (!number.empty()) return out + ", at line " + std::string(number);
  }
  return out;
}

std::vector<std::string> space_names(const ocio::Config& config, ocio::ColorSpaceVisibility visibility) {
  std::vector<std::string> names;
  const int count = config.getNumColorSpaces(ocio::SEARCH_REFERENCE_SPACE_ALL, visibility);
  for (int i = 0; i < count; ++i)
    names.emplace_back(config.getColorSpaceNameByIndex(ocio::SEARCH_REFERENCE_SPACE_ALL, visibility, i));
  return names;
}

// "\"A\", \"B\", \"C\"": the three spaces of the config whose name or alias is nearest.
std::string nearest_spaces(const ocio::Config& config, const std::string& asked) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const auto& name : space_names(config, ocio::COLORSPACE_ACTIVE)) {
    std::size_t distance = edit_distance(asked, name);
    const auto space = config.getColorSpace(name.c_str());
    for (std::size_t i = 0; i < space->getNumAliases(); ++i)
      distance = std::min(distance, edit_distance(asked, space->getAlias(i)));
    ranked.emplace_back(distance, name);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  ranked.resize(std::min<std::size_t>(3, ranked.size()));
  return joined(ranked, ", ", [](const auto& each) { return in_quotes(each.second, 80); });
}

constexpr Xyz white_of(double x, double y) {
  return {x / y, 1, (1 - x - y) / y};
}
constexpr Xyz d65_white = white_of(0.3127, 0.3290);

// An interchange role of a config, and the matrix from XYZ under `white` to the space of that role.
struct Interchange {
  std::string role;
  Xyz white;
  Mat3 from_xyz;
};

Interchange cie_interchange() {
  return {"cie_xyz_d65_interchange", d65_white, identity3};
}

// ACES2065-1: primaries and white of SMPTE ST 2065-1:2021.
Interchange aces_interchange() {
  const Xyz white = white_of(aces_white_x, aces_white_y);
  return {"aces_interchange", white,
          inverse(rgb_to_xyz({{{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}}}, white))};
}

// Whether the config has the role and the space that it names.
bool leads_in(const ocio::Config& config, const Interchange& door) {
  return config.hasRole(door.role.c_str()) && config.getColorSpace(door.role.c_str());
}

[[noreturn]] void no_way_in(const std::string& label) {
  throw Error::at(label, "no interchange role, so XYZ has no way in",
                  "role aces_interchange or cie_xyz_d65_interchange");
}

// A role on the same side (scene or display) as the space needs no view transform between the two, and with
// it no tone curve; ACES first, for its configs define everything else from it.
Interchange interchange_for(const ocio::Config& config, const std::string& label,
                            const ocio::ColorSpace& space) {
  const std::array<Interchange, 2> known{aces_interchange(), cie_interchange()};
  const Interchange* found = nullptr;
  for (const auto& candidate : known) {
    if (!leads_in(config, candidate)) continue;
    const auto role_space = config.getColorSpace(candidate.role.c_str());
    if (role_space->getReferenceSpaceType() == space.getReferenceSpaceType()) return candidate;
    if (found == nullptr) found = &candidate;
  }
  if (found == nullptr) no_way_in(label);
  return *found;
}

}  // namespace

// A way through the config, from the first to the second of: the space of an interchange role, the space that is
// asked for. For a display: from the scene's role to what its view shows.
struct OcioWay {
  std::string name, view;  // of the space, or of the display and its view
  Interchange door;
  Mat3 matrix = identity3;  // between linear sRGB and the interchange space, in the direction of the way
  ocio::ConstProcessorRcPtr whole;
  // Lossless: the default optimisation replaces powers by approximations good to 1e-5 only.
  ocio::ConstCPUProcessorRcPtr processor;
};

struct OcioConfig::State {
  Config config;
  std::string label;

  // The space called `space`, which must hold colours. Throws Error.
  ocio::ConstColorSpaceRcPtr colour_space(const std::string& space) const {
    const auto found = space.empty() ? nullptr : config->getColorSpace(space.c_str());
    if (!found)
      throw Error::at(label, "no colour space " + in_quotes(space, 80),
                      "one of its spaces, the nearest are " + nearest_spaces(*config, space));
    if (found->isData())
      throw Error::at(label, "space " + in_quotes(space, 80) + " holds data", "a space that holds colour");
    return found;
  }

  // The way between the space and its door.
  OcioWay way(const std::string& space, bool to_space) const {
    try {
      const auto found = colour_space(space);
      OcioWay out{found->getName(), {}, interchange_for(*config, label, *found), identity3, {}, {}};
      const char *role = out.door.role.c_str(), *name = found->getName();
      out.whole = config->getProcessor(to_space ? role : name, to_space ? name : role);
      out.processor = out.whole->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
      return out;
    } catch (const ocio::Exception& e) {
      throw Error::at(label, "space " + in_quotes(space, 80) + " cannot be used" + where(e.what()), usable);
    }
  }

  // The displays, or the views of a display, the standard one first.
  std::vector<std::string> displays() const {
    std::vector<std::string> out;
    for (int i = 0; i < config->getNumDisplays(); ++i) out.emplace_back(config->getDisplay(i));
    return first(std::move(out), config->getDefaultDisplay());
  }
  std::vector<std::string> views(const std::string& display) const {
    std::vector<std::string> out;
    for (int i = 0; i < config->getNumViews(display.c_str()); ++i)
      out.emplace_back(config->getView(display.c_str(), i));
    return first(std::move(out), config->getDefaultView(display.c_str()));
  }

 private:
  static std::vector<std::string> first(std::vector<std::string> names, const std::string& name) {
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) std::rotate(names.begin(), found, found + 1);
    return names;
  }
};

OcioConfig OcioConfig::open(const std::string& file) {
  std::string path = file;
  if (path.empty()) {
    const char* environment = std::getenv("OCIO");
    if (environment != nullptr) path = environment;
  }
  try {
    if (path.empty()) {
      std::istringstream text{std::string(ocio_config_text)};
      return OcioConfig({ocio::Config::CreateFromStream(text), builtin_ocio_config});
    }
    namespace fs = std::filesystem;
    const bool pipe = is_pipe_input(path);
    if (!pipe && !is_there(path))
      throw Error::at(path, "no such file", "an OpenColorIO config (" + setting("ocio") + " or $OCIO)");
    std::istringstream text{read_file(path, max_config_bytes)};
    const auto config = ocio::Config::CreateFromStream(text)->createEditableCopy();
    // The tables that the config names lie beside it; for a pipe in the working folder.
    const fs::path folder = pipe ? fs::path() : fs::path(path).parent_path();
    config->setWorkingDir((folder.empty() ? sys::working_folder() : folder).c_str());
    ConfigFiles(*config, path).check();
    return OcioConfig({config, path});
  } catch (const ocio::Exception& e) {
    throw Error::at(path.empty() ? builtin_ocio_config : path,
                    "cannot be read as an OpenColorIO config" + where(e.what()),
                    "a config of OpenColorIO 1 or 2, as ociocheck accepts it");
  }
}

OcioConfig::OcioConfig(State state) : state_(std::make_shared<const State>(std::move(state))) {}

const std::string& OcioConfig::name() const {
  return state_->label;
}

OcioSpace OcioConfig::space(const std::string& name) const {
  return OcioSpace(std::make_shared<const OcioWay>(state_->way(name, true)));
}

OcioSource OcioConfig::source(const std::string& name) const {
  OcioWay way = state_->way(name, false);
  way.matrix = inverse(rgb_to_xyz(primaries(RgbSpace::srgb), d65_white)) *
               (bradford(way.door.white, d65_white) * inverse(way.door.from_xyz));
  return OcioSource(std::make_shared<const OcioWay>(std::move(way)));
}

const std::string& OcioSpace::name() const {
  return way_->name;
}
const std::string& OcioSpace::role() const {
  return way_->door.role;
}

LinearRgb OcioSpace::from_xyz(const Xyz& xyz, const Xyz& white) const {
  const Interchange& door = way_->door;
  const Vec3 in = door.from_xyz * (bradford(white, door.white) * vec(xyz));
  std::array<float, 3> pixel{static_cast<float>(in[0]), static_cast<float>(in[1]), static_cast<float>(in[2])};
  way_->processor->applyRGB(pixel.data());
  return {pixel[0], pixel[1], pixel[2]};
}

void OcioSource::to_linear_srgb(float* rgb, std::size_t count) const {
  if (count == 0) return;
  ocio::PackedImageDesc pixels(rgb, static_cast<long>(count), 1, 3);
  way_->processor->apply(pixels);
  for (std::size_t i = 0; i < count; ++i, rgb += 3) {
    const Vec3 out = way_->matrix * Vec3{double{rgb[0]}, double{rgb[1]}, double{rgb[2]}};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = static_cast<float>(out[c]);
  }
}

namespace {

// `asked`, or the first of `known` where nothing is asked for. Throws Error with the list when it is not
// there.
std::string one_of(const std::string& asked, const std::vector<std::string>& known, const std::string& label,
                   const std::string& what) {
  if (asked.empty()) return known.empty() ? std::string() : known.front();
  if (std::ranges::find(known, asked) != known.end()) return asked;
  const auto cut = [](const std::string& each) { return in_quotes(each, 80); };
  throw Error::at(label, "no " + what + " " + in_quotes(asked, 80), joined(known, ", ", cut));
}

}  // namespace

OcioDisplay OcioConfig::display(const std::string& display, const std::string& view) const {
  const ocio::Config& c = *state_->config;
  const std::string& label = state_->label;
  try {
    OcioWay way;
    way.name = one_of(display, state_->displays(), label, "display");
    way.view = one_of(view, state_->views(way.name), label,
                      "view of display " + in_quotes(way.name, 80) + ", named");
    // Pictures are scene-referred: the role of the scene side is taken where there is one.
    way.door = leads_in(c, aces_interchange()) ? aces_interchange() : cie_interchange();
    if (!leads_in(c, way.door)) no_way_in(label);
    way.matrix = way.door.from_xyz *
                 (bradford(d65_white, way.door.white) * rgb_to_xyz(primaries(RgbSpace::srgb), d65_white));
    const auto transform = ocio::DisplayViewTransform::Create();
    transform->setSrc(c.getColorSpace(way.door.role.c_str())->getName());
    transform->setDisplay(way.name.c_str());
    transform->setView(way.view.c_str());
    way.whole = c.getProcessor(transform);
    way.processor = way.whole->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
    return OcioDisplay(std::make_shared<const OcioWay>(std::move(way)));
  } catch (const ocio::Exception& e) {
    throw Error::at(label,
                    "display " + in_quotes(display, 80) + " with view " + in_quotes(view, 80) +
                        " cannot be used" + where(e.what()),
                    usable);
  }
}

std::vector<OcioDisplayInfo> OcioConfig::displays() const {
  try {
    std::vector<OcioDisplayInfo> out;
    for (const std::string& name : state_->displays()) out.push_back({name, state_->views(name)});
    return out;
  } catch (const ocio::Exception& e) {
    throw Error::at(state_->label, "displays cannot be listed" + where(e.what()), usable);
  }
}

const std::string& OcioDisplay::display() const {
  return way_->name;
}
const std::string& OcioDisplay::view() const {
  return way_->view;
}

void OcioDisplay::apply(float* rgb, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i, rgb += 3) {
    const Vec3 in = way_->matrix * Vec3{double{rgb[0]}, double{rgb[1]}, double{rgb[2]}};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = static_cast<float>(in[c]);
    way_->processor->applyRGB(rgb);
  }
}

OcioShader OcioDisplay::shader() const {
  try {
    auto description = ocio::GpuShaderDesc::CreateShaderDesc();
    description->setLanguage(ocio::GPU_LANGUAGE_GLSL_1_3);
    description->setFunctionName("ocio_view");
    description->setResourcePrefix("ocio_");
    way_->whole->getOptimizedGPUProcessor(ocio::OPTIMIZATION_LOSSLESS)->extractGpuShaderInfo(description);
    OcioShader out;
    out.function = "ocio_display";
    const auto add = [&](const char* sampler, unsigned width, unsigned height, unsigned depth, int channels,
                         ocio::Interpolation interpolation, const float* values) {
      OcioShader::Table table{sampler,
                              static_cast<int>(width),
                              static_cast<int>(height),
                              static_cast<int>(depth),
                              channels,
                              interpolation == ocio::INTERP_NEAREST,
                              {}};
      const std::size_t count = std::size_t{width} * std::max(height, 1u) * std::max(depth, 1u) *
                                static_cast<std::size_t>(channels);
      table.values.assign(values, values + count);
      out.tables.push_back(std::move(table));
    };
    for (unsigned i = 0; i < description->getNumTextures(); ++i) {
      const char *texture = nullptr, *sampler = nullptr;
      unsigned width = 0, height = 0;
      ocio::GpuShaderDesc::TextureType type{};
      ocio::Interpolation interpolation{};
      const float* values = nullptr;
      description->getTexture(i, texture, sampler, width, height, type, interpolation);
      description->getTextureValues(i, values);
      // A table of one row is a sampler1D in the text.
      add(sampler, width, height > 1 ? height : 0, 0,
          type == ocio::GpuShaderDesc::TEXTURE_RED_CHANNEL ? 1 : 3, interpolation, values);
    }
    for (unsigned i = 0; i < description->getNum3DTextures(); ++i) {
      const char *texture = nullptr, *sampler = nullptr;
      unsigned side = 0;
      ocio::Interpolation interpolation{};
      const float* values = nullptr;
      description->get3DTexture(i, texture, sampler, side, interpolation);
      description->get3DTextureValues(i, values);
      add(sampler, side, side, side, 3, interpolation, values);
    }
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(9);
    text << std::showpoint << description->getShaderText() << "\nvec3 " << out.function
         << "(vec3 linear_srgb) {\n  return ocio_view(vec4(";
    for (std::size_t row = 0; row < 3; ++row) {
      text << (row == 0 ? "" : ",\n    ") << "dot(vec3(";
      for (std::size_t c = 0; c < 3; ++c) text << (c == 0 ? "" : ", ") << way_->matrix[row][c];
      text << "), linear_srgb)";
    }
    text << ", 1.0)).xyz;\n}\n";
    out.text = text.str();
    return out;
  } catch (const ocio::Exception& e) {
    throw Error::at("display " + in_quotes(way_->name, 80), "has no shader" + where(e.what()), usable);
  }
}

}  // namespace etak
