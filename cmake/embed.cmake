# What is generated into the build folder: the version header, and the label font as an object file.
set(AEOLIC_LZO_TEXT false)
if(AEOLIC_LZO)
    set(AEOLIC_LZO_TEXT true)
endif()
configure_file(cmake/version.h.in generated/version.h @ONLY)

find_file(AEOLIC_FONT DejaVuSans.ttf
    PATHS /usr/share/fonts /usr/local/share/fonts PATH_SUFFIXES truetype/dejavu dejavu TTF truetype dejavu-sans-fonts
    DOC "The TrueType font for labels, embedded in the program")
if(NOT AEOLIC_FONT)
    message(FATAL_ERROR "DejaVuSans.ttf not found: install the package fonts-dejavu-core, or set -DAEOLIC_FONT=/path/to/a.ttf")
endif()
enable_language(ASM)
configure_file(cmake/embedded_font.S.in generated/embedded_font.S @ONLY)
set_property(SOURCE ${CMAKE_CURRENT_BINARY_DIR}/generated/embedded_font.S PROPERTY OBJECT_DEPENDS ${AEOLIC_FONT})
target_sources(aeolic_lib PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated/embedded_font.S)

# embed_files(TABLE FOLDER FILES…): the files as bytes in the program, and a table of them for C++. A row holds the path below
# FOLDER, the first byte, and the end; a null name ends the table.
function(embed_files table folder)
    set(AEOLIC_TABLE ${table})
    set(AEOLIC_TABLE_ROWS "")
    set(AEOLIC_TABLE_BYTES "")
    set(index 0)
    foreach(file ${ARGN})
        file(RELATIVE_PATH name ${folder} ${file})
        string(APPEND AEOLIC_TABLE_ROWS "    .quad .Lname${index}, .Lbegin${index}, .Lend${index}\n")
        string(APPEND AEOLIC_TABLE_BYTES
            ".Lname${index}:\n    .asciz \"${name}\"\n.Lbegin${index}:\n    .incbin \"${file}\"\n.Lend${index}:\n    .byte 0\n")
        math(EXPR index "${index} + 1")
    endforeach()
    configure_file(cmake/embedded_files.S.in generated/${table}.S @ONLY)
    set_property(SOURCE ${CMAKE_CURRENT_BINARY_DIR}/generated/${table}.S PROPERTY OBJECT_DEPENDS "${ARGN}")
    target_sources(aeolic_lib PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated/${table}.S)
endfunction()

# The page (src/stream/gateway/http_answers.cpp).
file(GLOB_RECURSE AEOLIC_WEB_FILES CONFIGURE_DEPENDS web/*.html web/*.css web/*.js web/*.svg)
list(FILTER AEOLIC_WEB_FILES EXCLUDE REGEX "/web/loop/")
embed_files(aeolicWebFiles ${CMAKE_CURRENT_SOURCE_DIR}/web ${AEOLIC_WEB_FILES})

# What a file with a loop is made of (src/output/loop_page.cpp).
file(GLOB AEOLIC_LOOP_FILES CONFIGURE_DEPENDS web/loop/loop.html web/picture/cycle*.js)
embed_files(aeolicLoopFiles ${CMAKE_CURRENT_SOURCE_DIR}/web ${AEOLIC_LOOP_FILES})

# The GPU backend's shaders (src/render/gl/device/programs.cpp).
if(AEOLIC_GL)
    file(GLOB_RECURSE AEOLIC_SHADERS CONFIGURE_DEPENDS src/render/gl/shaders/*)
    embed_files(aeolicShaders ${CMAKE_CURRENT_SOURCE_DIR}/src/render/gl/shaders ${AEOLIC_SHADERS})
endif()
