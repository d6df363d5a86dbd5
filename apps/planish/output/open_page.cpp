#include "output/open_page.h"

#include "shell/session.h"

namespace planish::cli {

Flag open_flag() {
  return {"--open", "", "open the page in the browser once it is written"};
}

void open_if_asked(const Arguments& arguments, const std::filesystem::path& page,
                   Session& session) noexcept {
  if (arguments.has("--open")) session.open(page);
}

}  // namespace planish::cli
