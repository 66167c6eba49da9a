%
O0001
(rule: F 6.8 more than ten triples are an alarm)
(expect: alarm PS1095 K5466 at 5:40)
G65P9100I1.I2.I3.I4.I5.I6.I7.I8.I9.I10.I11.
M30
%
