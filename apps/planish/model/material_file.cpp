#include "model/material_file.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <vector>

#include <planish/core/error.h>
#include <planish/unfold/strain.h>

#include "model/json_file.h"
#include "shell/file_name.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

constexpr std::size_t k_longest_name = 60;  // bytes

/// "12 %" or "12%" as a share; NaN for what is no such text.
double share_of(std::string text) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!text.ends_with('%')) return none;
  text.pop_back();
  while (text.ends_with(' '))
    text.pop_back();
  double per_cent = none;
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, per_cent);
  return parsed.ec == std::errc() && parsed.ptr == end ? per_cent / 100.0 : none;
}

double strain_of(const JsonEntry& figure) {
  const Json& value = figure.required("strain");
  const std::string where = figure.where("strain");
  const std::string right = "a share of the length on the form, as 0.12, or per cent, as \"12 %\"";
  if (!value.is_number() && !value.is_string()) refuse(where, "must be " + right);
  const double strain =
      value.is_number() ? value.get<double>() : share_of(value.get<std::string>());
  if (!(strain > 0.0 && strain <= k_largest_strain_limit)) {
    refuse(where,
           "is " + json_text(value, -1) + " but must be " + right + ", above 0 and at most 100 %");
  }
  return strain;
}

MaterialFigure figure_of(const Json& json, const std::string& where) {
  static const std::vector<std::string> keys = {"strain", "source"};
  const JsonEntry figure(json, where, keys);
  return {strain_of(figure), figure.required_text("source")};
}

MaterialLimit limit_of(const Json& json, const std::string& where) {
  static const std::vector<std::string> keys = {"usual", "largest"};
  const JsonEntry entry(json, where, keys);
  MaterialLimit limit = {figure_of(entry.required("usual"), entry.where("usual"))};
  if (const Json* largest = entry.find("largest"))
    limit.largest = figure_of(*largest, entry.where("largest"));
  if (limit.largest && limit.largest->strain < limit.usual.strain)
    refuse(entry.where("largest") + ".strain", "must be at least that of \"usual\"");
  return limit;
}

std::string name_of(const JsonEntry& entry) {
  std::string name = entry.required_text("name");
  const std::string where = entry.where("name");
  if (name.size() > k_longest_name)
    refuse(where, "must have at most " + std::to_string(k_longest_name) + " bytes");
  const std::vector<std::string> taken = material_names();
  if (std::find(taken.begin(), taken.end(), name) != taken.end())
    refuse(where, "\"" + name + "\" is a material of planish: give yours another name");
  return name;
}

Material material_of(const Json& json) {
  static const std::vector<std::string> keys = {"name", "use", "stretch", "compression"};
  const JsonEntry entry(json, "", keys);
  return {.name = name_of(entry),
          .use = entry.text("use").value_or(""),
          .stretch = limit_of(entry.required("stretch"), entry.where("stretch")),
          .compression = limit_of(entry.required("compression"), entry.where("compression"))};
}

Json to_json(const MaterialFigure& figure) {
  return {{"strain", figure.strain}, {"source", figure.source}};
}

Json to_json(const MaterialLimit& limit) {
  Json json = {{"usual", to_json(limit.usual)}};
  if (limit.largest) json["largest"] = to_json(*limit.largest);
  return json;
}

}  // namespace

bool is_material_file(const std::string& word) {
  return lower_extension(word) == ".json";
}

Material read_material_file(const std::string& path) try {
  return material_of(read_json_file(path, "a material file"));
} catch (const Error& error) {
  SourceLocation place = error.place();
  place.path = path;
  throw Error(error.code(), error.message(), place);
}

Json material_json(const Material& material) {
  Json json = {{"name", material.name}};
  if (!material.use.empty()) json["use"] = material.use;
  json["stretch"] = to_json(material.stretch);
  json["compression"] = to_json(material.compression);
  return json;
}

}  // namespace planish::cli
