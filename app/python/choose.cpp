// SPDX-License-Identifier: Apache-2.0
#include "core/study/choose/choose.h"

#include "app/python/module.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/memory.h"
#include "core/base/setting.h"
#include "core/color/gloss.h"
#include "core/pages/choose_report.h"
#include "core/study/choose/choose_scene.h"

namespace etak::python {
namespace {

// The answer of choose(), with its documents.
struct Choices {
  std::vector<std::string> materials, remarks;
  std::string json, text;
};

// What choose() is asked for: the materials of a scene, or spheres of materials, and its settings.
struct Asked {
  std::vector<AskedMaterial> materials;
  std::string scene, costs;
  ChooseOptions options;
  std::optional<double> gloss, roughness;
  unsigned threads = 1;
};

Asked asked_of(const py::object& materials, const Keywords& given, int threads) {
  Asked out;
  out.costs = given.text("costs");
  out.options = {given.number("budget").value_or(1),
                 given.yes("codes") ? ErrorUnit::codes : ErrorUnit::delta_e};
  out.gloss = given.number("gloss");
  out.roughness = given.number("roughness");
  out.threads = threads_of(threads);
  if (is_text(materials)) out.scene = text_of(materials, "materials");
  if (names_scene(out.scene)) return out;
  out.scene.clear();
  const bool is_one =
      is_text(materials) || py::isinstance<Material>(materials) || py::isinstance<DatasetOf>(materials);
  out.materials = asked_materials(
      is_one ? std::vector{materials} : py::list(materials).cast<std::vector<py::object>>(), {});
  if (out.materials.empty()) throw Error::at("materials", "no material", "a material, several, or a scene");
  return out;
}

Choices choose_for(const Asked& of, const Library& library, LongWork& work) {
  Choices out;
  const std::optional<Gloss> given = given_gloss(of.gloss, of.roughness);
  const CostTable table = of.costs.empty() ? shipped_costs() : parse_costs(read_file(of.costs), of.costs);
  validate(of.options);
  std::vector<ChooseSubject> all;
  if (!of.scene.empty()) {
    if (given)
      throw Error::at(setting("gloss") + ", " + setting("roughness"), "given beside " + of.scene,
                      "a scene alone: it says its own");
    PackOptions pack;
    pack.input.pictures.door = picture_door_behind(&pictures);
    pack.run.threads = of.threads;
    all = scene_subjects(of.scene, pack, library.get(), out.remarks);
  }
  for (const AskedMaterial& asked : of.materials) {
    work.go_on();
    const DatasetOf found = read_one(asked, library, {});
    all.push_back(library_subject(*found.material, found.dataset(), given, out.remarks));
  }
  std::atomic<std::size_t> done{0};
  const std::vector<Choice> found = choose_each(all, of.options, table, of.threads, [&](unsigned) {
    work.tell(++done, all.size());
    work.go_on();
  });
  work.tell(all.size(), all.size());  // where another thread was the last
  for (const Choice& each : found) {
    out.materials.push_back(each.material);
    if (!each.met) out.remarks.push_back(unmet_remark(each));
  }
  out.json = choice_json(found, table, of.scene);
  out.text = choice_text(found, table, of.scene);
  return out;
}

// The documents for etak/documents.py, and beside them the texts whose bytes JSON may not hold.
py::dict choose_call(const py::object& materials, const py::dict& given, const Library& library, int threads,
                     py::object progress) {
  const Asked of = asked_of(materials, {given}, threads);
  LongWork work(std::move(progress));
  const Choices found = work.unlocked([&] {
    return with_memory_for(
        of.scene.empty() ? "choose" : of.scene, [] { return "what its shading is chosen from"; },
        [&] { return choose_for(of, library, work); });
  });
  py::dict out;
  out["scene"] = of.scene;
  out["materials"] = found.materials;
  out["remarks"] = found.remarks;
  out["json"] = found.json;
  out["text"] = found.text;
  return out;
}

}  // namespace

void add_choose(py::module_& module) {
  module.def("choose", &choose_call);
}

}  // namespace etak::python
