#pragma once

#include <span>
#include <string>

#include <planish/measure/material.h>

namespace planish::cli {

/// A line for each: what it takes, and for which work.
std::string materials_table(std::span<const Material> materials);

/// One material with the source of each figure.
std::string material_text(const Material& material);

/// {"materials": [...]}, each as a file of it.
std::string materials_json(std::span<const Material> materials);

}  // namespace planish::cli
