%
O0001
(rule: F 5.5 G92: the pull-out goes no farther than the start of the cycle)
(expect: path X21Z3 X19 t4:z-19 t5.6569:x21z-20 Z3)
G99 G97 S500 M03
G00 X21. Z3.
G92 X19. Z-20. F4.
M30
%
