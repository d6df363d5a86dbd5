# The script of the report pages. It is made of web/ where Node and the packages that
# scripts/run and scripts/test install under build/npm are there; nothing is downloaded here.
# Without them pages show still pictures only.
# Called where the target is made: elsewhere CMake would not see how the source comes about.
function(planish_page_script target)
  set(web "${PROJECT_SOURCE_DIR}/web")
  set(packages "${PROJECT_SOURCE_DIR}/build/npm/report")
  find_program(PLANISH_NODE node)
  if(NOT PLANISH_NODE OR NOT EXISTS "${packages}/installed")
    message(STATUS "Reports without a 3D view: no Node, or nothing in build/npm/report")
    target_sources(${target} PRIVATE "${PROJECT_SOURCE_DIR}/src/report/page/no_page_script.cpp")
    return()
  endif()
  # In browsers the script comes as a file of its own: the page that the program is in has it too.
  if(EMSCRIPTEN)
    set(script "${PROJECT_BINARY_DIR}/generated/page_script.txt")
    target_sources(${target} PRIVATE "${PROJECT_SOURCE_DIR}/bindings/wasm/src/page_script.cpp")
  else()
    set(script "${PROJECT_BINARY_DIR}/generated/page_script.cpp")
  endif()
  file(GLOB modules CONFIGURE_DEPENDS "${web}/report/*.js" "${web}/viewer/*.js")
  add_custom_command(
    OUTPUT "${script}"
    COMMAND "${PLANISH_NODE}" "${web}/build.mjs" "${packages}/node_modules" "${script}"
    DEPENDS ${modules} "${web}/build.mjs" "${packages}/installed"
    COMMENT "Bundling the script of the report pages"
    VERBATIM)
  target_sources(${target} PRIVATE "${script}")
endfunction()
