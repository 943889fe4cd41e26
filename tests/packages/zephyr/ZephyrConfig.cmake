# SPDX-License-Identifier: MIT
# Of Zephyr's build what module and sample call: prj.conf as variables, modules read before the application.
set(ZEPHYR_DOUBLE ${CMAKE_CURRENT_LIST_DIR})

file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/prj.conf lines REGEX "^CONFIG_")
foreach(line ${lines})
    string(REGEX REPLACE "=.*" "" name ${line})
    string(REGEX REPLACE "^[^=]*=" "" ${name} ${line})
endforeach()

function(zephyr_library_named name)
    add_library(${name} STATIC)
    target_link_libraries(${name} PRIVATE zephyr_interface)
    set(ZEPHYR_CURRENT_LIBRARY ${name} PARENT_SCOPE)
    set_property(GLOBAL APPEND PROPERTY ZEPHYR_LIBS ${name})
endfunction()

function(zephyr_library_sources)
    target_sources(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endfunction()

function(zephyr_include_directories)
    target_include_directories(zephyr_interface INTERFACE ${ARGN})
endfunction()

enable_language(C)
add_library(zephyr_interface INTERFACE)
target_include_directories(zephyr_interface INTERFACE ${ZEPHYR_DOUBLE}/include
    ${ZEPHYR_DOUBLE}/../../adapters/declarations)
foreach(module ${ZEPHYR_EXTRA_MODULES})
    add_subdirectory(${module}/zephyr ${CMAKE_CURRENT_BINARY_DIR}/module)
endforeach()
get_property(libraries GLOBAL PROPERTY ZEPHYR_LIBS)

add_library(app STATIC)
target_link_libraries(app PRIVATE zephyr_interface ${libraries})
if(NOT CMAKE_CROSSCOMPILING)
    add_executable(zephyr ${ZEPHYR_DOUBLE}/zephyr.c)
    target_link_libraries(zephyr PRIVATE zephyr_interface app)
endif()
