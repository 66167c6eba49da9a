%
O0001
G67
M30
%
(expect: 3:1 PS1100 CANCEL WITHOUT MODAL CALL: no modal call is active that could end)
(exit: 3)
