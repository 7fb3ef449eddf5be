// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "app/python/module.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/study/fresnel_forms.h"

namespace etak::python {
namespace {

constexpr std::string_view exact_form = "exact";

const FresnelForm* form_named(const std::string& id) {
  if (id == exact_form) return nullptr;
  if (const FresnelForm* form = fresnel_form(id)) return form;
  throw Error::at(setting("form"), printable(id),
                  std::string(exact_form) + ", " + joined(fresnel_forms(), ", ", &FresnelForm::id));
}

// Cosines, and the places of their colours, three numbers for each.
struct AtCosines {
  std::span<const double> cosines;
  std::span<double> colors;
  int threads = 0;
};

// Fills the colours, as `value` gives them.
template <class Value>
void fill(const AtCosines& at, LongWork& work, const Value& value) {
  constexpr std::size_t chunk = 16;
  parallel_chunks(
      at.cosines.size(), threads_of(at.threads), chunk, [&](std::size_t begin, std::size_t end, unsigned) {
        work.go_on();
        for (std::size_t i = begin; i < end; ++i) {
          const double c = at.cosines[i];  // read once: another thread may change the array meanwhile
          if (!(c >= 0 && c <= 1)) throw Error::at("cos_theta", number(c, 9), "0 to 1");
          const Vec3 color = value(c);
          std::copy(color.begin(), color.end(), at.colors.begin() + static_cast<std::ptrdiff_t>(3 * i));
        }
      });
}

void fresnel_into(const FresnelForm* form, const DatasetOf& found, const F0Options& options,
                  const AtCosines& at, LongWork& work) {
  const auto* constants = std::get_if<OpticalConstants>(&found.dataset().optics);
  if (constants == nullptr)
    throw Error::at(found.label(), without_constants(found.dataset().optics), "n and k");
  // Says why where the data do not allow it.
  if (const F0Result f0 = F0Solver(options).solve(found.dataset().optics); f0.refused())
    throw Error::at(found.label(), "refused: " + f0.refusal);
  if (form == nullptr) {
    const SeenStack seen(*constants, options, Method::nm1, found.label());
    return fill(at, work, [&](double c) { return seen(c); });
  }
  constexpr double step_deg = 0.25;
  const FresnelValues values = form->fit(fresnel_truth(*constants, found.label(), step_deg, options));
  fill(at, work, [&](double c) {
    return Vec3{form->value(values[0].data(), c), form->value(values[1].data(), c),
                form->value(values[2].data(), c)};
  });
}

Array fresnel(const py::object& material, const py::object& cos_theta, const py::dict& given,
              const Library& library, int threads) {
  const Keywords how{given};
  const AskedMaterial asked = asked_material(material, how.text("dataset"));
  const std::string form_id = how.text("form");
  const Array cosines = doubles(cos_theta, "cos_theta");
  const F0Settings settings = f0_settings(how);
  const TableSettings tables = table_settings(how);
  std::vector<py::ssize_t> shape(cosines.shape(), cosines.shape() + cosines.ndim());
  shape.push_back(3);
  Array out(shape);
  const AtCosines at{values_of(cosines), {out.mutable_data(), static_cast<std::size_t>(out.size())}, threads};
  LongWork work;
  work.unlocked([&] {
    const FresnelForm* const form = form_named(form_id);
    fresnel_into(form, read_one(asked, library, tables), options_of(settings, library), at, work);
    return true;
  });
  return out;
}

}  // namespace

void add_fresnel(py::module_& module) {
  module.def("fresnel", &fresnel);
  module.def("fresnel_forms", [] {
    py::dict out;
    out[py::cast(std::string(exact_form))] = "n and k of every nanometre";
    for (const FresnelForm& form : fresnel_forms())
      out[py::str(std::string(form.id))] = std::string(form.title);
    return out;
  });
}

}  // namespace etak::python
