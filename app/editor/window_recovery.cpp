// SPDX-License-Identifier: Apache-2.0
#include <QEventLoop>
#include <QLocale>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>

#include "app/document/files.h"
#include "app/editor/window.h"

namespace etak::editor {

bool Window::may_lose_changes() {
  take_typed();
  if (document_.is_saved()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                  tr("%1 has changes that are not saved.").arg(document_.title()),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer != QMessageBox::Save) return answer == QMessageBox::Discard;
  if (document_.path().isEmpty()) {
    if (!save_as()) return false;
  } else {
    save_to(document_.path());
  }
  return wait_for_save();
}

bool Window::may_replace(int revision) {
  return revision == document_.revision() || may_lose_changes();
}

// Waits for the end of a save. Returns whether the project was saved; a failure has been reported by then.
// Where the writing takes long, as on a network share that does not answer, the user may cancel the waiting
// and go on with the window; the save then goes on in the background.
bool Window::wait_for_save() {
  constexpr int patience_ms = 300;
  QEventLoop wait;
  bool over = false, well = false;
  connect(this, &Window::saved, &wait, [&](bool ok) {
    over = true;
    well = ok && document_.is_saved();
    wait.quit();
  });
  QTimer::singleShot(patience_ms, &wait, &QEventLoop::quit);
  wait.exec(QEventLoop::ExcludeUserInputEvents);
  if (over) return well;
  QProgressDialog dialog(tr("Saving %1").arg(document_.title()), tr("Cancel"), 0, 0, this);
  dialog.setAccessibleName(tr("Saving"));
  dialog.setWindowModality(Qt::WindowModal);
  connect(&dialog, &QProgressDialog::canceled, &wait, &QEventLoop::quit);
  dialog.show();
  wait.exec();
  if (!over) tell(tr("%1 is still being saved; the window stays open").arg(document_.title()));
  return well;
}

RecoveryChoice Window::ask_recovery(const Recovery& recovery) {
  QMessageBox box(QMessageBox::Question, tr("Unsaved work was found"),
                  tr("The editor ended without saving %1.")
                      .arg(recovery.path.isEmpty() ? tr("a project that was never saved") : recovery.path),
                  QMessageBox::NoButton, this);
  box.setInformativeText((recovery.materials == 1
                              ? tr("One material, last changed %1.")
                              : tr("%1 materials, last changed %2.").arg(recovery.materials))
                             .arg(QLocale().toString(recovery.when, QLocale::ShortFormat)));
  QPushButton* take = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
  QPushButton* keep = box.addButton(tr("Keep for later"), QMessageBox::RejectRole);
  QPushButton* drop = box.addButton(tr("Delete"), QMessageBox::DestructiveRole);
  box.setDefaultButton(take);
  box.setEscapeButton(keep);
  box.exec();
  return box.clickedButton() == take   ? RecoveryChoice::recover
         : box.clickedButton() == drop ? RecoveryChoice::discard
                                       : RecoveryChoice::keep;
}

bool Window::offer_recovery(const std::function<RecoveryChoice(const Recovery&)>& ask) {
  for (const Recovery& each : autosave_->left_behind()) {
    const RecoveryChoice choice = ask ? ask(each) : ask_recovery(each);
    if (choice == RecoveryChoice::discard) Autosave::discard(each);
    if (choice != RecoveryChoice::recover) continue;
    recover(each);
    return true;
  }
  return false;
}

void Window::recover(const Recovery& recovery) {
  read_or_write(
      [file = recovery.file, library = document_.library()] { return open_project(file, *library); },
      [this, recovery, revision = document_.revision()](Opened recovered) {
        // The copy is kept, so that the user can look at it.
        if (!recovered.error.isEmpty()) {
          show_problems(tr("The last state could not be read"), {recovered.error});
          emit opened(false);
          return;
        }
        if (!may_replace(revision)) {
          tell(tr("The last state is kept for later"));
          emit opened(false);
          return;
        }
        document_.replace(std::move(recovered.project), recovery.path, false);
        autosave_->write_now();
        read_or_write(
            [recovery, autosave = autosave_] {
              autosave->wait();
              Autosave::discard(recovery);
              return true;
            },
            [this](bool) { emit opened(true); });
      });
}

}  // namespace etak::editor
