// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/atlas/layout.h"
#include "core/atlas/leave_out.h"
#include "core/atlas/manifest.h"
#include "core/atlas/outputs.h"
#include "core/atlas/plan.h"
#include "core/atlas/sources/sources.h"
#include "core/atlas/variant.h"
#include "core/base/files/file_stamp.h"
#include "core/material/library.h"
#include "core/pack/blocks/compress_options.h"
#include "core/pack/settings.h"
#include "core/pack/totals.h"

namespace etak {

class Output;        // core/base/files/output.h
class OutputFolder;  // core/base/files/output_folder.h
class PagePixels;    // core/atlas/texels/page_pixels.h
struct PackedScene;  // core/pack/scene/gltf_pack.h

// From a list of materials to an atlas on disk. The target is etak::pack, which is no part of etak::core
// because it reads and writes picture files.

using PageCheck = std::function<bool(const AtlasLayout&, int page, const PagePixels&)>;
/// A check of a page whose PNG files are written but not yet in place.
using WrittenPageCheck =
    std::function<bool(const AtlasLayout&, int page, const std::function<std::string(Texture)>& path)>;

struct PackResult;

/// A manifest in memory, in the place of a file.
///   remarks    what had to be changed to get there; they come first in the report
///   settings   all that decides the result besides the bytes of the pictures: an atlas of other settings is
///              not up to date
struct PackManifest {
  AtlasManifest manifest;
  std::vector<std::string> remarks;
  std::string settings;
};

/// The input, and how it is read.
struct PackInputOptions {
  // Asked of every JSON file: the manifest that it stands for where it is none itself, such as a project.
  // Empty: every one is a manifest.
  std::function<std::optional<PackManifest>(const std::string& text, const std::string& file)> other_manifest;
  std::string pattern;  // of a folder, as "{name}_{role}.png"; empty: see manifest_in_folder() of source.h
  GltfOptions gltf;
  PictureReading pictures;
  std::string space_config;  // the file that pictures.open_space reads; empty: none
};

/// The parts that the atlas need not hold.
struct PackLeaveOutOptions : LeaveOutOptions {
  std::optional<ShadingVariants> variants;  // what etak choose found: defines, flat textures, unread mips
  // Where fewer texels do: differences up to `max_error` (CIEDE2000; and percent of alpha and gloss) against
  // what is seen; below so many texels per unit of a scene's world, and in pictures of so many pixels' height
  // from its cameras, nothing is. None and 0: resolutions stay.
  std::optional<double> max_error;
  double texel_density = 0;
  int view_height = 0;
};

/// Where the regions go.
struct PackLayoutOptions {
  int page = 4096;
  std::optional<PageForm> form;  // none: mixed; for scenes one free page where that holds everything
  int multiple = 1;              // of which the sides of pages are, but for those whose edges wrap
  bool rotate = false;
  int effort = 100;
  double max_seconds = 0;
  std::optional<int> gutter;          // none: from the mips
  std::optional<int> viewers_gutter;  // where none is asked for, of a scene's pages whose mips viewers make
  std::optional<int> mips;            // levels; 0: down to 1 x 1; none: 1, or all where a format holds them
  std::string previous;               // layout.json of an earlier run; empty: none
  double most_extra_area = 0.05;
};

/// The files that are written, and which existing files they may replace.
struct PackOutputOptions {
  WriteOptions write;
  CompressOptions compress;  // of KTX2 and DDS files
  std::vector<GltfForm> forms{GltfForm::specular_ior};
  bool smallest_form = false;     // of the exact ones the one whose textures weigh least, in place of `forms`
  PackGoal goal = PackGoal::gpu;  // what is weighed of a scene; files of PNG are the ones that count
  bool one_file = false;          // scene.glb in place of scene.gltf and what lies beside it
  bool webp = false;              // PNG files of the scene become lossless WebP where that is smaller
  bool bleed = false;
  bool overwrite = false;
  bool update = false;   // nothing is done when the result in place is of the same input and options
  bool dry_run = false;  // everything but writing
};

/// How the work is done: memory, threads, progress.
struct PackRunOptions {
  std::size_t memory = 0;  // bytes that pages and decoded pictures may take; 0: any
  unsigned threads = 1;
  std::size_t block_pictures = 0;  // that the result has at most
  std::string version;             // of the program: part of the settings
  std::function<void(std::size_t done, std::size_t all)> progress;
  std::function<bool()> cancelled;  // asked between regions, pages and stages, from any thread; true: stop
};

/// Functions that check the result before it is in place.
struct PackCheckHooks {
  // Told of a glTF scene before its first page.
  std::function<void(const PackedScene&)> scene;
  // Called with every page when its pixels are whole, before they are written; says whether they are good
  // enough. Pages begin again at 0 when what later ones teach changes the layout, whose hashes are not known
  // yet. Last comes the number of pages, for materials that are on none. An atlas with a page that is not
  // good enough is written, but never up to date.
  PageCheck page;
  // Called in place of `page` for pages that are never whole in memory; without it they are made whole for `page`.
  WrittenPageCheck written_page;
  std::string settings;  // what the check goes by: part of the settings
  // Asked when all files of the atlas are on the disk and none is in place, also in a dry run. What it gives
  // (or null) is put in place together with the atlas; it may write files into the folder as well, which is
  // null in a dry run.
  std::function<std::unique_ptr<Output>(PackResult&, OutputFolder*)> beside;
};

/// All that pack() is told beside its input and its target.
struct PackOptions {
  PackInputOptions input;
  PackLeaveOutOptions leave_out;
  PackLayoutOptions layout;
  PackOutputOptions output;
  PackRunOptions run;
  PackCheckHooks check;
};

/// What a person wrote, as values. Throws Error that names the setting. Left to the caller: the input's
/// pictures and their spaces, what may be overwritten, the run and the check.
PackOptions pack_options(const PackSettings& settings);

/// The bytes that the setting memory stands for: a number, with K, M or G behind it for more; empty: 0, which
/// means any. Throws Error.
std::size_t memory_setting(const std::string& text);

/// The path of the OpenColorIO config in use, because a change of its bytes is a change of the input; empty
/// where it is etak's own.
///   asked   that a setting names; empty: that of $OCIO
std::string space_config_file(const std::string& asked);

/// Thrown by pack() when PackOptions::cancelled said so: the folder is as it was.
class PackCancelled : public std::runtime_error {
 public:
  PackCancelled() : std::runtime_error("packing was cancelled") {}
};

/// A region that was stored with fewer texels.
struct ReducedRegion {
  std::string material;
  int width = 0, height = 0;                // of what it shows
  int stored_width = 0, stored_height = 0;  // of what was stored
  double seen_delta_e = 0;                  // against what can be seen at most
  double delta_e = 0, codes = 0;            // against level 0
};

/// The time that one stage of pack() took.
struct PackStage {
  std::string name;
  double seconds = 0;
};

/// What materials that were packed to one page would take on pages of their own, as PackGoal::gpu lays them.
struct PagesApart {
  std::size_t pages = 0, without_texels = 0;  // pairs to bind; materials of numbers alone, which are on none
  std::uint64_t gpu = 0;                      // bytes, uncompressed with all mips
};

/// What pack() did; report_text() and report_json() write it.
struct PackResult {
  std::string input, output;
  bool up_to_date = false, dry_run = false;
  AtlasLayout layout;  // that of the folder; of a result that was up to date too
  std::size_t materials = 0, regions = 0;
  std::vector<PlannedPage> pages;
  std::uint64_t region_texels = 0, gutter_texels = 0, waste_texels = 0;  // level 0, both textures
  LeaveOut left_out;                                                     // fates are emptied
  std::string method;
  int tries = 0, levels = 1;
  bool cut_by_time = false, kept_previous = false, inset = false;
  std::size_t moved = 0;
  // The level from which on the mips that a viewer makes of whole pages mix the texels of neighbours, for a scene whose
  // samplers read mips. None where no region has a neighbour.
  std::optional<int> mixed_from;
  int passes = 1;  // 2: what the texels taught changed the layout
  std::vector<std::string> files, remarks;
  std::vector<std::pair<std::string, FileStamp>> inputs;  // files that were read, as they were first seen
  std::vector<PackStage> stages;
  std::vector<ReducedRegion> reduced;
  std::optional<PackTotals> totals;  // none where nothing was written
  std::vector<FormCost> forms;       // of a scene
  PackGoal goal = PackGoal::gpu;     // by which they were weighed
  // How the texels of a scene lie whose files were weighed, what is read of it in the end, and what that would be by
  // other goals.
  std::string way;
  std::vector<GoalCost> other_goals;
  std::optional<PagesApart> apart;           // of PackGoal::one_page, where there are such pages
  std::vector<BlockLevel> blocks;            // of textures that were compressed, or were tried to be
  std::vector<BlockPicture> block_pictures;  // of the materials that look most changed, those first
  std::string validation;  // JSON of the validator's report on the pages; empty: they were not checked
  GlossForm gloss = GlossForm::schueler;
};

/// Packs one input into the folder `output`: all files of it appear at once, or none.
///   input   manifest or what options.input.other_manifest knows (.json), glTF scene (.gltf, .glb) or
///           folder of pictures
/// Throws Error, and PackCancelled.
PackResult pack(const std::string& input, const std::string& output, const PackOptions& options,
                const MaterialLibrary& library);

/// Packs a manifest in memory.
///   label   what the result calls it
PackResult pack(const PackManifest& manifest, const std::string& label, const std::string& output,
                const PackOptions& options, const MaterialLibrary& library);

std::string report_text(const PackResult& result, bool stages);
std::string report_json(const PackResult& result, bool stages);

}  // namespace etak
