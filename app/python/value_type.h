// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/base/bytes/member_bytes.h"
#include "core/base/error.h"

// Helpers for the types of the module, which are all values that nothing changes.
namespace etak::python {

namespace py = pybind11;

/// An iterator over a list of `Item`, which its signature names.
template <class Item>
struct Iterator : py::object {
  explicit Iterator(const py::object& list) : py::object(py::iter(list)) {}
};

/// The members of a struct as bytes for Python, and back. Throws Error where they are of another form.
template <class Struct>
py::bytes bytes_of(const Struct& value) {
  MemberWriter out;
  out.member(value);
  return out.bytes;
}
template <class Struct>
Struct from_bytes(const py::bytes& bytes) {
  MemberReader in{std::string_view(bytes)};
  Struct out;
  in.member(out);
  if (!in.good()) throw Error::at("pickle", "bytes of another form", "those of a pickle of this type");
  return out;
}

/// A function that defines attributes of a type: get("name", "What it is.", read), where `read` takes the value, or is
/// a member of it.
template <class Class>
auto attributes_of(Class& type) {
  return [&type](const char* name, const char* meaning, const auto& read) {
    if constexpr (std::is_member_object_pointer_v<std::decay_t<decltype(read)>>)
      type.def_readonly(name, read, meaning);
    else
      type.def_property_readonly(name, read, meaning);
  };
}

/// Gives a type copies (the object itself), equality, hashes and pickles by a state, and refuses subclasses and
/// Type.__new__(Type), which would be objects that no constructor has made.
///   state   py::tuple (const Type&): all that makes a difference
///   make    the object of a state: Type (parts of the tuple...)
template <class Class, class State, class Make>
void be_value(Class& type, const State& state, const Make& make) {
  using Type = typename Class::type;
  type.def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, const py::object&) { return self; })
      .def("__hash__", [state](const Type& self) { return py::hash(py::repr(state(self))); })
      .def(
          "__eq__", [state](const Type& a, const Type& b) { return &a == &b || state(a).equal(state(b)); },
          py::is_operator())
      .def("__reduce__",
           [state](const py::object& self) {
             const py::object restored = py::module_::import("etak").attr("_restored");
             return py::make_tuple(
                 restored, py::make_tuple(py::type::of(self), ETAK_VERSION, state(self.cast<const Type&>())));
           })
      .def_static("_restore", make);
  auto* const raw = reinterpret_cast<PyTypeObject*>(type.ptr());  // NOLINT: an object of Python is its type
  raw->tp_flags &= ~static_cast<unsigned long>(Py_TPFLAGS_BASETYPE);
  raw->tp_new = nullptr;
  PyType_Modified(raw);
}

}  // namespace etak::python

namespace pybind11::detail {

template <class Item>
struct handle_type_name<etak::python::Iterator<Item>> {
  static constexpr auto name = const_name("Iterator[") + make_caster<Item>::name + const_name("]");
};

}  // namespace pybind11::detail
