// SPDX-License-Identifier: Apache-2.0
#include "app/editor/options.h"

#include <QObject>

#include "core/brdf/models.h"

namespace etak::editor {

const QStringList& screenshot_states() {
  static const QStringList states =
      QStringLiteral(
          "default reflectance fresnel lobe shader textures light view compare wedge quad zone energy angles gamut library layers preview findings pack picture keys problem near drop mask empty glass water rim overcast sunset night backdrop ground exposure engine photograph mesh alone blocks")
          .split(' ');
  return states;
}

QString help_text() {
  return QObject::
      tr("usage: etak-editor [FILE]\n"
         "       etak-editor --screenshot FILE [MATERIAL] [--model ID] [--size WxH] [--theme dark|light] [--state NAME]\n"
         "\n"
         "The material editor: pick a measured material, see its F0 under the sources' light models, author diffuse,\n"
         "specular, gloss and alpha, be warned by the validator, export and pack.\n"
         "\n"
         "FILE is a project or a material (.json); a pipe that holds one, or - for standard input.\n"
         "\n"
         "  --screenshot FILE   write a PNG of the window and exit; needs no display with QT_QPA_PLATFORM=offscreen\n"
         "  --model ID          specular model of the screenshot's material (see etak models)\n"
         "  --size WxH          of the window, default 1280x800; no less than its panels need\n"
         "  --state NAME        what the screenshot shows, one of:\n"
         "                      %1\n"
         "  --theme NAME        dark or light, in place of the remembered one\n"
         "  --cpu               draw without OpenGL\n"
         "  --time-start        print how long the first picture took from the start of the process, and exit\n"
         "  --input-timeout SECONDS\n"
         "                      how long a named pipe may be silent at first (default 60)\n"
         "  --help, --version\n"
         "\n"
         "example:\n"
         "  QT_QPA_PLATFORM=offscreen etak-editor --screenshot gold.png gold --model ggx-f82\n")
          .arg(screenshot_states().join(", "));
}

Options parse_options(const QStringList& arguments) {
  Options out;
  for (int i = 1; i < arguments.size(); ++i) {
    QString name = arguments[i], value;
    bool has_value = false;
    if (const qsizetype equals = name.indexOf('='); name.startsWith("--") && equals > 0) {
      value = name.mid(equals + 1);
      name = name.left(equals);
      has_value = true;
    }
    const auto take = [&] {
      if (!has_value && i + 1 < arguments.size()) value = arguments[++i];
      if (value.isEmpty()) out.error = QObject::tr("%1 needs a value").arg(name);
      return value;
    };
    if (name == "--help" || name == "-h")
      out.help = true;
    else if (name == "--version")
      out.version = true;
    else if (name == "--cpu")
      out.cpu = true;
    else if (name == "--time-start")
      out.time_start = true;
    else if (name == "--screenshot")
      out.screenshot = take();
    else if (name == "--model")
      out.model = take();
    else if (name == "--state")
      out.state = take();
    else if (name == "--theme") {
      const QString theme = take();
      if (theme != "dark" && theme != "light")
        out.error = QObject::tr("--theme: %1; expected dark or light").arg(theme);
      out.theme = theme_named(theme);
    } else if (name == "--size") {
      const QStringList sides = take().split('x');
      out.size = sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : QSize();
      if (out.size.width() < 320 || out.size.height() < 240 || out.size.width() > 8192 ||
          out.size.height() > 8192)
        out.error = QObject::tr("--size: %1; expected WxH of 320x240 to 8192x8192").arg(value);
    } else if (name == "--input-timeout") {
      bool well = false;
      out.input_timeout = take().toDouble(&well);
      if (!well || !(*out.input_timeout >= 0 && *out.input_timeout <= 1e6))
        out.error = QObject::tr("--input-timeout: %1; expected seconds, 0 to 1e6").arg(value);
    } else if (name.startsWith('-') && name.size() > 1) {
      out.error = QObject::tr("%1 is no option; see --help").arg(name);
    } else {
      out.subjects << arguments[i];
    }
  }
  if (!out.state.isEmpty() && !screenshot_states().contains(out.state))
    out.error = QObject::tr("--state: %1; expected one of %2").arg(out.state, screenshot_states().join(", "));
  if (!out.model.isEmpty()) {
    const Model* model = find_model(out.model.toStdString());
    if (model == nullptr || model->kind == ModelKind::diffuse)
      out.error = QObject::tr("--model: %1; expected a specular model that etak models lists").arg(out.model);
  }
  if (out.screenshot.isEmpty() && !(out.model.isEmpty() && out.state.isEmpty()) && out.error.isEmpty())
    out.error = QObject::tr("--model and --state go with --screenshot");
  if (out.subjects.size() > 1)
    out.error = QObject::tr("%1: one file or material at a time").arg(out.subjects[1]);
  return out;
}

}  // namespace etak::editor
