%
O0001
(rule: F 3.7 not inside G68: G54 to G59, G52, G92, G28, another plane)
(expect: alarm  K5234 at 6:1)
G68X0Y0R30.
G18
M30
%
