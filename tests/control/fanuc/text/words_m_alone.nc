%
O0001
(rule: F 1.3 M30 is alone: PS5016)
(expect: alarm PS5016 K5022 at 5:4)
M08M30
%
