// The whole program: an argument a line, and behind an empty line what the file "given" holds. It
// runs in a folder of its own with a few small inputs; words cannot lead out of it.

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <vector>

#include <planish/io/mesh_format.h>

#include <nlohmann/json.hpp>

#include "fuzz/check.h"
#include "fuzz/temporary_folder.h"
#include "parse.h"
#include "run.h"
#include "support/meshes.h"

using namespace planish;
using namespace planish::cli;

namespace {

/// No way out of the folder, and no number that asks for hours of work.
std::string made_harmless(std::string word) {
  word = word.substr(0, word.find('\0'));
  std::size_t digits = 0;
  std::string harmless;
  for (const char c : word) {
    digits = std::isdigit(static_cast<unsigned char>(c)) != 0 ? digits + 1 : 0;
    const bool leads_up = c == '.' && !harmless.empty() && harmless.back() == '.';
    if (digits <= 3) harmless += c == '/' || leads_up ? '_' : c;
  }
  return harmless;
}

struct Input {
  std::vector<std::string> args;
  std::string given;
};

Input input_in(std::string_view bytes) {
  Input input;
  while (!bytes.empty()) {
    const std::string_view line = bytes.substr(0, bytes.find('\n'));
    bytes.remove_prefix(std::min(bytes.size(), line.size() + 1));
    if (line.empty()) break;
    input.args.push_back(made_harmless(std::string(line)));
  }
  input.given = bytes;
  return input;
}

/// Two patches that share a seam, as objects.
std::string product() {
  return "v 0 0 0\nv 10 0 1\nv 20 0 0\nv 0 10 1\nv 10 10 2\nv 20 10 1\nv 0 20 0\nv 10 20 1\n"
         "v 20 20 0\no left\nf 1 2 5 4\nf 4 5 8 7\no right\nf 2 3 6 5\nf 5 6 9 8\n";
}

std::map<std::string, std::string> inputs(const std::string& given) {
  const TriMesh panel = meshes::height_field(
      4, 3, [](double x, double y) { return 0.05 * (x - 2.0) * (x - 2.0) - 0.1 * y * y; });
  return {{"panel.obj", format_mesh(panel, MeshFormat::obj)},
          {"panel.stl", format_mesh(panel, MeshFormat::stl)},
          {"product.obj", product()},
          {"fixed.txt", "6 7\n"},
          {"weights.txt", "6 2.5\n7 0.5\n"},
          {"cuts.txt", "2 7 12\n"},
          {"notches.txt", "0.25\n50% v double\n0 t\n"},
          {"marks.txt", "6 cross\n8 drill\n"},
          {"lines.txt", "6 7 8\n"},
          {"edges.txt", "0 4 2.5mm\n"},
          {"seams.txt", "* 50%\n1 2mm v\n"},
          {"given", given},
          {"given.obj", given},
          {"given.ply", given}};
}

/// Short flags may stand in one word: -qh.
bool is_help(const std::vector<std::string>& args) {
  return asks_for(args, "--help") || asks_for(args, "--help-all") ||
         std::any_of(args.begin(), args.end(), [](const std::string& arg) {
           return arg.starts_with('-') && !arg.starts_with("--") && arg.find('h') != arg.npos;
         });
}

/// Messages repeat words of the input.
bool mentions(const Input& input, std::string_view text) {
  return input.given.find(text) != input.given.npos ||
         std::any_of(input.args.begin(), input.args.end(),
                     [&](const std::string& arg) { return arg.find(text) != arg.npos; });
}

void check_output(const Input& input, int exit_code, const std::string& out,
                  const std::string& err) {
  constexpr std::array known = {k_exit_done, k_exit_failed, k_exit_usage, k_exit_target_missed};
  fuzz::check(std::find(known.begin(), known.end(), exit_code) != known.end(),
              "exit codes are those that are documented");
  constexpr std::string_view unforeseen = "internal error";
  fuzz::check(err.find(unforeseen) == err.npos || mentions(input, unforeseen),
              "errors are foreseen");
  fuzz::check(exit_code == k_exit_done || !err.empty(), "failures are told");
  if (!asks_for(input.args, "--json") || is_help(input.args)) return;
  fuzz::check(nlohmann::json::parse(out, nullptr, false).is_object(),
              "with --json there is one object on standard output and nothing else");
}

/// A bad file does not keep the other files from their results, nor a bad patch the other patches
/// of a product.
bool keeps_other_results(const Input& input, std::string_view err) {
  return err.find(" files failed") != err.npos || err.find(" file failed") != err.npos ||
         std::any_of(input.args.begin(), input.args.end(), [](const std::string& arg) {
           return arg == "flatten" || arg == "unfold" || arg == "measure";
         });
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::TemporaryFolder folder;
  const Input input = input_in({reinterpret_cast<const char*>(data), size});
  folder.fill(inputs(input.given));
  const auto before = fuzz::files_here();
  std::ostringstream out, err;
  const int exit_code = run(input.args, out, err);
  check_output(input, exit_code, out.str(), err.str());
  const auto after = fuzz::files_here();
  const bool failed = exit_code == k_exit_usage || exit_code == k_exit_failed;
  fuzz::check(!failed || keeps_other_results(input, err.str()) || after == before,
              "nothing is written after a failure");
  for (const auto& [name, bytes] : after)
    fuzz::check(name.find(".planish-partial-") == name.npos, "no passing file stays");
  fuzz::check(folder.is_alone(), "nothing is written elsewhere");
  return 0;
}
