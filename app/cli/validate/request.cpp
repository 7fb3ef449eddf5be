// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate/validate.h"

#include <utility>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/options/shard.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/validate/changed.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/number.h"
#include "core/findings/baseline.h"
#include "core/judge/nearest.h"

namespace etak::cli {

std::shared_ptr<const KnownMaterials> asked_materials(Library& library) {
  if (library.folders.empty() && environment_libraries().empty()) return nullptr;
  return std::make_shared<const KnownMaterials>(library.get());
}

ValidationRequest validation_request(ValidateArguments& arguments) {
  ValidationRequest out;
  auto known = asked_materials(arguments.library);
  out.config = validate_config(arguments.settings, arguments.paths.empty() ? "" : arguments.paths.front(),
                               std::move(known));
  for (const std::string& each : out.config.remarks) remark(arguments.output, each);
  out.inputs.list = arguments.files_from;
  if (!arguments.files_from.empty()) out.inputs.listed = ListedNames(arguments.files_from).take();
  if (!arguments.changed_since.empty()) {
    if (!arguments.files_from.empty())
      throw Error::at("--changed-since", "is given beside --files-from", "one of both");
    arguments.allow_empty = true;
    out.inputs.list = "--changed-since " + printable(arguments.changed_since);
    Changed changed = changed_since(arguments.changed_since, arguments.paths);
    out.inputs.listed = std::move(changed.files);
    out.inputs.paths = std::move(changed.folders);
  } else {
    out.inputs.paths = arguments.paths;
  }
  if (out.inputs.paths.empty() && out.inputs.listed.empty() && !arguments.allow_empty)
    throw empty_list(arguments.files_from);
  out.inputs.manifest.material = arguments.material;
  out.inputs.manifest.surface_class = arguments.surface_class;
  if (!arguments.role.empty()) {
    out.inputs.role = role_named(arguments.role);
    if (!out.inputs.role) throw Error::at("--role", printable(arguments.role), picture_roles);
  }
  out.allowed.today = arguments.today;
  if (!arguments.baseline.empty())
    out.allowed.known = read_baseline(read_file(arguments.baseline), arguments.baseline);
  out.allowed.renew_known = !arguments.write_baseline.empty();
  out.run.door = picture_door();
  out.memory.cache = cache_options(arguments.cache);
  out.memory.before = arguments.before;
  out.memory.version = ETAK_VERSION;
  out.must_check = !arguments.allow_empty;
  out.inputs.pass_unknown = arguments.allow_empty;
  // JSON is the only form that holds hashes of the files.
  out.hashes = arguments.output.format == "json";
  out.run.threads = thread_count(arguments.threads);
  out.part.shard = asked_shard(arguments.shard);
  out.part.line_digest = arguments.line_digest;
  out.part.verdict = verdict_options(arguments);
  return out;
}

}  // namespace etak::cli
