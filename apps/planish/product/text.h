#pragma once

#include <string>

#include <planish/flatten/product.h>

#include "shell/session.h"

namespace planish::cli {

/// A line on a patch: a tick or not, its size and strain, and what it is judged by, what is missed
/// first.
std::string patch_line(const PatchResult& patch);

/// How many pieces have all that was asked for, and the lines of all, those that miss something
/// first.
std::string pieces_text(const ProductReport& report);

/// Notes what the mesh of each patch cannot show, and patterns of an unusual size, unless the unit
/// was given.
void note_cautions_and_sizes(Session& session, const ProductReport& report, bool is_unit_given);

/// How many patches were made from others; empty where none was.
std::string twins_text(const ProductReport& report);

/// The seams as people read them.
/// @param is_batch seams between files were not searched
std::string seams_text(const ProductReport& report, bool is_batch);

}  // namespace planish::cli
