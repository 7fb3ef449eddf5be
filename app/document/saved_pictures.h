// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <atomic>
#include <functional>

#include "app/viewport/saved_view.h"

namespace etak::editor {

/// Draws what a viewport shows and saves it, one picture for each file; several are a turntable. Returns why that could not
/// be done, and none of a turntable's pictures is left then.
///   done   is called with what is done of the whole, in hundredths
QString save_pictures(const SavedView& view, const QSize& size, bool transparent, const QStringList& files,
                      const std::atomic<bool>& cancelled, const std::function<void(int)>& done);

}  // namespace etak::editor
