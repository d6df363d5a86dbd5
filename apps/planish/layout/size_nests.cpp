#include "layout/size_nests.h"

#include <algorithm>
#include <cstddef>

#include <planish/core/error.h>

#include "platform/path.h"
#include "shell/safe_names.h"

namespace planish::cli {

std::vector<OutputFile> size_nest_files(const std::vector<NestPatch>& patches,
                                        const std::vector<std::string>& styles, Unit unit,
                                        const std::vector<PatternFormat>& formats,
                                        PatternOutput output, const std::filesystem::path& folder,
                                        Session& session) {
  std::vector<std::string> names;
  for (const std::string& style : styles) {
    if (!style.empty() && std::find(names.begin(), names.end(), style) == names.end())
      names.push_back(style);
  }
  const std::vector<std::string> stems = safe_names(names);
  output.only_layers.clear();
  output.dxf = DxfOptions{.stroked_text = output.dxf.stroked_text,
                          .version = output.dxf.version,
                          .unit = output.dxf.unit};
  std::vector<OutputFile> files;
  for (std::size_t s = 0; s < names.size(); ++s) {
    std::vector<NestPatch> sizes;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (styles[p] == names[s] && !patches[p].pattern.empty()) sizes.push_back(patches[p]);
    }
    try {
      const Drawing nest = size_nest(sizes, unit, names[s]);
      for (const PatternFormat format : formats) {
        const std::string name = "sizes-" + stems[s] + "." + std::string(to_string(format));
        files.push_back({folder / path_of(name), pattern_file(nest, format, output)});
      }
    } catch (const Error& error) {
      session.note("the sizes of " + names[s] + " are not drawn over each other: " + error.what());
    }
  }
  return files;
}

}  // namespace planish::cli
