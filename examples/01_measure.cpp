// How far is a patch from flattenable? Reads a mesh file or makes a built-in patch.
#include <iostream>

#include <planish/io/read_mesh.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/shapes.h>

int main(int argc, char** argv) {
  try {
    const planish::TriMesh mesh =
        argc > 1 ? planish::read_mesh(argv[1]).mesh : planish::make_shape("panel", 2000);

    const planish::Inspection inspection = planish::inspect(mesh);
    for (const planish::Problem& problem : inspection.problems) {
      std::cout << to_string(problem.code) << ": " << problem.message << "\n";
    }

    const planish::Flattenability figures = planish::measure(planish::Patch(mesh));
    std::cout << "e_max " << figures.e_max << " rad, energy " << figures.energy << " rad^2, "
              << (planish::is_flattenable(figures, inspection) ? "flattenable\n"
                                                               : "not flattenable\n");
  } catch (const planish::Error& error) {
    std::cerr << to_string(error.code()) << ": " << error.what() << "\n";
    return 1;
  }
}
