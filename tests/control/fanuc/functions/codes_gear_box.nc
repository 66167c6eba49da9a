%
O0001
(rule: F 2.2 electronic gear box, chopping, in-feed control are options: PS0010)
(expect: alarm PS0010 K5002 at 5:1)
G81.4
M30
%
