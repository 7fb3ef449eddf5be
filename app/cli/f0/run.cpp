// SPDX-License-Identifier: Apache-2.0
#include "app/cli/f0/run.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/base/system.h"
#include "core/certainty/publications.h"
#include "core/material/quality.h"
#include "core/pages/f0/report.h"

namespace etak::cli {
namespace {

// How many inputs had which result, for the exit status and the closing remark.
struct Tally {
  std::size_t rows = 0, answered = 0, refused = 0, refused_by_name = 0, failed = 0, nonlinear = 0, other = 0,
              prose = 0, lines = 0;

  Tally& operator+=(const Tally& more) {
    rows += more.rows;
    answered += more.answered;
    refused += more.refused;
    refused_by_name += more.refused_by_name;
    failed += more.failed;
    nonlinear += more.nonlinear;
    other += more.other;
    prose += more.prose;
    lines += more.lines;
    return *this;
  }
};

void count(const F0Outcome& outcome, const MaterialInput& input, Tally& tally) {
  tally.nonlinear += outcome.kind == F0Outcome::Kind::nonlinear;
  tally.other += outcome.kind == F0Outcome::Kind::other;
  tally.prose += outcome.kind == F0Outcome::Kind::prose;
  if (outcome.kind != F0Outcome::Kind::answered) return;
  ++tally.answered;
  const F0Result& result = outcome.row.result;
  // Without a flag of the kind, the integration was asked for.
  tally.lines += result.integration && result.flags.has(Flag::finer_than_grid);
  if (!outcome.row.result.refused()) return;
  ++tally.refused;
  tally.refused_by_name += !input.from_folder;
}

// The output of neighbouring inputs, made by one worker. Results in forms made of lines (CSV, JSON Lines)
// become text at once, so that a run over thousands of files does not hold their results; other forms keep
// rows.
struct Chunk {
  std::string text;
  std::vector<F0Row> rows;
  std::vector<std::string> errors;
  Tally tally;
};
constexpr std::size_t chunk_inputs = 8;

bool is_of_lines(const std::string& format) {
  return format == "csv" || format == "jsonl";
}

F0CsvColumns extra_columns(const F0Arguments& arguments) {
  return {.coat = !arguments.coat.empty(), .band = arguments.bands};
}

void append_line(std::string& out, const F0Row& row, const F0Arguments& arguments, const F0Options& options) {
  if (arguments.output.format == "csv")
    append_f0_csv(out, row, extra_columns(arguments));
  else
    out += f0_jsonl({&row, 1}, options);
}

void add_row(F0Row row, const F0Arguments& arguments, const F0Options& options, Chunk& out) {
  const std::string& format = arguments.output.format;
  if (is_of_lines(format) && arguments.sort.empty())
    append_line(out.text, row, arguments, options);
  else
    out.rows.push_back(std::move(row));
  ++out.tally.rows;
}

void answer_one(const MaterialInput& input, const F0Job& job, const F0Arguments& arguments, F0Worker& worker,
                Chunk& out) {
  try {
    F0Outcome outcome = worker.answer(input, job);
    count(outcome, input, out.tally);
    if (outcome.kind != F0Outcome::Kind::answered) return;
    Stopwatch watch(job.timed);
    add_row(std::move(outcome.row), arguments, job.solver.options(), out);
    watch.lap(worker.times.print);
  } catch (const Error& error) {
    ++out.tally.failed;
    out.errors.emplace_back(error.what());
    if (!input.from_folder) return;
    // The output of a folder has a row for every file, a broken file too.
    F0Row row;
    row.path = input.label();
    row.result.refusal = std::string("error: ") + error.what();
    add_row(std::move(row), arguments, job.solver.options(), out);
  }
}

// The material of one input for the HTML form; a material without datasets where there is nothing to show.
MaterialReport html_report(const MaterialInput& input, const F0Job& job, F0Worker& worker, Tally& tally) {
  F0Outcome outcome;
  if (input.from_folder) {
    // Files of a folder that are no pages, and pages without n, have nothing to show.
    outcome = worker.answer(input, job);
    if (!outcome.material) {
      count(outcome, input, tally);
      return {};
    }
  }
  MaterialReport report{outcome.material ? std::move(*outcome.material) : read_material(input, job.tables),
                        {}};
  for (const Dataset& dataset : report.material.datasets)
    report.results.push_back(solve(job.solver, report.material, dataset));
  outcome.row.result = report.results[report.material.preferred];
  count(outcome, input, tally);
  return report;
}

// The HTML form shows whole materials with all their datasets instead of rows.
std::string html(const std::vector<MaterialInput>& inputs, const F0Job& job, std::vector<F0Worker>& workers,
                 std::vector<std::string>& errors, Tally& tally) {
  std::vector<MaterialReport> reports(inputs.size());
  std::vector<std::string> failures(inputs.size());
  std::vector<Tally> tallies(workers.size());
  const auto threads = static_cast<unsigned>(workers.size());
  parallel_chunks(inputs.size(), threads, 1, [&](std::size_t i, std::size_t, unsigned worker) {
    // Each material is shown once, with all its datasets, so that "gold/*" gives one entry and not one for
    // each dataset.
    if (i > 0 && inputs[i].material && inputs[i].material == inputs[i - 1].material) return;
    try {
      reports[i] = html_report(inputs[i], job, workers[worker], tallies[worker]);
    } catch (const Error& error) {
      failures[i] = error.what();
    }
  });
  for (const Tally& part : tallies) tally += part;
  std::vector<MaterialReport> shown;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!failures[i].empty()) errors.push_back(std::move(failures[i]));
    if (!reports[i].results.empty()) shown.push_back(std::move(reports[i]));
  }
  tally.failed = errors.size();
  tally.rows = shown.size();
  return f0_page(shown, job.solver.options());
}

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what;
}

