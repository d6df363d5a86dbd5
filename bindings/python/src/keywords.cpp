#include "keywords.h"

#include <algorithm>
#include <vector>

#include "commands/commands.h"
#include "mesh_data.h"
#include "parse.h"

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

std::string text_of(const std::string& keyword, py::handle value) {
  auto text = value.cast<std::string>();
  if (text.find('\0') != std::string::npos)
    throw py::value_error(keyword + " must not hold a character of the number 0");
  return text;
}

/// A number, also one of NumPy, or a text.
Field field_of(const std::string& keyword, py::handle given) {
  const bool is_numpy = py::hasattr(given, "item") && py::hasattr(given, "ndim");
  const py::object value =
      is_numpy ? given.attr("item")() : py::reinterpret_borrow<py::object>(given);
  if (py::isinstance<py::str>(value)) return text_of(keyword, value);
  const bool is_bool = PyBool_Check(value.ptr()) != 0;
  if (!is_bool && PyIndex_Check(value.ptr()) != 0) {
    const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(whole.ptr(), &overflow);
    // Its digits, where it is too large for any flag.
    return overflow == 0 ? Field(std::int64_t{number}) : Field(py::str(whole).cast<std::string>());
  }
  if (!is_bool && py::hasattr(value, "__float__")) return py::float_(value).cast<double>();
  throw py::type_error(keyword + " must be a number or a text, not of type " + type_text(value));
}

std::vector<Field> fields_of(const std::string& keyword, py::handle values) {
  std::vector<Field> fields;
  for (const py::handle value : values)
    fields.push_back(field_of(keyword, value));
  return fields;
}

/// @param values each a list of fields, or a text as a line of a file
Rows rows_of(const std::string& keyword, py::handle values) {
  Rows rows{keyword, {}};
  std::size_t number = 0;
  for (const py::handle value : values) {
    ++number;
    if (!py::isinstance<py::str>(value)) {
      rows.rows.push_back({fields_of(keyword, value), number});
      continue;
    }
    for (Row& row : parse_rows(text_of(keyword, value), keyword).rows)
      rows.rows.push_back({std::move(row.fields), number});
  }
  return rows;
}

bool is_sequence(py::handle value) {
  if (py::isinstance<py::tuple>(value) || py::isinstance<py::list>(value)) return true;
  return py::hasattr(value, "tolist") && py::hasattr(value, "ndim") &&
         value.attr("ndim").cast<int>() > 0;
}

/// Whether each is a text, as a flag that repeats is given several.
bool are_texts(py::handle values) {
  bool are = true;
  for (const py::handle value : values)
    are = are && py::isinstance<py::str>(value);
  return are;
}

/// Whether True and False are taken for the flag and its absence.
bool is_switch(const cli::Flag& flag, py::handle value) {
  return !cli::needs_value(flag) && (flag.value.empty() || py::isinstance<py::bool_>(value));
}

bool switch_of(const std::string& keyword, py::handle value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  throw py::type_error(keyword + " must be True or False, not of type " + type_text(value));
}

void take(const std::string& keyword, const cli::Flag& flag, py::handle value,
          cli::Arguments& arguments) {
  std::vector<Field>& fields = arguments.flags[flag.name];
  if (py::isinstance<MeshData>(value)) {
    fields = {keyword};
    arguments.meshes[flag.name] = value.cast<const MeshData&>().mesh;
  } else if (is_sequence(value) && flag.accepts.repeats && are_texts(value)) {
    fields = fields_of(keyword, value);
  } else if (is_sequence(value) && cli::type_of(flag) == cli::ValueType::file) {
    fields = {keyword};
    arguments.rows[flag.name] = rows_of(keyword, value);
  } else if (is_sequence(value)) {
    fields = fields_of(keyword, value);
  } else if (py::hasattr(value, "__fspath__")) {
    fields = {text_of(keyword, value.attr("__fspath__")())};
  } else {
    fields = {field_of(keyword, value)};
  }
}

}  // namespace

const cli::Command& command_named(const std::string& verb) {
  const auto& all = cli::commands();
  return *std::find_if(all.begin(), all.end(),
                       [&](const cli::Command& command) { return command.name == verb; });
}

cli::Arguments arguments_of(const std::string& verb, const py::dict& keywords) {
  const cli::Command& command = command_named(verb);
  cli::Arguments arguments;
  for (const auto& [key, value] : keywords) {
    const auto keyword = key.cast<std::string>();
    const cli::Flag* const flag = cli::find_flag(command, flag_of(keyword));
    if (flag == nullptr) throw py::type_error(verb + " has no keyword " + keyword);
    if (value.is_none()) continue;
    if (!is_switch(*flag, value)) {
      take(keyword, *flag, value, arguments);
    } else if (switch_of(keyword, value)) {
      arguments.flags[flag->name];
    }
  }
  cli::refuse_empty_values(command, arguments);
  return arguments;
}

}  // namespace planish::python
