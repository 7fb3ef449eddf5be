// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/load.h"

#include "core/image/load.h"
#include "core/judge/pixels/flat_rows.h"
#include "core/validate/files/metal_rough.h"

namespace etak {

std::unique_ptr<RowSource> open_target_file(const TargetFile& file, const PictureDoor& door) {
  return file.bytes ? open_picture(*file.bytes, file.label, door) : open_picture(file.path, door);
}

Pictures load_pictures(const CheckTarget& target, const PictureDoor& door) {
  if (MetalRoughSet::is_set(target)) return MetalRoughSet(target, door).convert();
  Pictures out;
  const auto load = [&](const TargetFile* file, Image8& to) {
    if (file == nullptr) return;
    Image8 codes;
    auto source = open_target_file(*file, door);
    if (source->header().floating)
      source = rows_of(codes = codes_of(load_picture(file->picture(), door), true));
    source = spread_rows(target, *file, std::move(source));
    to = Image8(source->header().width, source->header().height, 4);
    source->read_rows(to.values.data(), 4 * static_cast<std::size_t>(to.width), to.height);
  };
  load(target.with_role({FileRole::diffuse_alpha}), out.a);
  load(target.with_role({FileRole::specular_gloss, FileRole::f0_only}), out.b);
  return out;
}

}  // namespace etak
