%
O0001
(rule: F 6.8 a second G65 is an argument G: PS0129)
(expect: alarm PS0129 K5465 at 5:9)
G65P9200G65P9201
M30
%
