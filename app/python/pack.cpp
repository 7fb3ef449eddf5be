// SPDX-License-Identifier: Apache-2.0
#include "core/pack/pack.h"

#include <algorithm>
#include <cmath>

#include "app/python/validate.h"
#include "core/base/error.h"
#include "core/base/files/output.h"
#include "core/base/memory.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/pack/setting_reader.h"
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
    if (!is_text(value)) fail_type("a text");
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

PackOptions options_of(const PackSettings& settings, const Keywords& given, int threads) {
  PackOptions out = pack_options(settings);
  out.input.space_config = space_config_file(settings.ocio);
  out.input.pictures.door = picture_door_behind(&pictures);
  out.input.pictures.open_space = [config = settings.ocio](const std::string& name) {
    return pictures(printable(name)).open_source(config, name);
  };
  if (writes_floats(out.output.write))
    (void)pictures(setting("textures"));  // throws before the work where the module is missing
  out.output.overwrite = given.yes("force");
  out.output.update = given.yes("update");
  out.output.dry_run = given.yes("dry_run");
  out.run.memory = memory_setting(given.text("memory"));
  out.run.threads = threads_of(threads);
  out.run.version = ETAK_VERSION;
  return out;
}

// The result of packing, and the findings of the validator on its pages.
struct Packed {
  PackResult result;
  std::shared_ptr<const ValidationReport> report;  // null: they were not checked
  Severity fail_on = Severity::error;
};

Packed packed(const PackSettings& settings, PackOptions options,
              const std::optional<ValidateSettings>& checking, const Library& library, LongWork& work) {
  Packed out;
  std::optional<PackCheck> check;
  if (checking) {
    PackCheckOptions how;
    how.config = validate_config(*checking, settings.out + "/layout.json", library.known());
    how.never_fails = checking->fail_on == never_fails;
    how.threads = options.run.threads;
    how.version = ETAK_VERSION;
    out.fail_on = how.config.settings.fail_on;
    check.emplace(settings.out, std::move(how)).attach(options);
  }
  options.run.progress = [&](std::size_t done, std::size_t all) { work.tell(done, all); };
  options.run.cancelled = [&] { return work.stopped(); };
  options.check.beside = [&](PackResult& of, OutputFolder*) -> std::unique_ptr<Output> {
    if (check) check->finish(of);
    return nullptr;
  };
  const MaterialLibrary& known = library.get();
  options.input.other_manifest = project_reader(known);
  out.result = with_memory_for(
      settings.input, [&] { return "its atlas " + settings.out; },
      [&] { return pack(settings.input, settings.out, options, known); });
  if (check && check->report() != nullptr)
    out.report = std::make_shared<const ValidationReport>(*check->report());
  return out;
}

// The documents of a pack for etak/documents.py, and beside them the texts whose bytes JSON may not hold.
py::dict pack_call(const py::dict& given, const py::dict& more, const Library& library, int threads,
                   py::object progress) {
  const Keywords how{given};
  const PackSettings settings = pack_settings(how.text("input"), how.text("output"), more);
  if (settings.input.empty())
    throw Error::at("input", "nothing to pack", "a manifest, a glTF scene or a folder");
  if (settings.out.empty()) throw Error::at("output", "no folder to write", "the name of a folder");
  std::optional<ValidateSettings> check;
  if (how.yes("validate")) check = check_settings(how);
  const PackOptions options = options_of(settings, how, threads);
  LongWork work(std::move(progress));
  const Packed done = work.unlocked([&] { return packed(settings, options, check, library, work); });
  const PackResult& result = done.result;
  py::dict out;
  out["input"] = result.input;
  out["output"] = result.output;
  out["files"] = result.files;
  out["remarks"] = result.remarks;
  out["layout"] = layout_json(result.layout);
  out["json"] = report_json(result, false);
  out["text"] = report_text(result, false);
  if (done.report) out["forms"] = forms_of(done.report, done.fail_on);
  return out;
}

}  // namespace

void add_pack(py::module_& module) {
  module.def("pack", &pack_call);
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
