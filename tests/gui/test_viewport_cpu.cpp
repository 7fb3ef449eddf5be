// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include "app/viewport/viewport.h"

using namespace etak;

namespace {

ViewState gold() {
  ViewState out;
  out.a.surface.f0 = {1.0, 0.78, 0.34};
  out.a.specular = find_model(default_specular);
  out.a.diffuse = find_model(default_diffuse);
  out.b = out.a;
  out.lights = default_lights();
  return out;
}

}  // namespace

class ViewportCpu : public QObject {
  Q_OBJECT

 private slots:
  void draws_without_gl() {
    Viewport viewport(nullptr, Viewport::Backend::cpu);
    viewport.resize(200, 200);
    viewport.set_state(gold());
    const QImage picture = viewport.grab_picture();
    QCOMPARE(picture.size(), QSize(200, 200));
    QVERIFY(!viewport.uses_gl());
    QVERIFY(picture.pixelColor(100, 100) != picture.pixelColor(2, 2));
  }
};

QTEST_MAIN(ViewportCpu)
#include "test_viewport_cpu.moc"
