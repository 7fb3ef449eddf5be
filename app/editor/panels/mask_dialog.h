// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <array>
#include <memory>

#include "app/viewport/background.h"
#include "core/project/project_mask.h"

class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace etak::editor {

class PathEdit;
class QuietComboBox;

/// Makes one material of two to four of the project by a mask. What the mask holds is proposed, a ball shows what comes
/// out, and the files are those that `etak pack` writes by the manifest that is written beside them.
class MaskDialog : public QDialog {
  Q_OBJECT

 public:
  ///   marked   names of the materials that are proposed
  ///   folder   where the files go, unless the user chooses another one
  MaskDialog(const Project& project, std::shared_ptr<const MaterialLibrary> library,
             const QStringList& marked, const QString& folder, QWidget* parent);
  void take_mask(const QString& path);
  bool is_busy() const { return busy_ > 0; }
  void accept() override;  // writes the files, and closes where that went well

 signals:
  void made(const ProjectMaterial& material, const QStringList& remarks);

 private:
  struct Row {
    QLineEdit* code;
    QuietComboBox* material;
  };
  Row add_row(int index);
  void choose_mask();
  void choose_folder();
  void propose(const MaskSurvey& survey);
  /// What is asked for; `fault` gets a sentence where that cannot be made.
  MaskedMaterial wanted(QString& fault) const;
  void show_wanted();
  void show_state();
  template <class Work, class Done>
  void work(Work work, Done done) {
    ++busy_;
    in_background(pool_, this, std::move(work), [this, done = std::move(done)](auto result) mutable {
      --busy_;
      done(std::move(result));
    });
  }

  Project project_;
  std::shared_ptr<const MaterialLibrary> library_;
  QStringList marked_;
  QLineEdit* name_;
  PathEdit *mask_, *folder_;
  std::array<Row, MaterialMask::most_parts> rows_{};
  QLabel *ball_, *note_;
  QCheckBox* replace_;
  QDialogButtonBox* buttons_;
  QString surveyed_, fault_;
  int busy_ = 0, asked_ = 0;  // number of the last preview
  Worker pool_;
};

}  // namespace etak::editor
