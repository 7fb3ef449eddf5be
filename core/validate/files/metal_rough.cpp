// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/metal_rough.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <mutex>

#include "core/image/load.h"
#include "core/scene/gltf_convert.h"

namespace etak {

ScenePictures::ScenePictures(const std::vector<PictureFile>& images, const PictureDoor& door)
    : images_(&images), door_(&door), codes_(images.size()), headers_(images.size()) {}

void ScenePictures::load(int image) {
  const auto i = static_cast<std::size_t>(image);
  if (codes_[i].width != 0) return;
  Picture picture = load_picture((*images_)[i], *door_);
  headers_[i] = picture.header;
  codes_[i] = codes_of(std::move(picture), true);
}

void ScenePictures::set(int image, Image8 codes) {
  codes_[static_cast<std::size_t>(image)] = std::move(codes);
}

const Image8& ScenePictures::codes(int image) {
  load(image);
  return codes_[static_cast<std::size_t>(image)];
}

const PictureHeader& ScenePictures::header(int image) {
  const auto i = static_cast<std::size_t>(image);
  if (headers_[i].width == 0) headers_[i] = open_picture((*images_)[i], *door_)->header();
  return headers_[i];
}

Pictures convert_material(const GltfMaterial& material, ScenePictures& pictures) {
  std::size_t clamped = 0;
  const SceneImages<std::uint8_t> images = [&](int image) -> const Image8& { return pictures.codes(image); };
  MaterialPair pair = scene_material_pair(material, images, GlossForm::one_minus_roughness,
                                          material.alpha_mode != AlphaMode::opaque, clamped);
  Pictures out;
  out.metallic = scene_metallic(material, images, pair.diffuse_alpha.width, pair.diffuse_alpha.height);
  out.a = std::move(pair.diffuse_alpha);
  out.b = std::move(pair.specular_gloss);
  return out;
}

bool MetalRoughSet::is_part(FileRole role) {
  return traits(role).kind == RoleKind::metal_rough;
}

bool MetalRoughSet::is_set(const CheckTarget& target) {
  return std::ranges::any_of(target.files, [](const TargetFile& file) { return is_part(file.role); });
}

// Takes the channels of an image by the letters of names.h: r roughness, s smoothness, m metallic.
void MetalRoughSet::add_channels(std::string_view letters, int image) {
  for (std::size_t i = 0; i < letters.size(); ++i) {
    if (letters[i] == 'm' && metallic_.image < 0) metallic_ = {image, i, false};
    if ((letters[i] == 'r' || letters[i] == 's') && roughness_.image < 0)
      roughness_ = {image, i, letters[i] == 's'};
  }
}

MetalRoughSet::MetalRoughSet(const CheckTarget& target, const PictureDoor& door)
    : door_(&door), pictures_(images_, door) {
  material_.alpha_mode = AlphaMode::blend;  // the file's alpha is kept
  const auto texture = [](int image) {
    GltfTexture out;
    out.image = image;
    out.sampler.wrap_u = out.sampler.wrap_v = Wrap::clamp;
    return out;
  };
  for (const TargetFile& file : target.files) {
    const auto image = static_cast<int>(images_.size());
    images_.push_back(file.picture());
    is_data_.push_back(traits(file.role).data);
    if (file.role == FileRole::base_color) material_.base_color_texture = texture(image);
    if (file.role == FileRole::diffuse_alpha) material_.diffuse_texture = texture(image);
    if (file.role == FileRole::specular_gloss) specular_ = image;
    if (file.role == FileRole::metallic) add_channels("m", image);
    if (file.role == FileRole::roughness) add_channels("r", image);
    if (file.role == FileRole::gloss) add_channels("s", image);
    if (file.role != FileRole::metal_rough) continue;
    // A picture that is packed as glTF packs them can be used as it is.
    const std::string_view letters = file.channels.empty() ? "-rm-" : std::string_view(file.channels);
    if (const std::size_t at = letters.find('o'); at != letters.npos && !occlusion_)
      occlusion_ = std::make_shared<Occlusion>(Occlusion{static_cast<std::size_t>(image), at, {}});
    if (letters.substr(1, 2) == "rm" && !material_.metallic_roughness_texture)
      material_.metallic_roughness_texture = texture(image);
    else
      add_channels(letters, image);
  }
  material_.specular_glossiness = specular_ >= 0;
  const bool whole = material_.metallic_roughness_texture.has_value();
  if (specular_ >= 0 || (!whole && (metallic_.image >= 0 || roughness_.image >= 0))) {
    joined_ = static_cast<int>(images_.size());
    images_.push_back({"", "", target.label});
    (specular_ >= 0 ? material_.specular_glossiness_texture : material_.metallic_roughness_texture) =
        texture(joined_);
  }
  // A base colour without a metallic channel is taken for that of a dielectric.
  if (!whole && metallic_.image < 0) material_.metallic = 0;
  pictures_ = ScenePictures(images_, door);
  data_ = std::make_shared<std::vector<DataCodes>>(target.files.size());
}

namespace {

void count_occlusion(const Image8& codes, MetalRoughSet::Occlusion& out) {
  const auto channels = static_cast<std::size_t>(codes.channels);
  if (out.channel >= channels) return;
  for (std::size_t i = out.channel; i < codes.values.size(); i += channels)
    ++out.codes.codes[codes.values[i]];
  out.codes.texels += codes.pixel_count();
}

}  // namespace

const DataCodes* MetalRoughSet::data(std::size_t file) const {
  return (*data_)[file].texels == 0 ? nullptr : &(*data_)[file];
}

// Counts the codes of some of the rows of an image, of which `codes` has those from `first_row` on.
void MetalRoughSet::count_codes(std::size_t image, const Image8& codes, int first_row, int height) const {
  constexpr int most_rows = 256, most_of_colours = 64;  // of colours: rows, and four times as many columns
  if (image >= is_data_.size()) return;
  const bool is_data = is_data_[image];
  DataCodes& out = (*data_)[image];
  const int step = 1 + (height - 1) / (is_data ? most_rows : most_of_colours);
  const int across = is_data ? 1 : 1 + (codes.width - 1) / (4 * most_of_colours);
  const std::size_t channels = std::min<std::size_t>(3, static_cast<std::size_t>(codes.channels));
  for (int y = (step - first_row % step) % step; y < codes.height; y += step)
    for (int x = 0; x < codes.width; x += across) {
      const std::uint8_t* texel = codes.at(x, y).data();
      ++out.texels;
      if (!is_data) {
        if (channels == 3) out.normals.add(texel);
        continue;
      }
      for (std::size_t c = 0; c < channels; ++c) ++out.codes[c][texel[c]];
      if (channels == 3) out.coloured += is_coloured(texel);
    }
}

Pictures MetalRoughSet::convert() {
  if (occlusion_) {
    occlusion_->codes = {};
    count_occlusion(pictures_.codes(static_cast<int>(occlusion_->file)), *occlusion_);
  }
  for (std::size_t i = 0; i < is_data_.size(); ++i) {
    (*data_)[i] = {};
    count_codes(i, pictures_.codes(static_cast<int>(i)), 0, header(static_cast<int>(i)).height);
  }
  return convert(pictures_);
}

// The joined picture: of a metal-rough set G roughness and B metallic, else F0 with gloss, 1 - roughness.
Image8 MetalRoughSet::joined(ScenePictures& pictures) const {
  int width = 0, height = 0;
  for (const int image : {specular_, metallic_.image, roughness_.image})
    if (image >= 0) {
      width = std::max(width, pictures.codes(image).width);
      height = std::max(height, pictures.codes(image).height);
    }
  Image8 out(width, height, specular_ >= 0 ? 4 : 3);
  // Calls put(texel of `out`, texel of `image` with its four channels).
  const auto each = [&](int image, auto put) {
    const Image8& from = pictures.codes(image);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const auto texel = from.at(texel_under(x, width, from.width), texel_under(y, height, from.height));
        put(out.at(x, y), four_channels(texel.data(), texel.size(), std::uint8_t{255}));
      }
  };
  const auto fill = [&](const Channel& channel, std::size_t to, bool inverted) {
    const bool turn = channel.inverted != inverted;
    each(channel.image, [&](auto texel, const auto& values) {
      const std::uint8_t value = values[channel.index];
      texel[to] = turn ? static_cast<std::uint8_t>(255 - value) : value;
    });
  };
  std::fill(out.values.begin(), out.values.end(), std::uint8_t{255});
  if (specular_ >= 0) {
    each(specular_, [](auto texel, const auto& values) { std::copy_n(values.begin(), 4, texel.begin()); });
    if (roughness_.image >= 0) fill(roughness_, 3, true);
    return out;
  }
  if (roughness_.image >= 0) fill(roughness_, 1, false);
  if (metallic_.image >= 0) fill(metallic_, 2, false);
  return out;
}

