%
O0001
(rule: F 11 P beside G96 and S selects a spindle, as real programs for several have it, so P9 is no wrong axis)
(expect: warning K5247 at 5:4)
G96P9S100
M30
%
