// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/cache.h"

#include "app/cli/output/replace.h"
#include "core/base/error.h"
#include "core/base/files/output_file.h"
#include "core/base/files/output_target.h"
#include "core/base/number.h"

namespace etak::cli {

void add_cache_options(Command verb, CacheArguments& arguments, const std::string& kept) {
  const auto add = [&](const char* name, std::string& value, const std::string& help, const char* takes) {
    return verb.option(name, value, help).value_name(takes).group("Cache").in_shards(InShards::free);
  };
  add("--cache", arguments.folder, "keep " + kept + "; any number of machines may share DIR", "DIR");
  add("--cache-key", arguments.key,
      "secret of at least 16 bytes: entries of the cache that were written without it do not count", "FILE")
      .reads_file();
  add("--cache-size", arguments.size,
      "most that the cache may take, such as 500M or 20G (default: 2G); what was used longest ago goes first",
      "SIZE");
  verb.flag("--cache-stats", arguments.stats,
            "say on standard error what was found in the cache, written, and is there now")
      .group("Cache")
      .in_shards(InShards::free);
  add("--cache-report", arguments.report, "the same as JSON", "FILE").in_shards(InShards::one_file);
}

CacheOptions cache_options(const CacheArguments& arguments) {
  CacheOptions out;
  if (arguments.folder.empty()) {
    for (const auto& [option, given] :
         {std::pair("--cache-key", !arguments.key.empty()),
          std::pair("--cache-size", !arguments.size.empty()), std::pair("--cache-stats", arguments.stats),
          std::pair("--cache-report", !arguments.report.empty())})
      if (given) throw Error::at(option, "no --cache", "--cache DIR with it");
    return out;
  }
  out.path = arguments.folder;
  if (!arguments.key.empty()) out.key = read_cache_key(arguments.key);
  if (!arguments.size.empty()) out.most_bytes = byte_size(arguments.size, "--cache-size");
  out.counted = arguments.stats || !arguments.report.empty();
  return out;
}

void check_cache_report(const CacheArguments& arguments, bool replace) {
  if (arguments.report.empty()) return;
  check_file_target(arguments.report, replace);
  refuse_input(arguments.report);
}

void tell_cache(const CacheArguments& arguments, const CacheUse& use, const OutputArguments& output) {
  const std::string folder = "--cache: " + printable(arguments.folder, 200);
  // A path that can hold no cache is more than a remark, which --quiet leaves out: no run will ever find a result there.
  if (use.missing)
    complain(folder + " cannot be used: " + use.fault);
  else if (!use.fault.empty())
    remark(output, folder + " takes no more results: " + use.fault);
  if (arguments.stats) complain("cache: " + cache_text(use));
}

std::unique_ptr<Output> cache_report(const CacheArguments& arguments, const CacheUse& use, bool replace) {
  if (arguments.report.empty()) return nullptr;
  return std::make_unique<OutputFile>(arguments.report, cache_json(use), replace);
}

}  // namespace etak::cli
