%
O0001
(rule: F 3.3 G28, G29: over the stored place)
(expect: to X10 Z5)
(expect: to X20 Z30)
(expect: to X0 Z0)
(expect: to X20 Z30)
(expect: to X40 Z1)
X10.Z5.
G28X20.Z30.
G29X40.Z1.
M30
%
