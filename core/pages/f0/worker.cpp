// SPDX-License-Identifier: Apache-2.0
#include "core/pages/f0/worker.h"

#include <utility>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/memory.h"
#include "core/base/system.h"
#include "core/exchange/rii/axis_pages.h"
#include "core/exchange/table.h"
#include "core/material/json.h"
#include "core/material/names.h"
#include "core/material/quality.h"

namespace etak {
namespace {

std::string kind_of(Origin origin) {
  return std::string(origin == Origin::unknown ? std::string_view() : name(origin));
}

F0Result refused(std::string reason, Flags flags = {}) {
  F0Result out;
  out.refusal = std::move(reason);
  out.flags = flags;
  return out;
}

// What the user says of a bare table or page.
void state_row(const F0Job& job, F0Row& row) {
  row.material_class = job.tables.material_class;
  if (job.tables.origin) row.kind = kind_of(*job.tables.origin);
  if (!gives_f0(row.material_class)) drop_zone(row.result);
}

std::string page_source(std::string_view text, const std::string& path) {
  try {
    return one_line(material_from_rii_page(text, path, "page").preferred_dataset().citation);
  } catch (const Error&) {
    return {};  // the row says why the page cannot be used; a second message about its citation helps nobody
  }
}

}  // namespace

F0StageTimes& F0StageTimes::operator+=(const F0StageTimes& other) {
  read += other.read;
  parse += other.parse;
  print += other.print;
  f0.interpolate += other.f0.interpolate;
  f0.fresnel += other.f0.fresnel;
  f0.sum += other.f0.sum;
  bytes += other.bytes;
  return *this;
}

void F0Worker::start_lap(const F0Job& job) {
  if (job.timed) lap_begin_ = std::chrono::steady_clock::now();
}

void F0Worker::lap(double& stage, const F0Job& job) {
  if (!job.timed) return;
  const auto now = std::chrono::steady_clock::now();
  stage += std::chrono::duration<double>(now - lap_begin_).count();
  lap_begin_ = now;
}

F0Outcome F0Worker::answer(const MaterialInput& input, const F0Job& job) {
  return with_memory_for(
      input.path, [&] { return mebibytes(text_.size()) + " of text"; },
      [&] { return answer_in_memory(input, job); });
}

F0Outcome F0Worker::answer_in_memory(const MaterialInput& input, const F0Job& job) {
  if (input.kind == MaterialInput::Kind::failed) throw Error(input.path);
  if (input.file == MaterialFileKind::page) return answer_page(input, job);
  F0Outcome out;
  out.row.path = input.label();
  if (input.kind == MaterialInput::Kind::material) {
    if (job.tables.states())
      answer_dataset(read_material(input, job.tables), input, job, out.row);
    else
      answer_dataset(*input.material, input, job, out.row);
    return out;
  }
  start_lap(job);
  read_file(input.path, text_);
  times.bytes += text_.size();
  lap(times.read, job);
  if (is_prose(input, text_)) {
    out.kind = F0Outcome::Kind::prose;
    return out;
  }
  if (input.file == MaterialFileKind::table) {
    const Table table = parse_table(text_, input.path, job.tables);
    lap(times.parse, job);
    out.row.result = job.solver.solve(table.optics, table.flags, job.timed ? &times.f0 : nullptr);
    state_row(job, out.row);
  } else {
    Material material = parse_material(text_, input.path);
    state(material, job.tables);
    lap(times.parse, job);
    answer_dataset(material, input, job, out.row);
  }
  return out;
}

F0Outcome F0Worker::answer_page(const MaterialInput& input, const F0Job& job) {
  const std::string& name = input.path;
  start_lap(job);
  read_file(input.path, text_);
  times.bytes += text_.size();
  lap(times.read, job);
  parse_rii_page(text_, name, page_);
  lap(times.parse, job);
  F0Outcome out;
  if (page_.kind != PageKind::constants) {
    if (!input.from_folder)
      throw Error::at(name,
                      page_.kind == PageKind::nonlinear ? "holds n2 data" : "holds no optical constants",
                      "a page of n and k");
    out.kind = page_.kind == PageKind::nonlinear ? F0Outcome::Kind::nonlinear : F0Outcome::Kind::other;
    return out;
  }
  out.row.path = input.label();
  if (job.with_source) out.row.source = page_source(text_, name);
  if (page_.flags.has(Flag::computed)) out.row.kind = etak::name(Origin::computed);
  out.without_optics = !page_.refusal.empty();
  if (out.without_optics)
    out.row.result = refused(page_.refusal, page_.flags);
  else if (job.axis_average && !is_pipe_input(input.path))
    out.row.result = average_pages(input, job, out.row);
  else
    out.row.result = solve(page_.optics, page_.flags, job);
  state_row(job, out.row);
  return out;
}

F0Result F0Worker::solve(OpticalConstants& constants, Flags flags, const F0Job& job) {
  // The solver takes a variant: the constants are moved into one and back, so that the next page can use the
  // memory of their vectors.
  Optics optics = std::move(constants);
  F0Result result = job.solver.solve(optics, flags, job.timed ? &times.f0 : nullptr);
  constants = std::move(std::get<OpticalConstants>(optics));
  return result;
}

F0Result F0Worker::average_pages(const MaterialInput& input, const F0Job& job, F0Row& row) {
  const std::vector<AxisPage> axes = axis_pages(input.path);
  if (axes.empty()) return solve(page_.optics, page_.flags, job);
  std::vector<Optics> optics(axes.size());
  std::vector<F0Solver::Part> parts;
  Flags flags;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (sys::FileInfo info; !sys::file_info(axes[i].path, info))
      return refused("no average over axes: " + axes[i].path.substr(input.label_at) + " is missing",
                     page_.flags);
    read_file(axes[i].path, text_);
    RiiPage page;
    parse_rii_page(text_, axes[i].path, page);
    if (!page.refusal.empty() || page.kind != PageKind::constants)
      return refused("no average over axes: " + axes[i].path.substr(input.label_at) + " has no usable n",
                     page.flags);
    optics[i] = std::move(page.optics);
    parts.push_back({&optics[i], axes[i].weight});
    flags |= page.flags;
    row.dataset += (i == 0 ? "" : " + ") + axes[i].path.substr(input.path.rfind('/') + 1);
  }
  return job.solver.solve(parts, flags);
}

void F0Worker::answer_dataset(const Material& material, const MaterialInput& input, const F0Job& job,
                              F0Row& row) {
  const Dataset& dataset = dataset_named(material, input.dataset, input.path);
  row.alias_note = input.alias_note;
  row.name = material.name;
  row.material_class = material.material_class;
  row.dataset = dataset.id;
  row.source = one_line(dataset.citation);
  row.kind = kind_of(dataset.origin);
  row.doubt = doubt(material, dataset);
  const auto average =
      job.axis_average ? average_over_axes(job.solver, material, dataset) : std::optional<AxisAverage>();
  if (!average) {
    row.result = etak::solve(job.solver, material, dataset, job.timed ? &times.f0 : nullptr);
    return;
  }
  if (!average->datasets.empty() && !average->result.refused()) row.dataset = average->datasets;
  if (row.doubt.empty()) row.doubt = average->doubt;
  row.result = average->result;
}

}  // namespace etak
