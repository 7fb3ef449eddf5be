// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/pack/pack.h"

#include <algorithm>

#include "app/python/validate.h"
#include "core/atlas/pack/setting_reader.h"
#include "core/base/error.h"
#include "core/base/files/output.h"
#include "core/base/memory.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/project/project_pack.h"
#include "core/validate/check_pack.h"

namespace etak::python {
namespace {

/// A keyword's value, for PackSettingReader.
struct KeywordValue {
  std::string name;
  py::handle value;

  [[noreturn]] void fail_type(std::string_view expected) const {
    throw Error::at(name, printable(py::str(value).cast<std::string>(), 60), expected);
  }
  bool is_number() const { return py::isinstance<py::int_>(value) && !py::isinstance<py::bool_>(value); }
  double number() const {
    if (py::isinstance<py::bool_>(value)) fail_type("a number");
    const double out = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr || !std::isfinite(out)) {
      PyErr_Clear();
      fail_type("a finite number");
    }
    return out;
  }
  int integer(int least, int most) const {
    const std::string range = "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    const double out = number();
    if (out != std::floor(out) || out < least || out > most) fail_type(range);
    return static_cast<int>(out);
  }
  bool boolean() const {
    if (!py::isinstance<py::bool_>(value)) fail_type("True or False");
    return value.cast<bool>();
  }
  std::string text() const {
    if (!py::isinstance<py::str>(value) && !py::hasattr(value, "__fspath__")) fail_type("a text");
    return text_of(value, name);
  }
  std::vector<std::string> texts() const { return texts_of(value, name); }
};

PackSettings pack_settings(const std::string& input, const std::string& output, const py::dict& given) {
  PackSettings out;
  out.input = input;
  out.out = output;
  for (const auto& [key, value] : given) {
    const std::string keyword = key.cast<std::string>();
    std::string remark;
    const PackSettingRow* const row = find_pack_setting(keyword, remark);
    if (row == nullptr) throw py::type_error("pack() got an unexpected keyword argument '" + keyword + "'");
    if (!remark.empty() && PyErr_WarnEx(PyExc_FutureWarning, remark.c_str(), 2) != 0)
      throw py::error_already_set();
    if (!value.is_none()) read_pack_setting(*row, KeywordValue{keyword, value}, {}, out);
  }
  return out;
}

/// etak.Packed: what is told of a pack.
struct Packed {
  std::string input, output;
  std::vector<std::string> files, remarks;
  bool up_to_date = false, dry_run = false;
  std::size_t materials = 0, regions = 0;
  std::vector<std::pair<int, int>> pages;
  std::string layout, json, text;  // layout.json, and the report of the packer in both forms
  std::optional<Report> report;
};

Packed told_of(const PackResult& r) {
  Packed out{r.input,
             r.output,
             r.files,
             r.remarks,
             r.up_to_date,
             r.dry_run,
             r.materials,
             r.regions,
             {},
             layout_json(r.layout),
             report_json(r, false),
             report_text(r, false),
             {}};
  for (const AtlasPage& each : r.layout.pages) out.pages.emplace_back(each.width, each.height);
  while (out.text.ends_with('\n')) out.text.pop_back();
  return out;
}

// How the work is done, as a caller says it.
struct PackCall {
  PackSettings settings;
  ValidateSettings check;
  std::string memory;
  bool validate = true, overwrite = false, update = false, dry_run = false;
  int threads = 0;
};

PackOptions options_of(const PackCall& call) {
  PackOptions out = pack_options(call.settings);
  out.input.space_config = space_config_file(call.settings.ocio);
  out.input.pictures.door = picture_door_behind(&pictures);
  out.input.pictures.open_space = [config = call.settings.ocio](const std::string& name) {
    return pictures(printable(name)).open_source(config, name);
  };
  if (writes_floats(out.output.write))
    (void)pictures(setting("textures"));  // throws before the work where the module is missing
  out.output.overwrite = call.overwrite;
  out.output.update = call.update;
  out.output.dry_run = call.dry_run;
  out.run.memory = memory_setting(call.memory);
  out.run.threads = threads_of(call.threads);
  out.run.version = ETAK_VERSION;
  return out;
}

Packed packed(const PackCall& call, const Library& library, LongWork& work) {
  PackOptions options = options_of(call);
  const std::string& out = call.settings.out;
  std::optional<PackCheck> check;
  std::optional<Report> report;
  if (call.validate) {
    PackCheckOptions how;
    how.config = validate_config(call.check, out + "/layout.json", library.known());
    how.never_fails = call.check.fail_on == never_fails;
    how.threads = options.run.threads;
    how.version = ETAK_VERSION;
    report = Report{nullptr, how.config.settings.fail_on, how.never_fails};
    check.emplace(out, std::move(how)).attach(options);
  }
  options.run.progress = [&](std::size_t done, std::size_t all) { work.tell(done, all); };
  options.run.cancelled = [&] { return work.stopped(); };
  options.check.beside = [&](PackResult& of, OutputFolder*) -> std::unique_ptr<Output> {
    if (check) check->finish(of);
    return nullptr;
  };
  const MaterialLibrary& known = library.get();
  options.input.other_manifest = project_reader(known);
  Packed result = told_of(with_memory_for(
      call.settings.input, [&] { return "its atlas " + out; },
      [&] { return pack(call.settings.input, out, options, known); }));
  if (!check || check->report() == nullptr) return result;
  report->report = std::make_shared<const ValidationReport>(*check->report());
  result.report = std::move(report);
  return result;
}

Packed pack_call(const py::object& input, const py::object& output, const py::dict& run,
                 const py::dict& check, const py::dict& settings, const Library& library, int threads,
                 py::object progress) {
  PackCall call;
  call.settings = pack_settings(text_of(input, "input"), text_of(output, "output"), settings);
  if (call.settings.input.empty())
    throw Error::at("input", "nothing to pack", "a manifest, a glTF scene or a folder");
  if (call.settings.out.empty()) throw Error::at("output", "no folder to write", "the name of a folder");
  call.check = check_settings(check);
  call.memory = text_of(run["memory"], "memory");
  call.validate = run["validate"].cast<bool>();
  call.overwrite = run["force"].cast<bool>();
  call.update = run["update"].cast<bool>();
  call.dry_run = run["dry_run"].cast<bool>();
  call.threads = threads;
  LongWork work(std::move(progress));
  return work.unlocked([&] { return packed(call, library, work); });
}

}  // namespace

