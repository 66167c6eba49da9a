%
O00001
(rule: Haas macros: #0 is vacant, and a word with it is left out)
(expect: to X1 Y0)
(expect: to X2 Y0)
G00 X1. Y0.
X2. Y#0
M30
%
