# SPDX-License-Identifier: MIT
# Of the Raspberry Pi Pico SDK what the sample calls: for this machine, where calls write the bus as text, or, with a
# toolchain file, as declarations alone.
set(PICO_DOUBLE ${CMAKE_CURRENT_LIST_DIR})

function(pico_sdk_init)
    foreach(name pico_stdlib hardware_spi hardware_dma)
        add_library(${name} INTERFACE)
        target_include_directories(${name} INTERFACE ${PICO_DOUBLE}/include)
    endforeach()
    if(NOT CMAKE_CROSSCOMPILING)
        target_sources(pico_stdlib INTERFACE ${PICO_DOUBLE}/pico.c)
    endif()
endfunction()

function(pico_add_extra_outputs target)
endfunction()
