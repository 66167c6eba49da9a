%
O0001
(rule: F 11 PS0245: no T beside G50)
(expect: alarm PS0245 K5022 at 5:1)
G50S2000T0101
M30
%