void print_remarks(const F0Arguments& arguments, std::size_t inputs, const Tally& tally) {
  if (tally.lines > 0)
    remark(arguments.output, counted(tally.lines, tally.lines == 1 ? "spectrum" : "spectra") +
                                 " with lines that the 1 nm sum would miss: integrated exactly");
  if (inputs < 2) return;
  std::string text = counted(tally.answered, "answered");
  if (tally.refused > 0) text += ", " + counted(tally.refused, "of them refused (the flags say why)");
  if (tally.nonlinear > 0) text += "; " + counted(tally.nonlinear, "n2 files are no pages");
  if (tally.other > 0) text += "; " + counted(tally.other, "about and catalogue files are no pages");
  if (tally.prose > 0)
    text += "; " + counted(tally.prose, tally.prose == 1 ? "text is no table" : "texts are no tables");
  if (tally.failed > 0) text += "; " + counted(tally.failed, "failed");
  remark(arguments.output, text);
}

// Tells readers of a table on a terminal about -v. Tables in files and pipes get no such remark.
void hint_at_policy(const F0Arguments& arguments, const F0Options& options) {
  const OutputArguments& output = arguments.output;
  if (output.format != "table" || arguments.verbose || !is_standard_output(output)) return;
  if (sys::is_terminal(sys::standard_output))
    remark(output, short_policy(options) + "; -v tells the whole policy and what the flags mean");
}

void print_stats(const F0StageTimes& times, double find, double wall, std::size_t inputs, unsigned threads) {
  const auto ms = [](double seconds) { return number(seconds * 1e3, 3) + " ms"; };
  const double megabytes = static_cast<double>(times.bytes) / 1e6;
  complain("stats: " + std::to_string(inputs) + " inputs, " + number(megabytes, 4) + " MB in " + ms(wall) +
           " on " + std::to_string(threads) + (threads == 1 ? " thread, " : " threads, ") +
           number(megabytes / wall, 4) + " MB/s");
  complain("stats: find " + ms(find) + "; summed over threads: read " + ms(times.read) + ", parse " +
           ms(times.parse) + ", interpolate " + ms(times.f0.interpolate) + ", Fresnel " +
           ms(times.f0.fresnel) + ", sum " + ms(times.f0.sum) + ", print " + ms(times.print));
}

