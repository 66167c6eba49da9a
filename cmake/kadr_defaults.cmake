# kadr_defaults(target): the standard, the warnings and the sanitizers that every target of ours has.
set(KADR_SANITIZE "" CACHE STRING "sanitizers of this build, for example address,undefined")
option(KADR_TIDY "run clang-tidy while compiling" OFF)

option(KADR_UNITY "compile the files of a room eight at a time; off where single files are worked on" ON)

# The fronts of most files cost more than what they are about: together they are compiled once.
function(kadr_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${KADR_UNITY} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

function(kadr_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/runtime)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # g++ 12 sees an overlap in `"text" + std::string` that is not there (GCC bug 105329), and behind
    # a precompiled header it forgets that the library's headers are not ours.
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow
      -Wno-stringop-overread)
  endif()
  if(KADR_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=${KADR_SANITIZE} -fno-sanitize-recover=all
      -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${KADR_SANITIZE})
  endif()
  if(KADR_FUZZ)
    # Coverage feedback for libFuzzer; its main function comes with the fuzz targets alone.
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    target_link_options(${target} PUBLIC -fsanitize=fuzzer-no-link)
  endif()
  if(KADR_TIDY)
    # Clang does not know every warning option of g++.
    set_target_properties(${target} PROPERTIES CXX_CLANG_TIDY
      "clang-tidy;--quiet;--extra-arg=-Wno-unknown-warning-option")
  endif()
endfunction()

# kadr_precompile(target headers…): what nearly every file of the room includes, compiled once; it
# takes most of the time of a file. Each file still includes what it uses: the preset `dev` builds
# without precompiled headers.
function(kadr_precompile target)
  list(TRANSFORM ARGN REPLACE "(.+)" "<\\1>")
  target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()

# Rooms of the compiler may also include their own floor.
function(kadr_compiler_room target)
  kadr_defaults(${target})
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/compiler)
endfunction()
