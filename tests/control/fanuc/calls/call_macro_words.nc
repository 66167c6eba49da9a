%
O0001
(rule: F 6.8 words before G65 are an alarm)
(expect: alarm PS0127 K5409 at 5:4)
X1.G65P9100
M30
%
