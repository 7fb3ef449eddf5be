// SPDX-License-Identifier: Apache-2.0
// Drops elements to which nothing refers any more, and changes all indices accordingly.
#include <algorithm>
#include <set>

#include "core/scene/gltf_write_json.h"
#include "core/scene/uri.h"

namespace etak {
namespace {

/// New indices of an array's elements, -1 for those that go.
using Renumbering = std::vector<int>;

/// Keeps the elements of `keep`. An array without elements is dropped, because glTF forbids empty ones.
Renumbering keep_elements(Json& root, const char* array, const std::vector<bool>& keep) {
  Renumbering to(keep.size(), -1);
  Json kept = Json::array();
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    to[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(root[array][i]));
  }
  if (kept.empty())
    root.erase(array);
  else
    root[array] = std::move(kept);
  return to;
}

/// The new index for the index in `value`; -1 where its element was dropped. Throws Error out of range.
int followed(const GltfRewrite& rewrite, const Json& value, const Renumbering& to, const char* array) {
  if (!value.is_number_integer() || value < 0 || value >= to.size())
    throw Error::at(rewrite.scene.path, printable(value.dump(), 40),
                    "an index into " + std::string(array) + ", which has " + std::to_string(to.size()));
  return to[value.get<std::size_t>()];
}

std::vector<bool> none_of(const GltfRewrite& rewrite, const char* array) {
  return std::vector<bool>(rewrite.document().count(array), false);
}

void drop_materials(GltfRewrite& rewrite) {
  Json& root = rewrite.root;
  const Renumbering to = keep_elements(root, "materials", rewrite.scene.material_written);
  if (root.contains("materials"))
    for (Json& material : root["materials"])
      if (extension(material, "MSFT_lod"))
        for (Json& level : material["extensions"]["MSFT_lod"]["ids"])
          level = followed(rewrite, level, to, "materials");
  if (!root.contains("meshes")) return;
  const auto primitive = [&](Json& json) {
    if (json.contains("material")) {
      const int index = followed(rewrite, json["material"], to, "materials");
      if (index < 0)
        json.erase("material");
      else
        json["material"] = index;
    }
    if (!extension(json, "KHR_materials_variants")) return;
    Json kept = Json::array();
    for (Json& mapping : json["extensions"]["KHR_materials_variants"]["mappings"]) {
      const int index = followed(rewrite, mapping["material"], to, "materials");
      if (index < 0) continue;
      mapping["material"] = index;
      kept.push_back(std::move(mapping));
    }
    if (kept.empty())
      remove_extension(json, "KHR_materials_variants");
    else
      json["extensions"]["KHR_materials_variants"]["mappings"] = std::move(kept);
  };
  for (Json& mesh : root["meshes"])
    if (mesh.contains("primitives"))
      for (Json& json : mesh["primitives"]) primitive(json);
}

void drop_textures(GltfRewrite& rewrite) {
  Json& root = rewrite.root;
  const auto each_info = [&](const auto& see) {
    if (!root.contains("materials")) return;
    for (Json& material : root["materials"])
      each_texture_info(material, [&](const std::string&, Json& info) { see(info); });
  };
  std::vector<bool> keep = none_of(rewrite, "textures");
  Renumbering same(keep.size());
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<int>(i);
  each_info([&](Json& info) {
    keep[static_cast<std::size_t>(followed(rewrite, info["index"], same, "textures"))] = true;
  });
  const Renumbering to = keep_elements(root, "textures", keep);
  each_info([&](Json& info) { info["index"] = to[info["index"].get<std::size_t>()]; });
}

/// Drops what only textures refer to: images (by `source`, in extensions too) and samplers.
void drop_of_textures(GltfRewrite& rewrite, const char* array, const char* reference) {
  Json& root = rewrite.root;
  const auto each_reference = [&](const auto& see) {
    if (!root.contains("textures")) return;
    each_key(root["textures"], [&](const std::string& key, Json& value) {
      if (key == reference && value.is_number_integer()) see(value);
    });
  };
  std::vector<bool> keep = none_of(rewrite, array);
  Renumbering same(keep.size());
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<int>(i);
  each_reference(
      [&](Json& value) { keep[static_cast<std::size_t>(followed(rewrite, value, same, array))] = true; });
  const Renumbering to = keep_elements(root, array, keep);
  each_reference([&](Json& value) { value = to[value.get<std::size_t>()]; });
}

/// Calls see(number) for every place that refers to an accessor.
template <class See>
void each_accessor_of(Json& root, const See& see) {
  const auto all = [&](Json& object) {
    if (object.is_object())
      for (Json& value : object) see(value);
  };
  const auto each_in = [](Json& parent, const char* array, const auto& visit) {
    if (parent.is_object() && parent.contains(array))
      for (Json& element : parent[array])
        if (element.is_object()) visit(element);
  };
  each_in(root, "meshes", [&](Json& mesh) {
    each_in(mesh, "primitives", [&](Json& primitive) {
      if (primitive.contains("indices")) see(primitive["indices"]);
      if (primitive.contains("attributes")) all(primitive["attributes"]);
      each_in(primitive, "targets", all);
    });
  });
  each_in(root, "skins", [&](Json& skin) {
    if (skin.contains("inverseBindMatrices")) see(skin["inverseBindMatrices"]);
  });
  each_in(root, "animations", [&](Json& animation) {
    each_in(animation, "samplers", [&](Json& sampler) {
      for (const char* key : {"input", "output"})
        if (sampler.contains(key)) see(sampler[key]);
    });
  });
  each_in(root, "nodes", [&](Json& node) {
    if (extension(node, "EXT_mesh_gpu_instancing") &&
        node["extensions"]["EXT_mesh_gpu_instancing"].contains("attributes"))
      all(node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]);
  });
}

