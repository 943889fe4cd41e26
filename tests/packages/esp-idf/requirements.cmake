# SPDX-License-Identifier: MIT
# ESP-IDF reads each component's CMakeLists.txt in a script first, to learn what it requires: -DCOMPONENT=FILE -P.
set(ESP_PLATFORM 1)
macro(idf_component_register)
    cmake_parse_arguments(component "" "" "SRCS;INCLUDE_DIRS;REQUIRES;PRIV_REQUIRES" ${ARGN})
    list(LENGTH component_SRCS count)
    message("${count} sources, headers in ${component_INCLUDE_DIRS}")
endmacro()
include(${COMPONENT})
