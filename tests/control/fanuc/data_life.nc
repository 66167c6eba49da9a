%
O0001
(rule: F 3.4 G10 L3: tool life data are not executed)
(expect: alarm  K5018 at 5:1)
G10L3
P1L500
T1H1D1
G11
M30
%
