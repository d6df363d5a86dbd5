// The OBJ reader.

#include "fuzz/read_mesh.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  planish::fuzz::check_mesh_reader({reinterpret_cast<const char*>(data), size},
                                   planish::MeshFormat::obj);
  return 0;
}
