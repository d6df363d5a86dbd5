#include "report/page/page_assets.h"

namespace planish {

PageScript page_script() {
  return {};
}

}  // namespace planish
