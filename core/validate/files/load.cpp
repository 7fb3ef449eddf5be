// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/load.h"

#include <list>

#include "core/base/error.h"
#include "core/image/load.h"
#include "core/judge/pixels/flat_rows.h"
#include "core/validate/files/metal_rough.h"

namespace etak {

std::unique_ptr<RowSource> open_target_file(const TargetFile& file, const PictureDoor& door) {
  return file.bytes ? open_picture(*file.bytes, file.label, door) : open_picture(file.path, door);
}

namespace {

// The rows of a picture whose fourth channel is red of another.
class RowsWithFourth : public RowSource {
 public:
  RowsWithFourth(std::unique_ptr<RowSource> colour, std::unique_ptr<RowSource> fourth)
      : RowSource(colour->header()), colour_(std::move(colour)), fourth_(std::move(fourth)) {
    header_.channels = 4;
  }

  void read_rows(std::uint8_t* rgba, std::size_t stride, int count) override {
    row_.resize(4 * static_cast<std::size_t>(header_.width));
    for (int y = 0; y < count; ++y, rgba += stride) {
      colour_->read_rows(rgba, stride, 1);
      fourth_->read_rows(row_.data(), row_.size(), 1);
      for (std::size_t i = 0; i < row_.size(); i += 4) rgba[i + 3] = row_[i];
    }
  }

 private:
  std::unique_ptr<RowSource> colour_, fourth_;
  std::vector<std::uint8_t> row_;
};

}  // namespace

std::unique_ptr<RowSource> open_page(const CheckTarget& target, const TargetFile& file,
                                     const PictureOpener& open) {
  std::unique_ptr<RowSource> rows = spread_rows(target, file, open(file));
  if (file.channels != "+") return rows;
  const TargetFile& apart = target.files[static_cast<std::size_t>(&file - target.files.data()) + 1];
  std::unique_ptr<RowSource> fourth = open(apart);
  if (rows->header().floating || fourth->header().floating)
    throw Error::at(apart.label,
                    "cannot hold the fourth channel of " + file.label + ", since one of them holds floats",
                    "codes of 8 bits in both");
  if (fourth->header().width != rows->header().width || fourth->header().height != rows->header().height)
    throw Error::at(apart.label, "is not as large as " + file.label, "one size");
  return std::make_unique<RowsWithFourth>(std::move(rows), std::move(fourth));
}

Pictures load_pictures(const CheckTarget& target, const PictureDoor& door) {
  if (MetalRoughSet::is_set(target)) return MetalRoughSet(target, door).convert();
  Pictures out;
  const auto load = [&](const TargetFile* file, Image8& to) {
    if (file == nullptr) return;
    std::list<Image8> codes;  // of rows that were floats, each read from here
    const auto source = open_page(target, *file, [&](const TargetFile& each) {
      auto rows = open_target_file(each, door);
      if (!rows->header().floating) return rows;
      return rows_of(codes.emplace_back(codes_of(load_picture(each.picture(), door), true)));
    });
    to = Image8(source->header().width, source->header().height, 4);
    source->read_rows(to.values.data(), 4 * static_cast<std::size_t>(to.width), to.height);
  };
  load(target.with_role({FileRole::diffuse_alpha}), out.a);
  load(target.with_role({FileRole::specular_gloss, FileRole::f0_only}), out.b);
  return out;
}

}  // namespace etak
