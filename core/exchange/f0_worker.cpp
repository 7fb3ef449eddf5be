// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/f0_worker.h"

#include <utility>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/memory.h"
#include "core/base/system.h"
#include "core/certainty/publications.h"
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

}  // namespace

std::vector<F0Layer> layers_of(const Dataset& dataset) {
  std::vector<F0Layer> out;
  const auto* stack = std::get_if<Stack>(&dataset.optics);
  if (stack == nullptr || !stack->is_open()) return out;
  for (const StackLayer& layer : stack->layers) {
    const StackMedium& medium = stack->media[layer.medium];
    out.push_back({medium.id, medium.dataset, layer.thickness_nm, layer.coherent});
  }
  const StackMedium& base = stack->media[stack->base];
  out.push_back({base.id, base.dataset, {}, true});
  return out;
}

void set_record(F0Row& row, const Material& material, const Dataset& dataset) {
  row.name = material.name;
  row.material_class = material.material_class;
  row.dataset = dataset.id;
  row.source = source_line(dataset);
  row.kind = kind_of(dataset.origin);
  row.layers = layers_of(dataset);
}

void set_band(F0Row& row, const F0Solver& solver, const Material& material, const Dataset& dataset) {
  const MaterialBand found = material_band(solver, material, dataset, row.result);
  row.band = found.band;
  row.band_reason = found.reason;
}

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

F0Outcome F0Worker::answer(const MaterialInput& input, const F0Job& job) {
  return with_memory_for(
      input.path, [&] { return mebibytes(text_.size()) + " of text"; },
      [&] { return answer_in_memory(input, job); });
}

F0Outcome F0Worker::answer_in_memory(const MaterialInput& input, const F0Job& job) {
  if (input.kind == MaterialInput::Kind::failed) throw Error(input.path);
  F0Outcome out;
  out.row.path = input.label();
  if (input.kind == MaterialInput::Kind::material) {
    if (job.materials)
      out.material = read_material(input, job.tables);
    else if (job.tables.states())
      answer_dataset(read_material(input, job.tables), input, job, out.row);
    else
      answer_dataset(*input.material, input, job, out.row);
    return out;
  }
  Stopwatch watch(job.timed);
  read_file(input.path, text_);
  times.bytes += text_.size();
  watch.lap(times.read);
  if (is_prose(input, text_)) {
    out.kind = F0Outcome::Kind::prose;
  } else if (input.file == MaterialFileKind::page) {
    parse_rii_page(text_, input.path, page_);
    watch.lap(times.parse);
    answer_page(input, job, out);
  } else if (job.materials) {
    out.material = material_of_text(text_, input.path, input.file, job.tables);
    open_stacks(*out.material, input);
  } else if (input.file == MaterialFileKind::table) {
    const Table table = parse_table(text_, input.path, job.tables);
    watch.lap(times.parse);
    solve(table.optics, table.flags, job, out.row);
    state_row(job, out.row);
  } else {
    Material material = parse_material(text_, input.path);
    open_stacks(material, input);
    state(material, job.tables);
    watch.lap(times.parse);
    answer_dataset(material, input, job, out.row);
  }
  return out;
}

// Answers for page_.
void F0Worker::answer_page(const MaterialInput& input, const F0Job& job, F0Outcome& out) {
  if (page_.kind != PageKind::constants) {
    const bool nonlinear = page_.kind == PageKind::nonlinear;
    if (!input.from_folder)
      throw Error::at(input.path, nonlinear ? "holds n2 data" : "holds no optical constants",
                      "a page of n and k");
    out.kind = nonlinear ? F0Outcome::Kind::nonlinear : F0Outcome::Kind::other;
    return;
  }
  if (page_.flags.has(Flag::computed)) out.row.kind = etak::name(Origin::computed);
  if (!page_.refusal.empty()) {
    out.row.result = refused(page_.refusal, page_.flags);
  } else if (job.materials) {
    out.material = material_of_page(std::move(page_), input.path, {});
    state(*out.material, job.tables);
    return;
  } else {
    if (job.with_source) out.row.source = one_line(citation_of_page(page_, input.path));
    if (job.axis_average && !is_pipe_input(input.path))
      average_pages(input, job, out.row);
    else
      solve(page_.optics, page_.flags, job, out.row);
  }
  state_row(job, out.row);
}

void F0Worker::average_pages(const MaterialInput& input, const F0Job& job, F0Row& row) {
  const std::vector<AxisPage> axes = axis_pages(input.path);
  if (axes.empty()) return solve(page_.optics, page_.flags, job, row);
  std::vector<RiiPage> others(axes.size());
  std::vector<F0Solver::Part> parts;
  Flags flags;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::string& path = axes[i].path;
    RiiPage& page = path == input.path ? page_ : others[i];
    if (&page != &page_) {
      if (sys::FileInfo info; !sys::file_info(path, info)) {
        row.result =
            refused("no average over axes: " + path.substr(input.label_at) + " is missing", page_.flags);
        return;
      }
      read_file(path, text_);
      parse_rii_page(text_, path, page);
    }
    if (!page.refusal.empty() || page.kind != PageKind::constants) {
      row.result =
          refused("no average over axes: " + path.substr(input.label_at) + " has no usable n", page.flags);
      return;
    }
    parts.push_back({&page.optics, axes[i].weight});
    flags |= page.flags;
    row.dataset += (i == 0 ? "" : " + ") + path.substr(input.path.rfind('/') + 1);
  }
  row.result = job.solver.solve(parts, flags);
}

// The row's result, and what the job's coat makes of it.
void F0Worker::finish(const Optics& optics, F0Result result, const F0Job& job, F0Row& row) {
  row.result = std::move(result);
  if (!job.coat || row.result.refused()) return;
  CoatedF0 coat;
  std::string why = coated(*job.coat, job.solver.options(), optics, row.path, coat);
  if (!why.empty()) {
    const Coverage coverage = row.result.coverage;
    row.result = refused(std::move(why), row.result.flags);
    row.result.coverage = coverage;
  } else {
    row.coat = std::move(coat);
  }
}

void F0Worker::answer_dataset(const Material& material, const MaterialInput& input, const F0Job& job,
                              F0Row& row) {
  const Dataset& dataset = dataset_named(material, input.dataset, input.path);
  row.alias_note = input.alias_note;
  set_record(row, material, dataset);
  if (job.with_source) row.clear = clear_body(material, dataset, job.solver.options().space);
  const auto average =
      job.axis_average ? average_over_axes(job.solver, material, dataset) : std::optional<AxisAverage>();
  if (!average) {
    finish(dataset.optics, etak::solve(job.solver, material, dataset, job.timed ? &times.f0 : nullptr), job,
           row);
    if (row.result.flags.has(Flag::doubtful)) row.doubt = doubt(material, dataset);
    if (job.bands) set_band(row, job.solver, material, dataset);
    return;
  }
  if (!average->datasets.empty() && !average->result.refused()) row.dataset = average->datasets;
  row.doubt = doubt(material, dataset);
  if (row.doubt.empty()) row.doubt = average->doubt;
  row.result = average->result;
  row.band_reason = "a mean over the axes of a crystal";
}

}  // namespace etak
