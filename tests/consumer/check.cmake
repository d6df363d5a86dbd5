# Builds and runs the consumer. With -DWAY=find_package or -DWAY=add_subdirectory, -DSOURCE (the
# project's folder), -DBINARY (its build folder), -DCOMPILER and -DFLAGS.
set(work "${BINARY}/consumer/${WAY}")
file(REMOVE_RECURSE "${work}")

if(WAY STREQUAL "find_package")
  execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BINARY}" --prefix "${work}/prefix"
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  set(how "-DCMAKE_PREFIX_PATH=${work}/prefix")
else()
  set(how "-DPLANISH_SOURCE_FOLDER=${SOURCE}" "-DPLANISH_PRECOMPILE=ON")
endif()

# Without optimisation: this is about building at all, and soon.
execute_process(
  COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}/tests/consumer" -B "${work}/build" -G Ninja
          "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}" ${how}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${work}/build" --target consumer
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${work}/build/consumer" COMMAND_ERROR_IS_FATAL ANY)
