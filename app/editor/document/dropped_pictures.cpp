// SPDX-License-Identifier: Apache-2.0
#include "app/editor/document/dropped_pictures.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <map>

#include "app/editor/document/files.h"
#include "app/editor/document/pictures.h"
#include "app/viewport/background.h"
#include "app/viewport/qt_text.h"
#include "core/base/files/file.h"
#include "core/image/picture_bytes.h"
#include "core/names/picture_sets.h"
#include "core/validate/find/picture_namer.h"

namespace etak::editor {
namespace {

std::optional<Channel> channel_of(FileRole role) {
  switch (role) {
    case FileRole::diffuse_alpha:
    case FileRole::base_color:
      return Channel::diffuse;
    case FileRole::specular_gloss:
    case FileRole::f0_only:
      return Channel::specular;
    case FileRole::gloss:
      return Channel::gloss;
    case FileRole::opacity:
      return Channel::alpha;
    case FileRole::emissive:
      return Channel::emission;
    case FileRole::occlusion:
      return Channel::occlusion;
    default:
      return std::nullopt;
  }
}

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

// What a picture holds that is not taken: "occlusion, roughness, metallic".
QString content_of(const NamedPicture& picture) {
  const ParsedName& name = picture.name;
  if (name.role == FileRole::other) {
    const QString stem = QFileInfo(qt_text(picture.path)).completeBaseName();
    return stem.mid(static_cast<qsizetype>(name.set.size())).remove(0, name.set.empty() ? 0 : 1).toLower();
  }
  if (name.role != FileRole::metal_rough) return qt_text(etak::name(name.role));
  QStringList parts;
  for (const char letter : name.channels.empty() ? std::string("rm") : name.channels)
    if (letter != '-') parts << qt_text(channel_word(letter));
  return parts.join(QLatin1String(", "));
}

using Group = std::vector<NamedPicture>;

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
  return out;
}

// The pictures of a set by their channels; what no channel takes is refused.
std::map<Channel, std::vector<std::string>> channels_of(Group& group, QStringList& refused) {
  (void)sets_of(group);  // settles what words mean by the pictures beside them
  std::map<Channel, std::vector<std::string>> out;
  std::vector<std::string> others;
  for (const NamedPicture& picture : group) {
    const std::optional<Channel> channel = channel_of(picture.name.role);
    if (picture.name.role == FileRole::ignored || may_mean_nothing(picture))
      others.push_back(picture.path);
    else if (channel)
      out[*channel].push_back(picture.path);
    else
      refused << QObject::tr("%1: %2: not taken yet").arg(file_name(picture.path), content_of(picture));
  }
  if (!out.contains(Channel::diffuse) && !others.empty()) {
    out[Channel::diffuse] = std::move(others);
  } else {
    for (const std::string& path : others)
      refused << QObject::tr("%1: its name tells no channel, and %2 is the diffuse colour")
                     .arg(file_name(path), file_name(out[Channel::diffuse].front()));
  }
  return out;
}

std::string name_of(const Group& group) {
  for (const NamedPicture& picture : group)
    if (!picture.name.set.empty()) return picture.name.set;
  // The names are the words alone, as in wood/diffuse.png.
  return QFileInfo(QFileInfo(qt_text(group.front().path)).path()).fileName().toStdString();
}

DroppedSet set_of(Group& group, QStringList& refused) {
  DroppedSet out;
  out.name = name_of(group);
  for (const auto& [channel, files] : channels_of(group, refused)) {
    QStringList names;
    for (const std::string& each : files) names << file_name(each);
    if (files.size() > 1) {
      refused << QObject::tr("%1: %2 files for the channel %3; none of them is taken")
                     .arg(names.join(QLatin1String(", ")))
                     .arg(files.size())
                     .arg(qt_text(name(channel)));
    } else if (const QString failure = picture_failure(qt_text(files.front())); !failure.isEmpty()) {
      refused << failure;
    } else {
      out.files.emplace_back(channel, qt_text(files.front()));
    }
  }
  return out;
}

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

QString picture_failure(const QString& path) {
  const std::string file = path.toStdString(), name = file_name(file).toStdString();
  return failure_of(
      [&] {
        const std::string bytes = read_file(file, largest_picture_bytes);
        check_whole(bytes, picture_format(bytes, name), name);
        (void)picture_door().header(file);
      },
      QObject::tr("%1: not enough memory").arg(qt_text(name)));
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
  for (auto& [key, group] : groups) {
    DroppedSet set = set_of(group, out.refused);
    if (!set.files.empty()) out.sets.push_back(std::move(set));
  }
  return out;
}

void take_set(const DroppedSet& set, ProjectMaterial& material) {
  for (const auto& [channel, path] : set.files)
    set_texture(material, channel, ImageSource{path.toStdString(), {}, {}});
}

ProjectMaterial material_of(const DroppedSet& set) {
  ProjectMaterial out;
  out.name = set.name;
  out.diffuse = {0.5, 0.5, 0.5};
  take_set(set, out);
  // A picture of the opacity is meant to be seen; a mode "opaque" does not look at it.
  out.alpha_mode = out.texture(Channel::alpha) ? AlphaMode::blend : AlphaMode::opaque;
  return out;
}

}  // namespace etak::editor
