// SPDX-License-Identifier: Apache-2.0
#include "app/cli/output/form.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/cli/output/output.h"
#include "app/cli/usage.h"
#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"

namespace etak::cli {
namespace {

struct Ending {
  std::string_view ending, form;
  std::string_view verb = {};  // the only verb that has this ending; empty: all
};

// A form may have several endings, and an ending several forms: the first form that the verb has is taken.
constexpr std::array endings{
    Ending{".txt", "table"},
    Ending{".txt", "text"},
    Ending{".csv", "csv"},
    Ending{".svg", "svg"},
    Ending{".png", "png"},
    Ending{".csv", "text", "etak eval"},  // the answers of --csv
    Ending{".sarif.json", "sarif"},
    Ending{".sarif", "sarif"},
    Ending{".json", "json"},
    Ending{".jsonl", "jsonl"},
    Ending{".ndjson", "jsonl"},
    Ending{".html", "html"},
    Ending{".htm", "html"},
    Ending{".md", "markdown"},
    Ending{".xml", "junit"},
    Ending{".glsl", "text", "etak shader"},
    Ending{".frag", "text", "etak shader"},
    Ending{".hlsl", "text", "etak shader"},
    Ending{".metal", "text", "etak shader"},
    Ending{".wgsl", "text", "etak shader"},
    Ending{".vert", "text", "etak shader"},
    Ending{".glsl", "text", "etak export"},
    Ending{".hlsl", "text", "etak export"},
    Ending{".h", "text", "etak export"},
    Ending{".usda", "text", "etak export"},
    Ending{".pbrt", "text", "etak export"},
    Ending{".xml", "text", "etak export"},  // of Mitsuba
    Ending{".py", "text", "etak export"},
    Ending{".gd", "text", "etak export"},
    Ending{".js", "text", "etak export"},
    Ending{".gltf", "gltf"},
    Ending{".glb", "glb"},
    Ending{".mtlx", "mtlx"},
};

// The name of a file without its folders, in lower case; empty for names without an ending: "x", "x.", ".x".
std::string name_with_ending(const std::string& file) {
  const std::string name = file.substr(file.rfind('/') + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || dot == 0 || dot + 1 == name.size()) return {};
  return lower_case(name);
}

bool fits(const Ending& ending, const std::vector<std::string>& formats, std::string_view verb) {
  return (ending.verb.empty() || ending.verb == verb) &&
         std::find(formats.begin(), formats.end(), ending.form) != formats.end();
}

// The endings that stand for one of these forms, each once.
std::vector<std::string> endings_of(const std::vector<std::string>& forms, std::string_view verb) {
  std::vector<std::string> out;
  for (const Ending& each : endings)
    if (fits(each, forms, verb) && each.ending != ".sarif.json" && (out.empty() || out.back() != each.ending))
      out.emplace_back(each.ending);
  return out;
}

}  // namespace

void settle_form(OutputArguments& arguments, const std::vector<std::string>& formats, const std::string& verb,
                 bool given) {
  const std::string name = name_with_ending(arguments.file);
  if (name.empty() || formats.size() < 2) return;
  std::string_view form;
  bool same = false;  // the form of --format has this ending too
  for (const Ending& each : endings) {
    if (!fits(each, formats, verb) || !name.ends_with(each.ending)) continue;
    if (form.empty()) form = each.form;
    same = same || each.form == arguments.format;
  }
  if (given) {
    if (!form.empty() && !same && arguments.format != "auto")
      remark(arguments, arguments.file + ": written as " + arguments.format + ", as --format asks");
    return;
  }
  if (form.empty()) {
    throw Error::at("-o",
                    printable(arguments.file, 200) + " has an ending that no form of " + verb + " goes with",
                    joined(endings_of(formats, verb)) + ", or --format beside it");
  }
  arguments.format = form;
  arguments.form_asked_by = "-o " + arguments.file;
}

void refuse_form(const OutputArguments& arguments, const std::string& verb, const std::string& beside,
                 const std::vector<std::string>& forms, const std::string& else_) {
  const bool by_ending = arguments.form_asked_by != "--format";
  std::string found = arguments.format + ' ' + beside;
  if (by_ending) {
    const std::string name = name_with_ending(arguments.file);
    for (const std::string& each : endings_of({arguments.format}, verb))
      if (name.ends_with(each)) {
        found = "its ending " + each + " asks for " + found;
        break;
      }
  }
  throw Error::at(arguments.form_asked_by, found,
                  (else_.empty() ? "" : else_ + ", or ") +
                      listed(by_ending ? endings_of(forms, verb) : forms, ", ", " or "));
}

}  // namespace etak::cli
