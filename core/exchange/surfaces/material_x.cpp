// SPDX-License-Identifier: Apache-2.0
// MaterialX documents, by pugixml, which expands no entities but the five of XML. Debian has it not for Windows, where these
// documents are refused.
// Based on: MaterialX Specification 1.39, "MaterialX Names", "Node Graph Elements", "Color Spaces".
#include <algorithm>
#include <filesystem>
#include <list>
#include <map>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/exchange/surfaces/document.h"
#include "core/exchange/surfaces/models.h"

#ifdef ETAK_HAS_PUGIXML
#include <pugixml.hpp>

namespace etak {
namespace {

constexpr int most_depth = 64;

// The kinds of nodes that the libraries of MaterialX 1.39.5 define, and those that 1.38 had besides.
constexpr std::string_view node_kinds =
    " LamaAdd LamaConductor LamaDielectric LamaDiffuse LamaEmission LamaGeneralizedSchlick LamaIridescence "
    " LamaLayer LamaMix LamaSSS LamaSheen LamaSurface LamaTranslucent UsdPreviewSurface UsdPrimvarReader "
    " UsdTransform2d UsdUVTexture absorption_vdf absval acescg_to_lin_rec709 acos add adobergb_to_lin_rec709 "
    " ambientocclusion and anisotropic_vdf arrayappend artistic_ior asin atan2 bitangent blackbody blur bump "
    " burley_diffuse_bsdf burn ceil cellnoise2d cellnoise3d checkerboard chiang_hair_absorption_from_color "
    " chiang_hair_bsdf chiang_hair_roughness circle clamp cloverleaf colorcorrect combine2 combine3 combine4 "
    " conductor_bsdf conical_edf constant contrast convert cos creatematrix crosshatch crossproduct "
    " deon_hair_absorption_from_melanin determinant dielectric_bsdf difference directional_light disjointover "
    " disney_principled displacement distance divide dodge dot dotproduct exp extract facingratio flake2d "
    " flake3d floor fract fractal2d fractal3d frame g18_rec709_to_lin_rec709 g22_ap1_to_lin_rec709 "
    " g22_rec709_to_lin_rec709 generalized_schlick_bsdf generalized_schlick_edf geomcolor geompropvalue "
    " geompropvalueuniform glossiness_anisotropy gltf_anisotropy_image gltf_colorimage gltf_image "
    " gltf_iridescence_thickness gltf_normalmap gltf_pbr gooch_shade grid heighttonormal hexagon hextiledimage "
    " hextilednormalmap hsvadjust hsvtorgb hueshift ifequal ifgreater ifgreatereq image in inside invert "
    " invertmatrix latlongimage layer light lin_adobergb_to_lin_rec709 lin_displayp3_to_lin_rec709 line ln "
    " luminance magnitude mask matte max maxcomponent measured_edf min mincomponent minus mix modulo multiply "
    " noise2d noise3d normal normalize normalmap not open_pbr_anisotropy open_pbr_surface "
    " open_pbr_surface_to_standard_surface or oren_nayar_diffuse_bsdf osl_set_ci out outside over overlay "
    " place2d plus point_light position power premult ramp ramp4 ramp_gradient ramplr ramptb randomcolor "
    " randomfloat range rec709_display_to_lin_rec709 reflect refract remap rgbtohsv rotate rotate2d rotate3d "
    " roughness_anisotropy roughness_dual round safepower saturate scale screen separate2 separate3 separate4 "
    " separatecolor sheen sheen_bsdf sign sin smoothstep splitlr splittb spot_light sqrt "
    " srgb_displayp3_to_lin_rec709 srgb_texture_to_lin_rec709 standard_surface "
    " standard_surface_to_UsdPreviewSurface standard_surface_to_gltf_pbr standard_surface_to_open_pbr_surface "
    " subsurface_bsdf subtract surface surface_unlit surfacematerial switch swizzle tan tangent texcoord "
    " thin_film_bsdf tiledcircles tiledcloverleafs tiledhexagons tiledimage time transformmatrix "
    " transformnormal transformpoint transformvector translucent_bsdf transpose trianglewave "
    " triplanarprojection unifiednoise2d unifiednoise3d uniform_edf unpremult viewdirection volume "
    " volumematerial worleynoise2d worleynoise3d xor ";

// Elements that are no nodes.
constexpr std::string_view other_elements =
    " nodedef nodegraph implementation look lookgroup collection geominfo geomprop geompropdef geomattr propertyset "
    "property propertyassign propertysetassign typedef unitdef unittypedef variantset variant variantassign backdrop token "
    "targetdef member attributedef materialassign visibility xi:include input output ";

bool is_word_of(std::string_view list, std::string_view word) {
  return !word.empty() && word.find(' ') == word.npos &&
         list.find(' ' + std::string(word) + ' ') != list.npos;
}

// The document, or one that it includes.
struct Source {
  std::string name;  // relative to the folder of the document; empty: it is the document
  std::vector<std::ptrdiff_t> lines = {};  // where each begins
  pugi::xml_document xml = {};
};

// A place where names of nodes hold: all documents together, or a graph.
struct Scope {
  struct Node {
    std::size_t link;  // into Document::links_
    pugi::xml_node element;
  };
  std::vector<pugi::xml_node> elements;  // whose children they are
  bool graph = true;
  std::map<std::string, Node, std::less<>> nodes = {};  // by name
};

class Document {
 public:
  Document(std::string_view text, const std::string& file, const DocumentFolder& folder)
      : file_(file), folder_(folder) {
    load(text, {});
  }

