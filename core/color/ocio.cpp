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
#include "core/base/setting.h"
#include "core/base/text/edit_distance.h"
#include "core/base/text/text.h"
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

struct OpenConfig {
  Config config;
  std::string label;
};

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

OpenConfig open_config(const std::string& asked) {
  std::string path = asked;
  if (path.empty()) {
    const char* environment = std::getenv("OCIO");
    if (environment != nullptr) path = environment;
  }
  try {
    if (path.empty()) {
      std::istringstream text{std::string(ocio_config_text)};
      return {ocio::Config::CreateFromStream(text), builtin_ocio_config};
    }
    namespace fs = std::filesystem;
    std::error_code failure;
    const bool pipe = is_pipe_input(path);
    if (!pipe && !fs::exists(path, failure))
      throw Error::at(path, "no such file", "an OpenColorIO config (" + setting("ocio") + " or $OCIO)");
    std::istringstream text{read_file(path, max_config_bytes)};
    const auto config = ocio::Config::CreateFromStream(text)->createEditableCopy();
    // The tables that the config names lie beside it; for a pipe in the working folder.
    const fs::path folder = pipe ? fs::path() : fs::path(path).parent_path();
    config->setWorkingDir((folder.empty() ? fs::current_path(failure) : folder).c_str());
    ConfigFiles(*config, path).check();
    return {config, path};
  } catch (const ocio::Exception& e) {
    throw Error::at(path.empty() ? builtin_ocio_config : path,
                    "cannot be read as an OpenColorIO config" + where(e.what()),
                    "a config of OpenColorIO 1 or 2, as ociocheck accepts it");
  }
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

Xyz white_of(double x, double y) {
  return {x / y, 1, (1 - x - y) / y};
}

// An interchange role of a config, and the matrix from XYZ under `white` to the space of that role.
struct Interchange {
  std::string role;
  Xyz white;
  Mat3 from_xyz;
};

Interchange cie_interchange() {
  return {"cie_xyz_d65_interchange", white_of(0.3127, 0.3290), identity3};
}

// ACES2065-1: primaries and white of SMPTE ST 2065-1:2021.
Interchange aces_interchange() {
  const Xyz white = white_of(0.32168, 0.33767);
  return {"aces_interchange", white,
          inverse(rgb_to_xyz({{{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}}}, white))};
}

// Whether the config has the role and the space that it names.
bool leads_in(const ocio::Config& config, const Interchange& door) {
  return config.hasRole(door.role.c_str()) && config.getColorSpace(door.role.c_str());
}

[[noreturn]] void no_way_in(const OpenConfig& open) {
  throw Error::at(open.label, "no interchange role, so XYZ has no way in",
                  "role aces_interchange or cie_xyz_d65_interchange");
}

// A role on the same side (scene or display) as the space needs no view transform between the two, and with
// it no tone curve; ACES first, for its configs define everything else from it.
Interchange interchange_for(const OpenConfig& open, const ocio::ColorSpace& space) {
  const std::array<Interchange, 2> known{aces_interchange(), cie_interchange()};
  const Interchange* found = nullptr;
  for (const auto& candidate : known) {
    if (!leads_in(*open.config, candidate)) continue;
    const auto role_space = open.config->getColorSpace(candidate.role.c_str());
    if (role_space->getReferenceSpaceType() == space.getReferenceSpaceType()) return candidate;
    if (found == nullptr) found = &candidate;
  }
  if (found == nullptr) no_way_in(open);
  return *found;
}

}  // namespace

struct OcioSpace::State {
  std::string config, name;
  Interchange interchange;
  ocio::ConstCPUProcessorRcPtr processor;
};

OcioSpace::OcioSpace(std::shared_ptr<const State> state) : state_(std::move(state)) {}

const std::string& OcioSpace::name() const {
  return state_->name;
}
const std::string& OcioSpace::config() const {
  return state_->config;
}
const std::string& OcioSpace::role() const {
  return state_->interchange.role;
}

