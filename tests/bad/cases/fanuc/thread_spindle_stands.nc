%
O0001
G00 X20. Z5.
G33 Z-20. F1.5
M30
%
(expect: 4:1 K5214 feed per revolution with the spindle stopped)
(exit: 3)
