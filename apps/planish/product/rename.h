#pragma once

#include <map>
#include <string>
#include <vector>

#include "piece/piece_settings.h"
#include "product/parts.h"

namespace planish::cli {

/// --rename, for patches whose names the file does not give, as those that a cut makes.
Flag rename_flag();

/// The input with the names that --rename gives, also of its folders.
/// @throws UsageError for a name that no patch has, one that would be there twice, and a product
///   file, which has names of its own
void rename_pieces(ProductInput& input, const Arguments& arguments);

/// The same for names that are at hand, old ones to new ones.
/// @param flag that has them, for errors
/// @throws UsageError as rename_pieces()
void give_names(ProductInput& input, std::map<std::string, std::string> asked,
                const std::string& flag);

/// What is asked for each piece (piece_requests()); those that get other names have them
/// afterwards.
/// @throws as piece_requests() and give_names()
std::vector<PieceRequest> named_requests(ProductInput& input, const PatternOptions& usual,
                                         const Arguments& arguments, Session& session);

}  // namespace planish::cli
