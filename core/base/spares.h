// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <thread>

namespace etak {

/// Working memory that is kept between calls which any number of threads make at once. A call takes an object,
/// has it to itself, and gives it back as it is when its Taken ends; nobody waits. A thread mostly gets the
/// object that it gave back last, and where there is none, a new one is made.
///
/// It stands where a thread_local object would, since GCC's programs for Windows free the memory of such an
/// object before they call its destructor, when a thread other than the first ends (GCC bug 80816).
template <class T>
class Spares {
 public:
  class Taken {
   public:
    explicit Taken(Spares& spares) : place_(spares.place()), object_(place_.exchange(nullptr)) {
      if (!object_) object_ = std::make_unique<T>();
    }
    // Where another thread has used the same place meanwhile, its object is the one that goes.
    ~Taken() { object_.reset(place_.exchange(object_.release())); }
    Taken(const Taken&) = delete;
    Taken& operator=(const Taken&) = delete;
    T& operator*() const { return *object_; }

   private:
    std::atomic<T*>& place_;
    std::unique_ptr<T> object_;
  };

  Spares() = default;
  ~Spares() {
    for (Place& place : places_) std::unique_ptr<T>(place.kept.load()).reset();
  }
  Spares(const Spares&) = delete;
  Spares& operator=(const Spares&) = delete;

 private:
  // A cache line of its own, so that threads do not slow each other down.
  struct alignas(64) Place {
    std::atomic<T*> kept{nullptr};
  };
  std::array<Place, 64> places_;

  std::atomic<T*>& place() {
    return places_[std::hash<std::thread::id>()(std::this_thread::get_id()) % places_.size()].kept;
  }
};

}  // namespace etak
