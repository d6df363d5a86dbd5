#include "keywords.h"

#include <algorithm>
#include <vector>

#include "commands/commands.h"
#include "parse.h"
#include "shell/failures.h"

namespace planish::python {

namespace {

std::string flag_of(std::string keyword) {
  if (keyword.ends_with('_')) keyword.pop_back();
  std::replace(keyword.begin(), keyword.end(), '_', '-');
  return "--" + keyword;
}

std::string type_text(py::handle value) {
  return py::str(py::type::handle_of(value).attr("__name__")).cast<std::string>();
}

/// That of a number of NumPy, else the value itself.
py::object plain_value(py::handle value) {
  if (py::hasattr(value, "item") && py::hasattr(value, "ndim")) return value.attr("item")();
  return py::reinterpret_borrow<py::object>(value);
}

/// A number with all its digits, or a text.
std::string word_of(const std::string& keyword, py::handle given) {
  const py::object value = plain_value(given);
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  const bool is_bool = PyBool_Check(value.ptr()) != 0;
  if (!is_bool && PyIndex_Check(value.ptr()) != 0)
    return py::str(py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr())));
  if (!is_bool && py::hasattr(value, "__float__")) return py::repr(py::float_(value));
  throw py::type_error(keyword + " must be a number or a text, not of type " + type_text(value));
}

bool is_sequence(py::handle value) {
  if (py::isinstance<py::tuple>(value) || py::isinstance<py::list>(value)) return true;
  return py::hasattr(value, "tolist") && py::hasattr(value, "ndim") &&
         value.attr("ndim").cast<int>() > 0;
}

std::string text_of(const std::string& keyword, py::handle value) {
  if (py::hasattr(value, "__fspath__")) return value.attr("__fspath__")().cast<std::string>();
  if (!is_sequence(value)) return word_of(keyword, value);
  std::string text;
  for (const py::handle item : value)
    text += (text.empty() ? "" : ",") + word_of(keyword, item);
  return text;
}

/// Whether True and False are taken for the flag and its absence.
bool is_switch(const cli::Command& command, const std::string& flag, py::handle value) {
  const cli::Flag* const found = cli::find_flag(command, flag);
  if (found == nullptr || cli::needs_value(*found)) return false;
  return found->value.empty() || py::isinstance<py::bool_>(value);
}

bool switch_of(const std::string& keyword, py::handle value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  throw py::type_error(keyword + " must be True or False, not of type " + type_text(value));
}

}  // namespace

const cli::Command& command_named(const std::string& verb) {
  const auto& all = cli::commands();
  return *std::find_if(all.begin(), all.end(),
                       [&](const cli::Command& command) { return command.name == verb; });
}

cli::Arguments arguments_of(const std::string& verb, const py::dict& keywords) {
  const cli::Command& command = command_named(verb);
  std::vector<std::string> words = {verb};
  words.insert(words.end(), command.operands.size(), "mesh");
  std::vector<std::string> unasked;  // that the program needs and Python does not
  for (const cli::FlagGroup& group : command.groups) {
    for (const cli::Flag& flag : group.flags) {
      if (flag.required) unasked.push_back(flag.name);
    }
  }
  for (const std::string& flag : unasked)
    words.push_back(flag + "=mesh.obj");
  for (const auto& [key, value] : keywords) {
    const auto keyword = key.cast<std::string>();
    const std::string flag = flag_of(keyword);
    if (value.is_none()) continue;
    if (!is_switch(command, flag, value)) {
      words.push_back(flag + "=" + text_of(keyword, value));
      if (words.back().find('\0') != std::string::npos)
        throw py::value_error(keyword + " must not hold a character of the number 0");
    } else if (switch_of(keyword, value)) {
      words.push_back(flag);
    }
  }
  cli::Arguments arguments = cli::parse(words).arguments;
  for (const std::string& flag : unasked)
    arguments.flags.erase(flag);
  return arguments;
}

}  // namespace planish::python
