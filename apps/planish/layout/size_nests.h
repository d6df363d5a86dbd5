#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <planish/io/write_file.h>
#include <planish/sheet/nest_sheet.h>

#include "output/pattern_output.h"
#include "shell/session.h"

namespace planish::cli {

/// The sizes of each piece drawn over each other, "sizes-tip.svg". A note says where that cannot
/// be, as with remeshed pieces.
/// @param patches those without a pattern are left out
/// @param styles of each patch the name that all its sizes have; empty for those of one size
std::vector<OutputFile> size_nest_files(const std::vector<NestPatch>& patches,
                                        const std::vector<std::string>& styles, Unit unit,
                                        const std::vector<PatternFormat>& formats,
                                        PatternOutput output, const std::filesystem::path& folder,
                                        Session& session);

}  // namespace planish::cli
