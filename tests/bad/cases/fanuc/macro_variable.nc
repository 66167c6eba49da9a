%
O0001
#1=5
G00 X#1
M30
%
(expect: 3:1 K5018 the control's own parametric language is not supported by Kadr yet)
(expect: 4:6 K5018 the control's own parametric language is not supported by Kadr yet)
(exit: 3)
