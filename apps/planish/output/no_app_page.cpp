#include "output/app_page.h"

namespace planish::cli {

std::span<const std::string_view> app_page() {
  return {};
}

}  // namespace planish::cli
