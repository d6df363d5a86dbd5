#pragma once

#include <map>
#include <optional>
#include <string>

#include <planish/core/error.h>
#include <planish/flatten/compare.h>
#include <planish/flatten/flatten.h>
#include <planish/flatten/frontier.h>

namespace planish {

/// Reports as JSON text, keys as the command line documents them (docs/command-line.md): one
/// object, UTF-8, numbers in the shortest digits that read back to the same doubles, numbers that
/// are not finite as null.
/// With "strain" and "limits"; without a strain, as of what cannot be laid flat, null and empty.
std::string json_report(const MeasuredPatch& patch,
                        const std::optional<StrainAsDesigned>& strain = {});
/// With before and after, deviation and history.
std::string json_report(const EvolveReport& report);
/// With strain, sizes and limits.
std::string json_report(const UnfoldReport& report);
/// @param files role -> path of what was written
std::string json_report(const FlattenReport& report,
                        const std::map<std::string, std::string>& files);
/// With the runs in their order.
std::string json_report(const CompareReport& report);
/// With the points of the curve and of other methods.
std::string json_report(const FrontierReport& report);
/// {"error": {code, message, path, line, byte, first, count}}, keys that are not known left out.
std::string json_report(const Error& error);

/// The history as comma-separated values: a header line, then a line a sweep.
std::string history_csv(const std::vector<SweepRecord>& history);

/// The histories of all methods likewise, a line a sweep, methods in their order.
std::string history_csv(const CompareReport& report);

}  // namespace planish