/// Drops accessors to which primitives no longer refer since their UVs were rewritten. Accessors to which
/// nothing known ever referred are kept: an unknown extension may use them.
void drop_accessors(GltfRewrite& rewrite, Json before) {
  std::vector<bool> keep(rewrite.document().count("accessors"), true);
  const auto mark = [&](Json& root, bool value) {
    each_accessor_of(root, [&](const Json& index) {
      if (index.is_number_integer() && index >= 0 && index < keep.size())
        keep[index.get<std::size_t>()] = value;
    });
  };
  mark(before, false);
  mark(rewrite.root, true);
  if (std::find(keep.begin(), keep.end(), false) == keep.end()) return;
  const Renumbering to = keep_elements(rewrite.root, "accessors", keep);
  each_accessor_of(rewrite.root, [&](Json& index) { index = followed(rewrite, index, to, "accessors"); });
}

std::set<std::size_t> named_views(const Json& root) {
  std::set<std::size_t> out;
  each_key(root, [&](const std::string& key, const Json& value) {
    if (key == "bufferView" && value.is_number_integer() && value >= 0) out.insert(value.get<std::size_t>());
  });
  return out;
}

/// A part of a view that accessors read, and these accessors.
struct ReadPart {
  std::size_t begin = 0, end = 0;
  std::vector<int> accessors;
};

/// Parts that lie nearer to each other than this stay together: a view of its own takes more in the document.
constexpr std::size_t least_gap = 64;

std::vector<ReadPart> parts_of(std::vector<ReadPart> reads, std::size_t stride) {
  std::sort(reads.begin(), reads.end(),
            [](const ReadPart& a, const ReadPart& b) { return a.begin < b.begin; });
  std::vector<ReadPart> out;
  for (const ReadPart& read : reads) {
    // Elements that are interleaved cannot be taken apart.
    if (!out.empty() && (stride > 0 || read.begin <= out.back().end + least_gap)) {
      out.back().end = std::max(out.back().end, read.end);
      out.back().accessors.insert(out.back().accessors.end(), read.accessors.begin(), read.accessors.end());
    } else {
      out.push_back(read);
    }
  }
  // Elements begin at multiples of the stride, and at what they are aligned to.
  const std::size_t unit = stride > 0 ? stride : 4;
  for (ReadPart& part : out) part.begin -= part.begin % unit;
  return out;
}

