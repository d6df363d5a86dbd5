# Install and export: consumers write find_package(planish) and link planish::planish, or ask
# pkg-config for planish. The components program, development and documentation are what the packages
# of scripts/package hold.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(PlanishManual)

install(TARGETS planish EXPORT planish_targets COMPONENT development)
install(DIRECTORY include/planish DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
        FILES_MATCHING PATTERN "*.h")
install(FILES "${PROJECT_BINARY_DIR}/generated/planish/core/version.h"
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/planish/core COMPONENT development)
if(PLANISH_BUILD_APPS)
  install(TARGETS planish_app COMPONENT program)
  planish_manual(planish_app)
endif()
install(
  EXPORT planish_targets
  NAMESPACE planish::
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/planish
  COMPONENT development)
configure_package_config_file(
  cmake/planish-config.cmake.in "${PROJECT_BINARY_DIR}/planish-config.cmake"
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/planish)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/planish-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/planish-config.cmake"
              "${PROJECT_BINARY_DIR}/planish-config-version.cmake" cmake/FindPolyclipping.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/planish COMPONENT development)

# Names every path from its own place, so that the whole may be moved.
file(RELATIVE_PATH planish_prefix_from_pc "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
string(REGEX REPLACE "/$" "" planish_prefix_from_pc "${planish_prefix_from_pc}")
configure_file(cmake/planish.pc.in "${PROJECT_BINARY_DIR}/planish.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/planish.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)

install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/planish-doc/docs COMPONENT documentation
        FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.png" PATTERN "*.csv" PATTERN "*.json")
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/planish-doc/examples
        COMPONENT documentation FILES_MATCHING PATTERN "*.cpp" PATTERN "*.py" PATTERN "*.ipynb")
# Beside them as in the sources, so that their links lead there.
install(FILES README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md NOTICE
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/planish-doc COMPONENT documentation)
