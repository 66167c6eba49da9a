%
O0001
(rule: F 4.2 G43 H without an axis moves by the length; G49 moves back)
(expect: to Z50)
(expect: to Z50)
(expect: to Z50)
G10L10P5R10.
Z50.
G43H5
G49
M30
%
