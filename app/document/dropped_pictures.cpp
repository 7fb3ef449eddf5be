// SPDX-License-Identifier: Apache-2.0
#include "app/document/dropped_pictures.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <map>
#include <optional>

#include "app/document/files.h"
#include "app/document/looked_at.h"
#include "app/document/pictures.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/names/picture_sets.h"
#include "core/validate/find/picture_namer.h"

namespace etak::editor {
namespace {

QString file_name(const std::string& path) {
  return QFileInfo(qt_text(path)).fileName();
}

// A picture whose name tells nothing: its set has the name of the file.
NamedPicture unnamed(const std::string& path) {
  NamedPicture out;
  out.path = path;
  out.name.set = QFileInfo(qt_text(path)).completeBaseName().toStdString();
  out.key = (QFileInfo(qt_text(path)).path() + '/' + qt_text(out.name.set)).toLower().toStdString();
  out.name.role = FileRole::ignored;
  return out;
}

// Whether the name is no proof and was not read at its end: "metal_plate.png" may be a plate of metal as well as
// metalness, and so may a picture in a folder "metal".
bool may_mean_nothing(const NamedPicture& picture) {
  const QString stem = QFileInfo(qt_text(picture.path)).completeBaseName();
  return picture.as == ListedAs::unknown &&
         (picture.by_folder || !stem.startsWith(qt_text(picture.name.set)));
}

// The word of a picture that no rule judges: "cavity" of Wall_Cavity.png.
QString own_word(const NamedPicture& picture) {
  const QString stem = QFileInfo(qt_text(picture.path)).completeBaseName();
  const auto before = static_cast<qsizetype>(picture.name.set.size());
  return stem.mid(before).remove(0, before == 0 ? 0 : 1).toLower();
}

using Group = std::vector<NamedPicture>;

// Puts pictures whose names tell nothing to the set whose name theirs begin with: Wall_ID.png to Wall_BaseColor.png.
void join_unnamed(std::map<std::string, Group>& groups) {
  for (auto each = groups.begin(); each != groups.end();) {
    const std::string& key = each->first;
    const auto known = std::ranges::find_if(groups, [&](const auto& other) {
      return other.first.size() < key.size() && key.starts_with(other.first) &&
             name_separators.find(key[other.first.size()]) != name_separators.npos &&
             other.second.front().name.role != FileRole::ignored;
    });
    if (each->second.size() > 1 || each->second[0].name.role != FileRole::ignored || known == groups.end()) {
      ++each;
      continue;
    }
    known->second.push_back(std::move(each->second[0]));
    each = groups.erase(each);
  }
}

// The pictures by the sets of their names. Tiles and levels of detail of one set stay together, because a
// material has one picture for a channel.
std::map<std::string, Group> groups_of(const std::vector<std::string>& paths) {
  const ValidateConfig config;
  const NameReader reader({});
  PictureNamer namer(config, reader);
  std::map<std::string, Group> out;
  for (const std::string& path : paths) {
    NamedPicture picture = namer.named(path).value_or(unnamed(path));
    std::string set = picture.key.substr(0, picture.key.find('\n'));
    out[std::move(set)].push_back(std::move(picture));
  }
  join_unnamed(out);
  return out;
}

std::string name_of(const Group& group) {
  for (const NamedPicture& picture : group)
    if (!picture.name.set.empty()) return picture.name.set;
  // The names are the words alone, as in wood/diffuse.png.
  return QFileInfo(QFileInfo(qt_text(group.front().path)).path()).fileName().toStdString();
}

// The letters of a packed picture; as glTF packs them where the name does not say it.
std::string letters_of(const NamedPicture& picture) {
  return picture.name.channels.empty() ? "-rm-" : picture.name.channels;
}

std::optional<Channel> channel_of_letter(char letter) {
  switch (letter) {
    case 'r':
      return Channel::roughness;
    case 's':
      return Channel::smoothness;
    case 'm':
      return Channel::metallic;
    case 'o':
      return Channel::occlusion;
    case 'a':
      return Channel::alpha;
    default:
      return std::nullopt;
  }
}

// Makes the rows of one set.
class SetRows {
 public:
  SetRows(Group& group, std::size_t set, const LookedAt& looked) : group_(group), set_(set), looked_(looked) {
    (void)sets_of(group_);  // settles what words mean by the pictures beside them
    for (const NamedPicture& picture : group_)
      metal_ =
          metal_ || (!may_mean_nothing(picture) && (picture.name.role == FileRole::metallic ||
                                                    (picture.name.role == FileRole::metal_rough &&
                                                     letters_of(picture).find('m') != std::string::npos)));
  }

  std::vector<DroppedRow> rows() {
    for (const NamedPicture& picture : group_) add(picture);
    add_fourth_channels();
    for (const Channel channel : all_channels) settle(channel);
    settle_sizes();
    std::vector<DroppedRow> out;
    for (Ranked& each : rows_) out.push_back(std::move(each.row));
    return out;
  }

 private:
  //   rank   of rows for one channel the one of the lowest rank is taken: 0 a picture of its own that is judged in this
  //          set, 1 a channel of a packed one, 2 a picture that another stands in for, 3 one whose name tells nothing
  struct Ranked {
    DroppedRow row;
    int rank = 0;
    PictureHeader header = {};
  };

