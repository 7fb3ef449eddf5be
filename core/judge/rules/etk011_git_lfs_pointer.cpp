// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"
#include "core/judge/rules/unreadable.h"

namespace etak {

constinit const Rule etk011_git_lfs_pointer{
    .id = "ETK011",
    .slug = "git-lfs-pointer",
    .title = "A pointer of Git LFS stands for a file",
    .severity = Severity::error,
    .source = "Git LFS, specification of the pointer, version 1",
    .what = "The file is a text of a few lines that names a large file which Git LFS has not fetched.",
    .why = "The file itself was not checked, and must not pass for clean: the run ends with exit status 2.",
    .example = "A clone by a build service that leaves large files out.",
    .fix = "Run git lfs pull, or let the service fetch large files (lfs: true).",
    .check = [](RuleCheck& check) { report_unreadable(check, etk011_git_lfs_pointer); }};

}  // namespace etak
