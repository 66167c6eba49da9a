%
O0001
(rule: F 3.3 G29: over the place of G28)
(expect: to X5 Y5)
(expect: to X8 Y5)
(expect: to X0 Y5)
(expect: to X8 Y5)
(expect: to X3 Y5)
G00X5.Y5.
G28X8.
G29X3.
M30
%
