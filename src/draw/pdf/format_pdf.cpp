#include <planish/draw/format_drawing.h>

#include "draw/pdf/pdf_content.h"
#include "draw/pdf/pdf_document.h"

namespace planish {

std::string format_pdf(const Drawing& drawing) {
  PdfContent content;
  content.add_layers(drawing.layers);
  PdfDocument document(drawing);
  document.add_page({drawing.width, drawing.height}, content.text());
  return document.bytes();
}

}  // namespace planish
