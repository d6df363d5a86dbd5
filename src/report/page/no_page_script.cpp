#include "report/page/page_script.h"

namespace planish {

PageScript page_script() {
  return {};
}

}  // namespace planish
