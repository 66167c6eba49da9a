%
O0001
(rule: F 6.8 G L N O P are no arguments)
(expect: alarm PS0129 K5465 at 5:9)
G65P9100G1
M30
%
