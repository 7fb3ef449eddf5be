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

// What choose() found, and its documents.
struct Choices {
  std::vector<std::string> materials, remarks;
  std::string json, text;
};

// The subjects that are asked for: the materials of a scene, or spheres of materials.
struct Subjects {
  std::vector<AskedMaterial> asked;
  std::string scene;
};

Subjects asked_subjects(const py::object& materials) {
  Subjects out;
  if (is_text(materials)) out.scene = text_of(materials, "materials");
  if (names_scene(out.scene)) return out;
  out.scene.clear();
  const bool is_one =
      is_text(materials) || py::isinstance<Material>(materials) || py::isinstance<DatasetOf>(materials);
  out.asked = asked_materials(
      is_one ? std::vector{materials} : py::list(materials).cast<std::vector<py::object>>(), {});
  if (out.asked.empty()) throw Error::at("materials", "no material", "a material, several, or a scene");
  return out;
}

Choices choose_for(const Subjects& subjects, const ChooseOptions& options, const std::optional<Gloss>& given,
                   const std::string& costs, const Library& library, int threads, LongWork& work) {
  Choices out;
  const CostTable table = costs.empty() ? shipped_costs() : parse_costs(read_file(costs), costs);
  validate(options);
  std::vector<ChooseSubject> all;
  if (!subjects.scene.empty()) {
    if (given)
      throw Error::at(setting("gloss") + ", " + setting("roughness"), "given beside " + subjects.scene,
                      "a scene alone: it says its own");
    PackOptions pack;
    pack.input.pictures.door = picture_door_behind(&pictures);
    pack.run.threads = threads_of(threads);
    all = scene_subjects(subjects.scene, pack, library.get(), out.remarks);
  }
  for (const AskedMaterial& asked : subjects.asked) {
    work.go_on();
    const DatasetOf found = read_one(asked, library, {});
    all.push_back(library_subject(*found.material, found.dataset(), given, out.remarks));
  }
  std::atomic<std::size_t> done{0};
  const std::vector<Choice> found = choose_each(all, options, table, threads_of(threads), [&](unsigned) {
    work.tell(++done, all.size());
    work.go_on();
  });
  work.tell(all.size(), all.size());  // where another thread was the last
  for (const Choice& each : found) {
    out.materials.push_back(each.material);
    if (!each.met) out.remarks.push_back(unmet_remark(each));
  }
  out.json = choice_json(found, table, subjects.scene);
  out.text = choice_text(found, table, subjects.scene);
  return out;
}

// The documents for etak/documents.py, and beside them the texts whose bytes JSON may not hold.
py::dict choose_call(const py::object& materials, double budget, bool codes, std::optional<double> gloss,
                     std::optional<double> roughness, const py::object& costs, const Library& library,
                     int threads, py::object progress) {
  const Subjects subjects = asked_subjects(materials);
  const std::string cost_file = text_of(costs, "costs");
  const ChooseOptions options{budget, codes ? ErrorUnit::codes : ErrorUnit::delta_e};
  LongWork work(std::move(progress));
  const Choices found = work.unlocked([&] {
    const std::optional<Gloss> given = given_gloss(gloss, roughness);
    return with_memory_for(
        subjects.scene.empty() ? "choose" : subjects.scene, [] { return "what its shading is chosen from"; },
        [&] { return choose_for(subjects, options, given, cost_file, library, threads, work); });
  });
  py::dict out;
  out["scene"] = subjects.scene;
  out["materials"] = found.materials;
  out["remarks"] = found.remarks;
  out["json"] = found.json;
  out["text"] = found.text;
  return out;
}

}  // namespace

void add_choose(py::module_& module) {
  module.def("choose", &choose_call, py::arg("materials"), py::arg("budget"), py::arg("codes"),
             py::arg("gloss"), py::arg("roughness"), py::arg("costs"), py::arg("library"), py::arg("threads"),
             py::arg("progress"));
}

}  // namespace etak::python
