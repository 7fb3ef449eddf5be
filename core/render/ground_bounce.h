// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/light/lights.h"
#include "core/render/environment.h"

namespace etak {

/// One bounce of light from the ground of a light setup (LightSetup::ground). The ground is level, endless and diffuse, and
/// as bright everywhere as right under the object, whose shadow it does not have: its radiance is its albedo over pi
/// times the irradiance there. So it lights a diffuse surface by the form factor (1 - ny) / 2, and is what is mirrored
/// below the horizon.

/// That radiance.
///   around   the environment, of which the upper half counts; null: none
Vec3 ground_radiance(const LightSetup& setup, const Environment* around);

/// The environment with the ground below its horizon, prefiltered anew; `around` itself where the setup has no ground.
///   threads   for prefiltering; the result is the same for any number
std::shared_ptr<const Environment> with_ground(
    const LightSetup& setup, std::shared_ptr<const Environment> around, unsigned threads,
    Environment::Prefilter prefilter = Environment::Prefilter::full);

/// For setups without an environment: the same setup with the ground as the lower hemisphere. Throws Error for
/// hemispheres whose axis is not +y.
LightSetup with_ground(LightSetup setup);

}  // namespace etak
