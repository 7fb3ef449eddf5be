// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMainWindow>
#include <QTimer>
#include <functional>
#include <memory>

#include "app/document/autosave.h"
#include "app/document/document.h"
#include "app/document/look.h"
#include "app/document/thumbnails.h"
#include "app/document/validator.h"
#include "app/editor/panels/preferences.h"
#include "app/viewport/background.h"
#include "app/viewport/viewport.h"

class QDockWidget;
class QLabel;
class QPlainTextEdit;
class QTabWidget;

namespace etak {
struct EngineTarget;
enum class ExportForm;
}  // namespace etak

namespace etak::editor {

class CurvesPanel;
struct DroppedPictures;
class FindingsPanel;
class Inspector;
class LibraryPanel;
class LightPanel;
class PackDialog;
class PreviewBar;
class ProblemStrip;
class ProjectPanel;
class TextureView;
class ViewBar;
class ViewPanel;

struct WindowOptions {
  bool cpu_viewport = false;
  QString data_folder, cache_folder;  // for autosaves and thumbnails; empty: the user's folders
  bool remember = true;               // keeps layout, theme and recent files for the next run
  bool theme_given = false;  // by an option of the program, so that the desktop's does not replace it
};

/// The window of the editor: library and project on the left, viewport with tabs under it, inspector on the
/// right. Its functions are in files by subject: window.cpp makes the panels,
/// window_menus.cpp the menus, window_files.cpp reads and writes files, window_drops.cpp takes dropped files,
/// window_own.cpp has materials across projects, window_view.cpp switches how they are looked at, window_findings.cpp acts on findings, window_mask.cpp makes materials by masks, window_export.cpp exports to other programs, window_recovery.cpp guards unsaved changes,
/// window_picture.cpp updates viewport and tabs.
class Window : public QMainWindow {
  Q_OBJECT

 public:
  explicit Window(const WindowOptions& options, QWidget* parent = nullptr);
  ~Window() override;

  Document& document() { return document_; }
  Viewport& viewport() { return *viewport_; }
  LibraryPanel& library_panel() { return *library_panel_; }
  ProjectPanel& project_panel() { return *project_panel_; }
  Inspector& inspector() { return *inspector_; }
  FindingsPanel& findings() { return *findings_; }
  ViewPanel& view_panel() { return *view_panel_; }
  TextureView& texture_view() { return *texture_view_; }
  CurvesPanel& curves() { return *curves_; }
  QTabWidget& tabs() { return *tabs_; }
  QTabWidget& inspector_tabs() { return *inspector_tabs_; }
  Validator& validator() { return *validator_; }
  Thumbnails& thumbnails() { return *thumbnails_; }
  Autosave& autosave() { return *autosave_; }
  Look& look() { return look_; }
  ProblemStrip& problems() { return *problems_; }
  void look_changed();

  /// Adds a material of the library to the project and makes it the current one. Returns false where the
  /// library has no material of that name.
  bool use_library_material(const QString& name);

  // Files. A worker reads and writes them; opened() and saved() are emitted at the end.
  void open(const QString& path);
  void save_to(const QString& path);
  void import(const QStringList& paths);
  /// Takes dropped files: spectra are imported, a .hdr becomes the environment. Pictures with one name become
  /// textures of the current material, those of several names one material for each name; of more than one picture a
  /// table shows first what goes where. For a project, the
  /// user is asked whether to open it or to add its materials. Other files are refused with a message.
  void take_files(const QStringList& paths);
  /// Reads a photograph that stands in place of side B.
  void take_photograph(const QString& file);
  PackDialog* pack_to(const QString& folder);
  /// Offers the copies of unsaved changes that killed runs left behind, until one is recovered. Returns
  /// whether one is: opened() is then emitted at the end.
  ///   ask   decides for each copy; empty: the user is asked
  bool offer_recovery(const std::function<RecoveryChoice(const Recovery&)>& ask = {});
  /// Whether files are read or written, an environment is computed, or a picture is in work.
  bool is_busy() const {
    return busy_ > 0 || comparing_ > 0 || difference_timer_.isActive() || environment_coming_ ||
           mesh_coming_ || blocks_coming_ || refresh_timer_.isActive() || viewport_->is_drawing();
  }
  /// Shows the viewport alone, without menus, panels and tabs, or the window as it was before.
  void show_viewport_only(bool on);

