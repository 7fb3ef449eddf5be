/* SPDX-License-Identifier: Apache-2.0 */
/* The built-in material library: the bytes that etak_embed wrote. */
    .section .rodata
    .balign 8
    .global etak_library_begin
    .global etak_library_end
etak_library_begin:
    .incbin "library.bin"
etak_library_end:
    .byte 0
#if defined(__linux__) && defined(__ELF__)
    .section .note.GNU-stack,"",%progbits
#endif