Pictures MetalRoughSet::convert(ScenePictures& pictures) const {
  if (joined_ >= 0) pictures.set(joined_, joined(pictures));
  return convert_material(material_, pictures);
}

/// The strip of a set that is being read. The first of the three sources that needs it decodes and converts
/// it.
class MetalRoughStrips {
 public:
  MetalRoughStrips(const MetalRoughSet& set, std::vector<std::unique_ptr<RowSource>> files)
      : set_(set), files_(std::move(files)), pictures_(set.images_, *set.door_) {
    if (set_.occlusion_) set_.occlusion_->codes = {};
    std::ranges::fill(*set_.data_, DataCodes{});
  }

  void copy_rows(Image8 Pictures::*picture, int first, int count, std::uint8_t* rgba, std::size_t stride) {
    const std::lock_guard guard(lock_);
    if (first == end_) decode(count);
    rows_of(strip_.*picture)->read_rows(rgba, stride, count);
  }

 private:
  void decode(int count) {
    // After a failure each source throws the same exception.
    if (failure_) std::rethrow_exception(failure_);
    try {
      for (std::size_t i = 0; i < files_.size(); ++i) {
        Image8 codes(files_[i]->header().width, count, 4);
        files_[i]->read_rows(codes.values.data(), 4 * static_cast<std::size_t>(codes.width), count);
        if (set_.occlusion_ && set_.occlusion_->file == i) count_occlusion(codes, *set_.occlusion_);
        set_.count_codes(i, codes, end_, files_[i]->header().height);
        pictures_.set(static_cast<int>(i), std::move(codes));
      }
      strip_ = set_.convert(pictures_);
      end_ += count;
    } catch (...) {
      failure_ = std::current_exception();
      throw;
    }
  }

