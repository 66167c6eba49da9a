%
O0001
(rule: F 2.3 T-B: a thread is G33)
(expect: path X20Z3 t1.5:z-20)
G90 G95 G97 S500 M03
G00 X20. Z3.
G33 Z-20. F1.5
M30
%
