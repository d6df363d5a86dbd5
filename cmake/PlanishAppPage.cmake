# The page of the app in the program, for `planish app`: PLANISH_APP_PAGE is the file that scripts/web makes. Without it
# the verb says where to get one.
set(PLANISH_APP_PAGE "" CACHE FILEPATH "The page that `planish app` writes: build/web/planish.html of scripts/web")

function(planish_app_page target)
  if(NOT PLANISH_APP_PAGE)
    target_sources(${target} PRIVATE output/no_app_page.cpp)
    return()
  endif()
  set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PLANISH_APP_PAGE}")
  file(READ "${PLANISH_APP_PAGE}" page)
  set(longest 60000)  # letters of a string that every compiler takes
  string(LENGTH "${page}" length)
  set(parts "")
  foreach(at RANGE 0 ${length} ${longest})
    string(SUBSTRING "${page}" ${at} ${longest} part)
    string(APPEND parts "R\"planish(${part})planish\"sv,\n")
  endforeach()
  set(source "${PROJECT_BINARY_DIR}/generated/app_page.cpp")
  file(WRITE "${source}.new" "#include \"output/app_page.h\"

namespace planish::cli {

namespace {

using namespace std::string_view_literals;  // with their lengths: compilers will not count so far

constexpr std::string_view k_parts[] = {
${parts}};

}  // namespace

std::span<const std::string_view> app_page() {
  return k_parts;
}

}  // namespace planish::cli
")
  file(COPY_FILE "${source}.new" "${source}" ONLY_IF_DIFFERENT)
  target_sources(${target} PRIVATE "${source}")
endfunction()
