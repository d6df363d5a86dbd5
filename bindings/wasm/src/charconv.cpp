#include <charconv>
#include <cstring>

#include <fast_float/fast_float.h>

#include "decimal.h"

namespace std {

namespace {

to_chars_result put(char* first, char* last, const string& text) {
  if (static_cast<size_t>(last - first) < text.size()) return {last, errc::value_too_large};
  memcpy(first, text.data(), text.size());
  return {first + text.size(), errc()};
}

template <typename Number>
from_chars_result read(const char* first, const char* last, Number& value, chars_format format) {
  const auto read = fast_float::from_chars(
      first, last, value,
      static_cast<fast_float::chars_format>(
          format == chars_format::fixed        ? fast_float::chars_format::fixed
          : format == chars_format::scientific ? fast_float::chars_format::scientific
                                               : fast_float::chars_format::general));
  return {read.ptr, read.ec};
}

}  // namespace

to_chars_result to_chars(char* first, char* last, double value) {
  return put(first, last, planish::shortest_decimal(value));
}

to_chars_result to_chars(char* first, char* last, float value) {
  return put(first, last, planish::shortest_decimal(value));
}

to_chars_result to_chars(char* first, char* last, double value, chars_format format) {
  return put(first, last, planish::shortest_decimal(value, format));
}

to_chars_result to_chars(char* first, char* last, float value, chars_format format) {
  return put(first, last, planish::shortest_decimal(value, format));
}

to_chars_result to_chars(char* first, char* last, double value, chars_format format,
                         int precision) {
  return put(first, last, planish::rounded_decimal(value, format, precision));
}

from_chars_result from_chars(const char* first, const char* last, double& value,
                             chars_format format) {
  return read(first, last, value, format);
}

from_chars_result from_chars(const char* first, const char* last, float& value,
                             chars_format format) {
  return read(first, last, value, format);
}

}  // namespace std
