#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include <planish/core/ways_on.h>
#include <planish/draw/color.h>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include "program.h"
#include "sketch.h"
#include "surface.h"

// What a worker calls. Files are those of the module's file system. Arrays are copies: memory moves
// when it grows.

namespace planish::wasm {

namespace {

using emscripten::val;

template <typename Number>
val array_of(const char* kind, const std::vector<Number>& numbers) {
  return val::global(kind).new_(val(emscripten::typed_memory_view(numbers.size(), numbers.data())));
}

/// What a call gives, or {"error": ...} with the words of the program.
template <typename Call>
val outcome_of(const Call& call) {
  std::string message;
  try {
    return call();
  } catch (const Error& error) {
    message = with_way_on(error);
  } catch (const std::exception& error) {
    message = error.what();
  }
  val failure = val::object();
  failure.set("error", message);
  return failure;
}

val meshed(const TriMesh& mesh) {
  val made = val::object();
  made.set("positions", array_of("Float32Array", coordinates_of(mesh)));
  made.set("triangles", array_of("Uint32Array", corners_of(mesh)));
  return made;
}

/// @param words an array of strings
/// @param on_progress called with stage, share and subject of long jobs
val run(val words, val on_progress) {
  const Run run =
      run_program(emscripten::vecFromJSArray<std::string>(words), [&](const Progress& progress) {
        on_progress(std::string(progress.stage), progress.share, std::string(progress.subject));
      });
  val made = val::object();
  made.set("code", run.exit_code);
  made.set("out", run.out);
  made.set("err", run.err);
  return made;
}

/// The model that lines are drawn on.
std::optional<Surface>& surface() {
  static std::optional<Surface> kept;
  return kept;
}

/// Opens another one, and gives its mesh.
/// @param paths an array of strings
val open_surface(val paths) {
  return outcome_of([&] {
    surface().reset();
    surface().emplace(emscripten::vecFromJSArray<std::string>(paths));
    val made = meshed(surface()->mesh());
    made.set("pieces", surface()->pieces());
    made.set("unit", std::string(surface()->unit()));
    return made;
  });
}

/// @param places x, y, z of each
val line_through(val places) {
  return outcome_of([&] {
    const std::vector<double> given = emscripten::convertJSArrayToNumberVector<double>(places);
    return array_of("Float64Array", surface() ? surface()->line(given) : std::vector<double>());
  });
}

/// The plane in which the model is most nearly its own mirror image.
val find_plane() {
  return outcome_of([&] {
    const SymmetryFound found = surface() ? surface()->symmetry() : SymmetryFound();
    const Vec3 n = found.plane.normal;
    val made = val::object();
    made.set("plane",
             array_of("Float64Array", std::vector<double>{n.x, n.y, n.z, found.plane.offset}));
    made.set("share", found.share);
    made.set("isSymmetric", found.is_symmetric);
    return made;
  });
}

/// The same model, to be cut and laid flat quickly.
std::optional<Sketch>& sketch() {
  static std::optional<Sketch> kept;
  return kept;
}

/// @param paths an array of strings
val open_sketch(val paths) {
  return outcome_of([&] {
    sketch().reset();
    sketch().emplace(emscripten::vecFromJSArray<std::string>(paths));
    return val::null();
  });
}

/// @param words an array of strings
val sketched(val words) {
  return outcome_of([&] {
    SketchPieces made;
    if (sketch()) made = sketch()->laid(emscripten::vecFromJSArray<std::string>(words));
    val pieces = val::array();
    for (const SketchPiece& piece : made.pieces) {
      val one = meshed(piece.surface);
      one.set("name", piece.name);
      one.set("flat", array_of("Float32Array", coordinates_of(piece.pattern)));
      one.set("strain", array_of("Float32Array", piece.strain));
      pieces.call<void>("push", one);
    }
    val all = val::object();
    all.set("pieces", pieces);
    all.set("hint", made.hint);
    return all;
  });
}

val read_laid(const std::string& in_space, const std::string& flat) {
  return outcome_of([&] {
    const LaidPiece piece = laid_piece(in_space, flat);
    val made = meshed(piece.surface);
    made.set("flat", array_of("Float32Array", coordinates_of(piece.pattern)));
    made.set("strain", array_of("Float32Array", piece.strain));
    return made;
  });
}

/// Red, green and blue from low to high, as pages have it.
val color_map(const std::string& name) {
  constexpr int steps = 64;
  std::vector<std::uint8_t> colors;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const Color color = name == "diverging" ? color_at(ColorMap::diverging, 2.0 * share - 1.0)
                                            : color_at(ColorMap::sequential, share);
    colors.insert(colors.end(), {color.r, color.g, color.b});
  }
  return array_of("Uint8Array", colors);
}

}  // namespace

EMSCRIPTEN_BINDINGS(planish) {
  emscripten::function("run", &run);
  emscripten::function("openSurface", &open_surface);
  emscripten::function("lineThrough", &line_through);
  emscripten::function("findPlane", &find_plane);
  emscripten::function("openSketch", &open_sketch);
  emscripten::function("sketch", &sketched);
  emscripten::function("readLaid", &read_laid);
  emscripten::function("colorMap", &color_map);
}

}  // namespace planish::wasm
