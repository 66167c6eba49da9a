%
O0001
(rule: F 6.5 an alarm inside a macro names its own line)
(expect: alarm PS0112 K5420 at O9999.NC:3:9)
(expect: called 7:1)
#1=1
G65P9999
M30
%
