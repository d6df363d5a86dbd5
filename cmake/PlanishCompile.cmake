# How every target of the project is compiled.

# planish_choose_build_type(): without a build type compilers do not optimise, and the same work takes
# some ten times as long. Where nobody chose one, a build of the project alone is a Release, and inside
# another project our targets alone are compiled as in one (planish_release_flags). Generators that hold
# several configurations choose when they build; flags that set a level of optimisation are a choice.
function(planish_choose_build_type)
  get_property(holds_several GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
  if(CMAKE_BUILD_TYPE OR holds_several OR CMAKE_CXX_FLAGS MATCHES "(^| )[-/]O")
    return()
  endif()
  if(PROJECT_IS_TOP_LEVEL)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Kind of build" FORCE)
    message(WARNING "No build type was given: Planish is built as Release. "
                    "Give -DCMAKE_BUILD_TYPE=Release, or another one.")
    return()
  endif()
  separate_arguments(flags NATIVE_COMMAND "${CMAKE_CXX_FLAGS_RELEASE}")
  set(planish_release_flags ${flags} PARENT_SCOPE)
  message(WARNING "No build type was given: Planish alone is compiled as in a Release (${CMAKE_CXX_FLAGS_RELEASE}), "
                  "the project around it without optimisation. Give -DCMAKE_BUILD_TYPE=Release, or another one.")
endfunction()

# The same bits from every compiler, at every level of optimisation and on every processor:
#   -ffp-contract=off     no fused multiply-add where the source has a product and a sum
#   EIGEN_DONT_VECTORIZE  Eigen sums one after the other: in packets the order of its sums would
#                         depend on the width of registers, and on ARM packets fuse. What has to be
#                         fast has loops of its own (solve/panel_products.h).
# Three flags cost nothing of that: -fno-math-errno and -fno-trapping-math let the compiler turn square
# roots into single instructions and vectorise them, and -fno-semantic-interposition lets it inline
# functions in code for shared libraries.
function(planish_compile target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_definitions(${target} PRIVATE EIGEN_DONT_VECTORIZE)
  target_compile_options(
    ${target}
    PRIVATE ${planish_release_flags}
            -ffp-contract=off
            -fno-math-errno
            -fno-trapping-math
            $<$<NOT:$<PLATFORM_ID:Windows,Emscripten>>:-fno-semantic-interposition>
            -Wall
            -Wextra
            -Wpedantic
            -Wshadow
            -Wconversion
            -Wno-sign-conversion
            -Wdouble-promotion
            -Wnon-virtual-dtor
            -Woverloaded-virtual
            # GCC 12 sees overlaps and overflows in string and vector code that has none.
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
            $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
            $<$<BOOL:${PLANISH_WARNINGS_AS_ERRORS}>:-Werror>)
  if(CMAKE_UNITY_BUILD)  # once the folder has named all its sources
    cmake_language(EVAL CODE "cmake_language(DEFER CALL planish_unite_folders ${target})")
  endif()
endfunction()

# planish_unite_folders(TARGET): with CMAKE_UNITY_BUILD, up to eight sources of one folder are compiled as
# one, which takes a third off the time of compiling. Names in the anonymous namespaces of a folder must not clash.
function(planish_unite_folders target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  get_target_property(home ${target} SOURCE_DIR)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${home}")
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${PROJECT_SOURCE_DIR}")
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    list(APPEND ${folder} "${source}")
    list(LENGTH ${folder} number)
    math(EXPR group "(${number} - 1) / 8")
    set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${folder}_${group})
  endforeach()
endfunction()

# planish_instrument(TARGET): compiles with the flags of PLANISH_INSTRUMENT.
function(planish_instrument target)
  target_compile_options(${target} PRIVATE ${PLANISH_INSTRUMENT})
endfunction()

# planish_precompile(TARGET HEADERS...): with PLANISH_PRECOMPILE_HEADERS, which saves a third of the
# time. Builds without it find a missing #include.
function(planish_precompile target)
  if(PLANISH_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    planish_compile_precompiled(${target})
  endif()
endfunction()

# Flags for a target with precompiled headers.
function(planish_compile_precompiled target)
  target_compile_options(
    ${target}
    PRIVATE # GCC 12 then sees more that is not: out of bounds in string code, members not initialised.
            $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
            $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
            # ccache needs these.
            $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
            "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()
