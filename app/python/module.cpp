// SPDX-License-Identifier: Apache-2.0
// The compiled part of `import etak`: what its Python part (etak/__init__.py) calls.
#include "app/python/module.h"

#include "app/pictures/open_module.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"

namespace etak::python {
namespace {

std::string module_folder;

// numpy.asarray(value), whose exceptions are passed on.
py::array as_array(const py::object& value, const char* name) {
  try {
    return py::module_::import("numpy").attr("asarray")(value);
  } catch (py::error_already_set& error) {
    // Lists of different lengths: numpy does not say which argument they are.
    if (!error.matches(PyExc_ValueError) ||
        !(py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)))
      throw;
    throw Error::at(name,
                    "no array of numbers: " + printable(py::str(error.value()).cast<std::string>(), 200),
                    "real numbers");
  }
}

}  // namespace

Array doubles(const py::object& value, const char* name) {
  const py::module_ numpy = py::module_::import("numpy");
  if (py::isinstance(value, numpy.attr("ma").attr("MaskedArray")))
    throw Error::at(name, "a masked array", "an array without gaps, such as its filled()");
  const py::array any = as_array(value, name);
  const char kind = any.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw Error::at(name, "an array of " + py::str(any.dtype()).cast<std::string>(), "real numbers");
  return py::reinterpret_borrow<Array>(numpy.attr("asarray")(any, "float64", "C"));
}

std::pair<py::object, py::object> parts_of_index(const py::object& n, const py::object& k) {
  if (n.is_none() || py::isinstance(n, py::module_::import("numpy.ma").attr("MaskedArray"))) return {n, k};
  const py::array any = as_array(n, "n");
  if (any.dtype().kind() != 'c') return {any, k};
  if (!k.is_none()) throw Error::at("k", "is given beside a complex n", "one of the two");
  return {any.attr("real"), any.attr("imag")};
}

std::string shape_text(const Array& array) {
  std::string out = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) out += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return out + (array.ndim() == 1 ? ",)" : ")");
}

Array array_of(std::span<const double> values) {
  return Array(static_cast<py::ssize_t>(values.size()), values.data());
}

std::string repr_line(const char* name, const std::string& text) {
  return std::string("<etak.") + name + " " + line_text(text) + ">";
}

bool is_text(const py::handle& value) {
  return py::isinstance<py::str>(value) || py::hasattr(value, "__fspath__");
}

std::vector<std::string> texts_of(const py::handle& value, const std::string& name) {
  if (value.is_none()) return {};
  if (is_text(value)) return {text_of(value, name)};
  std::vector<std::string> out;
  for (const py::handle each : py::iter(value)) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    out.push_back(text_of(each, name));
  }
  return out;
}

std::string text_of(const py::handle& value, const std::string& name) {
  if (value.is_none()) return {};
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value))
    return py::repr(value).cast<std::string>();
  if (py::hasattr(value, "__fspath__"))
    return py::module_::import("os").attr("fsdecode")(value).cast<std::string>();
  throw py::type_error(name + ": a word or a number is expected, not " +
                       printable(py::repr(value).cast<std::string>(), 200));
}

std::optional<double> Keywords::number(const char* name) const {
  try {
    return at(name).cast<std::optional<double>>();
  } catch (const py::cast_error&) {
    throw py::type_error(std::string(name) + ": a number is expected, not " +
                         printable(py::repr(at(name)).cast<std::string>(), 200));
  }
}

unsigned threads_of(int asked) {
  constexpr int most = 256;
  if (asked < 0 || asked > most)
    throw Error::at(setting("threads"), std::to_string(asked), "1 to 256, or 0 for all cores");
  return thread_count(static_cast<unsigned>(asked));
}

const PictureDoors& pictures(const std::string& place) {
  static const OpenedModule opened = [] {
    const std::array candidates{module_folder + "/_pictures.so"};
    return open_module(candidates, "etak_python_pictures", ETAK_VERSION);
  }();
  if (opened.table == nullptr)
    throw Error::at(place, "needs etak/_pictures.so; " + opened.fault,
                    "an etak built with OpenImageIO and OpenColorIO, and memory for them");
  return *static_cast<const PictureDoors*>(opened.table);
}

// ---- long work

bool LongWork::look_for_signals() {
  if (std::this_thread::get_id() != caller_ || stopped_) return false;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::milliseconds(50)) return false;
  last_ = now;
  return true;
}

void LongWork::tell(std::size_t done, std::size_t all) {
  if (std::this_thread::get_id() != caller_ || stopped_) return;
  const bool due = look_for_signals();
  if (progress_.is_none() ? !due : done == told_) return;
  told_ = done;
  const py::gil_scoped_acquire lock;
  try {
    if (!progress_.is_none()) progress_(done, all);
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  } catch (py::error_already_set& error) {
    why_.emplace(error);
    stopped_ = true;
  }
}

bool LongWork::stopped() {
  if (look_for_signals()) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) {
      why_.emplace();
      stopped_ = true;
    }
  }
  return stopped_;
}

}  // namespace etak::python

PYBIND11_MODULE(_core, module) {
  using namespace etak;
  using namespace etak::python;
  settings_are(SettingStyle::keywords);
  module.doc() = "The compiled part of etak.";
  module.attr("__version__") = ETAK_VERSION;
  // The text is that of the command line; bytes of files that are no UTF-8 must not break it.
  static py::exception<Error> error(module, "Error", PyExc_ValueError);
  error.attr("__module__") = "etak";
  error.attr("__doc__") = "Input or settings that cannot be used. Its text is that of the command line.";
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& what) {
      error(line_text(what.what()).c_str());
    }
  });
  module.def("_start", [](const std::string& folder) { module_folder = folder; });
  module.def("repr_line", &repr_line);
  add_library(module);
  add_f0(module);
  add_fresnel(module);
  add_validate(module);
  add_pack(module);
  add_choose(module);
  add_questions(module);
  add_rows(module);
}
