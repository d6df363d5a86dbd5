#include "errors.h"

#include <exception>
#include <optional>
#include <string>

#include <planish/core/context.h>
#include <planish/core/error.h>
#include <planish/core/ways_on.h>

#include <pybind11/pybind11.h>

#include "shell/failures.h"

namespace planish::python {

namespace py = pybind11;

namespace {

/// A text of the library, which may quote bytes of a file that are no UTF-8.
py::object text_of(const std::string& text) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "backslashreplace"));
}

/// Sets the Python exception that planish.errors makes of a code and words.
void raise(const std::string& code, const char* words, const SourceLocation& place = {}) {
  const auto number = [](const std::optional<std::size_t>& value) {
    return value ? py::object(py::int_(*value)) : py::object(py::none());
  };
  const py::object path = place.path.empty() ? py::object(py::none()) : text_of(place.path);
  const py::object error =
      py::module_::import("planish.errors")
          .attr("make")(code, text_of(words), path, number(place.line), number(place.byte),
                        number(place.first), number(place.count));
  PyErr_SetObject(py::type::handle_of(error).ptr(), error.ptr());
}

}  // namespace

void register_errors() {
  py::register_exception_translator([](std::exception_ptr failure) {
    try {
      if (failure) std::rethrow_exception(failure);
    } catch (const Error& error) {
      raise(std::string(to_string(error.code())), with_way_on(error).c_str(), error.place());
    } catch (const cli::UsageError& error) {
      raise("usage", error.what());
    } catch (const Cancelled&) {
      raise("interrupted", "cancelled; nothing was made");
    }
  });
}

}  // namespace planish::python
