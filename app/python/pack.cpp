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
    throw Error::at(name, printable(std::string(py::str(value)), 60), expected);
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
    std::string name = keyword;
    std::replace(name.begin(), name.end(), '_', '-');
    const auto rows = pack_setting_rows();
    const auto row = std::ranges::find(rows, name, &PackSettingRow::name);
    if (row == rows.end())
      throw py::type_error("pack() got an unexpected keyword argument '" + keyword + "'");
    if (!value.is_none()) read_pack_setting(*row, KeywordValue{keyword, value}, {}, out);
  }
  return out;
}

/// etak.Packed.
struct Packed {
  PackResult result;
  std::optional<Report> report;
};

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
    (void)pictures(setting("format"));  // throws before the work where the module is missing
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
  Packed result;
  if (call.validate) {
    PackCheckOptions how;
    how.config = validate_config(call.check, out + "/layout.json", library.known());
    how.never_fails = call.check.fail_on == never_fails;
    how.threads = options.run.threads;
    how.version = ETAK_VERSION;
    result.report = Report{nullptr, how.config.settings.fail_on, how.never_fails};
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
  result.result = with_memory_for(
      call.settings.input, [&] { return "its atlas " + out; },
      [&] { return pack(call.settings.input, out, options, known); });
  if (check && check->report() != nullptr)
    result.report->report = std::make_shared<const ValidationReport>(*check->report());
  else
    result.report.reset();
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
  const auto get = [&](const char* name, auto read, const char* doc) {
    packed.def_property_readonly(name, read, doc);
  };
  get(
      "input", [](const Packed& p) { return p.result.input; }, "As the caller named it.");
  get(
      "output", [](const Packed& p) { return p.result.output; }, "The folder.");
  get(
      "files", [](const Packed& p) { return p.result.files; }, "That were written, in the folder.");
  get(
      "remarks", [](const Packed& p) { return p.result.remarks; }, "What should be known of the result.");
  get(
      "up_to_date", [](const Packed& p) { return p.result.up_to_date; }, "It was in place already.");
  get(
      "dry_run", [](const Packed& p) { return p.result.dry_run; }, "Nothing was written.");
  get(
      "materials", [](const Packed& p) { return p.result.materials; }, "Their number.");
  get(
      "regions", [](const Packed& p) { return p.result.regions; }, "Their number.");
  get(
      "pages",
      [](const Packed& p) {
        std::vector<std::pair<int, int>> out;
        for (const AtlasPage& each : p.result.layout.pages) out.emplace_back(each.width, each.height);
        return out;
      },
      "(width, height) of each.");
  get(
      "layout",
      [](const Packed& p) {
        return py::module_::import("json").attr("loads")(layout_json(p.result.layout)).cast<py::dict>();
      },
      "What layout.json holds.");
  get(
      "report", [](const Packed& p) { return p.report; },
      "What the validator found on the pages; None: they were not checked.");
  packed
      .def(
          "json", [](const Packed& p) { return report_json(p.result, false); }, "The report of the packer.")
      .def("__str__",
           [](const Packed& p) {
             std::string out = report_text(p.result, false);
             while (out.ends_with('\n')) out.pop_back();
             return out;
           })
      .def("__repr__", [](const Packed& p) {
        return "<etak.Packed " + p.result.output + ": " + std::to_string(p.result.materials) +
               " materials, " + std::to_string(p.result.layout.pages.size()) + " pages>";
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