 signals:
  void opened(bool well);
  void saved(bool well);
  void first_frame();

 protected:
  void closeEvent(QCloseEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void make_panels();
  void make_docks();
  void connect_panels();
  void prepare_lines();
  /// The two ways of looking, in a corner below the viewport and in the menu View.
  void make_looks();
  void make_view_bar(QWidget* parent);
  QDockWidget* make_history();
  /// An action that switches something on and off.
  ///   tip   tooltip of its button
  QAction* switch_action(const QString& title, const QString& tip, const QKeySequence& keys,
                         const std::function<bool()>& is_on, const std::function<void()>& act);
  void show_switches();
  void make_context_menus();
  void ask_preferences();
  ProjectMaterial as_preferred(ProjectMaterial material) const;
  Project fresh_project() const;
  /// Takes the value that is typed in the focused field, although the user has not left the field yet.
  void take_typed();
  void make_menus();
  void make_file_menu();
  void make_edit_menu();
  void make_view_menu();
  void connect_viewport();
  void connect_comparison();
  void restore();
  void remember();

  QAction* action(QMenu* menu, const QString& text, const QKeySequence& keys,
                  const std::function<void()>& act);
  QMenu* submenu(QMenu* menu, const QString& title);
  void fill_copy_menu(QMenu* menu);
  void copy_value(const EngineTarget& target);
  enum class ExportOf { one, selected, all };
  void fill_export_menu(QMenu* menu, ExportOf which);
  void export_to(ExportForm form, ExportOf which);
  /// Asks for the name of a file to write. A name without an ending gets `ending` before the question whether
  /// a file of that name is to be replaced.
  ///   proposed   beginning of the name, with its folder; returns an empty name where the user gives up
  QString name_to_save(const QString& title, const QString& proposed, const QString& filter,
                       const QString& ending);

  bool may_lose_changes();
  /// Whether a project may replace the present one: asks the user only where the document has changed since
  /// `revision`, which is when the opening began.
  bool may_replace(int revision);
  bool wait_for_save();
  RecoveryChoice ask_recovery(const Recovery& recovery);
  bool can_take(const QStringList& files);
  ///   refused   what to tell of the other files that were dropped with them
  void take_pictures(const QStringList& files, const QStringList& refused);
  /// Shows the table of what goes where, and takes what the user leaves in it.
  void ask_what_goes_where(DroppedPictures dropped);
  ///   fresh   makes new materials; else a single set goes onto the material in hand
  void take_sets(const DroppedPictures& dropped, bool fresh);
  void take_picture(Channel channel, const QString& file);
  /// Asks for a mask, and makes one material of those that are marked.
  void ask_mask();
  void take_spectra(const QStringList& files);
  void ask_open_or_add(const QString& project);
  void recover(const Recovery& recovery);
  /// Puts a file first in the list of recent files, or takes it out.
  void change_recent(const QString& path, bool keep);
  void fill_recent(QMenu* menu);
  void tell(const QString& message);
  void untell(const QString& message);  // takes it away where it is still shown
  void show_problems(const QString& title, const QStringList& problems);
  void update_title();
  /// Does `work` on the thread that reads and writes files, then `done` with what it returns. The window is busy
  /// until then.
  template <class Work, class Done>
  void read_or_write(Work work, Done done) {
    ++busy_;
    in_background(io_, this, std::move(work), [this, done = std::move(done)](auto result) mutable {
      --busy_;
      done(std::move(result));
    });
  }
  /// Writes a file by `write`, which returns the message of an error, and tells the end.
  ///   failed   title of the message where it could not be written
  void write_in_background(const QString& file, const QString& failed, const std::function<QString()>& write);
  QString beside_project(const QString& file = {}) const;
  void choose_and_open();
  void save();
  bool save_as();  // returns whether the user has chosen a name
  void save_material_as();
  void choose_and_import();
  void choose_and_pack();
  void save_picture();

  void preview(const QString& id);
  void end_preview();
  void refresh();
  void set_environment(const QString& path);
  void load_environment();
  void choose_mesh();
  void take_mesh(const QString& file);
  void load_mesh();
  /// The textures of the viewport as blocks hold them; null where that is not asked for, and until they are made.
  std::shared_ptr<const SurfaceTextures> textures_in_blocks();
  void show_environment_work(bool on);
  void show_difference();
  void compare(const std::function<DifferencePicture()>& work,
               const std::function<void(const DifferencePicture*)>& show);
  void choose_photograph();
  void show_photograph(const QImage& photograph, const QString& name);  // null: none
  void copy_command();
  QString own_folder() const;
  void make_own_menu(QMenu* menu);
  void copy_materials();
  void paste_materials();
  void keep_as_own();
  void connect_favourites();
  void show_shader();
  void show_curves();
  void show_patch(const PatchUnderCursor& patch);
  void drop_old_patch();
  void go_to_finding(const Finding& finding);
  void count_findings();
  void fix_finding(const Finding& finding);
  void mute_finding(const Finding& finding, const QString& reason);

  WindowOptions options_;
  Document document_;
  std::unique_ptr<Thumbnails> thumbnails_;
  Validator* validator_;
  Autosave* autosave_;
  Look look_;
  Worker io_;  // files are read and written one after the other
  Worker heavy_;
  Worker comparer_;    // compares engines with the exact material
  Worker compressor_;  // makes blocks of textures
  int busy_ = 0;
  int comparison_ = 0,
      comparing_ = 0;             // number of the last comparison, and how many of its parts are in work
  bool follows_desktop_ = false;  // with the theme
  bool alone_ = false;            // the viewport is shown alone
  QByteArray beside_, below_;     // panels and tabs as they were before
  bool seen_frame_ = false, patch_compares_ = false;

  Viewport* viewport_ = nullptr;
  LibraryPanel* library_panel_ = nullptr;
  ProjectPanel* project_panel_ = nullptr;
  Inspector* inspector_ = nullptr;
  LightPanel* light_panel_ = nullptr;
  ViewPanel* view_panel_ = nullptr;
  FindingsPanel* findings_ = nullptr;
  TextureView* texture_view_ = nullptr;
  CurvesPanel* curves_ = nullptr;
  QPlainTextEdit* shader_ = nullptr;
  QTabWidget *tabs_ = nullptr, *inspector_tabs_ = nullptr;
  QLabel *backend_ = nullptr, *patch_ = nullptr, *work_ = nullptr, *pictures_ = nullptr, *blocks_ = nullptr;
  PreviewBar* preview_bar_ = nullptr;
  ProblemStrip* problems_ = nullptr;
  QString previewed_;  // id of the library material in the preview
  QAction *undo_ = nullptr, *redo_ = nullptr, *end_preview_ = nullptr;
  QAction *look_action_ = nullptr, *measure_action_ = nullptr, *compare_action_ = nullptr,
          *perspective_action_ = nullptr;
  QList<QAction*> overlays_;
  std::vector<std::function<void()>> switches_;  // show whether what the actions switch is on
  ViewBar* view_bar_ = nullptr;
  Preferences preferences_;
  QString let_go_;  // what was told of a measurement that a typed colour has replaced
  QTimer refresh_timer_, difference_timer_;

  // The environment that is shown, and the key of the one that is wanted.
  std::shared_ptr<const Environment> environment_;
  std::string environment_key_;
  std::string mesh_key_;
  bool mesh_coming_ = false;
  std::shared_ptr<const SurfaceTextures> compressed_, in_blocks_;  // the last ones, before and after
  bool blocks_coming_ = false;
  bool environment_coming_ = false;  // it or its sharper form
};

}  // namespace etak::editor
