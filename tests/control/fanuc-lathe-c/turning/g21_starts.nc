%
O0001
(rule: F 2.3, 5.5 T-C: Q of G21 in the blocks of its mode)
(expect: path X30Z3 X19 t3:z-17 t4.2426:x25z-20 X30 Z3 X19 t3@180:z-17 t4.2426:x25z-20 X30 Z3)
G90 G95 G97 S500 M03
G00 X30. Z3.
G21 X19. Z-20. F3.
X19. Q180000
M30
%