  const MetalRoughSet& set_;
  const std::vector<std::unique_ptr<RowSource>> files_;
  std::mutex lock_;
  ScenePictures pictures_;
  Pictures strip_;
  int end_ = 0;
  std::exception_ptr failure_;
};

namespace {

class ConvertedRows final : public RowSource {
 public:
  ConvertedRows(std::shared_ptr<MetalRoughStrips> strips, Image8 Pictures::*picture, PictureHeader header)
      : RowSource(std::move(header)), strips_(std::move(strips)), picture_(picture) {}

  void read_rows(std::uint8_t* rgba, std::size_t stride, int count) override {
    strips_->copy_rows(picture_, next_, count, rgba, stride);
    next_ += count;
  }

 private:
  std::shared_ptr<MetalRoughStrips> strips_;
  Image8 Pictures::*picture_;
  int next_ = 0;
};

}  // namespace

PictureRows MetalRoughSet::rows() {
  std::vector<std::unique_ptr<RowSource>> files;
  for (const PictureFile& image : images_) {
    if (!image.bytes.empty()) return {};
    if (image.path.empty()) continue;  // the joined one, which is last
    auto file = open_rows(image.path);
    if (!file || file->header().floating ||
        (!files.empty() && (file->header().width != files[0]->header().width ||
                            file->header().height != files[0]->header().height)))
      return {};
    files.push_back(std::move(file));
  }
  if (files.empty()) return {};
  PictureHeader header{files[0]->header().width, files[0]->header().height, 4};
  header.format = "memory";
  const auto strips = std::make_shared<MetalRoughStrips>(*this, std::move(files));
  PictureRows rows;
  rows.a = std::make_unique<ConvertedRows>(strips, &Pictures::a, header);
  rows.b = std::make_unique<ConvertedRows>(strips, &Pictures::b, header);
  if (is_specular()) return rows;
  header.channels = 1;
  rows.metallic = std::make_unique<ConvertedRows>(strips, &Pictures::metallic, header);
  return rows;
}

}  // namespace etak
