%
O0001
(rule: F 11 PS0058: no block that tells the end)
(expect: alarm PS0058 K5322 at 5:1)
G01,A45.F100
M30
%
