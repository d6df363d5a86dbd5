# How every target of the project is compiled.

# One set of bits everywhere: no fused multiply-add contraction. The other two let the compiler
# turn square roots into single instructions and vectorise them; neither changes a result.
function(planish_compile target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(
    ${target}
    PRIVATE -ffp-contract=off
            -fno-math-errno
            -fno-trapping-math
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