// Makes the allocator keep freed memory for the next page. The buffers of a worker grow and shrink with the
// pages that it reads; memory that is given back to the system comes again with page faults, for which
// threads wait.
void keep_worker_memory() {
  constexpr int kept_bytes = 64 << 20;
  sys::keep_freed_memory(kept_bytes, kept_bytes);
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// A run of the verb. It takes the names of the line at once and the names of a list in batches, so that for a
// list of a million names only the output is kept in memory: the text or the rows of the results.
class F0Run {
 public:
  F0Run(F0Arguments& arguments, const F0Job& job, unsigned threads)
      : arguments_(arguments), job_(job), workers_(threads) {
    if (arguments.output.format == "csv") text_ = f0_csv_header(extra_columns(arguments));
  }

  int answer_all() {
    const auto begin = Clock::now();
    std::optional<ListedNames> list;
    if (!arguments_.files_from.empty()) list.emplace(arguments_.files_from);
    InputNames batch = arguments_.inputs;
    {
      Progress progress(arguments_.output, 0, "f0");
      // The HTML page of all materials needs all inputs at once.
      const std::size_t most = is_html() ? static_cast<std::size_t>(-1) : batch_names;
      std::size_t names_left = list ? list->count() : 0;
      for (bool first = true;; first = false) {
        std::vector<std::string> listed;
        if (list) listed = list->take(most);
        if (!first && listed.empty()) break;
        names_left -= std::min(names_left, listed.size());
        for (std::string& name : listed)
          batch.names.push_back(name == "-" ? accept_input(name) : std::move(name));
        answer(batch, names_left, progress);
        batch.names.clear();
        batch.all = false;
      }
    }
    if (inputs_ == 0 && !arguments_.allow_empty) throw empty_list(arguments_.files_from);
    if (tally_.rows == 0 && tally_.failed == 0 && inputs_ > 0)
      throw Error::at(
          arguments_.inputs.names.empty() ? arguments_.files_from : arguments_.inputs.names.front(),
          "holds no page of n and k", "a page, table or material file");
    print();
    hint_at_policy(arguments_, job_.solver.options());
    print_remarks(arguments_, inputs_, tally_);
    for (const F0Worker& worker : workers_) times_ += worker.times;
    if (arguments_.stats) print_stats(times_, find_seconds_, seconds_since(begin), inputs_, threads());
    if (tally_.failed > 0) return exit_failure;
    return tally_.refused_by_name > 0 ? exit_findings : exit_ok;
  }

 private:
  static constexpr std::size_t batch_names = 1024;

  bool is_html() const { return arguments_.output.format == "html"; }
  unsigned threads() const { return static_cast<unsigned>(workers_.size()); }

  // Gives inputs of the library the materials that --without leaves of them.
  void leave_out(std::vector<MaterialInput>& inputs) {
    if (arguments_.without.empty()) return;
    const MaterialsWithout without = materials_without(arguments_.library.get(), arguments_.without);
    for (MaterialInput& input : inputs) etak::leave_out(without, input.material);
  }

  // Computes the results of a batch of names.
  //   names_left   number of names in the list after this batch, for the progress
  void answer(const InputNames& batch, std::size_t names_left, Progress& progress) {
    const auto begin = Clock::now();
    std::vector<std::string> remarks;
    std::vector<MaterialInput> inputs =
        find_inputs(batch, arguments_.library.when_asked(), threads(), &remarks);
    leave_out(inputs);
    for (const std::string& each : alias_remarks(inputs))
      if (told_.insert(each).second) remarks.push_back(each);
    find_seconds_ += seconds_since(begin);
    // Where the output is a new file, it is no input.
    if (sys::FileInfo info; sys::file_info(arguments_.output.file, info))
      for (const MaterialInput& input : inputs)
        if (input.kind == MaterialInput::Kind::file) arguments_.output.read.push_back(input.path);
    inputs_ += inputs.size();
    progress.set(inputs_ - inputs.size(), inputs_ + names_left);
    std::vector<Chunk> chunks(is_html() ? 1 : (inputs.size() + chunk_inputs - 1) / chunk_inputs);
    if (is_html())
      chunks[0].text = html(inputs, job_, workers_, chunks[0].errors, chunks[0].tally);
    else
      parallel_chunks(
          inputs.size(), threads(), chunk_inputs, [&](std::size_t first, std::size_t last, unsigned worker) {
            for (std::size_t i = first; i < last; ++i)
              answer_one(inputs[i], job_, arguments_, workers_[worker], chunks[first / chunk_inputs]);
            progress.advance(last - first, worker);
          });
    progress.take_away();
    for (const std::string& each : remarks) remark(arguments_.output, each);
    for (Chunk& chunk : chunks) {
      tally_ += chunk.tally;
      for (const std::string& error : chunk.errors) complain(error);
      text_ += chunk.text;
      std::move(chunk.rows.begin(), chunk.rows.end(), std::back_inserter(rows_));
    }
  }

  void print() {
    const auto begin = Clock::now();
    const OutputArguments& output = arguments_.output;
    const F0Options& options = job_.solver.options();
    // Rows without an answer come last.
    if (!arguments_.sort.empty())
      std::ranges::stable_sort(rows_, [](const F0Row& a, const F0Row& b) {
        const bool none = a.result.refused(), other_none = b.result.refused();
        return none != other_none ? other_none : !none && a.result.luminance < b.result.luminance;
      });
    if (is_of_lines(output.format))
      for (const F0Row& row : rows_) append_line(text_, row, arguments_, options);
    if (output.format == "json") text_ = f0_json(rows_, options);
    if (output.format == "table") {
      const bool terminal = is_standard_output(output) && sys::is_terminal(sys::standard_output);
      const std::size_t columns = terminal ? columns_of(sys::standard_output) : 0;
      text_ = f0_table(rows_, options, use_color(output), columns);
      if (arguments_.verbose && !output.quiet) text_ += f0_legend(rows_, options, columns);
    }
    // Where no input could be read, no empty output is written: it might replace an earlier, better file.
    if (tally_.rows > 0 || inputs_ == 0) write_output(output, text_);
    times_.print += seconds_since(begin);
  }

  F0Arguments& arguments_;
  const F0Job& job_;
  std::vector<F0Worker> workers_;
  Tally tally_;
  F0StageTimes times_;
  double find_seconds_ = 0;
  std::size_t inputs_ = 0;      // number of inputs found so far
  std::set<std::string> told_;  // remarks on names that were made, so that each is made once
  std::string text_;            // output in forms made of lines
  std::vector<F0Row> rows_;     // output in other forms
};

std::optional<Coat> coat_of(F0Arguments& arguments, const F0Options& options) {
  if (!arguments.coat.empty() && (arguments.output.format == "html" || !arguments.sweep.empty()))
    throw Error::at("--coat", "beside --sweep, or in a page", "rows of single datasets");
  return coat_option(arguments.coat, arguments.library.when_asked(), options, arguments.compute.axis_average);
}

}  // namespace

