// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/color/gloss.h"
#include "core/exchange/material_input.h"
#include "core/exchange/table.h"
#include "core/material/f0/f0_settings.h"
#include "core/material/library.h"
#include "core/render/typed.h"

namespace etak::cli {

/// The materials that a run knows: the built-in library, then the folders of ETAK_LIBRARY, then those of
/// --library. It is opened when first used, because most runs over files look up no name.
class Library {
 public:
  std::vector<std::string> folders;  // of --library

  const MaterialLibrary& get();
  /// The folders of ETAK_LIBRARY and of --library.
  std::vector<std::string> all_folders() const;
  /// The next get() reads the folders again.
  void forget() { library_.reset(); }
  LibraryWhenAsked when_asked() {
    return [this]() -> const MaterialLibrary& { return get(); };
  }

 private:
  std::optional<MaterialLibrary> library_;
};
void add_library_options(Command verb, Library& library);

/// Adds --class, which may be given more than once.
void add_class_option(Command verb, std::vector<std::string>& classes, const std::string& help);

/// Adds the options that say how F0 is computed: those of the spectrum, and of the colour space.
void add_compute_options(Command verb, F0Settings& settings);
/// Adds the options of the spectrum alone.
void add_solver_options(Command verb, F0Settings& settings);
/// The options of the line as values. Throws Error that names the option and what it takes.
F0Options f0_options(const F0Settings& settings, Library& library);

/// Adds the options that say how tables are read.
void add_table_options(Command verb, TableSettings& settings);

/// Adds -j N. `threads` stays 0 where the option is not given: thread_count() knows what that means.
void add_thread_option(Command verb, unsigned& threads);

/// Adds an option that takes a colour as typed_color() reads it (core/render/typed.h).
void add_color_option(Command verb, const char* name, std::string& value, const char* help);

/// The colour of --emission. Throws Error for a channel below 0.
LinearRgb typed_emission(std::string_view text);

/// The roughness of a surface as given on the line: --gloss or --roughness.
struct RoughnessArguments {
  std::optional<double> gloss, roughness;
};

/// Adds --gloss and --roughness.
///   whose   the object of the help's texts: "of the surface"
void add_roughness_options(Command verb, RoughnessArguments& arguments, const char* whose);

/// given_gloss() of core/color/gloss.h.
inline std::optional<Gloss> given_gloss(const RoughnessArguments& arguments) {
  return etak::given_gloss(arguments.gloss, arguments.roughness);
}

/// Adds --allow-empty, for scripts whose list of --files-from may be empty.
void add_allow_empty_option(Command verb, bool& allow_empty);

/// The error for a list of --files-from that names nothing. Without --allow-empty that is an error, because
/// most often the program that made the list has failed.
Error empty_list(const std::string& list);

/// Adds --follow-links to a verb that reads files named by scenes, manifests and folders
/// (core/base/files/links.h).
void add_follow_links(Command verb);

/// Adds --input-timeout to every verb of `line`.
void add_input_timeout(CommandLine& line);

}  // namespace etak::cli
