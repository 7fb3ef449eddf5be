// SPDX-License-Identifier: Apache-2.0
#include "app/editor/window.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QTabBar>
#include <QTabWidget>

#include "app/curves/curves_panel.h"
#include "app/document/files.h"
#include "app/document/press_id.h"
#include "app/editor/panels/findings_panel.h"
#include "app/editor/panels/inspector/inspector.h"
#include "app/editor/panels/inspector/source_section.h"
#include "app/editor/panels/inspector/texture_section.h"
#include "app/editor/panels/library_panel.h"
#include "app/editor/panels/light_panel.h"
#include "app/editor/panels/problem_strip.h"
#include "app/editor/panels/project_panel.h"
#include "app/editor/panels/texture_view.h"
#include "app/editor/panels/view_bar.h"
#include "app/editor/panels/view_panel.h"
#include "app/editor/theme.h"
#include "app/editor/window_icon.h"
#include "app/fields/number_field.h"
#include "app/fields/plain_text.h"
#include "app/viewport/background.h"

namespace etak::editor {
namespace {

std::shared_ptr<const MaterialLibrary> builtin_library() {
  return std::make_shared<const MaterialLibrary>(MaterialLibrary::builtin());
}

QTabWidget* tab_widget(const QString& name, QWidget* parent) {
  auto* out = new QTabWidget(parent);
  out->setDocumentMode(true);
  out->setAccessibleName(name);
  out->tabBar()->setAccessibleName(name);
  return out;
}

// Whether a field holds a typed text that is not taken as a value yet. The search field never does.
bool is_typed_in(const QWidget& widget) {
  if (const auto* number = qobject_cast<const FineSpinBox*>(&widget)) return number->is_typed_in();
  const auto* line = qobject_cast<const QLineEdit*>(&widget);
  return line != nullptr && line->isModified() && line->property("search").isNull();
}

// The usual size of the window, but no larger than the screen without the frame around a window.
QSize first_size(const QScreen& screen) {
  constexpr QSize wanted(1280, 800), frame(16, 48);
  return wanted.boundedTo(screen.availableSize() - frame);
}

}  // namespace

Window::Window(const WindowOptions& options, QWidget* parent)
    : QMainWindow(parent),
      options_(options),
      document_(builtin_library()),
      thumbnails_(std::make_unique<Thumbnails>(
          (options.cache_folder.isEmpty() ? cache_folder() : options.cache_folder) + "/thumbnails")),
      validator_(new Validator(document_, this)),
      autosave_(new Autosave(document_, options.data_folder.isEmpty() ? data_folder() : options.data_folder,
                             this)) {
  show_texts_plain();
  setObjectName("etak-editor");
  setAccessibleName(tr("etak editor"));
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  make_panels();
  make_menus();
  connect_viewport();
  setWindowIcon(window_icon());
  resize(first_size(*screen()));
  restore();
  const auto titled = [this] { update_title(); };
  connect(&document_, &Document::replaced, problems_, &ProblemStrip::clear);
  connect(&document_, &Document::saved_changed, this, titled);
  connect(&document_, &Document::replaced, this, titled);
  for (QUndoStack* each : {&document_.undo_stack(), &document_.view_stack()})
    connect(each, &QUndoStack::cleanChanged, this, titled);
  update_title();
  refresh();
  qApp->installEventFilter(this);
}

Window::~Window() {
  qApp->removeEventFilter(this);
  // A field that loses the focus takes its typed text as a value: that must happen while the document exists.
  if (QWidget* at = focusWidget()) at->clearFocus();
  io_.waitForDone();  // what is to be saved is
}

void Window::make_panels() {
  viewport_ =
      new Viewport(this, options_.cpu_viewport ? Viewport::Backend::cpu : Viewport::Backend::automatic);
  tabs_ = tab_widget(tr("Curves, shader, textures, findings"), this);
  shader_ = new QPlainTextEdit(tabs_);
  shader_->setReadOnly(true);
  shader_->setLineWrapMode(QPlainTextEdit::NoWrap);
  shader_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  shader_->setAccessibleName(tr("Shader text"));
  shader_->setTabChangesFocus(true);
  texture_view_ = new TextureView(document_, tabs_);
  curves_ = new CurvesPanel(tabs_);
  tabs_->addTab(curves_, tr("Curves"));
  tabs_->addTab(shader_, tr("Shader"));
  tabs_->addTab(texture_view_, tr("Textures"));
  findings_ = new FindingsPanel(*validator_, tabs_);
  tabs_->addTab(findings_, tr("Findings"));
  auto* centre = new QWidget(this);
  centre->setAccessibleName(tr("Messages and viewport"));
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  problems_ = new ProblemStrip(centre);
  column->setSpacing(0);
  column->addWidget(problems_);
  make_view_bar(centre);
  column->addWidget(view_bar_);
  auto* middle = new QSplitter(Qt::Vertical, centre);
  column->addWidget(middle, 1);
  middle->setAccessibleName(tr("Viewport and tabs"));
  middle->setObjectName("middle");
  middle->addWidget(viewport_);
  middle->addWidget(tabs_);
  middle->setStretchFactor(0, 3);
  middle->setStretchFactor(1, 1);
  middle->setCollapsible(0, false);
  middle->setSizes({450, 270});
  setCentralWidget(centre);
  make_docks();
  make_looks();
  for (const auto signal : {&Document::view_changed, &Document::replaced})
    connect(&document_, signal, this, &Window::show_switches);
  show_switches();
  connect_panels();
  prepare_lines();

  backend_ = new QLabel(this);
  backend_->setAccessibleName(tr("How the picture is drawn"));
  work_ = new QLabel(this);
  work_->setAccessibleName(tr("Work on the environment"));
  patch_ = new QLabel(this);
  patch_->setAccessibleName(tr("Under the cursor"));
  statusBar()->setAccessibleName(tr("Status"));
  pictures_ = new QLabel(this);
  pictures_->setAccessibleName(tr("Work on pictures"));
  blocks_ = new QLabel(this);
  blocks_->setAccessibleName(tr("What BC7 changes"));
  blocks_->setToolTip(tr(
      "What 1 % of the texels exceed in the viewport's largest textures: CIEDE2000, percent of gloss's exponent and of coverage. Then the bytes with all halves, and those of RGBA8. Over its budget: one of these is; etak pack tries such blocks again, and comes nearer. Small levels over it: only halves are, which etak pack can keep exact beside the blocks"));
  blocks_->setMinimumWidth(1);  // rather cut than a window that becomes wider
  statusBar()->addPermanentWidget(blocks_);
  statusBar()->addPermanentWidget(pictures_);
  statusBar()->addPermanentWidget(work_);
  statusBar()->addPermanentWidget(patch_);
  statusBar()->addPermanentWidget(backend_);
}

void Window::prepare_lines() {
  library_panel_->search().setProperty("search", true);
  for (QLineEdit* line : findChildren<QLineEdit*>()) {
    line->setAcceptDrops(false);  // the window takes dropped files; a line would paste their address
    if (qobject_cast<QAbstractSpinBox*>(line->parentWidget()) != nullptr) continue;
    // Once the text is taken as a value, the document undoes it. Setting the text clears the undo history of
    // the line.
    connect(line, &QLineEdit::editingFinished, line, [line] {
      if (line->isModified()) line->setText(line->text());
    });
  }
}

void Window::take_typed() {
  QWidget* at = focusWidget();
  if (at == nullptr || !at->hasFocus() || !is_typed_in(*at)) return;
  at->clearFocus();
  at->setFocus();
}

void Window::make_docks() {
  const auto dock = [this](const QString& title, const char* id, QWidget* inside, Qt::DockWidgetArea area) {
    auto* out = new QDockWidget(title, this);
    out->setObjectName(QLatin1String(id));
    out->setAccessibleName(title);
    out->setWidget(inside);
    addDockWidget(area, out);
    return out;
  };
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  library_panel_ = new LibraryPanel(*thumbnails_, this);
  project_panel_ = new ProjectPanel(document_, *thumbnails_, *validator_, this);
  inspector_ = new Inspector(document_, this);
  light_panel_ = new LightPanel(document_, this);
  view_panel_ = new ViewPanel(document_, look_, this);
  inspector_tabs_ = tab_widget(tr("Material, light, view"), this);
  inspector_tabs_->addTab(inspector_, tr("Material"));
  inspector_tabs_->addTab(light_panel_, tr("Light"));
  inspector_tabs_->addTab(view_panel_, tr("View"));
  QDockWidget* library = dock(tr("Library"), "library", library_panel_, Qt::LeftDockWidgetArea);
  QDockWidget* project = dock(tr("Project"), "project", project_panel_, Qt::LeftDockWidgetArea);
  QDockWidget* inspector = dock(tr("Inspector"), "inspector", inspector_tabs_, Qt::RightDockWidgetArea);
  QDockWidget* history = make_history();
  addDockWidget(Qt::LeftDockWidgetArea, history);
  tabifyDockWidget(project, history);
  history->hide();
  resizeDocks({library, inspector}, {300, 340}, Qt::Horizontal);
  resizeDocks({library, project}, {480, 240}, Qt::Vertical);
}

void Window::connect_panels() {
  library_panel_->set_library(document_.library());
  connect_favourites();
  connect(&document_, &Document::spectra_changed, this,
          [this] { library_panel_->set_library(document_.library()); });
  connect(library_panel_, &LibraryPanel::looked_at, this, &Window::preview);
  connect(library_panel_, &LibraryPanel::wanted, this, &Window::use_library_material);
  connect(project_panel_, &ProjectPanel::new_asked, this, [this] {
    ProjectMaterial material;
    material.name = tr("Material").toStdString();
    material.diffuse = {0.5, 0.5, 0.5};
    material.alpha_mode = AlphaMode::opaque;
    document_.add({as_preferred(material)}, {}, tr("new material"));
  });
  connect(project_panel_, &ProjectPanel::copy_asked, this, [this] {
    std::vector<ProjectMaterial> copies;
    for (const int row : project_panel_->in_hand())
      copies.push_back(document_.project().materials[static_cast<std::size_t>(row)]);
    document_.add(std::move(copies), {}, tr("duplicate"));
  });
  connect(project_panel_, &ProjectPanel::remove_asked, this,
          [this] { document_.remove(project_panel_->in_hand()); });
  connect(project_panel_, &ProjectPanel::picked, this, &Window::end_preview);
  connect(validator_, &Validator::findings_changed, this, &Window::count_findings);
  connect(findings_, &FindingsPanel::go_to, this, &Window::go_to_finding);
  connect(findings_, &FindingsPanel::fix_asked, this, &Window::fix_finding);
  connect(findings_, &FindingsPanel::mute_asked, this, &Window::mute_finding);
  inspector_->follow(*validator_);
  connect(inspector_, &Inspector::told, this, [this](const QString& message) {
    let_go_ = message;
    tell(message);
  });
  // A measurement that undo or a reset brought back is not gone any more.
  connect(&document_, &Document::material_changed, this, [this](int row) {
    if (document_.project().materials[static_cast<std::size_t>(row)].measured) untell(let_go_);
  });
  connect(&inspector_->textures(), &TextureSection::dropped, this, &Window::take_picture);
  connect(&inspector_->textures(), &TextureSection::refused, this,
          [this](const QString& why) { show_problems(tr("This cannot be taken"), {why}); });
  connect(&inspector_->textures(), &TextureSection::look_asked, this, [this](Channel channel) {
    tabs_->setCurrentWidget(texture_view_);
    texture_view_->show_channel(channel);
  });
}

bool Window::use_library_material(const QString& name) {
  const auto record = document_.library()->find(name.toStdString());
  if (!record) return false;
  const QString failure = failure_of([&] {
    document_.add({as_preferred(with_measured(material_of(*record), *document_.library()))}, {},
                  tr("add %1").arg(QString::fromStdString(record->name)));
  });
  if (!failure.isEmpty()) tell(failure);
  return failure.isEmpty();
}

void Window::show_viewport_only(bool on) {
  if (on == alone_) return;
  auto* middle = findChild<QSplitter*>("middle");
  if (on) {
    beside_ = saveState();
    below_ = middle->saveState();
  }
  alone_ = on;
  // The keys of a hidden menu bar would do nothing.
  menuBar()->setMaximumHeight(on ? 0 : QWIDGETSIZE_MAX);
  statusBar()->setVisible(!on);
  tabs_->setVisible(!on);
  view_bar_->setVisible(!on);
  if (on) {
    for (QDockWidget* each : findChildren<QDockWidget*>()) each->hide();
    viewport_->setFocus();
  } else {
    restoreState(beside_);
    middle->restoreState(below_);
  }
}

void Window::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && alone_) return show_viewport_only(false);
  if (event->key() == Qt::Key_Escape) return problems_->clear();
  if (event->key() == Qt::Key_Space) return viewport_->set_flipped(true);
  const int step = event->key() == Qt::Key_Right || event->key() == Qt::Key_Down ? 1
                   : event->key() == Qt::Key_Left || event->key() == Qt::Key_Up  ? -1
                                                                                 : 0;
  const int count = static_cast<int>(document_.project().materials.size());
  // Keys that another widget has no use for must not change the material behind the user's back.
  const QWidget* at = focusWidget();
  const bool here = at == nullptr || at == this || at == viewport_ || at == &project_panel_->list();
  if (step == 0 || count == 0 || !here) return QMainWindow::keyPressEvent(event);
  end_preview();
  document_.set_current((document_.current() + step + count) % count);
}

