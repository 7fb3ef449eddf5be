// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <map>
#include <optional>
#include <set>

#include "app/document/document.h"
#include "app/viewport/background.h"
#include "core/judge/finding.h"

namespace etak {
class KeptPictures;
}

namespace etak::editor {

/// What stands open of a material: findings that are not muted.
struct OpenFindings {
  int errors = 0, warnings = 0;
  QStringList errors_and_warnings;  // what is wrong, a sentence each
  /// "2 errors, 1 warning"; empty: none of either.
  QString text() const;
};

/// Runs the rules of the validator over materials that have changed, a moment after the change, on a thread
/// of its own. The pictures of the material that was checked last are kept in memory, so that a change of a
/// number reads no file.
class Validator : public QObject {
  Q_OBJECT

 public:
  explicit Validator(Document& document, QObject* parent = nullptr);
  ~Validator() override { stop_ = true; }

  /// Findings by the name of the material; materials without findings are left out. Those that the project's etak.toml
  /// allows are among them, as suppressed.
  const std::map<std::string, std::vector<Finding>>& findings() const { return findings_; }
  /// Why the etak.toml of the project is not gone by; empty: it is, or there is none.
  const QString& config_failure() const { return config_failure_; }
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
  QString config_failure_;
  std::shared_ptr<KeptPictures> kept_;
  QTimer timer_;
  std::atomic<bool> stop_{false};
  bool running_ = false;
  Worker pool_;  // the last member, because its thread looks at stop_
};

/// Those of a material; of a channel alone where one is given.
OpenFindings open_findings(const Validator& validator, const std::string& material,
                           std::optional<Channel> channel = std::nullopt);

/// What is wrong, and where: "F0 lies where no common material is: F0 0.22 (byte 128, grey) on 64 px (100 %)".
QString sentence_of(const Finding& finding);
/// "1 error", "2 errors"
QString counted(std::size_t count, const QString& one, const QString& more);

}  // namespace etak::editor
