%
O0001
(rule: F 2.3, 5.5 T-B: G78 is the single cycle of a thread)
(expect: path X30Z3 X19 t1.5:z-18.5 t2.1213:x22z-20 X30 Z3)
G90 G95 G97 S500 M03
G00 X30. Z3.
G78 X19. Z-20. F1.5
M30
%
