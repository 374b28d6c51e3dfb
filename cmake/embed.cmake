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

# The page: every file of web/, found by its name (src/stream/gateway/web_assets.cpp).
file(GLOB AEOLIC_WEB_FILES CONFIGURE_DEPENDS web/*.html web/*.css web/*.js web/*.svg)
set(AEOLIC_WEB_BYTES "")
set(AEOLIC_WEB_TABLE "")
set(index 0)
foreach(file ${AEOLIC_WEB_FILES})
    get_filename_component(name ${file} NAME)
    string(APPEND AEOLIC_WEB_BYTES "name${index}: .asciz \"${name}\"\nbegin${index}: .incbin \"${file}\"\nend${index}: .byte 0\n")
    string(APPEND AEOLIC_WEB_TABLE "    .quad name${index}, begin${index}, end${index}\n")
    math(EXPR index "${index} + 1")
endforeach()
configure_file(cmake/embedded_web.S.in generated/embedded_web.S @ONLY)
set_property(SOURCE ${CMAKE_CURRENT_BINARY_DIR}/generated/embedded_web.S PROPERTY OBJECT_DEPENDS "${AEOLIC_WEB_FILES}")
target_sources(aeolic_lib PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated/embedded_web.S)
