// SPDX-License-Identifier: Apache-2.0
#include <QFileInfo>

#include "app/editor/panels/mask_dialog.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/window.h"
#include "app/viewport/qt_text.h"

namespace etak::editor {

void Window::ask_mask() {
  QStringList marked;
  for (const int row : project_panel_->in_hand())
    marked << qt_text(document_.project().materials[static_cast<std::size_t>(row)].name);
  auto* dialog = new MaskDialog(document_.project(), document_.library(), marked, document_.folder(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(
      dialog, &MaskDialog::made, this, [this](const ProjectMaterial& material, const QStringList& remarks) {
        document_.add({material}, {}, tr("material by mask"));
        const QString texture = qt_text(material.texture(Channel::specular)->path);
        tell(
            tr("%1: textures and manifest are in %2").arg(qt_text(material.name), QFileInfo(texture).path()));
        if (!remarks.isEmpty()) show_problems(tr("Made; not everything is as it was said"), remarks);
      });
  dialog->open();
}

}  // namespace etak::editor
