// SPDX-License-Identifier: Apache-2.0
#include "app/python/validate.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/validate/baseline.h"
#include "core/validate/files/result_cache.h"
#include "core/validate/output/explain.h"
#include "core/validate/output/formats.h"
#include "core/validate/rules.h"
#include "core/validate/suppress.h"

namespace etak::python {

std::vector<std::string> texts_of(const py::handle& value, const std::string& name) {
  if (value.is_none()) return {};
  if (py::isinstance<py::str>(value) || py::hasattr(value, "__fspath__")) return {text_of(value, name)};
  std::vector<std::string> out;
  for (const py::handle each : py::iter(value)) out.push_back(text_of(each, name));
  return out;
}

ValidateSettings check_settings(const py::dict& given) {
  ValidateSettings out;
  const auto text = [&](const char* name, std::string& to) {
    if (given.contains(name)) to = text_of(given[name], name);
  };
  const auto texts = [&](const char* name, std::vector<std::string>& to) {
    if (given.contains(name)) to = texts_of(given[name], name);
  };
  text("config", out.config);
  text("profile", out.profile);
  text("transfer", out.transfer);
  text("fail_on", out.fail_on);
  text("alpha", out.alpha);
  if (given.contains("no_config")) out.no_config = given["no_config"].cast<bool>();
  texts("only", out.choice.only);
  texts("select", out.choice.select);
  texts("extend_select", out.choice.extend_select);
  texts("ignore", out.choice.ignore);
  return out;
}

namespace {

/// etak.Finding: a finding, which keeps the report that it is in.
struct FindingOf {
  std::shared_ptr<const ValidationReport> report;
  const Finding* finding = nullptr;

