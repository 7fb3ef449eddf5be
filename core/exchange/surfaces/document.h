// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

// Materials that documents of other programs hold: MaterialX, glTF, USD, and tables of values. Their readers give what
// the file says, input by input; meaning.h says what that is to a surface.

/// An input of a surface.
///   name         as the file writes it: "base_color", "KHR_materials_ior.ior"
///   place        of it in the file: "line 12", or a JSON pointer
///   values       one number or several; of a colour linear sRGB where its space is known. Empty: a picture or another node
///                gives the value, or it is no number
///   written      the numbers as they stand in the file, where a colour space has changed them; else empty
///   problem      what is wrong with it besides its numbers ("the colour space "x" is not known"); empty: nothing
struct SurfaceInput {
  std::string name, place;
  std::vector<double> values, written = {};
  std::string problem = {};
  friend bool operator==(const SurfaceInput&, const SurfaceInput&) = default;
};

/// A surface of a document.
///   name     of its material
///   model    of shading, an id of models.h: "open_pbr_surface"
///   place    as that of an input
///   looked_at   its colours are also judged as pictures (glTF)
struct DocumentSurface {
  std::string name, model, place;
  std::vector<SurfaceInput> inputs = {};
  bool looked_at = false;

  /// The input of that name; null: it stays at its default.
  const SurfaceInput* input(std::string_view input_name) const;
  friend bool operator==(const DocumentSurface&, const DocumentSurface&) = default;
};

/// The largest document that is read, in bytes.
inline constexpr std::size_t most_document_bytes = std::size_t{64} << 20;

/// Makes linear sRGB of an input's three numbers, and keeps those that are written; an unknown space is its problem.
///   space   what the file calls its colour space; empty: it is linear sRGB already
void take_color_space(SurfaceInput& input, std::string_view space);

/// Throws Error for the name of a file that does not lie in the document's folder or below it: with "..", absolute, or
/// with a scheme ("https:").
///   place   for the message
void require_inside(std::string_view file, std::string_view place);

/// A node of a document, and the nodes that it reads.
struct NodeLinks {
  std::string name, place;
  std::vector<std::size_t> reads = {};  // indices into the list of nodes
};
/// Throws Error where nodes read each other in a circle; it names one of them.
void require_no_loop(const std::vector<NodeLinks>& nodes, std::string_view file);

/// The surfaces of a USD layer in text form (.usda): shaders of UsdPreviewSurface, and of MaterialX's models where their
/// info:id names one (ND_open_pbr_surface_surfaceshader).
/// Throws Error with the line: the binary form (.usdc), a package (.usdz), broken text, numbers that are none, shaders of an unknown
/// id, connections in a circle or to nothing, other layers (references, sublayers,
/// payloads), files outside of the folder, depth of more than 64.
std::vector<DocumentSurface> surfaces_of_usda(std::string_view text, const std::string& file);

/// Whether a text begins as a table that `etak export --to values --format csv` writes.
bool is_value_table(std::string_view head);

/// The surfaces of such a table, one for each material and target, with the fields that the target takes; rows without a
/// text tell what a target shows and are no fields. Throws Error with the line: a missing column, numbers that are none, a target that is not known.
std::vector<DocumentSurface> surfaces_of_table(std::string_view text, const std::string& file);

/// The text of another file of the folder in which a document lies, by its name relative to that. Throws Error.
using DocumentFolder = std::function<std::string(const std::string& name)>;

/// The surfaces of a MaterialX document of version 1.38 or 1.39 (etak::material_x), and of those that it includes. Inputs are
/// followed to `constant` nodes; what other nodes give is not known.
///   folder   none: a document that includes others is refused
/// Throws Error with the line: broken XML, a document type (entities), nodes of an unknown kind or name, nodes in a circle, numbers that
/// are none, files outside of the folder, documents that include each other, depth of more than 64.
std::vector<DocumentSurface> surfaces_of_material_x(std::string_view text, const std::string& file,
                                                    const DocumentFolder& folder = {});

/// Whether a text begins as one of these documents.
bool is_surface_document(std::string_view head);

/// The surfaces of any of these documents, by its first bytes and its ending (etak::material_x), and of documents that it
/// includes from its folder or below. Throws Error, also for included files that are not there or behind a link that leads out of the
/// folder.
///   label   of the file in messages
///   read    takes the paths of the included files
std::vector<DocumentSurface> surfaces_of_document(const std::string& path, const std::string& label,
                                                  std::vector<std::string>* read = nullptr);

}  // namespace etak
