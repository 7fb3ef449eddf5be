// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/viewport/background.h"
#include "core/brdf/models.h"
#include "core/material/f0.h"
#include "core/material/material.h"
#include "core/pages/material_plots.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QStackedWidget;
class QTabWidget;

namespace etak::editor {

class LinePlotWidget;
class PlotWidget;
class PolarPlotWidget;

/// The curves of the current material, each in a tab: n and k, R with the matching functions, F over angle,
/// the lobe. They are computed on a thread of their own. Of the requests that come while the thread works,
/// only the latest is computed.
class CurvesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CurvesPanel(QWidget* parent = nullptr);

  /// Shows a dataset of a material under `options`, and the lobe of a model.
  ///   gloss    is named in the title of the lobe
  ///   model    null: no lobe; must live as long as the program
  ///   values   values of the model's parameters, value_count() numbers
  void set_material(const Material& material, const Dataset& dataset, const F0Options& options, double gloss,
                    const Model* model, const std::vector<double>& values);
  /// Shows a surface without measured data: the tabs say that there are none; the lobe of the model is shown.
  void set_surface(const QString& name, double gloss, const Model* model, const std::vector<double>& values);

  /// Keeps the curves that are shown beside those of what is shown next, in the tabs of R, F and the lobe; then these
  /// are drawn as by `etak curve`. Of more than most_kept, the first are forgotten.
  void keep();
  void forget_kept();
  static constexpr std::size_t most_kept = 11;

  /// The plot of the tab in front, for menus that copy it.
  PlotWidget* current_plot() const;
  bool busy() const { return running_; }

 signals:
  /// The last request has been computed; the next painting shows it.
  void drawn();
  /// The text of the values under the cursor of the plot in front; empty without a cursor.
  void readout_changed(const QString& text);

 private:
  // Everything that the plots are made from. Curves of data that have not changed are not computed again.
  struct Request {
    std::string name;
    std::optional<Optics> optics;
    F0Options options;
    std::string what;
    bool same_optics = false;  // the data are those of the last request that was computed
    bool time_them = false;
    const Model* model = nullptr;
    std::vector<double> values;
    double theta_l_deg = 45, gloss = 0;

    // Whether the curves are the same, but for the light of the lobe.
    bool operator==(const Request& other) const;
  };
  struct Result {
    std::optional<OpticsCurves> optics;
    std::optional<AngleCurves> angles;
    std::optional<LobeCurve> lobe;
    std::string refusal;  // why there are no curves; empty where there are
  };
  static Result compute(const Request& request);

  struct Kept {
    Request request;
    Result result;
  };
  // The kept curves and those in hand, as one of them has them; those that it has not are left out.
  template <class CurveOf>
  std::vector<ColorCurve> several(const CurveOf& curve_of) const;

  void want(const std::string& name, double gloss, const Model* model, const std::vector<double>& values);
  void ask();
  void start();
  void take(const Request& request, Result result);
  void show_all();
  void show_optics();
  void show_angles();
  void show_lobe();
  QWidget* with_controls(PlotWidget* plot, const std::vector<QWidget*>& controls);

  QTabWidget* tabs_;
  QStackedWidget* beside_tabs_;
  LinePlotWidget *index_, *reflectance_, *angles_;
  PolarPlotWidget* lobe_;
  QComboBox* channel_;
  QCheckBox* scale_;
  QDoubleSpinBox* light_;

  Request wanted_, shown_;
  Result result_;
  std::vector<Kept> kept_;
  std::vector<std::pair<std::string, double>> form_ns_;  // measured once, because materials do not change it
  double exact_ns_ = 0;
  bool waiting_ = false, running_ = false, has_shown_ = false;
  bool index_left_ = false;  // n and k were looked at before a record came that has none
  Worker pool_;
};

}  // namespace etak::editor
