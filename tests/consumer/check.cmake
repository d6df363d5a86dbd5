# Builds and runs the consumer. With -DWAY=find_package or -DWAY=add_subdirectory; without_type instead only
# configures it with the sources inside and no build type, and looks at the flags. Also -DSOURCE (the
# project's folder), -DBINARY (its build folder), -DCOMPILER, -DFLAGS, -DBUILD_TYPE,
# -DUNITY and -DPYTHON.
set(work "${BINARY}/consumer/${WAY}")
file(REMOVE_RECURSE "${work}")

# The flags that a build folder of Ninja compiles a target's object with.
function(flags_of object folder flags)
  file(STRINGS "${folder}/build.ninja" lines)
  set(inside FALSE)
  foreach(line IN LISTS lines)
    if(line MATCHES "^build .*${object}")
      set(inside TRUE)
    elseif(inside AND line MATCHES "^  FLAGS = (.*)")
      set(${flags} " ${CMAKE_MATCH_1} " PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "${folder} does not compile ${object}")
endfunction()

if(WAY STREQUAL "without_type")
  foreach(argument "-DCMAKE_BUILD_TYPE=" "-DCMAKE_BUILD_TYPE=Debug" "-DCMAKE_CXX_FLAGS=-O1")
    string(COMPARE EQUAL "${argument}" "-DCMAKE_BUILD_TYPE=" expected)
    string(MAKE_C_IDENTIFIER "${argument}" name)
    execute_process(
      COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}/tests/consumer" -B "${work}/${name}" -G Ninja
              "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DPLANISH_SOURCE_FOLDER=${SOURCE}" ${argument}
      ERROR_VARIABLE said OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    string(FIND "${said}" "No build type was given" place)
    flags_of("planish.dir/src/unfold/unfold.cpp" "${work}/${name}" flags)
    flags_of("consumer.dir/main.cpp" "${work}/${name}" theirs)
    string(REGEX MATCH " -O[23] .*-DNDEBUG " optimised "${flags}")
    if(expected AND (place EQUAL -1 OR NOT optimised))
      message(FATAL_ERROR "${name}: no warning, or the library is not optimised:${flags}\n${said}")
    elseif(NOT expected AND (NOT place EQUAL -1 OR optimised))
      message(FATAL_ERROR "${name}: what the project around it chose does not count:${flags}\n${said}")
    elseif(theirs MATCHES "-O[23]|NDEBUG")
      message(FATAL_ERROR "${name}: flags of ours reach the project around it:${theirs}")
    endif()
  endforeach()
  return()
endif()

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
