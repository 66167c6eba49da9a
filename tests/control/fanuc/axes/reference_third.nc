%
O0001
(rule: F 3.3 G30 P5: PS0046)
(expect: alarm PS0046 K5237 at 5:1)
G30P5X0
M30
%
