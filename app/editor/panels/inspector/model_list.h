// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <functional>

#include "core/brdf/models.h"

namespace etak::editor {

/// Adds models to a box by their titles, in families: each has a row with its name, which cannot be chosen.
/// The data of a row is the id of its model, as files and the command line have it; its tooltip tells id and
/// source.
///   is_shown   which models the box has
void add_models(QComboBox& box, const std::function<bool(const Model&)>& is_shown);

}  // namespace etak::editor
