# Makes the Debian packages, looks into them, unpacks them elsewhere and runs the programs.
# Variables: BUILD_DIR, WORK_DIR, VERSION, PYTHON (empty: there is no Python module).
cmake_minimum_required(VERSION 3.25)

function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "failed (${result}): ${ARGN}\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect text)
    foreach(pattern ${ARGN})
        if(NOT text MATCHES "${pattern}")
            message(FATAL_ERROR "no ${pattern} in:\n${text}")
        endif()
    endforeach()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR}/root)
run(${CMAKE_COMMAND} -E chdir ${WORK_DIR} ${CMAKE_CPACK_COMMAND} -G DEB --config ${BUILD_DIR}/CPackConfig.cmake -B ${WORK_DIR})
file(GLOB package ${WORK_DIR}/aeolic_${VERSION}_*.deb)

run(dpkg-deb --info ${package})
expect("${output}" "Package: aeolic" "Version: ${VERSION}" "Depends: [^\n]*libvtk9" "Depends: [^\n]*libtbb12")
run(dpkg-deb --contents ${package})
expect("${output}" "/usr/bin/aeolic\n" "/usr/bin/aeolic-bench\n" "/usr/lib/libaeolic.so" "/usr/include/aeolic/aeolic.h"
    "/usr/lib/cmake/Aeolic/AeolicConfig.cmake" "/usr/share/man/man1/aeolic-serve.1"
    "/usr/share/bash-completion/completions/aeolic\n" "/usr/share/zsh/vendor-completions/_aeolic\n" "/usr/share/doc/aeolic/copyright" "/usr/share/doc/aeolic/licenses/DejaVu-fonts.txt")

run(dpkg-deb --extract ${package} ${WORK_DIR}/root)
foreach(program aeolic aeolic-bench)
    run(${WORK_DIR}/root/usr/bin/${program} --version)
    expect("${output}" "${VERSION}")
endforeach()

if(PYTHON)
    file(GLOB module ${WORK_DIR}/python3-aeolic_${VERSION}_*.deb)
    run(dpkg-deb --info ${module})
    expect("${output}" "Package: python3-aeolic" "Depends: [^\n]*aeolic \\(= ${VERSION}\\)" "Depends: [^\n]*python3-numpy")
    run(dpkg-deb --contents ${module})
    expect("${output}" "/usr/lib/python3/dist-packages/aeolic/__init__.py\n" "/aeolic/_core[^\n]*.so\n" "/aeolic/__init__.pyi\n" "/aeolic/py.typed\n")
    run(dpkg-deb --extract ${module} ${WORK_DIR}/root)
    run(${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=${WORK_DIR}/root/usr/lib/python3/dist-packages ${PYTHON} -c
        "import aeolic; assert aeolic.__file__.startswith('${WORK_DIR}'); assert aeolic.render('sphere', size=(40, 30)).width == 40")
endif()
