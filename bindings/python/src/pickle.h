#pragma once

#include <array>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <planish/core/version.h>
#include <planish/mesh/patch.h>

#include <pybind11/pybind11.h>

#include "core/struct_fields.h"

namespace planish::python {

namespace py = pybind11;

// Results as bytes, so that Python can pickle them: field by field, whatever structs they are made
// of. What is pickled is read by the same version alone, as other ones may have other fields.

namespace pickling {

/// Puts values behind one another.
class Writer {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (write(values), ...);
  }
  std::string bytes = {};

 private:
  template <class Value>
  void write(const Value& value) {
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    } else {
      static_assert(std::is_aggregate_v<Value>, "not known how to pickle this");
      with_fields(value, *this);
    }
  }
  void write(const std::string& text) { write_all(text); }
  void write(const Patch& patch) { write(patch.mesh()); }
  template <class Value>
  void write(const std::vector<Value>& values) {
    write_all(values);
  }
  template <class Value, std::size_t N>
  void write(const std::array<Value, N>& values) {
    for (const Value& value : values)
      write(value);
  }
  template <class Value>
  void write(const std::optional<Value>& value) {
    write(value.has_value());
    if (value) write(*value);
  }
  template <class Value>
  void write(const std::shared_ptr<Value>& value) {
    write(value != nullptr);
    if (value) write(*value);
  }
  template <class... Values>
  void write(const std::variant<Values...>& value) {
    write(value.index());
    std::visit([this](const auto& some) { write(some); }, value);
  }
  /// Of a method of one's own its name is kept alone.
  template <class Signature>
  void write(const std::function<Signature>&) {}
  template <class Key, class Value, class Less>
  void write(const std::map<Key, Value, Less>& values) {
    write(values.size());
    for (const auto& [key, value] : values)
      (*this)(key, value);
  }
  template <class First, class Second>
  void write(const std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class List>
  void write_all(const List& values) {
    write(values.size());
    for (const auto& value : values)
      write(value);
  }
};

/// Takes values in the order in which Writer put them.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }
  bool is_at_end() const { return rest_.empty(); }

 private:
  template <class Value>
  void read(Value& value) {
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
      if (rest_.size() < sizeof value) throw std::invalid_argument("the pickle is cut off");
      std::memcpy(&value, rest_.data(), sizeof value);
      rest_.remove_prefix(sizeof value);
    } else {
      with_fields(value, *this);
    }
  }
  void read(std::string& text) { read_all(text); }
  void read(Patch& patch) {
    TriMesh mesh;
    read(mesh);
    patch = mesh.triangles.empty() ? Patch() : Patch(std::move(mesh));
  }
  template <class Value>
  void read(std::vector<Value>& values) {
    read_all(values);
  }
  template <class Value, std::size_t N>
  void read(std::array<Value, N>& values) {
    for (Value& value : values)
      read(value);
  }
  template <class Value>
  void read(std::optional<Value>& value) {
    if (next<bool>())
      read(value.emplace());
    else
      value.reset();
  }
  template <class Value>
  void read(std::shared_ptr<Value>& value) {
    value.reset();
    if (!next<bool>()) return;
    auto read_one = std::make_shared<std::remove_const_t<Value>>();
    read(*read_one);
    value = std::move(read_one);
  }
  template <class... Values>
  void read(std::variant<Values...>& value) {
    const auto index = next<std::size_t>();
    if (index >= sizeof...(Values)) throw std::invalid_argument("the pickle is damaged");
    std::size_t number = 0;
    (void)((number++ == index ? (read(value.template emplace<Values>()), true) : false) || ...);
  }
  template <class Signature>
  void read(std::function<Signature>& function) {
    function = {};
  }
  template <class Key, class Value, class Less>
  void read(std::map<Key, Value, Less>& values) {
    values.clear();
    for (auto count = next<std::size_t>(); count > 0; --count) {
      Key key;
      read(key);
      read(values[key]);
    }
  }
  template <class First, class Second>
  void read(std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class List>
  void read_all(List& values) {
    const auto count = next<std::size_t>();
    if (count > rest_.size()) throw std::invalid_argument("the pickle is cut off");
    values.resize(count);
    for (auto& value : values)
      read(value);
  }
  template <class Value>
  Value next() {
    Value value{};
    read(value);
    return value;
  }

  std::string_view rest_;
};

}  // namespace pickling

/// What a class of Python is given (def()) so that its values can be pickled.
template <class Value>
auto pickled() {
  return py::pickle(
      [](const Value& value) {
        pickling::Writer writer;
        writer(value);
        return py::make_tuple(std::string(k_version), py::bytes(writer.bytes));
      },
      [](const py::tuple& state) {
        if (state.size() != 2 || state[0].cast<std::string>() != k_version)
          throw py::value_error("pickled by another version of planish");
        const auto bytes = state[1].cast<std::string>();
        pickling::Reader reader(bytes);
        Value value;
        reader(value);
        if (!reader.is_at_end()) throw py::value_error("the pickle is too long");
        return value;
      });
}

}  // namespace planish::python
