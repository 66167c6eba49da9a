%
O0001
(rule: F 1.6 E for a lead is of other controls: PS0009)
(expect: alarm PS0009 K5001 at 5:13)
G33Z-10.F1.5E2.
M30
%
