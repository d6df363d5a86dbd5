# Builds and runs the consumer. With -DWAY=find_package or -DWAY=add_subdirectory, -DSOURCE (the
# project's folder), -DBINARY (its build folder), -DCOMPILER, -DFLAGS, -DBUILD_TYPE,
# -DUNITY and -DPYTHON.
set(work "${BINARY}/consumer/${WAY}")
file(REMOVE_RECURSE "${work}")

if(WAY STREQUAL "find_package")
  execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BINARY}" --prefix "${work}/prefix"
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  set(how "-DCMAKE_PREFIX_PATH=${work}/prefix")
else()
  set(how "-DPLANISH_SOURCE_FOLDER=${SOURCE}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_UNITY_BUILD=${UNITY}")
  # Objects that this build compiled by the same command are copied, to save compiling them again.
  if(PYTHON)
    list(APPEND how "-DCMAKE_CXX_COMPILER_LAUNCHER=${PYTHON}\;${CMAKE_CURRENT_LIST_DIR}/reuse_object.py\;${BINARY}\;${work}/build/planish")
  endif()
endif()

execute_process(
  COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}/tests/consumer" -B "${work}/build" -G Ninja
          "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}" ${how}
  COMMAND_ERROR_IS_FATAL ANY)
if(WAY STREQUAL "add_subdirectory")
  # The only generated header must be the same for copied objects to be right.
  set(version generated/planish/core/version.h)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E compare_files "${BINARY}/${version}"
                          "${work}/build/planish/${version}" COMMAND_ERROR_IS_FATAL ANY)
endif()
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${work}/build" --target consumer
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${work}/build/consumer" COMMAND_ERROR_IS_FATAL ANY)
