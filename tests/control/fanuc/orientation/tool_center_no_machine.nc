%
O0001
(rule: F 4.7 tool centre point control needs the parameters of the machine's rotary axes)
(expect: alarm PS5420 K5600 at 5:1)
G43.4H1
M30
%
