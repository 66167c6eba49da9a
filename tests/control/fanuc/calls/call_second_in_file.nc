%
O0001
(rule: F 7 all programs of a file are registered)
(expect: #151=20)
M98P20
M30
%
