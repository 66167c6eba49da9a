%
O0001
(rule: F 12: a dwell moves nothing: a place beside it is a slip)
(expect: alarm PS0009 K5010 at 5:4)
G04Z2.
M30
%
