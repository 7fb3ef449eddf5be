// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/document/look.h"
#include "app/editor/panels/inspector/fields_of.h"
#include "app/viewport/background.h"
#include "core/project/project_pictures.h"
#include "core/render/engines.h"

namespace etak::editor {

/// The exposure as a field shows it, in stops. A file may hold 0, which is no number of stops.
inline constexpr FieldRange exposure_range{-8, 8, 0};
inline auto stops_of_exposure() {
  return Computed{[](const ProjectView& v) { return std::log2(std::max(v.exposure, 1e-9)); },
                  [](ProjectView& v, double stops) { v.exposure = std::exp2(stops); }};
}

class DifferenceMap;

/// Shows whether a switch of Look::in_blocks can be used, and why not.
template <class Switch>
void show_blocks_switch(Switch& of, const ProjectMaterial* material) {
  of.setEnabled(material != nullptr && has_packed_textures(*material));
  of.setToolTip(
      of.isEnabled()
          ? QObject::tr("What BC7 leaves of the textures; Space, held, and side B show them exact (Ctrl+5)")
          : QObject::tr("The material has no picture of diffuse colour, alpha, F0 or gloss to compress"));
}

/// The tone curves of the plain display, and the titles that the registry gives them.
inline constexpr std::array tones{Tone::plain, Tone::neutral, Tone::agx_like, Tone::filament,
                                  Tone::false_color};
QStringList tone_titles();

/// Fields for exposure, display, backdrop, shape, comparison and overlays.
class ViewPanel : public PanelScroll {
  Q_OBJECT

 public:
  ///   look   belongs to the window; the panel changes it and emits look_changed()
  ViewPanel(Document& document, Look& look, QWidget* parent = nullptr);
  void show_look();
  /// Shows the viewport's text about the patch under the cursor.
  void show_patch(const QString& text);
  /// Shows how far the engine is from the exact material. Null: nothing.
  void show_difference(const DifferencePicture* difference);
  /// Shows how far the sides of a comparison are from each other. Null: nothing.
  void show_sides(const DifferencePicture* difference);

 signals:
  void look_changed();
  void pin_asked();
  void mesh_asked();
  void photograph_asked();
  void photograph_ended();

 private:
  void make_display();
  void make_backdrop();
  void make_shape();
  void make_compare();
  void make_engine();
  struct ReadDisplays;
  static ReadDisplays read_displays(const std::string& config);
  void fill_displays();
  void show_displays(const ReadDisplays& read);
  void take_display();

  Document& document_;
  Look& look_;
  FieldsOf<ProjectView> view_;
  FieldsOf<Look> overlays_;
  QuietComboBox *display_ = nullptr, *view_of_display_ = nullptr;
  QLabel *patch_ = nullptr, *config_ = nullptr, *difference_ = nullptr, *sides_ = nullptr;
  DifferenceMap *difference_map_ = nullptr, *sides_map_ = nullptr;
  Worker pool_;
  std::string filled_config_ = "?";
};

}  // namespace etak::editor
