#include <exception>
#include <new>

#include <planish/core/ways_on.h>
#include <planish/flatten/flatten.h>

namespace planish {

Failure current_failure() try {
  try {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return {std::string(to_string(error.code())), with_way_on(error)};
  } catch (const std::bad_alloc&) {
    return {"out_of_memory", "out of memory"};
  } catch (const std::exception& error) {
    return {"internal_error", error.what()};
  }
} catch (const std::bad_alloc&) {  // not even for the words
  return {"out_of_memory", "out of memory"};
}

}  // namespace planish