namespace {

// The space called `space`, which must hold colours. Throws Error.
ocio::ConstColorSpaceRcPtr colour_space(const OpenConfig& open, const std::string& space) {
  const auto found = space.empty() ? nullptr : open.config->getColorSpace(space.c_str());
  if (!found)
    throw Error::at(open.label, "no colour space " + in_quotes(space, 80),
                    "one of its spaces, the nearest are " + nearest_spaces(*open.config, space));
  if (found->isData())
    throw Error::at(open.label, "space " + in_quotes(space, 80) + " holds data", "a space that holds colour");
  return found;
}

[[noreturn]] void cannot_be_used(const OpenConfig& open, const std::string& space, const ocio::Exception& e) {
  throw Error::at(open.label, "space " + in_quotes(space, 80) + " cannot be used" + where(e.what()), usable);
}

}  // namespace

OcioSpace OcioSpace::open(const std::string& config, const std::string& space) {
  const OpenConfig open = open_config(config);
  try {
    const auto found = colour_space(open, space);
    State state;
    state.config = open.label;
    state.name = found->getName();
    state.interchange = interchange_for(open, *found);
    // Lossless: the default optimisation replaces powers by approximations good to 1e-5 only.
    state.processor = open.config->getProcessor(state.interchange.role.c_str(), found->getName())
                          ->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
    return OcioSpace(std::make_shared<const State>(std::move(state)));
  } catch (const ocio::Exception& e) {
    cannot_be_used(open, space, e);
  }
}

LinearRgb OcioSpace::from_xyz(const Xyz& xyz, const Xyz& white) const {
  const Interchange& door = state_->interchange;
  const Vec3 in = door.from_xyz * (bradford(white, door.white) * vec(xyz));
  std::array<float, 3> pixel{static_cast<float>(in[0]), static_cast<float>(in[1]), static_cast<float>(in[2])};
  state_->processor->applyRGB(pixel.data());
  return {pixel[0], pixel[1], pixel[2]};
}

struct OcioSource::State {
  std::string config, name;
  Mat3 from_interchange;
  ocio::ConstCPUProcessorRcPtr processor;
};

OcioSource::OcioSource(std::shared_ptr<const State> state) : state_(std::move(state)) {}

const std::string& OcioSource::name() const {
  return state_->name;
}
const std::string& OcioSource::config() const {
  return state_->config;
}

OcioSource OcioSource::open(const std::string& config, const std::string& space) {
  const OpenConfig open = open_config(config);
  try {
    const auto found = colour_space(open, space);
    const Interchange door = interchange_for(open, *found);
    const Xyz white = white_of(0.3127, 0.3290);
    State state;
    state.config = open.label;
    state.name = found->getName();
    state.from_interchange = inverse(rgb_to_xyz(primaries(RgbSpace::srgb), white)) *
                             (bradford(door.white, white) * inverse(door.from_xyz));
    state.processor = open.config->getProcessor(found->getName(), door.role.c_str())
                          ->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
    return OcioSource(std::make_shared<const State>(std::move(state)));
  } catch (const ocio::Exception& e) {
    cannot_be_used(open, space, e);
  }
}

void OcioSource::to_linear_srgb(float* rgb, std::size_t count) const {
  if (count == 0) return;
  ocio::PackedImageDesc pixels(rgb, static_cast<long>(count), 1, 3);
  state_->processor->apply(pixels);
  for (std::size_t i = 0; i < count; ++i, rgb += 3) {
    const Vec3 out = state_->from_interchange * Vec3{double{rgb[0]}, double{rgb[1]}, double{rgb[2]}};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = static_cast<float>(out[c]);
  }
}

struct OcioDisplay::State {
  std::string display, view;
  Mat3 to_interchange;
  ocio::ConstProcessorRcPtr whole;
  ocio::ConstCPUProcessorRcPtr processor;
};

OcioDisplay::OcioDisplay(std::shared_ptr<const State> state) : state_(std::move(state)) {}

const std::string& OcioDisplay::display() const {
  return state_->display;
}
const std::string& OcioDisplay::view() const {
  return state_->view;
}

namespace {

// `asked`, or the first of `known` where nothing is asked for. Throws Error with the list when it is not
// there.
std::string one_of(const std::string& asked, const std::string& standard,
                   const std::vector<std::string>& known, const std::string& label, const char* what) {
  if (asked.empty()) return standard;
  if (std::find(known.begin(), known.end(), asked) != known.end()) return asked;
  const auto cut = [](const std::string& each) { return in_quotes(each, 80); };
  throw Error::at(label, std::string("no ") + what + " " + in_quotes(asked, 80), joined(known, ", ", cut));
}

}  // namespace

