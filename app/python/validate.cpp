// SPDX-License-Identifier: Apache-2.0
// etak.validate: etak/documents.py makes the report of what is written here.
#include "app/python/validate.h"

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/findings/baseline.h"
#include "core/findings/output/explain.h"
#include "core/findings/output/formats.h"
#include "core/findings/suppress.h"
#include "core/judge/rules.h"
#include "core/validate/validate.h"

namespace etak::python {

ValidateSettings check_settings(const Keywords& given) {
  ValidateSettings out;
  out.config = given.text("config");
  out.no_config = given.yes("no_config");
  out.profile = given.text("profile");
  out.transfer = given.text("transfer");
  out.fail_on = given.text("fail_on");
  out.alpha = given.text("alpha");
  out.choice = {given.texts("only"), given.texts("select"), given.texts("extend_select"),
                given.texts("ignore")};
  return out;
}

py::function forms_of(std::shared_ptr<const ValidationReport> report, Severity fail_on) {
  return py::cpp_function(
      [report = std::move(report), options = OutputOptions{fail_on, ETAK_VERSION}](const std::string& form) {
        if (form == "head") return validation_head_json(*report, options);
        if (form == "files") return validation_files_json(*report);
        if (form == "verdict") return verdict_of(*report);
        if (auto out = validation_form(form, *report, options)) return *std::move(out);
        throw Error::at(setting("format"), printable(form), "text, json, sarif, junit, github or csv");
      },
      py::arg("form"), py::call_guard<Unlocked>());
}

namespace {

ValidationRequest request_of(const py::object& paths, const Keywords& given, const Library& library,
                             int threads) {
  ValidationRequest out;
  out.inputs.paths = texts_of(paths, "paths");
  if (out.inputs.paths.empty()) throw Error::at("paths", "nothing to check", "files or folders");
  out.config = validate_config(check_settings(given), out.inputs.paths.front(), library.known());
  for (const std::string& remark : out.config.remarks)
    if (PyErr_WarnEx(PyExc_FutureWarning, remark.c_str(), 2) != 0) throw py::error_already_set();
  if (const std::string role = given.text("role"); !role.empty()) {
    out.inputs.role = role_named(role);
    if (!out.inputs.role) throw Error::at(setting("role"), printable(role), picture_roles);
  }
  out.inputs.manifest.material = given.text("material");
  out.inputs.manifest.surface_class = given.text("surface");
  out.allowed.today = given.text("today");
  if (!out.allowed.today.empty() && !is_date(out.allowed.today))
    throw Error::at(setting("today"), printable(out.allowed.today), "a date such as 2027-01-01");
  if (const std::string baseline = given.text("baseline"); !baseline.empty())
    out.allowed.known = read_baseline(read_file(baseline), baseline);
  out.memory.cache.path = given.text("cache");
  if (const std::string size = given.text("cache_size"); !size.empty())
    out.memory.cache.most_bytes = byte_size(size, setting("cache-size"));
  out.run.door = picture_door_behind(&pictures);
  out.memory.version = ETAK_VERSION;
  out.inputs.pass_unknown = given.yes("allow_empty");
  out.must_check = !out.inputs.pass_unknown;
  out.run.threads = threads_of(threads);
  return out;
}

py::function check(const py::object& paths, const py::dict& given, const Library& library, int threads,
                   py::object progress) {
  LongWork work(std::move(progress));
  // Reading folders of materials can then be interrupted.
  (void)work.unlocked([&] { return library.known(); });
  ValidationRequest request = request_of(paths, {given}, library, threads);
  request.run.progress = [&](std::size_t done, std::size_t all) { work.tell(done, all); };
  request.run.stop = [&] { return work.stopped(); };
  const Severity fail_on = request.config.settings.fail_on;
  return forms_of(
      work.unlocked([&] { return std::make_shared<const ValidationReport>(validate(std::move(request))); }),
      fail_on);
}

// The long text about a rule; empty: no rule has the id.
std::string explanation_of(const std::string& id) {
  const Rule* const rule = find_rule(id);
  return rule == nullptr ? "" : explanation(*rule);
}

}  // namespace

void add_validate(py::module_& module) {
  module.def("explanation", &explanation_of);
  module.def("validate", &check);
}

}  // namespace etak::python