int answer_f0(F0Arguments& arguments) {
  const OutputArguments& output = arguments.output;
  check_output(output);
  if (arguments.inputs.names.empty() && arguments.files_from.empty() && !arguments.inputs.all)
    throw Error::at("etak f0", "no input", "a material, file or folder, - for standard input, or --all");
  if (!arguments.sort.empty() && arguments.sort != "Y")
    throw Error::at("--sort", printable(arguments.sort), "Y");
  if (arguments.bands && output.format != "csv")
    throw Error::at("--bands", "beside --format " + output.format + ", which tells bands in any case",
                    "--format csv");
  if (output.format == "html" && !arguments.sort.empty())
    throw Error::at("--sort", "materials of a page with all their datasets", "a form of rows, such as csv");
  if (output.format == "html" && (arguments.compute.axis_average || !arguments.inputs.dataset.empty()))
    throw Error::at("--format html", "shows every dataset of a material",
                    "no --dataset and no --axis-average");
  // A bad --library is an error even where no name is looked up.
  if (!arguments.library.folders.empty()) (void)arguments.library.get();
  F0Options options = f0_options(arguments.compute, arguments.library);
  // The mean is that of bare F, which no instrument sees.
  options.mean = !options.instrument.any() && (output.format == "json" || output.format == "jsonl" ||
                                               (output.format == "table" && arguments.verbose));
  const F0Solver solver(std::move(options));
  const bool with_source = output.format != "csv";
  const F0Job job{solver,
                  table_options(arguments.tables),
                  arguments.compute.axis_average,
                  with_source,
                  arguments.stats,
                  output.format == "html",
                  coat_of(arguments, solver.options()),
                  arguments.bands || with_source};
  if (output.format == "svg" && solver.options().instrument.any())
    throw Error::at("--format svg", "beside --aperture or --scatter: a strip over angles", "another form");
  if (const double aperture = solver.options().instrument.aperture; aperture > 0)
    remark(output, "mean over the cone of aperture " + number(aperture, 4) + "; F82 is left out");
  if (!arguments.sweep.empty()) return answer_film_sweep(arguments, job);
  if (output.format == "svg")
    throw Error::at("--format svg", "without --sweep", "a stack and --sweep, or another form");
  keep_worker_memory();
  return F0Run(arguments, job, thread_count(arguments.threads)).answer_all();
}

}  // namespace etak::cli
