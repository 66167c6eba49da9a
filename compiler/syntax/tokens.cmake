# tokens.cmake: the token kinds of the grammar as an enum of ours.
#
# ANTLR numbers the tokens and writes them as NAME=NUMBER; the files that prepare the tokens for the
# parser need the names, but not ANTLR. Arguments: -DTOKENS=Kadr.tokens -DHEADER=token.h
file(STRINGS ${TOKENS} lines REGEX "^[A-Za-z]+=[0-9]+$")
set(enumerators "    EndOfFile = -1,\n")
foreach(line ${lines})
  string(REGEX REPLACE "=.*" "" name ${line})
  string(REGEX REPLACE ".*=" "" number ${line})
  string(APPEND enumerators "    ${name} = ${number},\n")
endforeach()
set(text "// Made from the grammar; see compiler/syntax/tokens.cmake.\n#pragma once\n\n#include <cstdint>\n\n")
string(APPEND text "namespace kadr::syntax {\n\nenum class Token : std::int16_t {\n${enumerators}};\n\n}  // namespace kadr::syntax\n")
file(WRITE ${HEADER} "${text}")