OcioDisplay OcioDisplay::open(const std::string& config, const std::string& display,
                              const std::string& view) {
  const OpenConfig open = open_config(config);
  try {
    const ocio::Config& c = *open.config;
    std::vector<std::string> displays, views;
    for (int i = 0; i < c.getNumDisplays(); ++i) displays.emplace_back(c.getDisplay(i));
    State state;
    state.display = one_of(display, c.getDefaultDisplay(), displays, open.label, "display");
    for (int i = 0; i < c.getNumViews(state.display.c_str()); ++i)
      views.emplace_back(c.getView(state.display.c_str(), i));
    state.view = one_of(view, c.getDefaultView(state.display.c_str()), views, open.label,
                        ("view of display " + in_quotes(state.display, 80) + ", named").c_str());
    // Pictures are scene-referred: the role of the scene side is taken where there is one.
    const Interchange door = leads_in(c, aces_interchange()) ? aces_interchange() : cie_interchange();
    if (!leads_in(c, door)) no_way_in(open);
    const Xyz white = white_of(0.3127, 0.3290);
    state.to_interchange =
        door.from_xyz * (bradford(white, door.white) * rgb_to_xyz(primaries(RgbSpace::srgb), white));
    const auto transform = ocio::DisplayViewTransform::Create();
    transform->setSrc(c.getColorSpace(door.role.c_str())->getName());
    transform->setDisplay(state.display.c_str());
    transform->setView(state.view.c_str());
    state.whole = c.getProcessor(transform);
    state.processor = state.whole->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
    return OcioDisplay(std::make_shared<const State>(std::move(state)));
  } catch (const ocio::Exception& e) {
    throw Error::at(open.label,
                    "display " + in_quotes(display, 80) + " with view " + in_quotes(view, 80) +
                        " cannot be used" + where(e.what()),
                    usable);
  }
}

void OcioDisplay::apply(float* rgb, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i, rgb += 3) {
    const Vec3 in = state_->to_interchange * Vec3{double{rgb[0]}, double{rgb[1]}, double{rgb[2]}};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = static_cast<float>(in[c]);
    state_->processor->applyRGB(rgb);
  }
}

OcioShader OcioDisplay::shader() const {
  try {
    auto description = ocio::GpuShaderDesc::CreateShaderDesc();
    description->setLanguage(ocio::GPU_LANGUAGE_GLSL_1_3);
    description->setFunctionName("ocio_view");
    description->setResourcePrefix("ocio_");
    state_->whole->getOptimizedGPUProcessor(ocio::OPTIMIZATION_LOSSLESS)->extractGpuShaderInfo(description);
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
      for (std::size_t c = 0; c < 3; ++c) text << (c == 0 ? "" : ", ") << state_->to_interchange[row][c];
      text << "), linear_srgb)";
    }
    text << ", 1.0)).xyz;\n}\n";
    out.text = text.str();
    return out;
  } catch (const ocio::Exception& e) {
    throw Error::at("display " + in_quotes(state_->display, 80), "has no shader" + where(e.what()), usable);
  }
}

std::vector<OcioDisplayInfo> ocio_displays(const std::string& config) {
  const OpenConfig open = open_config(config);
  const auto first = [](std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) std::rotate(names.begin(), found, found + 1);
  };
  try {
    const ocio::Config& c = *open.config;
    std::vector<std::string> names;
    for (int i = 0; i < c.getNumDisplays(); ++i) names.emplace_back(c.getDisplay(i));
    first(names, c.getDefaultDisplay());
    std::vector<OcioDisplayInfo> out;
    for (const std::string& name : names) {
      OcioDisplayInfo info{name, {}};
      for (int i = 0; i < c.getNumViews(name.c_str()); ++i)
        info.views.emplace_back(c.getView(name.c_str(), i));
      first(info.views, c.getDefaultView(name.c_str()));
      out.push_back(std::move(info));
    }
    return out;
  } catch (const ocio::Exception& e) {
    throw Error::at(open.label, "displays cannot be listed" + where(e.what()), usable);
  }
}

}  // namespace etak
