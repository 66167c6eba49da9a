%
O0001
(rule: F 2.3 T-C: G70 is inch, G71 metric)
(expect: path X25.4Z50.8 X10)
G70 G90 G95 G97 S500 M03
G00 X1. Z2.
G71
X10.
M30
%