/// Cuts views down to what accessors read of them, each part a view of its own. Views that something else names,
/// or of which not all readers are understood, stay whole.
void cut_views(GltfRewrite& rewrite) {
  Json& root = rewrite.root;
  const std::size_t views = rewrite.document().count("bufferViews");
  std::vector<std::size_t> named(views, 0), strides(views, 0);
  std::vector<std::vector<ReadPart>> reads(views);
  each_key(root, [&](const std::string& key, const Json& value) {
    if (key == "bufferView" && value.is_number_integer() && value >= 0 && value < views)
      ++named[value.get<std::size_t>()];
  });
  for (int i = 0; i < static_cast<int>(rewrite.document().count("accessors")); ++i)
    if (const auto read = bytes_of_accessor(rewrite.document(), i)) {
      reads[static_cast<std::size_t>(read->view)].push_back({read->begin, read->end, {i}});
      strides[static_cast<std::size_t>(read->view)] = read->stride;
    }
  for (std::size_t v = 0; v < views; ++v) {
    if (reads[v].empty() || named[v] != reads[v].size()) continue;
    const Json view = root["bufferViews"][v];
    const std::size_t begin = view.value("byteOffset", std::size_t{0});
    const std::vector<ReadPart> parts = parts_of(std::move(reads[v]), strides[v]);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      Json part = view;
      part["byteOffset"] = begin + parts[p].begin;
      part["byteLength"] = parts[p].end - parts[p].begin;
      std::size_t index = v;
      if (p == 0)
        root["bufferViews"][v] = std::move(part);
      else
        index = static_cast<std::size_t>(rewrite.append("bufferViews", std::move(part)));
      for (const int accessor : parts[p].accessors) {
        Json& json = root["accessors"][static_cast<std::size_t>(accessor)];
        json["bufferView"] = index;
        json["byteOffset"] = json.value("byteOffset", std::size_t{0}) - parts[p].begin;
      }
    }
  }
}

/// Bytes [begin, end) of a buffer that stay, and where they begin in the new one.
struct Kept {
  std::size_t begin, end, to;
};

/// Appends what views keep of one buffer to `out`. Places keep their remainder by 8, so that what was aligned
/// stays so; views that share bytes go on sharing them.
std::vector<Kept> append_kept(std::string_view bytes, std::vector<Kept> ranges, std::string& out) {
  std::sort(ranges.begin(), ranges.end(), [](const Kept& a, const Kept& b) { return a.begin < b.begin; });
  std::vector<Kept> merged;
  for (const Kept& range : ranges) {
    if (!merged.empty() && range.begin <= merged.back().end)
      merged.back().end = std::max(merged.back().end, range.end);
    else
      merged.push_back(range);
  }
  for (Kept& range : merged) {
    while (out.size() % 8 != range.begin % 8) out += '\0';
    range.to = out.size();
    out += bytes.substr(range.begin, range.end - range.begin);
  }
  return merged;
}

}  // namespace

void drop_unused(GltfRewrite& rewrite, const Json& before) {
  drop_materials(rewrite);
  drop_accessors(rewrite, before);
  cut_views(rewrite);
  drop_textures(rewrite);
  drop_of_textures(rewrite, "images", "source");
  drop_of_textures(rewrite, "samplers", "sampler");
  // A view to which nothing known ever referred is kept: an unknown extension may use it.
  const std::set<std::size_t> views = named_views(rewrite.root);
  std::vector<bool> keep(rewrite.document().count("bufferViews"), true);
  for (const std::size_t view : named_views(before))
    if (view < keep.size()) keep[view] = views.contains(view);
  const Renumbering to = keep_elements(rewrite.root, "bufferViews", keep);
  each_key(rewrite.root, [&](const std::string& key, Json& value) {
    if (key == "bufferView" && value.is_number_integer()) value = followed(rewrite, value, to, "bufferViews");
  });
}

