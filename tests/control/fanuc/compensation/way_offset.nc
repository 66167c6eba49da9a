%
O0001
(rule: F 2.2 G45 to G48: ways longer or shorter by D)
(expect: to X15)
(expect: to X25)
(expect: to X50)
(expect: to X35)
(expect: to X15)
G10L12P1R5.
G45G00X10.D1
G46X30.
G47X40.
G48X25.
G46X10.
M30
%
