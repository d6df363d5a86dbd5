# The style sheets of the pages, which are in web/. They become a source of the target without Node: pages
# without a 3D view need them too. In the order in which they stand in a page.
# Called where the target is made: elsewhere CMake would not see how the source comes about.
function(planish_page_style target)
  set(web "${PROJECT_SOURCE_DIR}/web")
  foreach(sheet report/base report/page report/layout viewer/viewer report/panel report/pieces report/limit report/product)
    set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${web}/${sheet}.css")
    cmake_path(GET sheet FILENAME name)
    file(READ "${web}/${sheet}.css" ${name}_css)
  endforeach()
  set(source "${PROJECT_BINARY_DIR}/generated/page_style.cpp")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/page_style.cpp.in" "${source}" @ONLY)
  target_sources(${target} PRIVATE "${source}")
endfunction()
