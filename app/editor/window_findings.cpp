// SPDX-License-Identifier: Apache-2.0
#include <QDockWidget>
#include <QFileInfo>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>

#include "app/document/pictures.h"
#include "app/document/press_id.h"
#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/texture_view.h"
#include "app/editor/theme.h"
#include "app/editor/window.h"
#include "app/viewport/qt_text.h"
#include "core/base/files/file.h"
#include "core/project/project_pictures.h"
#include "core/validate/config.h"
#include "core/validate/files/project_check.h"
#include "core/validate/repairs/repair_material.h"

namespace etak::editor {
namespace {

QString lines_of(const std::vector<std::string>& list) {
  QStringList out;
  for (const std::string& each : list) out << qt_text(each);
  return out.join(QStringLiteral("; "));
}

struct Fixed {
  RepairedMaterial repaired;
  QString failure;
};

Fixed fixed(const ProjectMaterial& material, const MaterialLibrary& library, const std::string& config,
            const std::string& folder) {
  Fixed out;
  const QTemporaryDir work;
  out.failure = failure_of(
      [&] {
        const Settings settings = read_config(config).settings;
        out.repaired =
            repair_material(material, library, settings, picture_door(), work.path().toStdString(), folder);
      },
      QObject::tr("not enough memory to repair these pictures"));
  return out;
}

// The folder of the first picture of a material; empty: it has none.
QString folder_of_pictures(const ProjectMaterial& material) {
  for (const auto& each : material.textures)
    if (each) return QFileInfo(qt_text(each->path)).absolutePath();
  return {};
}

}  // namespace

void Window::go_to_finding(const Finding& finding) {
  end_preview();
  const auto& list = document_.project().materials;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].name == finding.material) document_.set_current(static_cast<int>(i));
  // The panel may be closed, or behind another one.
  auto* dock = findChild<QDockWidget*>("inspector");
  dock->show();
  dock->raise();
  inspector_tabs_->setCurrentWidget(inspector_);
  inspector_->go_to(finding.rule);
  const ProjectMaterial* m = document_.material();
  if (m == nullptr || !finding.box || !has_packed_textures(*m)) return;
  tabs_->setCurrentWidget(texture_view_);
  texture_view_->show_box(field_of(finding.rule).value_or(Channel::specular), *finding.box);
}

// The tab says how many errors and warnings there are, because it is mostly behind another one.
void Window::count_findings() {
  const auto [errors, warnings, infos, muted] = findings_->model().counts();
  const int tab = tabs_->indexOf(findings_);
  const QString title = errors + warnings == 0 ? tr("Findings") : tr("Findings (%1)").arg(errors + warnings);
  if (tabs_->tabText(tab) != title) tabs_->setTabText(tab, title);  // which lays out the window again
  tabs_->setTabToolTip(tab, tr("%1 errors, %2 warnings, %3 infos, %4 muted (Ctrl+Shift+F)")
                                .arg(errors)
                                .arg(warnings)
                                .arg(infos)
                                .arg(muted));
  const bool dark = is_dark(palette());
  const QColor color = errors > 0     ? QColor(dark ? "#ff7864" : "#b02818")
                       : warnings > 0 ? QColor(dark ? "#ebb41e" : "#8a6000")
                                      : QColor();  // that of the theme
  if (tabs_->tabBar()->tabTextColor(tab) != color) tabs_->tabBar()->setTabTextColor(tab, color);
}

void Window::fix_finding(const Finding& finding) {
  const auto& list = document_.project().materials;
  const auto found = std::ranges::find(list, finding.material, &ProjectMaterial::name);
  if (found == list.end()) return;
  const QString pictures = folder_of_pictures(*found);
  const QString folder = document_.folder().isEmpty() ? pictures : document_.folder();
  const std::string config = document_.path().isEmpty() ? "" : find_config(document_.path().toStdString());
  read_or_write([material = *found, library = document_.library(), config,
                 folder = folder.toStdString()] { return fixed(material, *library, config, folder); },
                [this, before = *found, rule = finding.rule](const Fixed& result) {
                  const auto& now = document_.project().materials;
                  const auto at = std::ranges::find(now, before.name, &ProjectMaterial::name);
                  if (!result.failure.isEmpty())
                    return show_problems(tr("Nothing was repaired"), {result.failure});
                  if (at == now.end() || *at != before)
                    return tell(tr("Nothing was repaired: the material has changed meanwhile"));
                  if (result.repaired.done.empty())
                    return show_problems(
                        tr("Nothing was repaired"),
                        {result.repaired.left.empty() ? tr("%1: not found any more").arg(qt_text(rule))
                                                      : lines_of(result.repaired.left)});
                  document_.edit(static_cast<int>(at - now.begin()), result.repaired.material, tr("repair"),
                                 next_press_id());
                  tell(tr("%1: %2").arg(qt_text(before.name), lines_of(result.repaired.done)));
                });
}

void Window::mute_finding(const Finding& finding, const QString& reason) {
  if (document_.path().isEmpty())
    return show_problems(tr("Nothing was muted"),
                         {tr("Save the project first: what is accepted stands in the etak.toml beside it")});
  AllowEntry entry;
  entry.rule = finding.rule;
  entry.material = finding.material;
  entry.reason = reason.toStdString();
  read_or_write(
      [entry, project = document_.path().toStdString(), folder = document_.folder().toStdString()] {
        return failure_of([&] {
          const std::string there = find_config(project);
          const std::string file = there.empty() ? folder + "/etak.toml" : there;
          const std::string text = (there.empty() ? std::string() : read_file(file)) + allow_text(entry);
          (void)parse_config(text, file);  // never a file that cannot be read again
          write_file(file, text, true);
        });
      },
      [this, name = qt_text(finding.material), rule = qt_text(finding.rule)](const QString& failure) {
        if (!failure.isEmpty()) return show_problems(tr("Nothing was muted"), {failure});
        tell(tr("%1 of %2 is muted, in the etak.toml of the project").arg(rule, name));
        validator_->check_all();
      });
}

}  // namespace etak::editor
