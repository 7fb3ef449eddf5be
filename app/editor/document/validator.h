// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <map>
#include <set>

#include "app/editor/document/document.h"
#include "app/viewport/background.h"
#include "core/judge/finding.h"

namespace etak {
class KeptPictures;
}

namespace etak::editor {

/// Runs the rules of the validator over materials that have changed, a moment after the change, on a thread
/// of its own. The pictures of the material that was checked last are kept in memory, so that a change of a
/// number reads no file.
class Validator : public QObject {
  Q_OBJECT

 public:
  explicit Validator(Document& document, QObject* parent = nullptr);
  ~Validator() override { stop_ = true; }

  /// Findings by the name of the material; materials without findings are left out.
  const std::map<std::string, std::vector<Finding>>& findings() const { return findings_; }
  bool is_idle() const { return dirty_.empty() && !running_ && !timer_.isActive(); }
  void check_all();
  void check(const QStringList& materials);  // whose pictures have changed

 signals:
  void findings_changed();
  void work_changed();  // is_idle() may have changed

 private:
  void begin();
  void drop_gone();

  Document& document_;
  std::map<std::string, std::vector<Finding>> findings_;
  std::set<std::string> dirty_;
  std::shared_ptr<KeptPictures> kept_;
  QTimer timer_;
  std::atomic<bool> stop_{false};
  bool running_ = false;
  Worker pool_;  // the last member, because its thread looks at stop_
};

}  // namespace etak::editor
