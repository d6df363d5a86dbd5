#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <planish/draw/drawing.h>

#include "draw/pdf/pdf_file.h"

namespace planish {

/// The longest side of a page that all viewers show at true size, millimetres: 14,400 points.
inline constexpr double k_longest_page = 5080.0;

/// A PDF file in the making, all of whose pages show the layers of one drawing.
class PdfDocument {
 public:
  explicit PdfDocument(const Drawing& drawing);

  /// A form of the sheet's size, in millimetres, that pages can draw as /Sheet.
  void add_sheet(std::string_view content, Vec2 size);
  /// @param content in millimetres
  void add_page(Vec2 size, std::string_view content);

  std::string bytes() const;

 private:
  std::string resources(bool with_layers) const;
  std::string catalog(const std::vector<Layer>& layers) const;

  PdfFile file_;
  int catalog_, pages_, info_, font_;
  int sheet_ = 0;            // 0: none
  std::vector<int> groups_;  // of optional content, one per layer
  std::vector<int> page_numbers_;
};

}  // namespace planish