  void put(const NamedPicture& picture, const QString& holds, std::optional<Channel> channel, int rank,
           const std::string& letters = {}) {
    const bool spare = picture.as != ListedAs::judged && picture.as != ListedAs::lone;
    Ranked& out = rows_.emplace_back(Ranked{{set_, holds, channel, ImageSource{picture.path, letters, {}}},
                                            spare ? std::max(rank, 2) : rank});
    if (!channel) out.row.remark = QObject::tr("not taken: no channel holds it");
    out.row.fixed = !channel;
    const Looked& looked = looked_.at(picture.path);
    out.header = looked.header;
    if (looked.failure.isEmpty()) return;
    out.row.channel.reset();
    out.row.fixed = true;
    out.row.remark = looked.failure;
  }

  Channel color() const { return metal_ ? Channel::base_color : Channel::diffuse; }

  void add(const NamedPicture& picture) {
    if (picture.name.role == FileRole::ignored || may_mean_nothing(picture))
      return put(picture, QObject::tr("its name tells nothing"), color(), 3);
    const auto whole = [&](Channel channel) { put(picture, qt_text(name(picture.name.role)), channel, 0); };
    switch (picture.name.role) {
      case FileRole::diffuse_alpha:
      case FileRole::base_color:
        return whole(color());
      case FileRole::specular_gloss:
      case FileRole::f0_only:
        return whole(Channel::specular);
      case FileRole::metallic:
        return whole(Channel::metallic);
      case FileRole::roughness:
        return whole(Channel::roughness);
      case FileRole::gloss:
        return whole(Channel::smoothness);
      case FileRole::opacity:
        return whole(Channel::alpha);
      case FileRole::emissive:
        return whole(Channel::emission);
      case FileRole::occlusion:
        return whole(Channel::occlusion);
      case FileRole::normal:
        whole(Channel::normal);
        if (rows_.back().row.channel) take_green(picture);
        return;
      case FileRole::metal_rough:
        return add_packed(picture);
      default:
        return put(
            picture,
            picture.name.role == FileRole::other ? own_word(picture) : qt_text(name(picture.name.role)),
            std::nullopt, 0);
    }
  }

  void take_green(const NamedPicture& picture) {
    DroppedRow& row = rows_.back().row;
    row.green = picture.name.green;
    if (row.green != GreenAxis::unsaid) return;
    const std::optional<GreenAxis>& measured = looked_.at(picture.path).green;
    row.green = measured ? *measured : green_of(picture.path);
    row.remark = row.green == GreenAxis::unsaid
                     ? QObject::tr("neither name nor texels tell which way green points")
                     : QObject::tr("green by its texels");
  }

  void add_packed(const NamedPicture& picture) {
    const std::string letters = letters_of(picture);
    for (std::size_t i = 0; i < std::min<std::size_t>(letters.size(), 4); ++i) {
      if (letters[i] == '-') continue;
      const QChar place = QLatin1Char("RGBA"[i]);
      put(picture, qt_text(channel_word(letters[i])) + QStringLiteral(", ") + place,
          channel_of_letter(letters[i]), 1, std::string(1, "rgba"[i]));
    }
  }

  bool has(Channel channel) const {
    return std::ranges::any_of(rows_, [&](const Ranked& each) { return each.row.channel == channel; });
  }

  // A fourth channel of a colour is opacity, and that of F0 what is left of roughness.
  void add_fourth_channels() {
    const std::size_t count = rows_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const DroppedRow from = rows_[i].row;
      if (rows_[i].header.channels != 4 || !from.channel || !from.source.channels.empty()) continue;
      const bool of_f0 = from.channel == Channel::specular;
      if (of_f0 ? has(Channel::roughness) || has(Channel::smoothness)
                : from.channel != color() || has(Channel::alpha))
        continue;
      DroppedRow row{set_, of_f0 ? QObject::tr("gloss, A") : QObject::tr("opacity, A"),
                     of_f0 ? Channel::smoothness : Channel::alpha, ImageSource{from.source.path, "a", {}}};
      rows_.push_back({std::move(row), 1, rows_[i].header});
    }
  }

  // Skips all rows of a channel but one, or all where nothing tells which.
  void settle(Channel channel) {
    std::vector<Ranked*> all;
    for (Ranked& each : rows_)
      if (each.row.channel == channel) all.push_back(&each);
    if (all.empty()) return;
    const auto order = [](const Ranked* each) {
      return std::pair(each->rank,
                       each->row.green == GreenAxis::directx);  // of both conventions OpenGL is taken
    };
    std::ranges::stable_sort(all, {}, order);
    const bool clear = all.size() == 1 || order(all[0]) < order(all[1]);
    for (Ranked* each : all) {
      if (clear && each == all[0]) continue;
      each->row.channel.reset();
      each->row.remark =
          clear ? (each->rank == 3 ? QObject::tr("its name tells no channel, and %1 is the %2")
                                   : QObject::tr("%1 is the %2"))
                      .arg(file_name(all[0]->row.source.path), text_of(channel))
                : QObject::tr("%1 files for %2: choose one").arg(all.size()).arg(text_of(channel));
    }
  }

