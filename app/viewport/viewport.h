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

#include "core/render/view_state.h"

class QMimeData;

namespace etak {

/// What lies under the cursor on both sides of a comparison: means of a patch of 5 x 5 pixels.
struct PatchUnderCursor {
  QPointF position;                       // in the widget
  std::array<int, 3> code_a{}, code_b{};  // 8-bit codes as the display shows them
  std::array<int, 3> difference{};        // b - a
  double delta_e = 0;                     // CIEDE2000 of the two codes
  bool on_object = false;
};

/// Shows a ViewState, by OpenGL 3.3 where there is one, else by core's CPU renderer.
///
/// Mouse: left drag orbits (so does Alt + left), middle drag pans, wheel or Alt + right drag zooms, Ctrl +
/// left drag turns the environment, Shift + left drag moves a light or the hemispheres' axis (the one whose
/// mark is nearest), Shift + wheel changes its strength, a drag on the separator moves that, double click
/// resets the camera. Keys: F frames the object, held Space shows b in place of a. Arrow keys are left to the
/// window.
class Viewport : public QWidget {
  Q_OBJECT

 public:
  /// gl_one_thread: as OpenGL is used where contexts cannot share, with the window's thread drawing.
  enum class Backend { automatic, gl_one_thread, cpu };
  explicit Viewport(QWidget* parent = nullptr, Backend backend = Backend::automatic);
  ~Viewport() override;

  /// Shows `state`. One that cannot be drawn is kept, and its message shown in place of the picture.
  void set_state(const ViewState& state);
  const ViewState& state() const;

  /// The picture in device pixels as core's rules say, without marks and texts; waits for it. Grey where the
  /// state cannot be drawn.
  QImage grab_picture();

  bool is_drawing() const;  // a picture of the last state, or of one before, is still to come

  bool uses_gl() const;
  QString gl_name() const;          // the driver's; empty without GL
  QString fallback_reason() const;  // why there is no GL, for people; empty with GL
  QString message() const;          // what is shown over the picture: an error, the lack of GL; may be empty

  QString shader_text() const;  // of side a: what is in, what was left out and why, then the fragment shader
  double compile_ms() const;    // of that shader and its first drawing; 0 without GL
  double frame_ms() const;      // of the last frame

  std::optional<PatchUnderCursor> patch_at(const QPointF& position) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

  /// Which dragged files are accepted; without it all are.
  void set_drop_filter(std::function<bool(const QStringList&)> can_take);

  /// The kind of drag that material_dropped() answers: UTF-8 text.
  static constexpr const char* material_mime = "application/x-etak-material";

 public slots:
  void frame_object();        // F: the whole object in the middle
  void reset_camera();        // double click
  void set_flipped(bool on);  // shows b in place of a

  /// As when the driver takes the context away (a reset of the device): draws on with a new one, after the
  /// second time with the CPU.
  void recover_from_lost_context();

 signals:
  /// The user changed the state by mouse or keys (it is set already). All edits of one drag have one
  /// press_id, so that they can be undone as one.
  void state_edited(const etak::ViewState& state, int press_id);
  void frame_drawn(double milliseconds);
  void hovered(const etak::PatchUnderCursor& patch);
  void hover_ended();
  /// Drops: a lat-long .hdr or .exr; any other file, or several; something of the application's own.
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

/// The files of a drag that lie on this machine.
QStringList dragged_files(const QMimeData& data);

}  // namespace etak

Q_DECLARE_METATYPE(etak::ViewState)
Q_DECLARE_METATYPE(etak::PatchUnderCursor)
