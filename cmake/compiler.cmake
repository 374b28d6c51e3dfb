# How everything of ours is compiled. One interface target, so tests, library and program cannot differ.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
find_program(CCACHE ccache)
if(CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# Highway picks AVX2, AVX-512 … at run time; what is below this floor (2010) is not worth a code path.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(AEOLIC_BASELINE -march=x86-64-v2 -maes -mpclmul)
endif()

add_library(aeolic_options INTERFACE)
# Same bytes from any split: no contraction the source does not spell out, never fast-math (docs/decisions).
# No semantic interposition: the shared library's own functions stay inlinable.
target_compile_options(aeolic_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off -fno-semantic-interposition ${AEOLIC_BASELINE}
    # GCC 12 sees overlapping copies in std::string's own operator+ (GCC bug 105651).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
    $<$<BOOL:${AEOLIC_WERROR}>:-Werror>)
if(AEOLIC_SANITIZE)
    # A finding ends the program: a test that only prints one would pass. Following variables through instrumented vector
    # code takes GCC half the time of a kernel; line numbers do without.
    target_compile_options(aeolic_options INTERFACE -fsanitize=${AEOLIC_SANITIZE} -fno-sanitize-recover=all
        -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-fno-var-tracking>)
    target_link_options(aeolic_options INTERFACE -fsanitize=${AEOLIC_SANITIZE})
    # The widest vectors take GCC minutes a file to instrument; the same source runs here with narrower ones.
    target_compile_definitions(aeolic_options INTERFACE "HWY_DISABLED_TARGETS=(HWY_AVX3|HWY_AVX3_DL)")
endif()