void add_pack(py::module_& module) {
  py::class_<Packed> packed(module, "Packed", "What pack() did.");
  be_value(
      packed,
      [](const Packed& p) {
        return py::make_tuple(py::make_tuple(p.input, p.output, p.layout, p.json, p.text), p.files, p.remarks,
                              py::make_tuple(p.up_to_date, p.dry_run), py::make_tuple(p.materials, p.regions),
                              p.pages, p.report);
      },
      [](const std::array<std::string, 5>& texts, const std::vector<std::string>& files,
         const std::vector<std::string>& remarks, const std::array<bool, 2>& is,
         const std::array<std::size_t, 2>& counts, const std::vector<std::pair<int, int>>& pages,
         const std::optional<Report>& report) {
        return Packed{texts[0],  texts[1], files,    remarks,  is[0],    is[1], counts[0],
                      counts[1], pages,    texts[2], texts[3], texts[4], report};
      });
  packed.def_readonly("input", &Packed::input, "As the caller named it.")
      .def_readonly("output", &Packed::output, "The folder.")
      .def_readonly("files", &Packed::files, "That were written, in the folder.")
      .def_readonly("remarks", &Packed::remarks, "What should be known of the result.")
      .def_readonly("up_to_date", &Packed::up_to_date, "It was in place already.")
      .def_readonly("dry_run", &Packed::dry_run, "Nothing was written.")
      .def_readonly("materials", &Packed::materials, "Their number.")
      .def_readonly("regions", &Packed::regions, "Their number.")
      .def_readonly("pages", &Packed::pages, "(width, height) of each.")
      .def_property_readonly(
          "layout",
          [](const Packed& p) {
            return py::module_::import("json").attr("loads")(p.layout).cast<py::dict>();
          },
          "What layout.json holds.")
      .def_readonly("report", &Packed::report,
                    "What the validator found on the pages; None: they were not checked.")
      .def(
          "json", [](const Packed& p) { return p.json; }, "The report of the packer.")
      .def("__str__", [](const Packed& p) { return p.text; })
      .def("__repr__", [](const Packed& p) {
        return repr_line("Packed", p.output + ": " + std::to_string(p.materials) + " materials, " +
                                       std::to_string(p.pages.size()) + " pages");
      });
  module.def("pack", &pack_call, py::arg("input"), py::arg("output"), py::arg("run"), py::arg("check"),
             py::arg("settings"), py::arg("library"), py::arg("threads"), py::arg("progress"));
  module.def("pack_settings", [] {
    py::dict out;
    for (const PackSettingRow& row : pack_setting_rows()) {
      std::string name(row.name);
      std::replace(name.begin(), name.end(), '-', '_');
      out[py::str(name)] = row.help_text();
    }
    return out;
  });
}

}  // namespace etak::python
