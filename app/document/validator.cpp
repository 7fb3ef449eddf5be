// SPDX-License-Identifier: Apache-2.0
#include "app/document/validator.h"

#include "app/document/pictures.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/judge/rules.h"
#include "core/project/project_pictures.h"
#include "core/validate/files/project_check.h"
#include "core/validate/validate.h"

namespace etak::editor {
namespace {

struct Checked {
  std::vector<CheckedFile> files;
  QString config_failure;
};

constexpr int check_delay_ms = 200;
constexpr std::size_t most_at_once = 64;  // materials in a batch; the list is looked at again after each
constexpr std::size_t most_texels = std::size_t{64} << 20;

}  // namespace

Validator::Validator(Document& document, QObject* parent)
    : QObject(parent), document_(document), kept_(std::make_shared<KeptPictures>()) {
  timer_.setSingleShot(true);
  timer_.setInterval(check_delay_ms);
  connect(&timer_, &QTimer::timeout, this, &Validator::begin);
  const auto mark = [this](int first, int count) {
    for (int i = first; i < first + count; ++i)
      dirty_.insert(document_.project().materials[static_cast<std::size_t>(i)].name);
    timer_.start();
    emit work_changed();
  };
  connect(&document, &Document::material_changed, this, [mark](int index) { mark(index, 1); });
  connect(&document, &Document::materials_added, this, mark);
  connect(&document, &Document::materials_removed, this, [this] { timer_.start(); });
  connect(&document, &Document::saved_changed, this, [this, path = document_.path()]() mutable {
    if (path == document_.path()) return;
    path = document_.path();  // beside which another etak.toml may be
    check_all();
  });
  connect(&document, &Document::replaced, this, [this] {
    findings_.clear();
    kept_ = std::make_shared<KeptPictures>();  // a check that still runs has the one before
    emit findings_changed();
    check_all();
  });
}

QString counted(std::size_t count, const QString& one, const QString& more) {
  return QStringLiteral("%1 %2").arg(count).arg(count == 1 ? one : more);
}

QString sentence_of(const Finding& finding) {
  const Rule* rule = find_rule(finding.rule);
  const QString message = qt_text(finding.message);
  return rule == nullptr ? message : qt_text(rule->title) + QStringLiteral(": ") + message;
}

QString OpenFindings::text() const {
  QStringList out;
  if (errors > 0)
    out << counted(static_cast<std::size_t>(errors), QObject::tr("error"), QObject::tr("errors"));
  if (warnings > 0)
    out << counted(static_cast<std::size_t>(warnings), QObject::tr("warning"), QObject::tr("warnings"));
  return out.join(QStringLiteral(", "));
}

OpenFindings open_findings(const Validator& validator, const std::string& material,
                           std::optional<Channel> channel) {
  OpenFindings out;
  const auto found = validator.findings().find(material);
  if (found == validator.findings().end()) return out;
  for (const Finding& each : found->second) {
    if (each.suppressed || each.severity < Severity::warning) continue;
    if (channel && field_of(each.rule) != channel) continue;
    ++(each.severity == Severity::error ? out.errors : out.warnings);
    out.errors_and_warnings << sentence_of(each);
  }
  return out;
}

void Validator::check_all() {
  for (const ProjectMaterial& each : document_.project().materials) dirty_.insert(each.name);
  timer_.start();
  emit work_changed();
}

void Validator::check(const QStringList& materials) {
  for (const QString& each : materials) dirty_.insert(each.toStdString());
  timer_.start();
  emit work_changed();
}

void Validator::drop_gone() {
  std::set<std::string_view> names;
  for (const ProjectMaterial& each : document_.project().materials) names.insert(each.name);
  const std::size_t before = findings_.size();
  std::erase_if(findings_, [&](const auto& row) { return !names.contains(row.first); });
  if (findings_.size() != before) emit findings_changed();
}

void Validator::begin() {
  if (running_) return;  // materials that were marked meanwhile are in the next batch
  drop_gone();
  std::vector<ProjectMaterial> batch;
  for (const ProjectMaterial& each : document_.project().materials) {
    if (batch.size() == most_at_once) break;
    if (dirty_.erase(each.name) != 0) batch.push_back(each);
  }
  if (batch.empty()) {
    dirty_.clear();
    emit work_changed();
    return;
  }
  running_ = true;
  in_background(
      pool_, this,
      [this, batch = std::move(batch), library = document_.library(), kept = kept_,
       project = document_.path()]() mutable {
        let_others_go_first();
        ValidationRequest request;
        Checked out;
        if (!project.isEmpty())
          out.config_failure =
              failure_of([&] { request.config = read_config(find_config(project.toStdString())); });
        // Materials that are not in this batch may be what an entry is for.
        request.config.settings.rules["ETK903"].severity = Severity::off;
        request.inputs.materials = {std::move(batch), std::move(library), most_texels, std::move(kept)};
        request.run.door = picture_door();
        request.run.stop = [this] { return stop_.load(); };  // the destructor waits for this thread
        out.files = validate(std::move(request)).files;
        return out;
      },
      [this](Checked checked) {
        running_ = false;
        config_failure_ = checked.config_failure;
        for (CheckedFile& file : checked.files) {
          if (file.findings.empty())
            findings_.erase(file.path);
          else
            findings_[file.path] = std::move(file.findings);
        }
        emit findings_changed();
        begin();
      });
}

}  // namespace etak::editor
