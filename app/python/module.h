// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/python/text_caster.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

#include "app/pictures/doors.h"
#include "app/python/value_type.h"
#include "core/base/files/between_files.h"
#include "core/exchange/material_input.h"
#include "core/exchange/table.h"
#include "core/judge/nearest.h"
#include "core/material/f0/f0_settings.h"
#include "core/material/library.h"

// The parts of etak._core. Every call that computes releases the lock of the interpreter (Unlocked) while it
// works, and takes arguments and makes results while it holds it.
namespace etak::python {

namespace py = pybind11;
using Unlocked = py::gil_scoped_release;
using Array = py::array_t<double, py::array::c_style>;

// ---- arrays

/// `value` as an array of doubles in C order: a copy only where it is not one already. Throws Error (naming
/// `name`) for what is no array of real numbers, and what its __array__ or a lack of memory throws.
Array doubles(const py::object& value, const char* name);

/// The parts of a complex index n + 1j k; `n` and `k` as they are where n is not complex. Throws Error where k stands
/// beside a complex n.
std::pair<py::object, py::object> parts_of_index(const py::object& n, const py::object& k);

/// "(906, 471)", for messages.
std::string shape_text(const Array& array);

Array array_of(std::span<const double> values);
template <class Rgb>
Array array_of_rgb(const Rgb& color) {
  return array_of(vec(color));
}

inline std::span<const double> values_of(const Array& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// The number of threads that a keyword asks for; 0: all cores. Throws Error for a number that is none.
unsigned threads_of(int asked);

// ---- materials

/// etak.Library: the materials that names stand for. It is opened when first asked, with ETAK_LIBRARY.
class Library {
 public:
  explicit Library(std::vector<std::string> folders) : folders_(std::move(folders)) {}

  /// The materials. Any thread may ask.
  const MaterialLibrary& get() const;
  /// The materials for a thread that holds the interpreter's lock: reading folders can be interrupted.
  const MaterialLibrary& opened() const;
  const std::vector<std::string>& folders() const { return folders_; }
  LibraryWhenAsked when_asked() const {
    return [this]() -> const MaterialLibrary& { return get(); };
  }
  /// For the validator: null where there are only the built-in materials.
  std::shared_ptr<const KnownMaterials> known() const;

 private:
  std::vector<std::string> folders_;
  mutable std::once_flag opened_, knows_;
  mutable std::optional<MaterialLibrary> library_;
  mutable std::shared_ptr<const KnownMaterials> known_;
};
/// The library that is meant where none is given.
const Library& standard_library();

/// A dataset of a material, which keeps the material.
struct DatasetOf {
  std::shared_ptr<const Material> material;
  std::size_t index = 0;

  const Dataset& dataset() const { return material->datasets[index]; }
  std::string label() const {
    const auto* stack = std::get_if<Stack>(&dataset().optics);  // whose text tells its datasets
    return stack != nullptr ? stack->text : material->id + "/" + dataset().id;
  }
};

/// The material that a caller asks for: a name, a path, a Material or a Dataset.
///   text   as a command line has it: "gold", "gold/johnson-1972", "page.yml"; of objects with '/' and the id
struct AskedMaterial {
  std::string text;
  std::shared_ptr<const Material> material;  // null: `text` is to be looked up
  std::string dataset;
};
AskedMaterial asked_material(const py::object& value, const std::string& dataset);

/// The materials that a caller asks for in a list; Ctrl-C is heard meanwhile.
std::vector<AskedMaterial> asked_materials(const std::vector<py::object>& values, const std::string& dataset);

/// The one input that was asked for, and its material. Throws Error where it is none, or several.
MaterialInput find_one(const AskedMaterial& asked, const Library& library);
DatasetOf read_one(const AskedMaterial& asked, const Library& library, const TableSettings& tables);

/// Whether the value is a text or a path.
bool is_text(const py::handle& value);

/// A word or number that a keyword gives; None: empty. Throws TypeError for a value of another type.
std::string text_of(const py::handle& value, const std::string& name);

/// A list of texts, of a keyword that takes one text or several.
std::vector<std::string> texts_of(const py::handle& value, const std::string& name);

/// Keywords of a call, which etak/__init__.py gives as a dictionary. One that is None or not there is empty.
struct Keywords {
  py::dict given;

  py::object at(const char* name) const {
    return given.contains(name) ? py::object(given[name]) : py::none();
  }
  std::string text(const char* name) const { return text_of(at(name), name); }
  std::vector<std::string> texts(const char* name) const { return texts_of(at(name), name); }
  std::optional<double> number(const char* name) const;  // none: None; throws TypeError for what is none
  bool yes(const char* name) const { return given.contains(name) && given[name].cast<bool>(); }
};

/// The line of repr(): "<etak.NAME TEXT>", which a terminal can show whatever the text holds.
std::string repr_line(const char* name, const std::string& text);

/// The settings that a dictionary holds by their keywords, which are those of F0 and of tables.
F0Settings f0_settings(const Keywords& given);
TableSettings table_settings(const Keywords& given);

/// The names of flags, in their order.
std::vector<std::string> flag_names(Flags flags);

/// The solver's options.
F0Options options_of(const F0Settings& settings, const Library& library);

// ---- pictures

/// The functions of etak/_pictures.so, which the first call opens. Throws Error.
const PictureDoors& pictures(const std::string& place);

// ---- long work

/// Lets Ctrl-C and the exceptions of a progress function stop work that does not hold the interpreter's lock: where the
/// work asks, and between two files. Tells how far it is. One for each call.
class LongWork {
 public:
  ///   progress   called as progress(done, all); None: nobody listens
  explicit LongWork(py::object progress = py::none()) : progress_(std::move(progress)) {}

  /// For the core, from any thread: does nothing in others than the one that made this.
  void tell(std::size_t done, std::size_t all);
  bool stopped();
  /// For work that is stopped by an exception only: throws Stopped where stopped() says so.
  void go_on() {
    if (stopped()) throw Stopped();
  }
  struct Stopped {};

  /// Does the work without the interpreter's lock, and returns what it returns. Throws what stopped it, in place of
  /// what it then threw.
  template <class Work>
  std::invoke_result_t<Work> unlocked(const Work& work) {
    std::optional<std::invoke_result_t<Work>> out;
    std::exception_ptr failure;
    {
      const Unlocked without_lock;
      const std::function<void()> between = [this] { go_on(); };
      const BetweenFiles files(between);
      try {
        out.emplace(work());
      } catch (...) {
        failure = std::current_exception();
      }
    }
    if (why_) throw *why_;
    if (failure) std::rethrow_exception(failure);
    return std::move(*out);
  }

 private:
  bool look_for_signals();

  py::object progress_;
  std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<bool> stopped_{false};
  std::size_t told_ = static_cast<std::size_t>(-1);  // what progress was called with last
  std::optional<py::error_already_set> why_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void add_library(py::module_& module);
void add_f0(py::module_& module);
void add_fresnel(py::module_& module);
void add_validate(py::module_& module);
void add_pack(py::module_& module);
void add_choose(py::module_& module);
void add_questions(py::module_& module);
void add_rows(py::module_& module);

}  // namespace etak::python
