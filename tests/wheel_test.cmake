# Makes a wheel as pip does, of the build that is there, and imports what is in it.
# Variables: PYTHON, BUILD_DIR, SOURCE_DIR, WORK_DIR.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${PYTHON} -c "from importlib.util import find_spec
print(*(name for name in ('pip', 'setuptools', 'wheel') if not find_spec(name)))" OUTPUT_VARIABLE missing OUTPUT_STRIP_TRAILING_WHITESPACE)
if(missing)
    message("skipped: ${PYTHON} has no ${missing}")
    return()
endif()

function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "failed (${result}): ${ARGN}\n${output}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR}/unpacked)
run(${CMAKE_COMMAND} -E env AEOLIC_BUILD_DIR=${BUILD_DIR} PIP_DISABLE_PIP_VERSION_CHECK=1 ${PYTHON} -m pip wheel
    --no-build-isolation --no-deps --no-index -w ${WORK_DIR} ${SOURCE_DIR})
file(GLOB wheel ${WORK_DIR}/aeolic-*.whl)
if(NOT wheel MATCHES "-cp3[0-9]+-cp3[0-9]+-linux_")
    message(FATAL_ERROR "the wheel should be for one Python and one kind of machine: ${wheel}")
endif()
file(ARCHIVE_EXTRACT INPUT ${wheel} DESTINATION ${WORK_DIR}/unpacked)
run(${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=${WORK_DIR}/unpacked ${PYTHON} -c
    "import aeolic; assert aeolic.__file__.startswith('${WORK_DIR}'); assert aeolic.render('sphere', size=(40, 30)).width == 40; assert any('${WORK_DIR}/unpacked' in line for line in open('/proc/self/maps') if 'libaeolic' in line)")
# It brings along what reads files, and the modules of that.
file(WRITE ${WORK_DIR}/a.stl "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n")
file(WRITE ${WORK_DIR}/b.cgns "no HDF5")
run(${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=${WORK_DIR}/unpacked ${PYTHON} -c "
import aeolic
assert aeolic.render('${WORK_DIR}/a.stl', field='rotation:8,8,8', size=(40, 30)).width == 40
try:
    aeolic.render('${WORK_DIR}/b.cgns', size=(40, 30))
except aeolic.InputError as error:
    assert str(error).startswith('${WORK_DIR}/b.cgns: '), error
")
