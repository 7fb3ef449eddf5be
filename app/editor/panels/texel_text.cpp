// SPDX-License-Identifier: Apache-2.0
#include "app/editor/panels/texel_text.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/viewport/qt_text.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/color/gloss.h"
#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "core/image/image.h"
#include "core/judge/nearest.h"
#include "core/material/f0.h"
#include "core/project/project_pictures.h"

namespace etak::editor {
namespace {

QString texel_color(const LinearRgb& c) {
  const Srgb8 codes = srgb_u8(c);
  return QObject::tr("code %1 %2 %3 (%4), linear %5 %6 %7, Y %8")
      .arg(codes.r)
      .arg(codes.g)
      .arg(codes.b)
      .arg(qt_text(hex(codes)))
      .arg(qt_text(fixed(c.r, 3)), qt_text(fixed(c.g, 3)), qt_text(fixed(c.b, 3)),
           qt_text(fixed(luminance_of(vec(c)), 3)));
}

QString texel_f0(const LinearRgb& c) {
  QString out = QObject::tr(", %1 the zone").arg(qt_text(name(zone_of(luminance_of(vec(c))))));
  const auto near =
      nearest_f0(KnownMaterials::builtin(), vec(c), [](const KnownF0& each) { return each.preferred; });
  if (near != nullptr)
    out += QObject::tr("; nearest %1, \u0394E %2")
               .arg(qt_text(near->name), qt_text(number(delta_e_of(vec(c), *near), 2)));
  return out;
}

QString texel_value(Channel channel, double value) {
  const QString out =
      QObject::tr("code %1, %2").arg(to_code(static_cast<float>(value))).arg(qt_text(fixed(value, 3)));
  if (channel != Channel::gloss) return out;
  const Gloss gloss(value);
  return out + QObject::tr(", roughness %1, exponent %2")
                   .arg(qt_text(fixed(gloss.roughness(), 3)), qt_text(number(gloss.exponent(), 4)));
}

}  // namespace

QString texel_text(const SurfaceTextures& textures, Channel channel, const QPoint& at) {
  const Image& from = channel_image(textures, channel);
  if (at.x() < 0 || at.y() < 0 || at.x() >= from.width || at.y() >= from.height) return {};
  const auto texel = from.at(at.x(), at.y());
  const QString place = QObject::tr("texel %1, %2: ").arg(at.x()).arg(at.y());
  const LinearRgb color{double{texel[0]}, double{texel[1]}, double{texel[2]}};
  if (channel == Channel::normal) {
    const double length = std::sqrt(color.r * color.r + color.g * color.g + color.b * color.b);
    const double cosine = length > 0 ? std::clamp(color.b / length, -1.0, 1.0) : 1;
    return place +
           QObject::tr("%1 %2 %3, leans by %4\u00b0, length %5")
               .arg(qt_text(fixed(color.r, 3)), qt_text(fixed(color.g, 3)), qt_text(fixed(color.b, 3)),
                    qt_text(fixed(std::acos(cosine) * 180 / std::numbers::pi, 1)), qt_text(fixed(length, 3)));
  }
  if (!is_color(channel)) return place + texel_value(channel, double{texel[3]});
  return place + texel_color(color) + (channel == Channel::specular ? texel_f0(color) : QString());
}

}  // namespace etak::editor