  std::string path() const { return shown_path(finding->file, report->typed); }
};

/// etak.CheckedFile.
struct FileOf {
  std::shared_ptr<const ValidationReport> report;
  const CheckedFile* file = nullptr;
};

// ---- pickles

// What the bytes of the cache do not hold of a file and its findings: what a configuration and a baseline say of them.
py::tuple file_state(const CheckedFile& file) {
  py::list judged;
  for (const Finding& each : file.findings)
    judged.append(py::make_tuple(each.suppressed, each.suppression, each.baseline));
  return py::make_tuple(py::bytes(result_text(file)), file.unreadable, judged);
}
CheckedFile file_of(const py::tuple& state) {
  auto out = read_result_text(std::string_view(state[0].cast<py::bytes>()));
  const py::list judged = state[2].cast<py::list>();
  if (!out || judged.size() != out->findings.size())
    throw Error::at("pickle", "bytes of another form", "those of a pickle of this type");
  out->unreadable = state[1].cast<bool>();
  for (std::size_t i = 0; i < judged.size(); ++i) {
    Finding& each = out->findings[i];
    std::tie(each.suppressed, each.suppression, each.baseline) =
        judged[i].cast<std::tuple<bool, std::string, bool>>();
  }
  return std::move(*out);
}

py::tuple state_of(const FileOf& of) {
  return py::make_tuple(file_state(*of.file), of.report->typed);
}
py::tuple state_of(const FindingOf& of) {
  CheckedFile alone;
  alone.findings = {*of.finding};
  return py::make_tuple(file_state(alone), of.report->typed);
}
FileOf restored_file(const py::tuple& file, const TypedFolders& typed) {
  auto report = std::make_shared<ValidationReport>();
  report->typed = typed;
  report->files.push_back(file_of(file));
  const CheckedFile* const first = &report->files.front();
  return {std::move(report), first};
}
FindingOf restored_finding(const py::tuple& file, const TypedFolders& typed) {
  FileOf of = restored_file(file, typed);
  if (of.file->findings.empty()) throw Error::at("pickle", "no finding", "one");
  return {std::move(of.report), &of.file->findings.front()};
}

py::tuple state_of(const Report& of) {
  const ValidationReport& r = *of.report;
  py::list files;
  for (const CheckedFile& each : r.files) files.append(file_state(each));
  return py::make_tuple(
      static_cast<int>(of.fail_on), of.never_fails, py::make_tuple(r.profile, r.transfer, r.settings_hash),
      files, std::array{r.errors, r.warnings, r.infos},
      std::array{r.passed, r.incomplete, r.stopped, r.nothing_checked}, r.not_opened, r.unknown, r.typed,
      std::array{r.run.files, r.run.skipped, r.run.failed, r.run.checks, r.run.from_cache, r.run.unchanged});
}
Report restored_report(int fail_on, bool never_fails, const std::array<std::string, 3>& texts,
                       const py::list& files, const std::array<std::size_t, 3>& found,
                       const std::array<bool, 4>& is, const std::vector<std::string>& not_opened,
                       const std::vector<std::string>& unknown, const TypedFolders& typed,
                       const std::array<std::size_t, 6>& run) {
  auto r = std::make_shared<ValidationReport>();
  r->profile = texts[0], r->transfer = texts[1], r->settings_hash = texts[2];
  for (const py::handle each : files) r->files.push_back(file_of(each.cast<py::tuple>()));
  r->errors = found[0], r->warnings = found[1], r->infos = found[2];
  r->passed = is[0], r->incomplete = is[1], r->stopped = is[2], r->nothing_checked = is[3];
  r->not_opened = not_opened, r->unknown = unknown, r->typed = typed;
  r->run = {run[0], run[1], run[2], run[3], run[4], run[5]};
  return {std::move(r), static_cast<Severity>(fail_on), never_fails};
}

std::vector<FindingOf> findings_of(const Report& report) {
  std::vector<FindingOf> out;
  for (const CheckedFile& file : report.report->files)
    for (const Finding& finding : file.findings) out.push_back({report.report, &finding});
  return out;
}

std::vector<FileOf> files_of(const Report& report) {
  std::vector<FileOf> out;
  for (const CheckedFile& file : report.report->files) out.push_back({report.report, &file});
  return out;
}

std::string form_of(const Report& report, const std::string& format) {
  const OutputOptions options{report.fail_on, ETAK_VERSION};
  const ValidationReport& r = *report.report;
  if (format == "text") return validation_text(r);
  if (format == "json") return validation_json(r, options);
  if (format == "sarif") return validation_sarif(r, options);
  if (format == "junit") return validation_junit(r, options);
  if (format == "github") return validation_github(r);
  if (format == "csv") return validation_csv(r);
  throw Error::at(setting("format"), printable(format), "text, json, sarif, junit, github or csv");
}

ValidationRequest request_of(const py::object& paths, const py::dict& given, const Library& library,
                             int threads) {
  ValidationRequest out;
  out.paths = texts_of(paths, "paths");
  if (out.paths.empty()) throw Error::at("paths", "nothing to check", "files or folders");
  const auto text = [&](const char* name) { return given.contains(name) ? text_of(given[name], name) : ""; };
  const auto yes = [&](const char* name) { return given.contains(name) && given[name].cast<bool>(); };
  out.config = validate_config(check_settings(given), out.paths.front(), library.known());
  if (const std::string role = text("role"); !role.empty()) {
    out.role = role_named(role);
    if (!out.role) throw Error::at(setting("role"), printable(role), picture_roles);
  }
  out.manifest.material = text("material");
  out.manifest.surface_class = text("surface");
  out.today = text("today");
  if (!out.today.empty() && !is_date(out.today))
    throw Error::at(setting("today"), printable(out.today), "a date such as 2027-01-01");
  if (const std::string baseline = text("baseline"); !baseline.empty())
    out.known = read_baseline(read_file(baseline), baseline);
  out.cache.path = text("cache");
  if (const std::string size = text("cache_size"); !size.empty())
    out.cache.most_bytes = byte_size(size, setting("cache-size"));
  out.door = picture_door_behind(&pictures);
  out.version = ETAK_VERSION;
  out.must_check = !yes("allow_empty");
  out.pass_unknown = yes("allow_empty");
  out.threads = threads_of(threads);
  return out;
}

Report check(const py::object& paths, const py::dict& given, const Library& library, int threads,
             py::object progress) {
  LongWork work(std::move(progress));
  // Reading folders of materials can then be interrupted.
  (void)work.unlocked([&] { return library.known(); });
  ValidationRequest request = request_of(paths, given, library, threads);
  request.progress = [&](std::size_t done, std::size_t all) { work.tell(done, all); };
  request.stop = [&] { return work.stopped(); };
  Report out;
  out.fail_on = request.config.settings.fail_on;
  out.never_fails = given.contains("fail_on") && text_of(given["fail_on"], "fail_on") == never_fails;
  out.report =
      work.unlocked([&] { return std::make_shared<const ValidationReport>(validate(std::move(request))); });
  return out;
}

py::object box_of(const std::optional<PixelBox>& box) {
  if (!box) return py::none();
  return py::make_tuple(box->x, box->y, box->width, box->height);
}

void add_finding(py::module_& module) {
  py::class_<FindingOf> finding(module, "Finding", "A defect that a rule has found.");
  be_value(
      finding, [](const FindingOf& f) { return state_of(f); }, &restored_finding);
  const auto get = [&](const char* name, auto read, const char* doc) {
    finding.def_property_readonly(name, read, doc);
  };
  get(
      "rule", [](const FindingOf& f) { return f.finding->rule; }, "\"ETK101\".");
  get(
      "slug", [](const FindingOf& f) { return f.finding->slug; }, "\"f0-forbidden-zone\".");
  get(
      "severity", [](const FindingOf& f) { return std::string(name(f.finding->severity)); },
      "\"info\", \"warning\" or \"error\".");
  get("path", &FindingOf::path, "The file, as the caller named it.");
  get(
      "place", [](const FindingOf& f) { return place_of(*f.finding, f.path()); },
      "File, tile and box, or the JSON pointer, as one text.");
  get(
      "tile", [](const FindingOf& f) { return f.finding->tile; }, "Of an atlas; else empty.");
  get(
      "material", [](const FindingOf& f) { return f.finding->material; }, "Where it is named.");
  get(
      "pointer", [](const FindingOf& f) { return f.finding->pointer; },
      "JSON pointer, for materials and scenes.");
  get(
      "box", [](const FindingOf& f) { return box_of(f.finding->box); },
      "(x, y, width, height) in texels, or None.");
  get(
      "uv", [](const FindingOf& f) { return f.finding->uv; }, "[left, top, right, bottom], or None.");
  get(
      "area", [](const FindingOf& f) { return f.finding->area_px; }, "In texels.");
  get(
      "area_share", [](const FindingOf& f) { return f.finding->area_share; }, "Of the tile.");
  get(
      "linear", [](const FindingOf& f) { return f.finding->linear; },
      "The linear colour that was found, or None.");
  get(
      "byte", [](const FindingOf& f) { return f.finding->byte; }, "Its codes, or None.");
  get(
      "luminance", [](const FindingOf& f) { return f.finding->luminance; }, "Of it, or None.");
  get(
      "value", [](const FindingOf& f) { return f.finding->value; }, "What was found: \"F0 0.22\".");
  get(
      "limit", [](const FindingOf& f) { return f.finding->limit; }, "What it is held against: \"20-45 %\".");
  get(
      "nearest",
      [](const FindingOf& f) {
        std::vector<std::tuple<std::string, std::string, double>> out;
        for (const NearestMaterial& each : f.finding->nearest)
          out.emplace_back(each.id, each.dataset, each.bytes);
        return out;
      },
      "Materials that come near: (id, dataset, distance in codes).");
  get(
      "message", [](const FindingOf& f) { return f.finding->message; }, "One sentence: value, place, area.");
  get(
      "cause", [](const FindingOf& f) { return f.finding->cause; }, "A possible cause; empty: not known.");
  get(
      "advice", [](const FindingOf& f) { return f.finding->fix; }, "What mends it.");
  get(
      "source", [](const FindingOf& f) { return f.finding->source; }, "Of the rule.");
  get(
      "explanation",
      [](const FindingOf& f) {
        const Rule* rule = find_rule(f.finding->rule);
        return rule == nullptr ? std::string() : explanation(*rule);
      },
      "What the rule is about, at length.");
  get(
      "suppressed", [](const FindingOf& f) { return f.finding->suppressed; },
      "By an [[allow]] entry of etak.toml.");
  get(
      "suppression", [](const FindingOf& f) { return f.finding->suppression; }, "The reason that it gives.");
  get(
      "known", [](const FindingOf& f) { return f.finding->baseline; }, "From the baseline.");
  get(
      "counts", [](const FindingOf& f) { return counts(*f.finding); }, "Neither suppressed nor known.");
  const auto line = [](const FindingOf& f) {
    return std::string(name(f.finding->severity)) + " " + f.finding->rule + " " +
           place_of(*f.finding, f.path()) + ": " + sentence_of(*f.finding);
  };
  finding.def("__str__", line).def("__repr__", [line](const FindingOf& f) {
    return repr_line("Finding", line(f));
  });
}

}  // namespace

void add_validate(py::module_& module) {
  add_finding(module);
  py::class_<FileOf> file(module, "CheckedFile",
                          "A checked file, or a pair or set of files that belong together.");
  be_value(
      file, [](const FileOf& f) { return state_of(f); }, &restored_file);
  file.def_property_readonly(
          "path", [](const FileOf& f) { return shown_path(f.file->path, f.report->typed); },
          "As the caller named it.")
      .def_property_readonly(
          "companions",
          [](const FileOf& f) {
            std::vector<std::string> out;
            for (const std::string& each : f.file->companions)
              out.push_back(shown_path(each, f.report->typed));
            return out;
          },
          "Other files of the set.")
      .def_property_readonly(
          "size", [](const FileOf& f) { return std::pair(f.file->width, f.file->height); },
          "In texels; (0, 0) for what is no picture.")
      .def_property_readonly(
          "roles",
          [](const FileOf& f) {
            py::dict out;
            for (const auto& [path, role] : f.file->roles)
              out[py::cast(shown_path(path, f.report->typed))] = role;
            return out;
          },
          "What each file was taken for.")
      .def_property_readonly(
          "counts",
          [](const FileOf& f) {
            py::dict out;
            for (const auto& [name, count] : f.file->counts) out[py::str(name)] = count;
            return out;
          },
          "Exact counts of texels.")
      .def_property_readonly(
          "readable", [](const FileOf& f) { return !f.file->unreadable; }, "Whether it could be read.")
      .def_property_readonly(
          "findings",
          [](const FileOf& f) {
            std::vector<FindingOf> out;
            for (const Finding& each : f.file->findings) out.push_back({f.report, &each});
            return out;
          },
          "In the order of rules.")
      .def("__repr__", [](const FileOf& f) {
        return repr_line("CheckedFile", shown_path(f.file->path, f.report->typed));
      });

  py::class_<Report> report(module, "Report", "What the validator found: a sequence of findings.");
  be_value(
      report, [](const Report& r) { return state_of(r); }, &restored_report);
  const auto get = [&](const char* name, auto read, const char* doc) {
    report.def_property_readonly(name, read, doc);
  };
  get("findings", &findings_of, "All of them, in the order of files.");
  get("files", &files_of, "What was checked.");
  get("passed", &Report::passed, "Nothing at or above fail_on, and all was checked.");
  get(
      "incomplete", [](const Report& r) { return r.report->incomplete; }, "Something could not be checked.");
  get(
      "errors", [](const Report& r) { return r.report->errors; }, "Their number.");
  get(
      "warnings", [](const Report& r) { return r.report->warnings; }, "Their number.");
  get(
      "infos", [](const Report& r) { return r.report->infos; }, "Their number.");
  get(
      "profile", [](const Report& r) { return r.report->profile; }, "That was used.");
  get(
      "transfer", [](const Report& r) { return r.report->transfer; }, "The curve of the codes.");
  get(
      "unknown",
      [](const Report& r) {
        std::vector<std::string> out;
        for (const std::string& each : r.report->unknown) out.push_back(shown_path(each, r.report->typed));
        return out;
      },
      "Pictures whose names tell no role.");
  get(
      "verdict", [](const Report& r) { return verdict_of(*r.report); }, "One line.");
  report.def("form", &form_of, py::arg("format"), "As text, json, sarif, junit, github or csv.")
      .def("__len__", [](const Report& r) { return findings_of(r).size(); })
      .def("__iter__", [](const Report& r) { return py::iter(py::cast(findings_of(r))); })
      .def(
          "__getitem__",
          [](const Report& r, py::ssize_t index) {
            const auto all = findings_of(r);
            const auto size = static_cast<py::ssize_t>(all.size());
            if (index < 0) index += size;
            if (index < 0 || index >= size) throw py::index_error("no such finding");
            return all[static_cast<std::size_t>(index)];
          },
          py::arg("index"))
      .def("__str__",
           [](const Report& r) {
             std::string out = validation_text(*r.report);
             while (out.ends_with('\n')) out.pop_back();
             return out;
           })
      .def("__repr__", [](const Report& r) { return repr_line("Report", verdict_of(*r.report)); });

  module.def("validate", &check, py::arg("paths"), py::arg("settings"), py::arg("library"),
             py::arg("threads"), py::arg("progress"));
}

}  // namespace etak::python
