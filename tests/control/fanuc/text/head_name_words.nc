%
<PART1> G20 (A PLATE)
(rule: F 1.2 words behind a program's name are read as those behind its number)
(expect: to X25.4)
G00X1.
M30
%
