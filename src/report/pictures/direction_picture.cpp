#include "report/pictures/direction_picture.h"

#include <algorithm>

#include <planish/draw/color.h>

#include "core/figure_text.h"
#include "core/number_text.h"
#include "draw/base64.h"
#include "draw/svg/svg_layers.h"
#include "draw/text/markup_text.h"
#include "report/pictures/direction_map.h"
#include "report/pictures/patch_view.h"

namespace planish {

namespace {

constexpr Color k_border = {150, 150, 150}, k_flat = {246, 246, 246};
constexpr Color k_lowers = {0, 121, 107}, k_stuck = {238, 178, 58};

// The colours that the pictures of defects have.
Color class_color(VertexClass kind) {
  switch (kind) {
    case VertexClass::dome_or_cup:
      return color_at(ColorMap::diverging, 0.75);
    case VertexClass::saddle:
      return color_at(ColorMap::diverging, -0.75);
    case VertexClass::flat:
      return k_flat;
    case VertexClass::border:
    case VertexClass::unused:
      return k_border;
  }
  return k_border;
}

Color direction_color(const VertexDirection& direction) {
  if (direction.can_lower) return k_lowers;
  const bool sticks =
      direction.kind == VertexClass::dome_or_cup || direction.kind == VertexClass::saddle;
  return sticks ? k_stuck : class_color(direction.kind);
}

// As few digits as the threshold has: below 1e-4 it is 0.01 over the number of vertices.
std::string flat_text(const DirectionCounts& counts) {
  return "|d| at most " + significant_text(flat_defect(counts.inner), 2) + "\u00A0rad";
}

constexpr double k_column = 440.0, k_gap = 24.0, k_margin = 20.0;  // of the SVG file, pixels
constexpr double k_line = 21.0, k_swatch = 13.0;

std::string text(double x, double y, double size, const std::string& words, bool bold = false) {
  return "<text x=\"" + fixed_text(x, 1) + "\" y=\"" + fixed_text(y, 1) + "\" font-size=\"" +
         fixed_text(size, 0) + (bold ? "\" font-weight=\"600" : "") + "\">" + escape_markup(words) +
         "</text>\n";
}

// One picture with its title and key, its upper left corner at (x, y).
std::string column(const DirectionPicture& picture, double x, double y) {
  const double height = k_column * picture.image.height / picture.image.width;
  std::string svg = text(x, y + 14.0, 15.0, picture.title, true) + "<image x=\"" +
                    fixed_text(x, 1) + "\" y=\"" + fixed_text(y + 26.0, 1) + "\" width=\"" +
                    fixed_text(k_column, 1) + "\" height=\"" + fixed_text(height, 1) +
                    "\" href=\"data:image/png;base64," + base64(format_png(picture.image)) +
                    "\"/>\n";
  double line = y + 26.0 + height + 24.0;
  for (const DirectionKey& key : picture.keys) {
    svg += "<rect x=\"" + fixed_text(x, 1) + "\" y=\"" + fixed_text(line - 11.0, 1) +
           "\" width=\"" + fixed_text(k_swatch, 0) + "\" height=\"" + fixed_text(k_swatch, 0) +
           "\" fill=\"" + hex_text(key.color) + "\" stroke=\"#808080\" stroke-width=\"0.5\"/>\n" +
           text(x + k_swatch + 8.0, line, 14.0, key.text);
    line += k_line;
  }
  return svg;
}

}  // namespace

DirectionPictures direction_pictures(const TriMesh& mesh,
                                     std::span<const VertexDirection> directions, int width) {
  const DirectionCounts counts = count_directions(directions);
  std::vector<Color> classes, lowering;
  for (const VertexDirection& direction : directions) {
    classes.push_back(class_color(direction.kind));
    lowering.push_back(direction_color(direction));
  }
  const PatchView view(mesh, {}, width);
  return {{"Class of each vertex",
           view.picture_of_kinds(classes),
           {{class_color(VertexClass::dome_or_cup),
             "dome or cup, d > 0: " + count_text(counts.dome_or_cup)},
            {class_color(VertexClass::saddle), "saddle, d < 0: " + count_text(counts.saddle)},
            {k_flat, "flat, " + flat_text(counts) + ": " + count_text(counts.flat)},
            {k_border, "border: has no defect"}}},
          {"Does the Laplacian direction lower the ring energy?",
           view.picture_of_kinds(lowering),
           {{k_lowers, "yes: " + count_text(counts.can_lower)},
            {k_stuck, "no: " + count_text(counts.stuck)},
            {k_flat, "no, but flat as it is: " +
                         count_text(counts.inner - counts.can_lower - counts.stuck)},
            {k_border, "border: stays"}}}};
}

std::string direction_csv(std::span<const VertexDirection> directions) {
  std::string csv = "vertex,class,defect,laplacian_slope,can_lower\n";
  for (std::size_t v = 0; v < directions.size(); ++v) {
    const VertexDirection& direction = directions[v];
    csv += std::to_string(v) + ',' + std::string(to_string(direction.kind)) + ',';
    if (direction.kind == VertexClass::border || direction.kind == VertexClass::unused) {
      csv += ",,\n";
      continue;
    }
    append_number(csv, direction.defect);
    csv += ',';
    append_number(csv, direction.slope);
    csv += direction.can_lower ? ",1\n" : ",0\n";
  }
  return csv;
}

std::string direction_svg(const TriMesh& mesh, std::span<const VertexDirection> directions,
                          const std::string& name) {
  const DirectionPictures pictures = direction_pictures(mesh, directions, 880);
  const Image& image = pictures.classes.image;
  const double keys = k_line * static_cast<double>(pictures.classes.keys.size());
  const double top = k_margin + 34.0;
  const double width = 2.0 * (k_margin + k_column) + k_gap;
  const double height = top + 26.0 + k_column * image.height / image.width + 14.0 + keys + k_margin;
  const std::string size = fixed_text(width, 0) + "\" height=\"" + fixed_text(height, 0);
  const std::string title = (name.empty() ? "Patch" : name) + ": where Laplacian evolution can act";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
         size + "\" viewBox=\"0 0 " + fixed_text(width, 0) + ' ' + fixed_text(height, 0) +
         "\" font-family=\"sans-serif\" fill=\"#1e1f21\">\n<title>" + escape_markup(title) +
         "</title>\n<rect width=\"" + size + "\" fill=\"#ffffff\"/>\n" +
         text(k_margin, k_margin + 16.0, 19.0, title, true) +
         column(pictures.classes, k_margin, top) +
         column(pictures.directions, k_margin + k_column + k_gap, top) + "</svg>\n";
}

}  // namespace planish
