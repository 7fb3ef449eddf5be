// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/cast.h>

#include <string>

// Names of files may hold bytes that are no UTF-8. Python writes such a byte as one half of a surrogate pair
// (os.fsdecode, "surrogateescape"), and so do all texts that go in and out here, in place of pybind11's own way, which
// refuses them. It stands before the headers of pybind11 that make use of it.
namespace pybind11::detail {

template <>
struct type_caster<std::string> {
  PYBIND11_TYPE_CASTER(std::string, const_name("str"));

  bool load(handle source, bool) {
    if (!source || !PyUnicode_Check(source.ptr())) return false;
    const auto bytes =
        reinterpret_steal<object>(PyUnicode_AsEncodedString(source.ptr(), "utf-8", "surrogateescape"));
    if (!bytes) throw error_already_set();
    value.assign(PyBytes_AsString(bytes.ptr()), static_cast<std::size_t>(PyBytes_Size(bytes.ptr())));
    return true;
  }
  static handle cast(const std::string& text, return_value_policy, handle) {
    PyObject* const out =
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape");
    if (out == nullptr) throw error_already_set();
    return out;
  }
};

}  // namespace pybind11::detail
