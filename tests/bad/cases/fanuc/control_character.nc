%
O1
G90 X10. Y5.
M30
%
(expect: 3:9 PS0004 `character 1` cannot be read here)
(exit: 3)
