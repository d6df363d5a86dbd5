#pragma once

#include <utility>

#include <planish/draw/drawing.h>

namespace planish {

/// A sheet of A4 with one shape on its only layer, "cut".
inline Drawing sheet_with(DrawingShape shape) {
  return {"sheet", 210.0, 297.0, {Layer{"cut", {std::move(shape)}}}};
}

}  // namespace planish