  // Skips pictures of another size than the colour's. Those of light and normals may have one of their own.
  void settle_sizes() {
    const Ranked* first = nullptr;
    const auto counts = [](const Ranked& each) {
      return each.row.channel && each.row.channel != Channel::emission &&
             each.row.channel != Channel::occlusion && each.row.channel != Channel::normal;
    };
    for (const Ranked& each : rows_)
      if (counts(each) && (first == nullptr || each.row.channel == color())) first = &each;
    for (Ranked& each : rows_) {
      if (!counts(each) ||
          (each.header.width == first->header.width && each.header.height == first->header.height))
        continue;
      each.row.channel.reset();
      each.row.remark = QObject::tr("%1 x %2 texels, but %3 has %4 x %5")
                            .arg(each.header.width)
                            .arg(each.header.height)
                            .arg(file_name(first->row.source.path))
                            .arg(first->header.width)
                            .arg(first->header.height);
    }
  }

  Group& group_;
  std::size_t set_;
  const LookedAt& looked_;
  bool metal_ = false;
  std::vector<Ranked> rows_;
};

std::vector<std::string> pictures_of(const QStringList& paths, QStringList& refused) {
  std::vector<std::string> out;
  const auto take = [&](const QString& path) {
    const bool picture = kind_of_file(path) == FileKind::picture;
    if (picture) out.push_back(path.toStdString());
    return picture;
  };
  for (const QString& path : paths) {
    if (!QFileInfo(path).isDir()) {
      take(path);
      continue;
    }
    bool any = false;
    for (const QFileInfo& each : QDir(path).entryInfoList(QDir::Files, QDir::Name))
      any = take(each.filePath()) || any;
    if (!any) refused << QObject::tr("%1: a folder without pictures").arg(QFileInfo(path).fileName());
  }
  return out;
}

}  // namespace

QString text_of(Channel channel) {
  return qt_text(name(channel)).replace('_', ' ');
}

bool DroppedPictures::needs_table() const {
  return rows.size() > 1;
}

QString DroppedPictures::doubles() const {
  std::map<std::pair<std::size_t, Channel>, int> count;
  for (const DroppedRow& row : rows)
    if (row.channel && ++count[{row.set, *row.channel}] > 1)
      return QObject::tr("%1: two pictures for %2").arg(qt_text(sets[row.set]), text_of(*row.channel));
  return {};
}

DroppedPictures sort_pictures(const QStringList& paths) {
  DroppedPictures out;
  std::map<std::string, Group> groups = groups_of(pictures_of(paths, out.refused));
  if (groups.size() > most_dropped_sets) {
    out.refused << QObject::tr(
                       "the pictures have %1 names; one drop makes at most %2 materials, and none was made")
                       .arg(groups.size())
                       .arg(most_dropped_sets);
    return out;
  }
  std::vector<FileToLookAt> files;
  for (const auto& [key, group] : groups)
    for (const NamedPicture& each : group)
      files.push_back(
          {each.path, each.name.role == FileRole::normal && each.name.green == GreenAxis::unsaid});
  const LookedAt looked = looked_at(std::move(files));
  for (auto& [key, group] : groups) {
    std::vector<DroppedRow> rows = SetRows(group, out.sets.size(), looked).rows();
    out.sets.push_back(name_of(group));
    std::ranges::move(rows, std::back_inserter(out.rows));
  }
  for (const auto& [path, at] : looked)
    if (at.file.picture) out.decoded.emplace(path, at.file);
  return out;
}

void take_set(const DroppedPictures& dropped, std::size_t set, ProjectMaterial& material) {
  for (const DroppedRow& row : dropped.rows) {
    if (row.set != set || !row.channel) continue;
    set_texture(material, *row.channel, row.source);
    if (row.channel == Channel::normal) material.green_down = row.green == GreenAxis::directx;
  }
}

std::vector<ProjectMaterial> materials_of(const DroppedPictures& dropped) {
  std::vector<ProjectMaterial> out;
  for (std::size_t set = 0; set < dropped.sets.size(); ++set) {
    ProjectMaterial made;
    made.name = dropped.sets[set];
    made.diffuse = {0.5, 0.5, 0.5};
    const auto before = made.textures;
    take_set(dropped, set, made);
    if (made.textures == before) continue;
    // A picture of the opacity is meant to be seen; a mode "opaque" does not look at it.
    made.alpha_mode = made.texture(Channel::alpha) ? AlphaMode::blend : AlphaMode::opaque;
    out.push_back(std::move(made));
  }
  return out;
}

QString taken_text(const DroppedPictures& dropped) {
  QStringList out;
  for (const ProjectMaterial& each : materials_of(dropped)) {
    QStringList channels;
    for (const Channel channel : all_channels)
      if (each.texture(channel)) channels << text_of(channel);
    out << QObject::tr("%1: %2").arg(qt_text(each.name), channels.join(QLatin1String(", ")));
  }
  return out.join(QLatin1String("; "));
}

}  // namespace etak::editor
