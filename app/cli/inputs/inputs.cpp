// SPDX-License-Identifier: Apache-2.0
#include "app/cli/inputs/inputs.h"

#include <sys/stat.h>

#include <algorithm>
#include <set>

#include "core/base/ascii.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/memory.h"
#include "core/exchange/content_kind.h"
#include "core/exchange/data_folder.h"
#include "core/exchange/rii_page.h"
#include "core/exchange/table.h"
#include "core/material/find.h"
#include "core/material/json.h"
#include "core/material/names.h"

namespace etak::cli {
namespace {

Input failed(std::string message) {
  Input out;
  out.path = std::move(message);
  return out;
}

Input::Kind input_kind(DataFileKind kind) {
  if (kind == DataFileKind::page) return Input::Kind::page;
  if (kind == DataFileKind::table) return Input::Kind::table;
  return Input::Kind::material_file;
}

void add_folder(const std::string& path, const InputArguments& arguments, unsigned threads,
                std::vector<std::string>* remarks, std::vector<Input>& out) {
  Folder folder = list_folder(path, threads);
  if (remarks != nullptr && !folder.skipped.empty()) remarks->push_back(skipped_remark(folder.skipped));
  if (folder.files.empty() && folder.unreadable.empty())
    throw Error::at(path, "is a folder without any page, table or material file",
                    "files ending in .yml, .csv, .tsv, .txt, .dat or .json");
  for (std::string& message : folder.unreadable) out.push_back(failed(std::move(message)));
  out.reserve(out.size() + folder.files.size());
  for (std::string& file : folder.files) {
    Input& input = out.emplace_back();
    input.kind = input_kind(data_file_kind(file));
    input.path = std::move(file);
    input.label_at = folder.root.size();
    input.from_folder = true;
    input.dataset = arguments.dataset;
  }
}

// `dataset` as datasets_named() has it; empty: the preferred one, or every one where all are asked for.
//   label   id of the material, or the file that it was read from
void add_datasets(Material read, std::string dataset, const InputArguments& arguments,
                  const std::string& label, std::string_view asked, std::vector<Input>& out) {
  if (dataset.empty() && arguments.all_datasets) dataset = "*";
  Input input;
  input.kind = Input::Kind::material;
  input.path = label;
  const auto material = std::make_shared<const Material>(std::move(read));
  input.material = material;
  if (const std::string_view note = alias_note(*material, asked); !note.empty())
    input.alias_note = printable(asked) + ": " + std::string(note);
  if (dataset.empty()) {
    out.push_back(std::move(input));
    return;
  }
  for (const Dataset* each : datasets_named(*material, dataset, label)) {
    input.path = label + '/' + each->id;
    input.dataset = each->id;
    out.push_back(input);
  }
}

// "id" or "id/dataset" of the library; false when the library does not know the id.
bool add_material(const std::string& name, const InputArguments& arguments, Library& library,
                  bool path_exists, std::vector<Input>& out) {
  auto found = find_material(library.get(), name);
  if (!found) return false;
  const bool whole = found->name == name;
  if (!whole && path_exists && found->material.dataset(found->dataset) == nullptr) return false;
  const std::string id = found->material.id;
  add_datasets(std::move(found->material), whole ? arguments.dataset : found->dataset, arguments, id,
               found->name, out);
  return true;
}

// Material files among the inputs from `first` on, in place of which come their datasets. One that cannot be
// read stays, so that its reader says why.
void open_datasets(const InputArguments& arguments, std::size_t first, std::vector<Input>& out) {
  std::vector<Input> closed(std::make_move_iterator(out.begin() + static_cast<std::ptrdiff_t>(first)),
                            std::make_move_iterator(out.end()));
  out.resize(first);
  for (Input& input : closed) {
    const std::size_t begin = out.size();
    if (input.kind != Input::Kind::material_file || !input.dataset.empty()) {
      out.push_back(std::move(input));
      continue;
    }
    try {
      add_datasets(parse_material(read_file(input.path), input.path), {}, arguments, input.path, {}, out);
      for (std::size_t i = begin; i < out.size(); ++i) {
        out[i].label_at = input.label_at;
        out[i].from_folder = input.from_folder;
      }
    } catch (const Error&) {
      out.push_back(std::move(input));
    }
  }
}

// What comes from a pipe: as --stdin-format says, else by its first bytes.
Input::Kind kind_of_pipe(const std::string& path, const std::string& format) {
  if (format == "page") return Input::Kind::page;
  if (format == "json") return Input::Kind::material_file;
  if (format == "table") return Input::Kind::table;
  constexpr const char* expected = "a page, a table or a material file";
  switch (content_kind(read_head(path, content_head))) {
    case ContentKind::gltf:
      throw Error::at(path, "holds a glTF scene", expected);
    case ContentKind::binary:
      throw Error::at(path, "holds no text", expected);
    case ContentKind::page:
      return Input::Kind::page;
    case ContentKind::json:
      return Input::Kind::material_file;
    case ContentKind::table:
    case ContentKind::prose:
      break;
  }
  return Input::Kind::table;  // whose reader says what is missing
}

// A known name wins over a file or folder of that name ("./gold" is the folder); what ends like a data file
// or begins like a path is one.
void add_name(const std::string& name, const InputArguments& arguments, Library& library, unsigned threads,
              std::vector<std::string>* remarks, std::vector<Input>& out) {
  Input input;
  input.path = name;
  input.dataset = arguments.dataset;
  struct stat info {};
  const bool exists = ::stat(name.c_str(), &info) == 0;
  const DataFileKind kind = data_file_kind(name);
  const bool pipe = is_pipe_input(name);
  const bool path_like = name.starts_with('/') || name.starts_with('.') || name.ends_with('/') ||
                         (pipe && typed_input(name) != name);
  if (!path_like && kind == DataFileKind::unknown && add_material(name, arguments, library, exists, out))
    return;
  if (exists && S_ISDIR(info.st_mode)) return add_folder(name, arguments, threads, remarks, out);
  if (pipe && kind == DataFileKind::unknown) {
    input.kind = kind_of_pipe(name, arguments.stdin_format);
    out.push_back(std::move(input));
    return;
  }
  if (kind == DataFileKind::unknown && exists && S_ISREG(info.st_mode))
    throw Error::at(name, "has no ending that etak knows",
                    ".yml, .csv, .tsv, .txt, .dat or .json, or - for standard input");
  if (!exists && !path_like && kind == DataFileKind::unknown) unknown_material(name, library.get());
  // A missing file or a device goes on to the reader, whose message tells why.
  input.kind = kind == DataFileKind::unknown ? Input::Kind::material_file : input_kind(kind);
  out.push_back(std::move(input));
}

// "path/to/My sample.csv" gives "my_sample".
std::string id_from_file(std::string_view path, char blank) {
  path = path.substr(path.rfind('/') + 1);
  path = path.substr(0, path.rfind('.'));
  const std::string out = identifier(path, blank);
  return out.empty() ? "table" : out;
}

Material material_from_table(std::string_view text, const std::string& path, const TableOptions& options,
                             std::string_view id) {
  Table table = parse_table(text, path, options);
  Material out;
  out.id = id.empty() ? id_from_file(path, '_') : std::string(id);
  out.name = out.id;
  out.material_class = "solid";
  out.preferred_reason = "the only dataset";
  Dataset& dataset = out.datasets.emplace_back();
  dataset.id = id_from_file(path, '-');
  dataset.optics = std::move(table.optics);
  dataset.flags = table.flags;
  dataset.citation.title = path.substr(path.rfind('/') + 1);
  return out;
}

}  // namespace

void add_input_options(Command verb, InputArguments& arguments) {
  verb.option("INPUT", arguments.names,
              "material (gold), dataset (gold/ID, its unique beginning, or gold/* for all), file "
              "(.yml page, .json material, .csv .tsv .txt .dat table), folder, pipe, or - for "
              "standard input")
      .reads_file()
      .value_name("");
  verb.option("--stdin-format", arguments.stdin_format,
              "what - and pipes without an ending hold; auto: told by the first bytes")
      .one_of({"auto", "table", "page", "json"})
      .show_default();
}

void add_all_datasets_option(Command verb, InputArguments& arguments) {
  verb.flag("--all-datasets", arguments.all_datasets,
            "every dataset of each material, in place of the preferred one");
}

std::vector<Input> find_inputs(const InputArguments& arguments, Library& library, unsigned threads,
                               std::vector<std::string>* remarks) {
  std::vector<Input> out;
  if (arguments.all) {
    const MaterialLibrary& known = library.get();
    for (std::size_t i = 0; i < known.ids().size(); ++i)
      add_datasets(known.at(i), {}, arguments, known.ids()[i], {}, out);
    for (Input& input : out) input.from_folder = true;
  }
  for (const std::string& name : arguments.names) {
    try {
      const std::size_t first = out.size();
      add_name(name, arguments, library, threads, remarks, out);
      if (arguments.all_datasets) open_datasets(arguments, first, out);
    } catch (const Error& error) {
      out.push_back(failed(error.what()));
    }
  }
  return out;
}

ListedNames::ListedNames(const std::string& path)
    : text_(read_file(path)), separator_(text_.find('\0') != std::string::npos ? '\0' : '\n') {}

std::vector<std::string> ListedNames::take(std::size_t most) {
  std::vector<std::string> out;
  while (out.size() < most && at_ < text_.size()) {
    const std::size_t end = std::min(text_.find(separator_, at_), text_.size());
    std::string name = text_.substr(at_, end - at_);
    if (separator_ == '\n' && name.ends_with('\r')) name.pop_back();
    if (!name.empty()) out.push_back(std::move(name));
    at_ = end + 1;
  }
  return out;
}

std::size_t ListedNames::count() const {
  const bool open_end = !text_.empty() && text_.back() != separator_;
  return static_cast<std::size_t>(std::count(text_.begin(), text_.end(), separator_)) + (open_end ? 1 : 0);
}

std::vector<std::string> alias_remarks(const std::vector<Input>& inputs) {
  std::vector<std::string> out;
  std::set<std::string_view> seen;
  for (const Input& input : inputs)
    if (!input.alias_note.empty() && seen.insert(input.alias_note).second) out.push_back(input.alias_note);
  return out;
}

bool is_prose(const Input& input, std::string_view head) {
  if (!input.from_folder || input.kind != Input::Kind::table) return false;
  const std::string_view ending = std::string_view(input.path).substr(input.path.size() - 4);
  const bool any_text = ending == ".txt" || ending == ".TXT" || ending == ".dat" || ending == ".DAT";
  return any_text && content_kind(head) == ContentKind::prose;
}

std::vector<Input> find_tables(const InputArguments& arguments, Library& library, unsigned threads,
                               const OutputArguments& output) {
  std::vector<std::string> remarks;
  std::vector<Input> inputs = find_inputs(arguments, library, threads, &remarks);
  const auto prose = [](const Input& input) {
    if (!input.from_folder || input.kind != Input::Kind::table) return false;
    try {
      return is_prose(input, read_head(input.path, content_head));
    } catch (const Error&) {
      return false;  // whoever reads it says why it cannot be read
    }
  };
  if (const auto count = std::erase_if(inputs, prose); count > 0)
    remarks.push_back(std::to_string(count) + (count == 1 ? " text is no table" : " texts are no tables"));
  for (const std::string& each : remarks) remark(output, each);
  return inputs;
}

Material read_material(const Input& input, const TableOptions& tables, std::string_view id) {
  if (input.kind == Input::Kind::failed) throw Error(input.path);
  if (input.kind == Input::Kind::material) return *input.material;
  const std::string& name = input.path;
  const std::string text = read_file(name);
  return with_memory_for(
      name, [&] { return mebibytes(text.size()) + " of text"; },
      [&] {
        if (input.kind == Input::Kind::page) return material_from_rii_page(text, name, id);
        if (input.kind == Input::Kind::table) return material_from_table(text, name, tables, id);
        return parse_material(text, name);
      });
}

}  // namespace etak::cli
