%
O0001
(rule: F 3.8 the move is too short: PS0055)
(expect: alarm PS0055 K5314 at 5:1)
G01X40.,R50.F200.
Y30.
M30
%
