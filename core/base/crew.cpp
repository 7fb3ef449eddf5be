// SPDX-License-Identifier: Apache-2.0
#include "core/base/crew.h"

#include "core/base/parallel.h"

namespace etak {

Crew::Crew(unsigned workers) {
  for (unsigned i = 1; i < workers; ++i)
    if (!start_thread(threads_, [this, i] { help(i); })) break;
}

Crew::~Crew() {
  {
    const std::lock_guard guard(lock_);
    stop_ = true;
  }
  begin_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Crew::run(const std::vector<Task>& tasks) {
  {
    const std::lock_guard guard(lock_);
    tasks_ = &tasks;
    next_ = 0;
    failure_ = nullptr;
  }
  begin_.notify_all();
  work(0);
  std::unique_lock guard(lock_);
  end_.wait(guard, [&] { return next_ >= tasks.size() && running_ == 0; });
  tasks_ = nullptr;
  if (failure_) std::rethrow_exception(failure_);
}

void Crew::work(unsigned worker) {
  std::unique_lock guard(lock_);
  while (tasks_ != nullptr && next_ < tasks_->size()) {
    const std::size_t index = next_++;
    const Task& task = (*tasks_)[index];
    ++running_;
    guard.unlock();
    std::exception_ptr failure;
    try {
      task(worker);
    } catch (...) {
      failure = std::current_exception();
    }
    guard.lock();
    --running_;
    if (failure) {
      // All tasks before this one have begun, so that the first of those that fail is always found.
      if (!failure_ || index < failed_) {
        failed_ = index;
        failure_ = failure;
      }
      next_ = tasks_->size();
    }
    if (running_ == 0 && next_ >= tasks_->size()) end_.notify_all();
  }
}

void Crew::help(unsigned worker) {
  for (;;) {
    {
      std::unique_lock guard(lock_);
      begin_.wait(guard, [&] { return stop_ || (tasks_ != nullptr && next_ < tasks_->size()); });
      if (stop_) return;
    }
    work(worker);
  }
}

}  // namespace etak
