%
O0001
(rule: F 2.3, 5.5 T-C: G20, G21 and G24 are the single cycles)
(expect: path X50Z2 X46 z-18f0.2 x50 Z2 Z-2 x20 z2 X50 X19 t1.5:z-18.5 t2.1213:x22z-20 X50 Z2)
G90 G95 G97 S500 M03
G00 X50. Z2.
G20 X46. Z-18. F0.2
G24 X20. Z-2.
G21 X19. Z-20. F1.5
M30
%
