// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/shape_box.h"

#include "app/document/press_id.h"
#include "app/viewport/qt_text.h"
#include "core/project/shown_mesh.h"

namespace etak::editor {
namespace {

enum Row { sphere, quad, wedge, ball_on_foot, own_mesh };

Row row_of(const ProjectView& view) {
  if (view.wedge.on) return wedge;
  if (view.mesh == shader_ball_name) return ball_on_foot;
  if (!view.mesh.empty()) return own_mesh;
  return view.shape == Shape::quad ? quad : sphere;
}

}  // namespace

ShapeBox::ShapeBox(Document& document, const QString& name, QWidget* parent)
    : QuietComboBox(name, parent), document_(document) {
  setToolTip(tr("What the material is shown on"));
  addItems({tr("sphere"), tr("quad"), tr("wedge"), tr("shader ball"), tr("own mesh\u2026")});
  setItemData(wedge, tr("A row over the range of one parameter"), Qt::ToolTipRole);
  setItemData(ball_on_foot, tr("A ball with a groove and a hollow, on a foot; drawn by the CPU"),
              Qt::ToolTipRole);
  setItemData(own_mesh, tr("The triangles of a glTF file, .gltf or .glb; drawn by the CPU"), Qt::ToolTipRole);
  connect(this, &QComboBox::activated, this, &ShapeBox::choose);
  connect(&document, &Document::view_changed, this, &ShapeBox::show_view);
  connect(&document, &Document::replaced, this, &ShapeBox::show_view);
  show_view();
}

void ShapeBox::choose(int row) {
  if (row == own_mesh) {
    show_view();  // the shape that is shown stays chosen until there is a file
    return emit mesh_asked();
  }
  document_.change_view(tr("shape"), next_press_id(), [&](ProjectView& view) {
    view.wedge.on = row == wedge;
    if (row == wedge) return;
    view.shape = row == quad ? Shape::quad : Shape::sphere;
    view.mesh = row == ball_on_foot ? shader_ball_name : "";
  });
}

void ShapeBox::show_view() {
  const ProjectView& view = document_.project().view;
  const Row row = row_of(view);
  setItemText(own_mesh, row == own_mesh ? qt_text(view.mesh).section('/', -1) : tr("own mesh\u2026"));
  setCurrentIndex(row);
}

}  // namespace etak::editor
