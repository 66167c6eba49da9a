%
O0001
(rule: F 5.5 G92: a thread inside is pulled out towards the axis)
(expect: path X16Z3 X20 t1:z-19 t1.4142:x18z-20 X16 Z3)
G99 G97 S500 M03
G00 X16. Z3.
G92 X20. Z-20. F1.
M30
%
