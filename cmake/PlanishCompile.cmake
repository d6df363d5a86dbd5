# How every target of the project is compiled.

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
    PRIVATE -ffp-contract=off
            -fno-math-errno
            -fno-trapping-math
            -fno-semantic-interposition
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
endfunction()

# planish_instrument(TARGET HEADERS...): compiles with the flags of PLANISH_INSTRUMENT, if there are
# any, and with these headers precompiled, as that takes long. All other builds compile every source
# by itself and so find a missing #include.
function(planish_instrument target)
  if(NOT PLANISH_INSTRUMENT)
    return()
  endif()
  target_compile_options(${target} PRIVATE ${PLANISH_INSTRUMENT}
                                           "SHELL:-Xclang -fno-pch-timestamp")  # for ccache
  target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()
