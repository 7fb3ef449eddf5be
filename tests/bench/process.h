// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bench {

/// What one run of a command cost.
///   wall_s, cpu_s   start to end; user + system time of the process and the children it waited for
///   peak_mb         largest resident size. Linux counts from the size of the process that started it, so a
///                   figure at or below own_peak_mb() says "no more than that"
///   exit_code       128 + signal where a signal ended it
struct Run {
  double wall_s = 0;
  double cpu_s = 0;
  double peak_mb = 0;
  int exit_code = 0;
};

/// Runs argv[0] (looked up in PATH) and waits. Standard output goes to the file `output`, or nowhere when
/// that is empty; standard error likewise to `errors`. Throws std::runtime_error when it cannot be started.
Run run(const std::vector<std::string>& argv, const std::string& output = {}, const std::string& errors = {});

/// Splits a command line at blanks; '...' and "..." hold blanks together. No other shell rule applies.
std::vector<std::string> split_command(std::string_view line);

/// `argv` with every occurrence of `mark` ("{dir}") replaced by `value`.
std::vector<std::string> fill(std::vector<std::string> argv, std::string_view mark, std::string_view value);

/// Middle value (mean of the two middle ones); NaN of nothing.
double median(std::vector<double> values);

/// Load average of the last minute.
double load_average();

/// Peak resident size of the calling process so far, MB.
double own_peak_mb();

/// A folder of its own below the system's temporary one, removed with all it holds at the end of its life.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(std::string_view name) const;

 private:
  std::string path_;
};

}  // namespace bench
