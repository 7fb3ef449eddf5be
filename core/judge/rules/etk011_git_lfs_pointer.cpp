// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"
#include "core/judge/rules/unreadable.h"

namespace etak {

namespace {

void etk011(RuleCheck& check) {
  report_unreadable(check, etk011_git_lfs_pointer);
}

}  // namespace

constinit const Rule etk011_git_lfs_pointer{
    "ETK011",
    "git-lfs-pointer",
    "A pointer of Git LFS stands for a file",
    Severity::error,
    Severity::error,
    {},
    {},
    "Git LFS, specification of the pointer, version 1",
    "The file is a text of a few lines that names a large file which Git LFS has not fetched.",
    "The file itself was not checked, and must not pass for clean: the run ends with exit "
    "status 2.",
    "A clone by a build service that leaves large files out.",
    "Run git lfs pull, or let the service fetch large files (lfs: true).",
    &etk011};

}  // namespace etak
