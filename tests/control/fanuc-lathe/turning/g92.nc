%
O0001
(rule: F 5.5 G92: thread with a pull-out at 45 degrees over No.5130, one turn here)
(expect: path X30Z3 X19 t1.5:z-18.5 t2.1213:x22z-20 X30 Z3 X18.4 t1.5:z-18.5 t2.1213:x21.4z-20 X30 Z3)
G99 G97 S500 M03
G00 X30. Z3.
G92 X19. Z-20. F1.5
X18.4
M30
%
