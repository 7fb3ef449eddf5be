// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/color/rgb.h"

namespace etak {

struct OcioWay;

/// A colour space of an OpenColorIO config as a target for etak's colours.
///
/// Values enter through an interchange role of the config: aces_interchange (ACES2065-1) or
/// cie_xyz_d65_interchange, whichever has the same reference (scene or display) as the space asked for.
class OcioSpace {
 public:
  /// Colour in this space: linear light or encoded, as the config defines it; never clipped by etak.
  ///   xyz      under any illuminant
  ///   white    of the perfect reflector under that illuminant; Bradford's adaptation takes it to the white
  ///            of the interchange space, so that it comes out as (1, 1, 1) in every linear RGB space of a
  ///            well-made config
  ///   error    OpenColorIO computes in float: 1e-6 for colours in [0, 1] and matrix spaces
  LinearRgb from_xyz(const Xyz& xyz, const Xyz& white) const;

  const std::string& name() const;  // as the config spells it
  const std::string& role() const;  // the interchange role in use

 private:
  friend class OcioConfig;
  explicit OcioSpace(std::shared_ptr<const OcioWay> way) : way_(std::move(way)) {}
  std::shared_ptr<const OcioWay> way_;
};

/// A colour space of an OpenColorIO config as the source of colours, such as pictures are stored in.
class OcioSource {
 public:
  /// Values of the space, in place to linear sRGB (D65); never clipped. White goes to white: Bradford from
  /// the interchange space's white. May be called from several threads.
  ///   rgb     `count` pixels of three, as fractions of full scale
  ///   error   OpenColorIO computes in float, and configs round their matrices: 1e-5 for values in [0, 1]
  void to_linear_srgb(float* rgb, std::size_t count) const;

 private:
  friend class OcioConfig;
  explicit OcioSource(std::shared_ptr<const OcioWay> way) : way_(std::move(way)) {}
  std::shared_ptr<const OcioWay> way_;
};

/// A display and view as text for OpenGL 3.3, made by OpenColorIO.
struct OcioShader {
  /// A table that the text reads, to be bound as a texture. Rows of `values` from the first, edges clamped.
  struct Table {
    std::string sampler;  // of type sampler1D, sampler2D (height above 0) or sampler3D (depth above 0)
    int width = 0, height = 0, depth = 0;
    int channels = 3;      // 1 or 3
    bool nearest = false;  // no filtering; else linear
    std::vector<float> values;
  };
  std::string text;      // samplers and functions
  std::string function;  // vec3 to vec3: linear sRGB to display code values
  std::vector<Table> tables;
};

/// A display and view of an OpenColorIO config: how a picture in linear light is to look on a screen.
class OcioDisplay {
 public:
  /// Linear sRGB in place to display code values, of which 0..1 can be shown; never clipped by etak.
  ///   rgb     `count` pixels of three
  ///   error   OpenColorIO computes in float, and configs round their matrices: 1e-5 with etak's own config
  void apply(float* rgb, std::size_t count) const;

  /// What apply() does, for a GPU: OpenColorIO's own shader, with its tables.
  ///   error   8-bit codes within 1 of apply()'s: OpenColorIO puts curves into tables there
  OcioShader shader() const;

  const std::string& display() const;
  const std::string& view() const;

 private:
  friend class OcioConfig;
  explicit OcioDisplay(std::shared_ptr<const OcioWay> way) : way_(std::move(way)) {}
  std::shared_ptr<const OcioWay> way_;
};

/// A display of a config, and its views, the default one first.
struct OcioDisplayInfo {
  std::string name;
  std::vector<std::string> views;
  friend bool operator==(const OcioDisplayInfo&, const OcioDisplayInfo&) = default;
};

/// How messages and OcioConfig::name() call etak's own config.
inline constexpr const char* builtin_ocio_config = "<built-in OpenColorIO config>";

/// An opened config: the one door to OpenColorIO (target etak::ocio, only where that library is found; not part of
/// etak::core, so that the start-up binary stays light). Errors name the config.
class OcioConfig {
 public:
  /// Throws Error when the config cannot be read.
  ///   file   empty: the one named by $OCIO, or when that is unset etak's own config (resources/ocio/config.ocio)
  static OcioConfig open(const std::string& file);

  const std::string& name() const;  // path, or builtin_ocio_config

  /// Opens a space. Both functions throw Error that names the space when there is no such space (the nearest names are told), the space holds
  /// data and no colour, or the interchange roles are missing.
  ///   name   name, alias or role in the config
  OcioSpace space(const std::string& name) const;
  OcioSource source(const std::string& name) const;

  /// Throws Error that lists the config's displays, or the display's views, where one is unknown.
  ///   display, view   as the config spells them; empty: its default display, and that display's default view
  OcioDisplay display(const std::string& display, const std::string& view) const;

  /// The default display first. Throws Error.
  std::vector<OcioDisplayInfo> displays() const;

 private:
  struct State;
  explicit OcioConfig(State state);
  std::shared_ptr<const State> state_;
};

}  // namespace etak
