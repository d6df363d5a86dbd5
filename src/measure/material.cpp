#include <array>
#include <string>

#include <planish/core/error.h>
#include <planish/measure/material.h>

namespace planish {

namespace {

constexpr std::string_view k_fitting =
    "guide value of Zhang, Wang and Ramani 2016, Optimal fitting of strain-controlled flattenable "
    "mesh surfaces";

constexpr std::array<Material, 4> k_materials = {
    {{"steel", 0.002, "lasting strain at the 0.2 % proof strength of sheet steel, EN 10130"},
     {"leather", 0.01, k_fitting},
     {"cotton", 0.05, k_fitting},
     {"neoprene", 0.10, k_fitting}}};

}  // namespace

std::span<const Material> materials() {
  return k_materials;
}

const Material& material_named(std::string_view name) {
  std::string known;
  for (const Material& material : k_materials) {
    if (material.name == name) return material;
    known += (known.empty() ? "" : ", ") + std::string(material.name);
  }
  throw Error(ErrorCode::unknown_name,
              "no material is called \"" + std::string(name) + "\"; known are " + known);
}

}  // namespace planish