std::string compact_buffers(GltfRewrite& rewrite) {
  const GltfDocument document = rewrite.document();
  const int views = static_cast<int>(document.count("bufferViews"));
  std::vector<std::vector<Kept>> kept(rewrite.buffers.size());
  const auto range_of = [&](int view, std::size_t& buffer) {
    const JsonNode node = document.element("bufferViews", view);
    buffer = static_cast<std::size_t>(document.index(node.at("buffer"), "buffers"));
    const std::size_t offset = size_at(node, "byteOffset", 0), length = size_at(node.at("byteLength"), "", 0);
    const std::size_t size = rewrite.buffers[buffer].size();
    if (offset > size || length > size - offset)
      node.fail("bytes beyond the end of its buffer", "bytes inside the buffer");
    return Kept{offset, offset + length, 0};
  };
  std::size_t buffer = 0;
  for (int view = 0; view < views; ++view) {
    const Kept range = range_of(view, buffer);
    kept[buffer].push_back(range);
  }
  std::string out;
  for (std::size_t i = 0; i < kept.size(); ++i)
    kept[i] = append_kept(rewrite.buffers[i], std::move(kept[i]), out);
  for (int view = 0; view < views; ++view) {
    const Kept range = range_of(view, buffer);
    auto at = std::upper_bound(kept[buffer].begin(), kept[buffer].end(), range.begin,
                               [](std::size_t begin, const Kept& k) { return begin < k.begin; });
    --at;  // the last run that begins at or before the view holds it
    Json& json = rewrite.root["bufferViews"][static_cast<std::size_t>(view)];
    json["buffer"] = 0;
    json["byteOffset"] = at->to + (range.begin - at->begin);
  }
  rewrite.root.erase("buffers");
  if (!out.empty())
    rewrite.root["buffers"] =
        Json::array({{{"byteLength", out.size()}, {"uri", uri_of_file(rewrite.output.buffer_name)}}});
  return out;
}

void name_extensions(GltfRewrite& rewrite, const Json& before) {
  const auto present = [](const Json& root) {
    std::set<std::string> out;
    each_key(root, [&](const std::string& key, const Json& value) {
      if (key == "extensions" && value.is_object())
        for (const auto& [name, ignored] : value.items()) out.insert(name);
    });
    return out;
  };
  const std::set<std::string> was = present(before), is = present(rewrite.root);
  const auto names = [&](const char* key) {
    std::set<std::string> out;
    if (before.contains(key))
      // Some extensions are listed without any object of theirs (KHR_mesh_quantization): those are kept.
      for (const auto& name : JsonNode{before, rewrite.scene.path, ""}.at(key).texts())
        if (is.contains(name) || !was.contains(name)) out.insert(name);
    return out;
  };
  std::set<std::string> used = names("extensionsUsed"), required = names("extensionsRequired");
  for (const char* name : atlas_extensions)
    if (is.contains(name)) used.insert(name);
  if (is.contains("KHR_texture_transform")) {
    used.insert("KHR_texture_transform");
    required.insert("KHR_texture_transform");
  }
  if (is.contains("EXT_texture_webp") && !was.contains("EXT_texture_webp")) {
    used.insert("EXT_texture_webp");
    required.insert("EXT_texture_webp");
  }
  const auto put = [&](const char* key, const std::set<std::string>& value) {
    if (value.empty())
      rewrite.root.erase(key);
    else
      rewrite.root[key] = value;
  };
  put("extensionsUsed", used);
  put("extensionsRequired", required);
}

}  // namespace etak
