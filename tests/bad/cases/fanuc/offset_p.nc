%
O0001
G54.1 P999
G00 X0.
M30
%
(expect: 3:7 PS0010 IMPROPER G-CODE: `P999` does not fit into `G54.1 P{number-6}`)
(exit: 3)
