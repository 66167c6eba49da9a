%
O0001
(rule: F 1.3 four M codes: PS5074)
(expect: alarm PS5074 K5007 at 5:10)
M03M08M05M09
M30
%
