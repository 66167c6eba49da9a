%
O00001
(rule: Haas block delete: / is level 1, /2 to /9 their own)
(expect: to X2)
(expect: to X3)
(skip: 2)
/2 G00 X1.
G00 X2.
/3 X3.
M30
%
