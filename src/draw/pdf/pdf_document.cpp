#include "draw/pdf/pdf_document.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/number_text.h"
#include "draw/pdf/pdf_text.h"

namespace planish {

namespace {

constexpr double k_points = 72.0 / 25.4;  // per millimetre
constexpr double k_smallest_page = 1.0;   // millimetres: no page is nothing

std::string references(const std::vector<int>& numbers) {
  std::string text = "[";
  for (const int number : numbers)
    text += " " + pdf_reference(number);
  return text + " ]";
}

}  // namespace

PdfDocument::PdfDocument(const Drawing& drawing)
    : catalog_(file_.reserve()), pages_(file_.reserve()), info_(file_.reserve()) {
  file_.set(info_, "<< /Title " + pdf_unicode_string(drawing.title) + " /Producer (Planish) >>");
  font_ = file_.add(
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>");
  groups_.reserve(drawing.layers.size());
  for (const Layer& layer : drawing.layers)
    groups_.push_back(file_.add("<< /Type /OCG /Name " + pdf_unicode_string(layer.name) + " >>"));
  file_.set(catalog_, catalog(drawing.layers));
}

std::string PdfDocument::catalog(const std::vector<Layer>& layers) const {
  std::vector<int> hidden;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!layers[i].visible) hidden.push_back(groups_[i]);
  }
  std::string text = "<< /Type /Catalog /Pages " + pdf_reference(pages_) +
                     " /ViewerPreferences << /PrintScaling /None >>";
  if (!groups_.empty()) {
    const std::string all = references(groups_);
    text += " /OCProperties << /OCGs " + all + " /D << /Order " + all + " /OFF " +
            references(hidden) + " >> >>";
  }
  return text + " >>";
}

std::string PdfDocument::resources(bool with_layers) const {
  std::string text = "/Resources << /Font << /F1 " + pdf_reference(font_) + " >>";
  if (sheet_ != 0) text += " /XObject << /Sheet " + pdf_reference(sheet_) + " >>";
  if (with_layers && !groups_.empty()) {
    text += " /Properties <<";
    for (std::size_t i = 0; i < groups_.size(); ++i)
      text += " /L" + std::to_string(i) + " " + pdf_reference(groups_[i]);
    text += " >>";
  }
  return text + " >>";
}

void PdfDocument::add_sheet(std::string_view content, Vec2 size) {
  sheet_ = file_.add_stream("/Type /XObject /Subtype /Form /BBox [0 0 " + fixed_text(size.x, 3) +
                                " " + fixed_text(size.y, 3) + "] " + resources(true),
                            content);
}

void PdfDocument::add_page(Vec2 size, std::string_view content) {
  const double width = k_points * std::max(size.x, k_smallest_page);
  const double height = k_points * std::max(size.y, k_smallest_page);
  // Points to a unit of the page.
  const double longest = k_points * k_longest_page + 1e-6;
  const double unit = std::max(1.0, std::ceil(std::max(width, height) / longest));
  const std::string scale = number_text(k_points / unit);
  const int stream =
      file_.add_stream("", scale + " 0 0 " + scale + " 0 0 cm\n1 j\n" + std::string(content));
  std::string page = "<< /Type /Page /Parent " + pdf_reference(pages_) + " /MediaBox [0 0 " +
                     fixed_text(width / unit, 4) + " " + fixed_text(height / unit, 4) + "]";
  if (unit > 1.0) page += " /UserUnit " + fixed_text(unit, 0);
  page_numbers_.push_back(file_.add(page + " " + resources(sheet_ == 0) + " /Contents " +
                                    pdf_reference(stream) + " >>"));
}

std::string PdfDocument::bytes() const {
  PdfFile file = file_;
  file.set(pages_, "<< /Type /Pages /Count " + std::to_string(page_numbers_.size()) + " /Kids " +
                       references(page_numbers_) + " >>");
  return file.bytes(catalog_, info_);
}

}  // namespace planish
