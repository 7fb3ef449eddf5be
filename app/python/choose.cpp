// SPDX-License-Identifier: Apache-2.0
#include "core/study/choose/choose.h"

#include "app/python/members.h"
#include "app/python/validate.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/memory.h"
#include "core/base/setting.h"
#include "core/color/gloss.h"
#include "core/pages/choose_report.h"
#include "core/study/choose/choose_scene.h"

namespace etak::python {
namespace {

/// etak.Choices: what choose() found, for each material.
struct Choices {
  std::vector<Choice> all;
  std::string scene;  // empty: materials of the library
  std::vector<std::string> remarks;
  std::string text, json;
};

// The subjects that are asked for: the materials of a scene, or spheres of materials.
struct Subjects {
  std::vector<AskedMaterial> asked;
  std::string scene;
};

Subjects asked_subjects(const py::object& materials) {
  Subjects out;
  const bool is_one = py::isinstance<py::str>(materials) || py::hasattr(materials, "__fspath__") ||
                      py::isinstance<Material>(materials) || py::isinstance<DatasetOf>(materials);
  if (is_one) {
    if (py::isinstance<py::str>(materials) || py::hasattr(materials, "__fspath__")) {
      const std::string text = text_of(materials, "materials");
      if (names_scene(text)) {
        out.scene = text;
        return out;
      }
    }
    out.asked.push_back(asked_material(materials, {}));
    return out;
  }
  for (const py::handle each : py::iter(materials))
    out.asked.push_back(asked_material(py::reinterpret_borrow<py::object>(each), {}));
  if (out.asked.empty()) throw Error::at("materials", "no material", "a material, several, or a scene");
  return out;
}

Choices choose_for(const Subjects& subjects, const ChooseOptions& options, const std::optional<Gloss>& given,
                   const std::string& costs, const Library& library, int threads, LongWork& work) {
  Choices out;
  const CostTable table = costs.empty() ? shipped_costs() : parse_costs(read_file(costs), costs);
  out.scene = subjects.scene;
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
    const DatasetOf found = read_one(asked, library, {});
    all.push_back(library_subject(*found.material, found.dataset(), given, out.remarks));
  }
  std::atomic<std::size_t> done{0};
  out.all = choose_each(all, options, table, threads_of(threads), [&](unsigned) {
    work.tell(++done, all.size());
    work.go_on();
  });
  work.tell(all.size(), all.size());  // where another thread was the last
  for (const Choice& each : out.all)
    if (!each.met) out.remarks.push_back(unmet_remark(each));
  out.json = choice_json(out.all, table, out.scene);
  out.text = choice_text(out.all, table, out.scene);
  while (out.text.ends_with('\n')) out.text.pop_back();
  return out;
}

Choices choose_call(const py::object& materials, double budget, bool codes, std::optional<double> gloss,
                    std::optional<double> roughness, const py::object& costs, const Library& library,
                    int threads, py::object progress) {
  const Subjects subjects = asked_subjects(materials);
  const std::string cost_file = text_of(costs, "costs");
  const ChooseOptions options{budget, codes ? ErrorUnit::codes : ErrorUnit::delta_e};
  LongWork work(std::move(progress));
  return work.unlocked([&] {
    const std::optional<Gloss> given = given_gloss(gloss, roughness);
    return with_memory_for(
        subjects.scene.empty() ? "choose" : subjects.scene, [] { return "what its shading is chosen from"; },
        [&] { return choose_for(subjects, options, given, cost_file, library, threads, work); });
  });
}

}  // namespace

void add_choose(py::module_& module) {
  py::class_<Choice> choice(module, "Choice",
                            "The cheapest way to draw a material within a budget of error.");
  be_value(
      choice, [](const Choice& c) { return py::make_tuple(bytes_of(c)); }, &from_bytes<Choice>);
  const auto get = [&](const char* name, auto read, const char* doc) {
    choice.def_property_readonly(name, read, doc);
  };
  choice.def_readonly("material", &Choice::material, "Its name.")
      .def_readonly("library", &Choice::library, "\"gold/ID\" where its spectrum is known; else empty.")
      .def_readonly("met", &Choice::met, "False: nothing stays within the budget, and the closest was taken.")
      .def_readonly("visibility", &Choice::visibility, "The term of visibility.")
      .def_readonly("method", &Choice::method, "Integration of F0; empty: there is no spectrum.")
      .def_readonly("model", &Choice::model, "As etak render and etak shader take it.")
      .def_readonly("model_values", &Choice::model_values, "Its parameters.")
      .def_readonly("alpha", &Choice::alpha, "Width of the lobe.")
      .def_readonly("textured", &Choice::textured, "Whether it has a texture of more than one colour.")
      .def_readonly("defines", &Choice::defines, "Of the specialised shader.")
      .def_readonly("fresnel_error", &Choice::fresnel_error, "The largest over all angles.")
      .def_readonly("picture_error", &Choice::picture_error, "Of the worst pixel.")
      .def_readonly("everything_ns", &Choice::everything_ns, "Cost of one evaluation with everything.")
      .def_readonly("chosen_ns", &Choice::chosen_ns, "Cost of one evaluation as chosen.");
  get(
      "fresnel", [](const Choice& c) { return std::string(c.fresnel->id); },
      "The form of Fresnel reflectance.");
  get(
      "filter", [](const Choice& c) { return std::string(name(c.filter)); }, "Of the texture.");
  get("error", &largest_error, "The largest of all choices together, in the unit of the budget.");
  get(
      "unit", [](const Choice& c) { return std::string(name(c.unit)); },
      "Of errors: \"ΔE2000\" or \"codes\".");
  choice.def("__repr__", [](const Choice& c) { return repr_line("Choice", c.material + ": " + c.model); });

  py::class_<Choices> choices(module, "Choices", "What choose() found: a sequence, one for each material.");
  be_value(
      choices,
      [](const Choices& c) { return py::make_tuple(bytes_of(c.all), c.scene, c.remarks, c.text, c.json); },
      [](const py::bytes& all, const std::string& scene, const std::vector<std::string>& remarks,
         const std::string& text, const std::string& json) {
        return Choices{from_bytes<std::vector<Choice>>(all), scene, remarks, text, json};
      });
  choices.def_readonly("remarks", &Choices::remarks, "What should be known of it.")
      .def_readonly("scene", &Choices::scene, "Empty: materials of the library.")
      .def(
          "json", [](const Choices& c) { return c.json; },
          "What pack(choice=...) and etak shader --choice take, as a file.")
      .def("__len__", [](const Choices& c) { return c.all.size(); })
      .def("__iter__", [](const Choices& c) { return py::iter(py::cast(c.all)); })
      .def(
          "__getitem__",
          [](const Choices& c, py::ssize_t index) {
            const auto size = static_cast<py::ssize_t>(c.all.size());
            if (index < 0) index += size;
            if (index < 0 || index >= size) throw py::index_error("no such choice");
            return c.all[static_cast<std::size_t>(index)];
          },
          py::arg("index"))
      .def("__str__", [](const Choices& c) { return c.text; })
      .def("__repr__",
           [](const Choices& c) { return "<etak.Choices of " + std::to_string(c.all.size()) + ">"; });
  module.def("choose", &choose_call, py::arg("materials"), py::arg("budget"), py::arg("codes"),
             py::arg("gloss"), py::arg("roughness"), py::arg("costs"), py::arg("library"), py::arg("threads"),
             py::arg("progress"));
}

}  // namespace etak::python
