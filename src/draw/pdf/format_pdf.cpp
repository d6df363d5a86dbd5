#include <algorithm>
#include <optional>

#include <planish/draw/format_drawing.h>

#include "draw/pdf/divided_pdf.h"
#include "draw/pdf/pdf_content.h"
#include "draw/pdf/pdf_document.h"

namespace planish {

std::string format_pdf(const Drawing& drawing) {
  if (std::max(drawing.width, drawing.height) > k_longest_page) {
    if (auto divided = format_divided_pdf(drawing)) return *std::move(divided);
  }
  PdfContent content;
  content.add_layers(drawing.layers);
  PdfDocument document(drawing);
  document.add_page({drawing.width, drawing.height}, content.text());
  return document.bytes();
}

}  // namespace planish
