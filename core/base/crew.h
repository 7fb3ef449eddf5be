// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace etak {

/// Threads that stay between rounds of work: a strip of a picture takes less than a millisecond, and to start
/// threads for each strip would take a tenth of that.
class Crew {
 public:
  /// The caller is one of the workers, and the only one where no thread can be started.
  explicit Crew(unsigned workers);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  using Task = std::function<void(unsigned worker)>;

  /// Runs the tasks on the workers, beginning them in their order, and waits for all. After an exception no
  /// other task is begun; of several exceptions that of the first task is thrown.
  void run(const std::vector<Task>& tasks);

 private:
  void work(unsigned worker);
  void help(unsigned worker);

  std::mutex lock_;
  std::condition_variable begin_, end_;
  const std::vector<Task>* tasks_ = nullptr;
  std::size_t next_ = 0, running_ = 0, failed_ = 0;
  bool stop_ = false;
  std::exception_ptr failure_;  // of the task `failed_`
  std::vector<std::thread> threads_;
};

}  // namespace etak
