// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <exception>
#include <memory>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "core/base/text/free_names.h"
#include "core/material/json.h"
#include "core/material/optics/optics_class.h"
#include "core/project/project_import.h"

namespace etak::cli {
namespace {

struct ImportArguments {
  InputNames inputs;
  std::string id, name;
  TableSettings tables;
  OutputArguments output;
  unsigned threads = 0;
  Library library;  // find_tables() needs one; materials of the library cannot be imported
};

struct Reading {
  Material material;
  std::exception_ptr failure;
};

Reading reading(const MaterialInput& input, const TableOptions& tables, const std::string& id) {
  Reading out;
  try {
    if (input.kind == MaterialInput::Kind::material)
      throw Error::at(input.path, "is a material of the library", "a page, table or material file");
    out.material = read_material(input, tables, id);
  } catch (const Error&) {
    out.failure = std::current_exception();
  }
  return out;
}

int import_inputs(ImportArguments& arguments) {
  const TableOptions tables = table_options(arguments.tables);
  if (arguments.inputs.names.empty()) throw Error::at("etak import", "no input", "a page or table");
  const unsigned threads = thread_count(arguments.threads);
  const std::vector<MaterialInput> inputs =
      find_tables(arguments.inputs, arguments.library, threads, arguments.output);
  // Inputs are read on all threads and then taken in their order, so that the first of several errors is
  // thrown.
  std::vector<Reading> readings(inputs.size());
  parallel_chunks(inputs.size(), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) readings[i] = reading(inputs[i], tables, arguments.id);
  });
  std::vector<Material> materials;
  for (Reading& read : readings) {
    if (read.failure) std::rethrow_exception(read.failure);
    materials.push_back(std::move(read.material));
  }
  Material material = merged(std::move(materials));
  if (!arguments.id.empty()) material.id = arguments.id;
  if (!arguments.name.empty()) material.name = arguments.name;
  if (material.datasets.size() > 1) material.preferred_reason = "the first of the imported datasets";
  const std::string text = format_material(material);
  // Reading the file again finds an --id that the schema does not allow.
  (void)parse_material(text, "the imported material");
  write_output(arguments.output, text);
  if (const std::string class_said = class_remark(material); !class_said.empty())
    remark(arguments.output, material.id + ": " + class_said);
  const auto unknown = std::count_if(material.datasets.begin(), material.datasets.end(),
                                     [](const Dataset& d) { return d.origin == Origin::unknown; });
  if (unknown > 0)
    remark(arguments.output,
           material.id + ": " + (unknown > 1 ? std::to_string(unknown) + " inputs do" : "the input does") +
               " not say whether the numbers were measured: origin unknown; --origin states it");
  return exit_ok;
}

// The materials of documents have colours and no spectra, so that they become a project.
int import_documents(const ImportArguments& arguments) {
  const TableSettings& t = arguments.tables;
  const TableSettings untouched;
  for (const auto& [option, given] :
       {std::pair{"--id", !arguments.id.empty()}, std::pair{"--unit", t.unit != untouched.unit},
        std::pair{"--columns", t.columns != untouched.columns},
        std::pair{"--duplicates", t.duplicates != untouched.duplicates},
        std::pair{"--class", t.material_class != untouched.material_class},
        std::pair{"--origin", t.origin != untouched.origin}})
    if (given) throw Error::at(option, "given with material documents", "pages or tables with it");
  Project project;
  std::vector<std::string> remarks;
  FreeNames taken = names_of(project);
  for (const std::string& path : arguments.inputs.names) {
    if (!holds_surfaces(path))
      throw Error::at(path, "a file of another kind beside a material document",
                      "material documents (.mtlx, .usda, .gltf, .glb) alone, or none");
    for (ProjectMaterial& material : imported_materials(path, remarks)) {
      material.name = free_name(taken, material.name);
      project.materials.push_back(std::move(material));
    }
  }
  if (!arguments.name.empty()) {
    if (project.materials.size() > 1)
      throw Error::at("--name", std::to_string(project.materials.size()) + " materials", "one");
    project.materials[0].name = arguments.name;
  }
  write_output(arguments.output, format_project(project, arguments.output.file));
  for (const std::string& each : remarks) remark(arguments.output, each);
  return exit_ok;
}

int run(ImportArguments& arguments) {
  const auto& names = arguments.inputs.names;
  const bool documents = std::ranges::any_of(names, holds_surfaces);
  return with_memory_for(
      names.size() == 1 ? names[0] : "etak import", [] { return "the material made of it"; },
      [&] { return documents ? import_documents(arguments) : import_inputs(arguments); });
}

}  // namespace

void add_import(CommandLine& line) {
  const auto arguments = std::make_shared<ImportArguments>();
  Command verb = line.verb("import", "pages or tables as one material file, material documents as a project");
  add_input_options(verb, arguments->inputs);
  verb.option("--id", arguments->id, "id of the material, [a-z0-9_] (default: from the page's folder)");
  verb.option("--name", arguments->name, "name of the material");
  add_table_options(verb, arguments->tables);
  add_output_options(verb, arguments->output, {"json"});
  add_thread_option(verb, arguments->threads);
  verb.footer(
      "Several inputs become datasets of one material; the first is preferred. Citation, sample and class are\n"
      "taken from a page as far as it tells them: read them over before the file joins a library.\n"
      "Materials of .mtlx, .usda, .gltf and .glb files become a project for etak-editor and etak pack.\n"
      "Example:\n  printf 'nm n k\\n400 1.5 3\\n700 1.6 4\\n' | etak import - --id sample --class metal");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
