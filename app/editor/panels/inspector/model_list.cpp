// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/inspector/model_list.h"

#include <QStandardItemModel>
#include <vector>

#include "app/viewport/qt_text.h"

namespace etak::editor {
namespace {

QString family_of(const Model& model) {
  if (model.id.starts_with("schueler")) return QObject::tr("Sch\u00fcler 2009");
  if (model.distribution != nullptr)
    return QObject::tr("Microfacets: %1").arg(qt_text(model.distribution->title));
  return model.kind == ModelKind::diffuse ? QObject::tr("Rough bodies") : QObject::tr("Classics");
}

}  // namespace

void add_models(QComboBox& box, const std::function<bool(const Model&)>& is_shown) {
  std::vector<std::pair<QString, std::vector<const Model*>>> families;
  for (const Model& each : models()) {
    if (!is_shown(each)) continue;
    const QString family = family_of(each);
    auto at = std::find_if(families.begin(), families.end(),
                           [&](const auto& other) { return other.first == family; });
    if (at == families.end()) at = families.insert(at, {family, {}});
    at->second.push_back(&each);
  }
  for (const auto& [family, members] : families) {
    box.addItem(family);
    const int head = box.count() - 1;
    auto* item = qobject_cast<QStandardItemModel*>(box.model())->item(head);
    item->setEnabled(false);
    QFont font = box.font();
    font.setBold(true);
    item->setFont(font);
    for (const Model* each : members) {
      box.addItem(qt_text(each->title), qt_text(each->id));
      box.setItemData(box.count() - 1, qt_text(each->id) + '\n' + qt_text(each->source), Qt::ToolTipRole);
    }
  }
}

}  // namespace etak::editor
