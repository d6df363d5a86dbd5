#include <filesystem>

#include <planish/core/error.h>
#include <planish/io/write_file.h>

#include "commands/commands.h"
#include "output/app_page.h"
#include "output/open_page.h"
#include "platform/path.h"
#include "shell/session.h"
#include "text/json_text.h"
#include "text/written_text.h"

namespace planish::cli {

namespace {

CommandResult run_app(const Arguments& arguments, Session& session) {
  if (app_page().empty()) {
    throw Error(ErrorCode::file_not_found,
                "this program was built without the app: scripts/web makes its page, and the CMake "
                "option PLANISH_APP_PAGE=build/web/planish.html takes it into the program");
  }
  std::string page;
  for (const std::string_view part : app_page())
    page += part;
  const std::filesystem::path path = path_of(arguments.text("--output", "planish.html"));
  const std::vector<OutputFile> files = {{path, std::move(page)}};
  CommandResult outcome = {written_text(files), json_page(utf8_of(path))};
  session.write(files);
  open_if_asked(arguments, path, session);
  return outcome;
}

}  // namespace

Command app_command() {
  return {"app",
          "Planish as a page for the browser",
          "[-o PAGE]",
          "Writes the app as one .html file that works without a network: drop a model on it, draw "
          "seams, and download the pattern.",
          {},
          {{"Output",
            {{"--output",
              "PAGE",
              "the page to write: .html (default planish.html)",
              'o',
              false,
              {.type = ValueType::file, .extensions = {"html"}}},
             open_flag()}}},
          {"planish app --open", "planish app -o planish.html"},
          run_app};
}

}  // namespace planish::cli