  std::vector<DocumentSurface> surfaces() {
    scopes_.push_back({roots_, false});
    for (const pugi::xml_node root : roots_) {
      for (const pugi::xml_node each : root.children("nodedef"))
        own_kinds_.insert(each.attribute("node").value());
      for (const pugi::xml_node graph : root.children("nodegraph")) scopes_.push_back({{graph}});
      for (const pugi::xml_node material : root.children("surfacematerial"))
        for (const pugi::xml_node input : material.children("input"))
          materials_.emplace(input.attribute("nodename").value(), material.attribute("name").value());
    }
    for (Scope& scope : scopes_) list_nodes(scope);
    for (const Scope& scope : scopes_) link_nodes(scope);
    require_no_loop(links_, file_);
    std::vector<DocumentSurface> out;
    for (const Scope& scope : scopes_)
      for (const pugi::xml_node element : scope.elements)
        for (const pugi::xml_node node : element.children())
          if (is_word_of(node_kinds, node.name()) && is_surface_model(node.name()))
            out.push_back(surface_of(scope, node));
    return out;
  }

 private:
  // Reads a document, and those that it includes, each of them once.
  void load(std::string_view text, const std::string& name) {
    Source& source = sources_.emplace_back(Source{name});
    for (std::size_t at = 0; at != text.npos; at = text.find('\n', at))
      source.lines.push_back(static_cast<std::ptrdiff_t>(at == 0 && source.lines.empty() ? at : ++at));
    const pugi::xml_parse_result result = source.xml.load_buffer(
        text.data(), text.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
    if (!result)
      throw Error::at_line(file_of(source), line_at(source, result.offset), result.description(), "XML");
    check_elements(source.xml);
    const pugi::xml_node root = source.xml.child("materialx");
    if (!root) throw Error::at(file_of(source), "no element materialx", "a MaterialX document");
    const std::string_view version = root.attribute("version").value();
    if (version != "1.38" && version != "1.39")
      fail(root, "MaterialX " + (version.empty() ? "without a version" : in_quotes(version)),
           "version 1.38 or 1.39");
    roots_.push_back(root);
    open_.push_back(name.empty() ? std::filesystem::path(file_).filename().generic_string() : name);
    for (const pugi::xml_node each : root.children("xi:include")) include(each);
    open_.pop_back();
  }

  void include(const pugi::xml_node& at) {
    const std::string href = at.attribute("href").value();
    require_inside(href, line(at));
    const std::string name =
        (std::filesystem::path(open_.back()).parent_path() / href).lexically_normal().generic_string();
    if (!folder_) fail(at, "an included document, " + in_quotes(href, 80), "a file, whose folder holds it");
    if (std::ranges::count(open_, name) > 0)
      fail(at, in_quotes(name, 80) + " includes itself, or through others", "documents without a circle");
    if (static_cast<int>(open_.size()) > most_depth)
      fail(at, "documents that include each other to a depth of " + std::to_string(open_.size()),
           "at most 64");
    if (!included_.insert(name).second) return;
    const std::string text = folder_(name);
    bytes_ += text.size();
    if (bytes_ > most_document_bytes) fail(at, "more than 64 MiB of included documents");
    load(text, name);
  }

  static std::size_t line_at(const Source& source, std::ptrdiff_t offset) {
    return static_cast<std::size_t>(std::ranges::upper_bound(source.lines, offset) - source.lines.begin());
  }
  std::string file_of(const Source& source) const {
    if (source.name.empty()) return file_;
    return (std::filesystem::path(file_).parent_path() / source.name).generic_string();
  }
  const Source& source_of(const pugi::xml_node& at) const {
    return *std::ranges::find_if(sources_, [&](const Source& each) { return each.xml == at.root(); });
  }
  std::size_t line_at(const pugi::xml_node& at) const { return line_at(source_of(at), at.offset_debug()); }
  [[noreturn]] void fail(const pugi::xml_node& at, const std::string& found,
                         std::string_view expected = {}) const {
    throw Error::at_line(file_of(source_of(at)), line_at(at), found, expected);
  }
  std::string line(const pugi::xml_node& at) const {
    return file_of(source_of(at)) + ":" + std::to_string(line_at(at));
  }
  std::string place(const pugi::xml_node& at) const {
    const std::string& name = source_of(at).name;
    return (name.empty() ? "" : printable(name, 80) + ", ") + "line " + std::to_string(line_at(at));
  }

  // Every element but the texts that a document does not need.
  void check_elements(pugi::xml_node at) const {
    int depth = 0;
    while (true) {
      if (at.type() == pugi::node_doctype) fail(at, "a document type, which can hold entities", "none");
      if (at.first_child()) {
        at = at.first_child();
        if (++depth > most_depth)
          fail(at, "elements inside of each other to a depth of " + std::to_string(depth), "at most 64");
        continue;
      }
      while (!at.next_sibling() && at.parent()) {
        at = at.parent();
        --depth;
      }
      if (!at.next_sibling()) return;
      at = at.next_sibling();
    }
  }

  void list_nodes(Scope& scope) {
    for (const pugi::xml_node element : scope.elements)
      for (const pugi::xml_node node : element.children())
        if (node.type() == pugi::node_element) list_node(scope, node);
  }
  void list_node(Scope& scope, const pugi::xml_node& node) {
    const std::string_view kind = node.name();
    if (kind == "xi:include" && scope.graph)
      fail(node, "an included document inside of a graph", "in the element materialx");
    const bool other = is_word_of(other_elements, kind);
    if (!other && !is_word_of(node_kinds, kind) && !own_kinds_.contains(kind))
      fail(node, "a node of the unknown kind " + in_quotes(kind),
           "a node of MaterialX 1.39, or one that the document defines");
    if (other && kind != "output" && kind != "nodegraph") return;
    const std::string name = node.attribute("name").value();
    if (name.empty()) fail(node, "an element " + in_quotes(kind) + " without a name");
    if (!scope.nodes.emplace(name, Scope::Node{links_.size(), node}).second)
      fail(node, "two elements of the name " + in_quotes(name) + " in one place", "names of their own");
    links_.push_back({name, place(node), {}});
  }

  // The element of that name, in the scope of the input.
  std::size_t found(const Scope& scope, const pugi::xml_node& input, const char* attribute) const {
    const std::string_view name = input.attribute(attribute).value();
    const auto at = scope.nodes.find(name);
    if (at != scope.nodes.end()) return at->second.link;
    fail(input,
         std::string(input.name()) + " " + in_quotes(input.attribute("name").value()) + " reads " +
             in_quotes(name) + ", which is not there",
         "the name of a node");
  }

  // What an input or output of the node reads.
  void link_input(const Scope& scope, std::size_t from, const pugi::xml_node& input) {
    std::vector<std::size_t>& reads = links_[from].reads;
    if (input.attribute("nodename")) reads.push_back(found(scope, input, "nodename"));
    if (input.attribute("nodegraph")) reads.push_back(found(scopes_.front(), input, "nodegraph"));
    if (std::string_view(input.attribute("type").value()) == "filename")
      require_inside(std::string(inherited(input, "fileprefix")) + input.attribute("value").value(),
                     line(input));
  }

  // A graph reads what its inputs read, and its outputs, which are the ends of what stands in it.
  void link_nodes(const Scope& scope) {
    const auto graph =
        scopes_.front().nodes.find(std::string_view(scope.elements.front().attribute("name").value()));
    for (const auto& [name, node] : scope.nodes) {
      const bool output = std::string_view(node.element.name()) == "output";
      if (output) link_input(scope, node.link, node.element);
      if (output && scope.graph) links_[graph->second.link].reads.push_back(node.link);
      for (const pugi::xml_node input : node.element.children("input")) link_input(scope, node.link, input);
    }
  }

  // An attribute that holds for what stands below it too.
  static std::string_view inherited(pugi::xml_node node, const char* name) {
    for (; node; node = node.parent())
      if (const auto found = node.attribute(name)) return found.value();
    return {};
  }

  std::vector<double> numbers_of(const pugi::xml_node& input) const {
    const std::string_view type = input.attribute("type").value(), text = input.attribute("value").value();
    const std::map<std::string_view, std::size_t> counts{{"float", 1},  {"integer", 1}, {"color3", 3},
                                                         {"color4", 4}, {"vector2", 2}, {"vector3", 3},
                                                         {"vector4", 4}};
    const auto count = counts.find(type);
    if (count == counts.end()) return {};
    std::vector<double> out;
    for (const std::string& part : parts_of(text, ',')) {
      const std::size_t first = part.find_first_not_of(" \t\n\r"), last = part.find_last_not_of(" \t\n\r");
      double value = 0;
      if (first == part.npos || !parse_number(std::string_view(part).substr(first, last - first + 1), value))
        fail(input, "input " + in_quotes(input.attribute("name").value()) + ": " + in_quotes(text),
             "numbers");
      out.push_back(value);
    }
    if (out.size() != count->second)
      fail(input, "input " + in_quotes(input.attribute("name").value()) + ": " + in_quotes(text),
           std::to_string(count->second) + " numbers of a " + std::string(type));
    return out;
  }

  // The element that holds the input's number: itself, a constant that it reads, or nothing.
  pugi::xml_node valued(const Scope& scope, const pugi::xml_node& input) const {
    if (input.attribute("value") && !input.attribute("nodename") && !input.attribute("nodegraph"))
      return input;
    const auto source = scope.nodes.find(std::string_view(input.attribute("nodename").value()));
    if (source == scope.nodes.end() || std::string_view(source->second.element.name()) != "constant")
      return {};
    const pugi::xml_node value = source->second.element.find_child_by_attribute("input", "name", "value");
    return value.attribute("value") ? value : pugi::xml_node();
  }

  SurfaceInput input_of(const Scope& scope, const std::string& model, const pugi::xml_node& input) const {
    SurfaceInput out{input.attribute("name").value(), place(input), {}};
    const pugi::xml_node from = valued(scope, input);
    if (from) out.values = numbers_of(from);
    const ModelInput* known = model_input(model, out.name);
    const bool color = known != nullptr && known->type == InputType::color && known->meaning != Meaning::n &&
                       known->meaning != Meaning::k;
    if (color && out.values.size() == 3) take_color_space(out, inherited(from, "colorspace"));
    return out;
  }

  DocumentSurface surface_of(const Scope& scope, const pugi::xml_node& node) const {
    const std::string name = node.attribute("name").value();
    const auto material = materials_.find(name);
    DocumentSurface out{material == materials_.end() ? name : material->second, node.name(), place(node)};
    std::set<std::string> seen;
    for (const pugi::xml_node input : node.children("input")) {
      out.inputs.push_back(input_of(scope, out.model, input));
      if (!seen.insert(out.inputs.back().name).second)
        fail(input, "a second input " + in_quotes(out.inputs.back().name), "each input once");
    }
    return out;
  }

  const std::string& file_;
  const DocumentFolder& folder_;
  std::list<Source> sources_;
  std::vector<pugi::xml_node> roots_;  // of the sources
  // Names of the sources that are being read, each included by the one before.
  std::vector<std::string> open_;
  std::set<std::string> included_;
  std::size_t bytes_ = 0;  // of included documents
  std::set<std::string, std::less<>> own_kinds_;
  std::map<std::string, std::string, std::less<>> materials_;  // by the name of their surface
  std::vector<Scope> scopes_;
  std::vector<NodeLinks> links_;
};

}  // namespace

std::vector<DocumentSurface> surfaces_of_material_x(std::string_view text, const std::string& file,
                                                    const DocumentFolder& folder) {
  if (text.size() > most_document_bytes) throw Error::at(file, "more than 64 MiB", "a MaterialX document");
  return Document(text, file, folder).surfaces();
}

}  // namespace etak

#else

namespace etak {

std::vector<DocumentSurface> surfaces_of_material_x(std::string_view, const std::string& file,
                                                    const DocumentFolder&) {
  throw Error::at(file, "a MaterialX document, which this etak was built without a reader for");
}

}  // namespace etak

#endif
