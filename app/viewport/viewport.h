// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QPointF>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "app/viewport/saved_view.h"
#include "core/render/sheet.h"
#include "core/render/view_state.h"

class QAbstractSlider;
class QMimeData;

namespace etak {

/// The colours under the cursor on both sides of a comparison, as means over a patch of 5 x 5 pixels.
struct PatchUnderCursor {
  QPointF position;                       // in the widget
  std::array<int, 3> code_a{}, code_b{};  // 8-bit codes as the display shows them
  std::array<int, 3> difference{};        // b - a, in codes
  double delta_e = 0;                     // CIEDE2000 of the two codes
  bool on_object = false;
};

/// Shows a ViewState, drawn by OpenGL 3.3 where that is available, else by the CPU renderer of core.
///
/// Mouse: left drag orbits (so does Alt + left), middle drag pans, wheel or Alt + right drag zooms, Ctrl +
/// left drag turns the environment, Shift + left drag moves the light or the axis of the hemispheres whose
/// mark is nearest, Shift + wheel changes its strength, a drag on the separator moves the separator, double
/// click resets the camera. Keys: F frames the object; arrows with Alt orbit, with Ctrl turn the environment, with Shift
/// move a light, which L chooses; plus and minus zoom, comma and period move the separator; while Space is held, b is
/// shown in place of a. Arrow keys alone are left to the window.
class Viewport : public QWidget {
  Q_OBJECT

 public:
  /// gl_one_thread: the user-interface thread draws with OpenGL, as it does where contexts cannot share.
  enum class Backend { automatic, gl_one_thread, cpu };
  explicit Viewport(QWidget* parent = nullptr, Backend backend = Backend::automatic);
  ~Viewport() override;

  /// Shows `state`. A state that cannot be drawn is kept, and a message is shown over a grey picture.
  ///   dragged   the slider outside of the viewport that changes the state, or null. While it is down, fewer pixels are
  ///             drawn where whole pictures take long, as in drags in the viewport
  void set_state(const ViewState& state, const QAbstractSlider* dragged = nullptr);
  const ViewState& state() const;

  /// The picture of the state in device pixels, without marks and texts; waits until it is drawn. Grey where
  /// the state cannot be drawn.
  ///   refined   as in struct Scene; else the picture that is shown while things move
  QImage grab_picture(bool refined = false);

  /// What is shown, for pictures of other sizes.
  SavedView saved_view() const;

  /// A photograph that stands in place of side b of a comparison, in sRGB; its middle is that of the view. Null: none.
  void set_photograph(const QImage& photograph);

  /// The work that finds how far side a is from side b, in a picture as wide as the view and `width` pixels wide. Any thread
  /// may do it; it throws Error.
  std::function<DifferencePicture()> difference_work(int width) const;

  bool is_drawing() const;   // a picture of this state or of an earlier one is still in work
  bool is_hurried() const;   // the user drags, so that pictures may have fewer pixels
  bool is_refining() const;  // so, or a refined one is

  bool uses_gl() const;
  QString gl_name() const;          // renderer and version, as the driver names them; empty without GL
  QString fallback_reason() const;  // why there is no GL, for the user; empty with GL
  QString message() const;  // the text over the picture: an error, or why there is no GL; may be empty
  QString readout() const;  // the text over the picture of the colours under the cursor; may be empty

  /// The fragment shader of side a, below comments that list the features in it and those left out, with
  /// reasons.
  QString shader_text() const;
  double compile_ms() const;  // time of compiling that shader and drawing with it first; 0 without GL
  double frame_ms() const;    // time of the last frame

  std::optional<PatchUnderCursor> patch_at(const QPointF& position) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

  /// Sets the function that tells whether dragged files are accepted. Without a filter all are.
  void set_drop_filter(std::function<bool(const QStringList&)> can_take);

  /// The MIME type of dragged materials, whose data is an id in UTF-8; a drop emits material_dropped().
  static constexpr const char* material_mime = "application/x-etak-material";

  /// How long the picture is covered by the note that the CPU draws it.
  static constexpr int cpu_note_ms = 6000;

 public slots:
  void frame_object();        // key F: shows the whole object in the middle
  void reset_camera();        // double click
  void set_flipped(bool on);  // shows b in place of a

  /// Does what is done when the driver takes the context away, as after a reset of the device: goes on with a
  /// new context, from the second time on with the CPU.
  void recover_from_lost_context();

 signals:
  /// The user has changed the state by mouse or keys; state() is the new one already. All edits of one drag
  /// have the same press_id, so that they can be undone as one.
  void state_edited(const etak::ViewState& state, int press_id);
  void frame_drawn(double milliseconds);
  void hovered(const etak::PatchUnderCursor& patch);
  void hover_ended();
  /// Drops: a single .hdr or .exr file, taken as a lat-long environment; other files; a material of
  /// material_mime.
  void environment_dropped(const QString& path);
  void textures_dropped(const QStringList& paths);
  void material_dropped(const QString& material_id);
  void message_changed(const QString& message);
  void backend_changed(bool uses_gl);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  class Private;
  std::unique_ptr<Private> d_;
};

/// The paths of the local files in a drag.
QStringList dragged_files(const QMimeData& data);

}  // namespace etak

Q_DECLARE_METATYPE(etak::ViewState)
Q_DECLARE_METATYPE(etak::PatchUnderCursor)
