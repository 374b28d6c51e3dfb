# Installs the build, moves the tree, builds the examples against it and runs what comes out.
# Variables: BUILD_DIR, SOURCE_DIR, WORK_DIR, CONFIG, PYTHON (empty: there is no Python module), PYTHON3, MPIRUN (empty: there
# is none).
cmake_minimum_required(VERSION 3.25)

function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "failed (${result}): ${ARGN}\n${output}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --config ${CONFIG} --prefix ${WORK_DIR}/first)
file(RENAME ${WORK_DIR}/first ${WORK_DIR}/moved)
run(${WORK_DIR}/moved/bin/aeolic --version)
run(${WORK_DIR}/moved/bin/aeolic-bench --version)
foreach(file man/man1/aeolic.1 man/man1/aeolic-render.1 bash-completion/completions/aeolic zsh/vendor-completions/_aeolic)
    if(NOT EXISTS ${WORK_DIR}/moved/share/${file})
        message(FATAL_ERROR "share/${file} was not installed")
    endif()
endforeach()

if(PYTHON)
    run(${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=${WORK_DIR}/moved/lib/python3/dist-packages ${PYTHON} -c
        "import aeolic; assert aeolic.__file__.startswith('${WORK_DIR}'); assert aeolic.render('sphere', size=(40, 30)).width == 40")
endif()

run(${CMAKE_COMMAND} -S ${SOURCE_DIR}/examples/library -B ${WORK_DIR}/example -G Ninja
    -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_PREFIX_PATH=${WORK_DIR}/moved)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/example)
run(${CMAKE_COMMAND} -E chdir ${WORK_DIR} ${WORK_DIR}/example/first_picture)

file(READ ${WORK_DIR}/teapot.png signature LIMIT 8 HEX)
if(NOT signature STREQUAL "89504e470d0a1a0a")
    message(FATAL_ERROR "teapot.png is no PNG: it starts with ${signature}")
endif()
file(SIZE ${WORK_DIR}/teapot.png bytes)
if(bytes LESS 20000)
    message(FATAL_ERROR "teapot.png has ${bytes} bytes: an empty picture; a textured teapot has more than 20000")
endif()

# The solver that draws what it computes.
if(MPIRUN AND PYTHON3)
    run(${CMAKE_COMMAND} -S ${SOURCE_DIR}/examples/insitu -B ${WORK_DIR}/insitu -G Ninja
        -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_PREFIX_PATH=${WORK_DIR}/moved)
    run(${CMAKE_COMMAND} --build ${WORK_DIR}/insitu)
    run(${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${PYTHON3} ${SOURCE_DIR}/tests/insitu_test.py
        ${WORK_DIR}/moved/bin/aeolic ${WORK_DIR}/insitu/insitu ${MPIRUN})
endif()

# The page that shows the program shows this program.
file(READ ${SOURCE_DIR}/examples/library/first_picture.cpp program)
file(READ ${SOURCE_DIR}/docs/library.md page)
string(FIND "${page}" "${program}" found)
if(found EQUAL -1)
    message(FATAL_ERROR "docs/library.md no longer quotes examples/library/first_picture.cpp")
endif()
