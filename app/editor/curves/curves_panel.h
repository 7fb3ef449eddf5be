// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QThreadPool>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/brdf/models.h"
#include "core/material/f0.h"
#include "core/material/material.h"
#include "core/pages/material_plots.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QStackedWidget;
class QTabWidget;

namespace etak::editor {

class LinePlotWidget;
class PlotWidget;
class PolarPlotWidget;

/// The curves of the material in hand, a tab each: n and k, R with the matching functions, F over angle, the
/// lobe. Everything is computed on a thread of its own; what is asked for while that works is answered last,
/// and only the latest of it.
class CurvesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CurvesPanel(QWidget* parent = nullptr);
  ~CurvesPanel() override;

  /// Shows a dataset of a material under `options`, and the lobe of a model.
  ///   gloss    for the title of the lobe
  ///   model    null: no lobe; lives as long as the program
  ///   values   the model's parameters, value_count() numbers
  void set_material(const Material& material, const Dataset& dataset, const F0Options& options, double gloss,
                    const Model* model, const std::vector<double>& values);
  /// A surface without data: the tabs say so, the lobe stays.
  void set_surface(const QString& name, double gloss, const Model* model, const std::vector<double>& values);

  /// The plot of the tab in front, for those who copy it by a menu of theirs.
  PlotWidget* current_plot() const;
  bool busy() const { return running_; }

 signals:
  /// What was asked for last has been computed and is on the screen at the next painting.
  void drawn();
  /// The values under the cursor of the plot in front; empty without a cursor.
  void readout_changed(const QString& text);

 private:
  // What is to be drawn; data that have not changed since are not computed again.
  struct Request {
    std::string name;
    std::optional<Optics> optics;
    F0Options options;
    std::string what;
    bool same_optics = false;  // as the last one that was computed
    bool time_them = false;
    const Model* model = nullptr;
    std::vector<double> values;
    double theta_l_deg = 45, gloss = 0;
  };
  struct Result {
    std::optional<OpticsCurves> optics;
    std::optional<AngleCurves> angles;
    std::optional<LobeCurve> lobe;
    std::string refusal;  // not empty: why there are no curves
  };
  static Result compute(const Request& request);

  void ask();
  void start();
  void take(const Request& request, Result result);
  void show_optics();
  void show_angles();
  void show_lobe();
  QWidget* with_controls(PlotWidget* plot, const std::vector<QWidget*>& controls);

  QTabWidget* tabs_;
  QStackedWidget* beside_tabs_;
  LinePlotWidget *index_, *reflectance_, *angles_;
  PolarPlotWidget* lobe_;
  QComboBox *channel_, *scale_;
  QDoubleSpinBox* light_;

  Request wanted_, shown_;
  Result result_;
  std::vector<std::pair<std::string, double>> form_ns_;  // measured once: no material changes them
  double exact_ns_ = 0;
  bool waiting_ = false, running_ = false, has_shown_ = false;
  QThreadPool pool_;
};

}  // namespace etak::editor
