%
O0001
(rule: F 6.6 SETVN is not read)
(expect: alarm PS0009 K5001 at 5:1)
SETVN500[PROBEX]
M30
%
