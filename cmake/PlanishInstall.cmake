# Install and export: consumers write find_package(planish) and link planish::planish.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS planish EXPORT planish_targets)
install(DIRECTORY include/planish DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(FILES "${PROJECT_BINARY_DIR}/generated/planish/core/version.h"
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/planish/core)
if(PLANISH_BUILD_APPS)
  install(TARGETS planish_app)
endif()
install(
  EXPORT planish_targets
  NAMESPACE planish::
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/planish)
configure_package_config_file(
  cmake/planish-config.cmake.in "${PROJECT_BINARY_DIR}/planish-config.cmake"
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/planish)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/planish-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/planish-config.cmake"
              "${PROJECT_BINARY_DIR}/planish-config-version.cmake" cmake/FindPolyclipping.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/planish)