void Window::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space) return QMainWindow::keyReleaseEvent(event);
  if (!event->isAutoRepeat()) viewport_->set_flipped(false);
}

// Fields take the keys of undo for themselves. That is right only while they hold a typed text; otherwise the
// keys must undo changes of the document.
bool Window::event(QEvent* event) {
  if (event->type() == QEvent::ThemeChange && follows_desktop_)
    QTimer::singleShot(0, this, [] { apply_theme(*qApp, desktop_theme()); });
  return QMainWindow::event(event);
}

bool Window::eventFilter(QObject* object, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QMainWindow::eventFilter(object, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const QKeySequence keys(key->keyCombination());
  const auto* widget = qobject_cast<QWidget*>(object);
  const bool of_undo = undo_->shortcuts().contains(keys) || redo_->shortcuts().contains(keys);
  if (!of_undo || widget == nullptr || !(widget == this || isAncestorOf(widget)) || is_typed_in(*widget))
    return QMainWindow::eventFilter(object, event);
  event->ignore();
  return true;
}

void Window::restore() {
  if (!options_.remember) return;
  const QSettings settings;
  preferences_ = Preferences::remembered();
  if (preferences_.measure) document_.replace(fresh_project(), {}, true);
  restoreGeometry(settings.value("window/geometry").toByteArray());
  restoreState(settings.value("window/state").toByteArray());
  auto* middle = findChild<QSplitter*>("middle");
  middle->restoreState(settings.value("window/middle").toByteArray());
  inspector_->source().unfold(settings.value("window/record_unfolded", true).toBool());
}

void Window::remember() {
  if (!options_.remember) return;
  show_viewport_only(false);
  QSettings settings;
  settings.setValue("window/geometry", saveGeometry());
  settings.setValue("window/state", saveState());
  settings.setValue("window/middle", findChild<QSplitter*>("middle")->saveState());
  settings.setValue("window/record_unfolded", inspector_->source().is_unfolded());
}

void Window::closeEvent(QCloseEvent* event) {
  if (!may_lose_changes()) return event->ignore();
  remember();
  event->accept();
}

void Window::update_title() {
  setWindowTitle(tr("%1[*] - etak editor").arg(document_.title()));
  setWindowModified(!document_.is_saved());
}

void Window::tell(const QString& message) {
  constexpr int shown_ms = 8000;
  statusBar()->showMessage(message.section('\n', 0, 0), shown_ms);
}

void Window::untell(const QString& message) {
  if (!message.isEmpty() && statusBar()->currentMessage() == message.section('\n', 0, 0))
    statusBar()->clearMessage();
}

}  // namespace etak::editor
